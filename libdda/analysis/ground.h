// What the ground is in a model.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/analysis/joint_openings.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

constexpr double bed = 0.5;  // cosine of normal and weight: a stone lies on what is less steep

/// Blocks that the ground holds: foundations, and those at which the model ends, once for each of their faces
/// there.
std::vector<int> blocks_held_by_ground(const Model& model);

/// Those of them whose mean motion is that of the ground: foundations; without any the blocks at which the model
/// ends.
std::vector<int> blocks_that_are_ground(const Model& model);

/// For each block whether it is ground: foundations, and all blocks of the materials of which blocks at the ends
/// of the model, or with tied sides, are.
std::vector<bool> ground_marks(const Model& model);

/// The foot of a structure: what its displacements count relative to. Its supports; of a structure that stands on
/// soil alone the stones that lie on it, for the ground below goes its own way. Without either the ends of the
/// model.
class Foot
{
 public:
    /// @param joints of the start of the run
    Foot(const Model& model, const std::vector<WatchedJoint>& joints);

    const std::vector<int>& blocks() const { return blocks_; }
    /// Whether it is stones that lie on soil.
    bool is_on_soil() const { return on_soil_; }
    /// How far it has moved since the model was drawn [m]; of supports along the axes that they hold.
    Eigen::Vector3d displacement(const Model& model, const State& state) const;
    /// m/s
    Eigen::Vector3d velocity(const Model& model, const State& state) const;

 private:
    std::vector<int> blocks_;
    bool on_soil_ = false;
};

}  // namespace voussoir
