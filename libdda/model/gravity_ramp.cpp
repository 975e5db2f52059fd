#include "libdda/model/gravity_ramp.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace voussoir
{

namespace
{

using Eigen::Vector3d;

/// Integral over time, from 0, of the share of the way that is done [s].
double integral_of_share(double duration, double time)
{
    return time < duration ? time * time / (2 * duration) : time - 0.5 * duration;
}

/// Part of the way from one vector to another, at a constant rate of their angle. Opposite ones have no way.
Vector3d turned(const Vector3d& from, const Vector3d& to, double share)
{
    const Eigen::Quaterniond whole = Eigen::Quaterniond::FromTwoVectors(from, to);
    const Vector3d direction = Eigen::Quaterniond::Identity().slerp(share, whole) * from.normalized();
    return ((1 - share) * from.norm() + share * to.norm()) * direction;
}

}  // namespace

Vector3d mean_gravity(const GravityRamp& ramp, const Vector3d& gravity, double start, double end)
{
    if (ramp.duration <= 0 || start >= ramp.duration) return gravity;
    const double share =
        end > start
            ? (integral_of_share(ramp.duration, end) - integral_of_share(ramp.duration, start)) / (end - start)
            : std::clamp(start / ramp.duration, 0.0, 1.0);
    return ramp.turns ? turned(ramp.from, gravity, share) : Vector3d(ramp.from + share * (gravity - ramp.from));
}

}  // namespace voussoir
