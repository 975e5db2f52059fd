// An arch of two rigid halves on supports that move apart or together: three hinges, and closed forms.
//
//            crown  ^ z
//        H     /|\              Each half is the quadrangle of its springing joint, from the inner to the outer
//             / | \             corner, and its crown joint, from the lower to the upper corner.
//        h   / /|\ \            Supports that spread: the halves lean on their inner springing corners (2a apart)
//           / / | \ \           and meet at the upper crown corners. Supports that close: on the outer corners (2b
//          /_/  |  \_\ > x      apart), meeting at the lower crown corners.
//        -b -a  0   a  b
#pragma once

#include <cmath>
#include <vector>

namespace voussoir::verification
{

struct ThreeHingedArch {
    double inner = 2.0, outer = 2.6;  // a, b: m from the axis to the corners of the springing joints
    double lower = 1.6, upper = 2.3;  // h, H: m from the springings to the corners of the crown joint

    struct Moved {
        double sideways, up;  // m
    };

    double hinge_height(bool spreads) const { return spreads ? upper : lower; }
    double half_span(bool spreads) const { return spreads ? inner : outer; }

    /// How the hinge at the crown moves with the supports: half the sum of their ways to the side, and up or down
    /// as the span between the hinges says. @param left, right along x [m]
    Moved crown(double left, double right) const
    {
        const double spread = right - left;
        const double start = half_span(spread > 0), height = hinge_height(spread > 0);
        const double length = std::hypot(start, height), now = start + spread / 2;
        return {(left + right) / 2, std::sqrt(length * length - now * now) - height};
    }

    /// How far joints that give lower the crown at most, when no hinge is pressed in by more than `penetration`
    /// [m]. A springing gives that much down and, its shear springs half as stiff and the thrust less than the
    /// weight, twice that outwards; each half has half of the crown's. What gives outwards lowers the crown by
    /// half-span / height.
    double give(double penetration, bool spreads) const
    {
        return penetration * (1 + 2.5 * half_span(spreads) / hinge_height(spreads));
    }
};

/// Displacements every 10 ms: from 0 to `end` [m] in 4 s, speed and acceleration starting and ending at zero, and
/// resting there for a second more.
inline std::vector<double> slow_ramp(double end)
{
    std::vector<double> samples;
    for (int i = 0; i <= 500; ++i) {
        const double u = std::fmin(i / 400.0, 1);
        samples.push_back(end * u * u * u * (10 + u * (-15 + 6 * u)));
    }
    return samples;
}
constexpr double ramp_step = 0.01;  // s

}  // namespace voussoir::verification
