// How far blocks have gone from one place to another, whatever the kinematics.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Of one block.
struct BlockShift {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  // m
    Eigen::Matrix3d map = Eigen::Matrix3d::Zero();       // -, change of Pose::map
    double farthest = 0;                                 // m, of its corners
};

/// Of all blocks; those that are wholly held have none. @param from, to State::coordinates of the model
std::vector<BlockShift> shifts_between(const Model& model, const std::vector<double>& from,
                                       const std::vector<double>& to);

/// Sum over the blocks of the integral of one displacement times the other dm [kg m2].
double product_of(const Model& model, const std::vector<BlockShift>& one, const std::vector<BlockShift>& other);

/// The farthest that a corner has gone, as a share of its block's size; 0 without blocks.
double largest_share(const Model& model, const std::vector<BlockShift>& shifts);

}  // namespace voussoir
