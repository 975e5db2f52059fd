// A sliding joint that comes to rest or turns round inside a step.
//
// Friction is constant between reversals and the step exact; a reversal inside a step that keeps the friction of
// one direction for all of it costs up to mu g h of velocity. Here the friction of the step is its mean over the
// time before and after the joint has stopped, contact by contact: the sliding speed w falls from w0 at the start
// to zero at the fraction s of the step. With b = mu N h / m, the speed that friction takes in a step, what drives
// the stones is then m (w0 / s - b) / h, and afterwards either friction holds it (the joint sticks: w1 = 0) or it
// slides back:
//
//   t / (mu N) = 2 s - 1,   w1 = (1 - s) (2 b - w0 / s) < 0.
//
// Both are one rising function of the displacement of the step, h (w0 + w1) / 2: the potential of the step stays
// convex. Source: docs/method.md, "Reversals".
#pragma once

#include <algorithm>
#include <cmath>

#include "libdda/step/contact_step.h"

namespace voussoir::step
{

/// Displacement along the heading after which a point has come to rest at the end of the step [m].
template <int D>
double half_way(const PointStep<D>& p, double h)
{
    return 0.5 * h * p.speed;
}

/// Mean friction of a joint that slides back, as a share of its bound, and its derivative by the end speed [s/m].
struct SlidingBack {
    double share = 0, slope = 0;
};
inline SlidingBack sliding_back(double speed, double end_speed, double braking)
{
    const double b = 2 * braking + speed - end_speed;
    const double root = std::sqrt(std::max(b * b - 8 * braking * speed, 1e-6 * b * b));
    const double fraction = std::min(1.0, 2 * speed / (b + root));
    return {2 * fraction - 1, 2 * fraction * (1 + b / root) / (b + root)};
}

/// The shear force of a point whose sliding ends within the step. @param move tangential displacement [m]
template <class K>
void turn_round(const typename K::Vector& move, const PatchStep<K>& patch, PointStep<K::dimension>& p)
{
    using Vector = typename K::Vector;
    p.turns_round = true;
    const double along = p.heading.dot(move), rest = half_way(p, patch.h);
    const SlidingBack back = sliding_back(p.speed, 2 * along / patch.h - p.speed, patch.braking);
    const double stuck = p.bound > 0 ? 1 + p.shear_stiffness * (along - rest) / p.bound : -1;
    const bool sticks = stuck > back.share;
    const double share = std::min(sticks ? stuck : back.share, 1.0);
    p.status = sticks ? ContactStatus::locked : ContactStatus::sliding;
    p.tangent_along = sticks ? p.shear_stiffness : p.bound * back.slope * 2 / patch.h;
    // What crosses the heading bends the force, as it does of a joint that slides on: by as much where it just
    // does not turn, and the less, the longer the way there and back is.
    const Vector path = p.slip_start + move;
    const double back_way = sticks ? 0 : 0.5 * (1 - share) * (rest - along);
    const double reach = p.heading.dot(p.slip_start) + rest + back_way;
    const Vector bent = share * reach * p.heading + (path - p.heading.dot(path) * p.heading);
    p.tangent_across = p.bound / std::max(bent.norm(), reach);
    p.shear = p.trial = p.tangent_across * bent;
}

/// Elastic slip at the end of a step in which the joint turned round [m]. One that sticks is left with the
/// friction that holds it, not with the mean of the step.
template <class K>
typename K::Vector slip_after_turning(const PatchStep<K>& patch, const PointStep<K::dimension>& p)
{
    using Vector = typename K::Vector;
    if (p.bound == 0) return Vector::Zero();
    const double share = p.heading.dot(p.shear) / p.bound, c = p.speed / patch.braking;
    double held = -1;
    if (p.status == ContactStatus::locked) {
        const double b = 1 + c + share;
        const double fraction = 2 * c / (b + std::sqrt(std::max(b * b - 8 * c, 0.0)));
        held = std::clamp(c / fraction - 1, -1.0, 1.0);
    }
    return (p.shear + (held - share) * p.bound * p.heading) / p.shear_stiffness;
}

}  // namespace voussoir::step
