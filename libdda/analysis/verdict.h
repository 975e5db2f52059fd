// The verdict on a structure at the end of a run: one function for whatever tells it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "libdda/analysis/joint_openings.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"
#include "libdda/model/verdict.h"

namespace voussoir
{

/// Where a run began, as State::coordinates.
struct RunStart {
    std::vector<double> start;      // of the run
    std::vector<double> reference;  // when the first motion began; empty: there was none, and damage is not judged
};

/// Judges what is, whatever led there. A joint of the start holds while its stones are near (they have moved apart
/// or along it by less than half the size of the smaller one, or touch on a bed, or touch and have gone down along
/// one another by less than that) and have not turned against one another by 30 degrees out of its plane. A block
/// is lost that joints and bars connected to the ground when the run began and those that hold do no more, or that
/// leans by 30 degrees. Supports that move are no failure: all is told relative to the
/// foot of the structure.
/// @param joints of the start of the run @param gravity m/s2
/// @returns nothing where nothing can stand: without gravity, or without ground
std::optional<Verdict> verdict_of(const Model& model, const std::vector<WatchedJoint>& joints,
                                  const RunStart& from, const Eigen::Vector3d& gravity, const State& state);

/// Adds blocks that are known otherwise to have come off, and judges anew whether the structure stands.
void add_lost(const Model& model, const std::vector<int>& blocks, Verdict& verdict);

}  // namespace voussoir
