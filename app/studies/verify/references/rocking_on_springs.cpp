#include "app/studies/verify/references/rocking_on_springs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/studies/verify/references/smooth_ode.h"

namespace voussoir::app::studies::verify::references
{

using Eigen::Vector2d;
using Eigen::VectorXd;

namespace
{

constexpr double tolerance = 1e-12;  // of an integration step

enum Unknown { x, z, turn, speed_x, speed_z, spin, slip_left, slip_right, unknowns };
enum class Phase { sticks, slips, open };  // of the right corner, which lifts

/// One corner: its lever, the force of its springs on the block, and its speed.
struct Corner {
    Vector2d lever, force, velocity;
};

struct System {
    const RockingBlock& block;
    const CornerSprings& springs;
    Phase phase = Phase::sticks;
    double slip_sign = 0;  // of the right corner while it slips

    Corner corner(const VectorXd& y, double side) const
    {
        const double c = std::cos(y[turn]), s = std::sin(y[turn]);
        const double along = side * block.half_width, down = -block.half_height;
        Corner at;
        at.lever = {along * c + down * s, -along * s + down * c};
        at.velocity = {y[speed_x] + y[spin] * at.lever.y(), y[speed_z] - y[spin] * at.lever.x()};
        const double normal = -springs.normal * (y[z] + at.lever.y());
        at.force = {-springs.shear * y[side < 0 ? slip_left : slip_right], normal};
        if (side < 0) return at;
        if (phase == Phase::slips) at.force.x() = -slip_sign * springs.friction * normal;
        if (phase == Phase::open) at.force.setZero();
        return at;
    }

    /// In the frame of the base; z is the height of the centre.
    VectorXd rates(double t, const VectorXd& y) const
    {
        const double inertia =
            springs.mass / 3 * (block.half_width * block.half_width + block.half_height * block.half_height);
        const double ground = block.amplitude * std::sin(2 * std::numbers::pi * block.frequency * t);
        VectorXd rate = VectorXd::Zero(unknowns);
        rate.head<3>() = y.segment<3>(speed_x);
        rate[speed_x] = -ground;
        rate[speed_z] = -block.gravity;
        for (const double side : {-1.0, 1.0}) {
            const Corner at = corner(y, side);
            rate[speed_x] += at.force.x() / springs.mass;
            rate[speed_z] += at.force.y() / springs.mass;
            rate[spin] += (at.force.x() * at.lever.y() - at.force.y() * at.lever.x()) / inertia;
            rate[side < 0 ? slip_left : slip_right] = at.velocity.x();
        }
        return rate;
    }

    /// Elastic slip of the right corner at the friction bound [m].
    double bound(const VectorXd& y) const
    {
        return slip_sign * springs.friction * corner(y, 1).force.y() / springs.shear;
    }

    /// Speed by which the right corner slips on, beyond what its shear spring gives as it is unloaded [m/s].
    double slip_speed(const VectorXd& y) const
    {
        const Corner right = corner(y, 1);
        const double unloading = -springs.normal * right.velocity.y();  // N/s
        return slip_sign * (right.velocity.x() - slip_sign * springs.friction * unloading / springs.shear);
    }

    /// Falls through zero where the phase ends.
    double margin(const VectorXd& y) const
    {
        const Corner right = corner(y, 1);
        if (phase == Phase::slips) return std::min(right.force.y(), slip_speed(y) * springs.normal);
        return springs.friction * right.force.y() - std::abs(right.force.x());
    }

    /// The phase that follows.
    void change(VectorXd& y)
    {
        if (phase == Phase::sticks) {
            slip_sign = y[slip_right] < 0 ? -1 : 1;
            phase = Phase::slips;
            return;
        }
        y[slip_right] = bound(y);
        phase = slip_speed(y) > 0 ? Phase::open : Phase::sticks;
    }
};

}  // namespace

std::vector<double> rocking_angles_on_springs(const RockingBlock& block, const CornerSprings& springs,
                                              const std::vector<double>& times)
{
    System system{block, springs};
    OdePoint point;
    point.y = VectorXd::Zero(unknowns);
    point.y[z] = block.half_height - springs.mass * block.gravity / (2 * springs.normal);
    std::vector<double> angles;
    const Derivative f = [&](double t, const VectorXd& y) { return system.rates(t, y); };
    const Event ends = [&](double, const VectorXd& y) { return system.margin(y); };
    for (const double time : times) {
        while (point.time < time) {
            if (!integrate(f, time, tolerance, system.phase == Phase::open ? Event{} : ends, point)) continue;
            system.change(point.y);
        }
        angles.push_back(point.y[turn]);
    }
    return angles;
}

}  // namespace voussoir::app::studies::verify::references
