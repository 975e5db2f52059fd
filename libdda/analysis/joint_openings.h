// How far joints have opened, whether or not their blocks still touch.
#pragma once

#include <vector>

#include "libdda/analysis/material_point.h"

namespace voussoir
{

/// A corner of a joint: two material points that faced each other when the joint was looked at.
struct JointCorner {
    MaterialPoint on_a, on_b;                          // that faced each other
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, outward from block b, turning with it
};

/// All patches between two blocks.
struct WatchedJoint {
    int block_a = 0, block_b = 0;      // a < b
    std::vector<JointCorner> corners;  // of all patches
};

/// The joints of a state, by its contacts, in ascending order of the pair. A patch of edge on edge counts.
std::vector<WatchedJoint> joints_of(const Model& model, const State& state);

/// Largest distance by which the two points of a corner have parted along the joint's normal [m]; sliding along
/// the joint is no opening. At most 0 of a joint that is closed all over.
double opening_of(const WatchedJoint& joint, const Model& model, const State& state);

}  // namespace voussoir
