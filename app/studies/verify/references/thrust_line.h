// Limit analysis of a symmetric half arch by its thrust line: the least and the greatest crown thrust.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voussoir::app::studies::verify::references
{

/// A joint of the half arch x >= 0 with what lies between it and the crown.
struct HalfArchJoint {
    Eigen::Vector2d intrados, extrados;  // m, (x, z)
    double weight = 0;                   // N, of the stones from the crown to this joint
    double weight_arm = 0;               // m, x of their centre of gravity
};

struct ThrustRange {
    double least = 0, greatest = 0;  // N
    bool exists = false;
};

/// All thrusts H at heights z with a thrust line inside every joint. With m = H z the conditions "the moment about
/// the intrados is not negative, about the extrados not positive",
///   m - H z_P - W (x_P - x_W) >= 0 at P = intrados, <= 0 at P = extrados,
/// are linear in (H, m): the extremes are vertices of their polygon. Source: [Heyman1982], ch. 2.
ThrustRange thrust_range(const std::vector<HalfArchJoint>& joints);

}  // namespace voussoir::app::studies::verify::references
