// A point that moves with its block: what histories follow.
#pragma once

#include <Eigen/Core>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// A point of a block.
struct MaterialPoint {
    int block = 0;                                    // index into Model::blocks
    Eigen::Vector3d lever = Eigen::Vector3d::Zero();  // m, reference place relative to the block's centroid
};

/// c + A X - (c_0 + X) [m], in space whatever the kinematics.
Eigen::Vector3d displacement_of(const Model& model, const State& state, const MaterialPoint& point);

/// dc/dt + dA/dt X [m/s].
Eigen::Vector3d velocity_of(const Model& model, const State& state, const MaterialPoint& point);

}  // namespace voussoir
