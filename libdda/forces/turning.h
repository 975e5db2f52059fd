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

#include "libdda/forces/contact_step.h"

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

/// How a point that turns round has come to lie. Its force, bound / length x bent, is continuous in its
/// displacement, and where it just comes to rest that of a joint that slides on.
template <class K>
struct Turning {
    using Vector = typename K::Vector;
    double along = 0;     // m, of the displacement along the heading
    double rest = 0;      // m, the same if it just comes to rest
    SlidingBack back;     // if it slides back
    bool sticks = false;  // and does not
    double share = 0;     // -, mean friction along the heading / bound
    double reach = 0;     // m, by which what crosses the heading bends the force
    Vector bent;          // m, along the force
    double length = 0;    // m

    /// @param move tangential displacement [m]
    Turning(const Vector& move, const PatchStep<K>& patch, const PointStep<K::dimension>& p)
        : along(p.heading.dot(move)),
          rest(half_way(p, patch.h)),
          back(sliding_back(p.speed, 2 * along / patch.h - p.speed, patch.braking))
    {
        const double stuck = p.bound > 0 ? 1 + p.shear_stiffness * (along - rest) / p.bound : -1;
        sticks = stuck > back.share;
        share = std::min(sticks ? stuck : back.share, 1.0);
        // What crosses the heading bends the force, as it does of a joint that slides on: by as much where it just
        // does not turn, and the less, the longer the way there and back is.
        reach = p.heading.dot(p.slip_start) + rest + 0.5 * (1 - share) * (rest - along);
        const Vector path = p.slip_start + move;
        bent = share * reach * p.heading + (path - p.heading.dot(path) * p.heading);
        length = std::max(bent.norm(), reach);
    }
};

/// The shear force of a point whose sliding ends within the step. @param move tangential displacement [m]
template <class K>
void turn_round(const typename K::Vector& move, const PatchStep<K>& patch, PointStep<K::dimension>& p)
{
    const Turning<K> t(move, patch, p);
    p.turns_round = true;
    p.status = t.sticks ? ContactStatus::locked : ContactStatus::sliding;
    p.tangent_across = p.bound / t.length;
    p.tangent_along = t.sticks ? p.shear_stiffness : p.bound * t.back.slope * 2 / patch.h;
    p.shear = p.trial = p.tangent_across * t.bent;
}

/// How that force changes, exactly: `tangent_along` and `tangent_across` leave out what is not symmetric.
template <class K>
struct TurningChange {
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    Matrix by_move;   // N/m
    Vector by_bound;  // -

    /// @pre p.bound > 0
    TurningChange(const PatchStep<K>& patch, const PointStep<K::dimension>& p)
    {
        const Turning<K> t(tangential(patch.displacement.at(p.lever), patch.normal), patch, p);
        const Vector& h = p.heading;
        const double share_by_along = t.sticks ? p.shear_stiffness / p.bound : t.back.slope * 2 / patch.h;
        const double share_by_bound = t.sticks ? (1 - t.share) / p.bound : 0;
        const double reach_by_along = -0.5 * share_by_along * (t.rest - t.along) - 0.5 * (1 - t.share);
        const double reach_by_bound = -0.5 * share_by_bound * (t.rest - t.along);
        const Matrix across = Matrix::Identity() - patch.normal * patch.normal.transpose() - h * h.transpose();
        const Matrix bent_by_move =
            across + (share_by_along * t.reach + t.share * reach_by_along) * h * h.transpose();
        const Vector bent_by_bound = (share_by_bound * t.reach + t.share * reach_by_bound) * h;
        const Vector direction = t.bent / t.length;
        const bool capped = t.length > t.reach;
        const Vector length_by_move =
            capped ? Vector(bent_by_move.transpose() * direction) : Vector(reach_by_along * h);
        const double length_by_bound = capped ? direction.dot(bent_by_bound) : reach_by_bound;
        by_move = p.bound / t.length * (bent_by_move - direction * length_by_move.transpose());
        by_bound = direction + p.bound / t.length * (bent_by_bound - length_by_bound * direction);
    }
};

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
