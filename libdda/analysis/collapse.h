// Collapse is a result: which blocks have fallen, and when.
#pragma once

#include <optional>
#include <vector>

#include "libdda/model/diagnosis.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Where everything stood at the start of the run, by which falling is judged.
struct CollapseWatch {
    CollapseWatch() = default;
    /// @param start state at the start of the run
    CollapseWatch(const Model& model, const State& start);

    std::vector<Eigen::Vector3d> start;                // m, centroids
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // m, of the scene
    double extent = 0;                                 // m, largest distance of a block from the middle
};

/// Adds the blocks that have fallen since the last call to report.fallen: those that no chain of closed contacts
/// joins to a block held by the ground, and that are lower than at the start by more than their own size, along
/// `gravity`, or have left, being farther from the middle than three times the scene's extent. Nothing falls in a
/// scene without foundations. A block that has fallen and then leaves is not told twice, but marked.
void note_fallen(const Model& model, const CollapseWatch& watch, const Eigen::Vector3d& gravity,
                 const State& state, RunReport& report);

/// The blocks of report.fallen that show that the structure has fallen: those that hang in the air, have left, or
/// stood on something at the start. A stone that was in flight then, moving of its own or touching nothing, and
/// lies on the ground or on what stands on it by now, has only landed.
/// @param state as it is now
std::vector<int> blocks_that_fell(const Model& model, const State& state, const RunReport& report);

/// Adds blocks to report.fallen that are not there yet. @param time s since the run's start
void note_lost(const std::vector<int>& blocks, double time, RunReport& report);

/// Whether every block that could fall has left the domain: nothing more can happen.
bool all_have_left(const Model& model, const RunReport& report);

/// Which blocks have fallen and when, if any have: why a run has ended, or a warning.
std::optional<Diagnosis> diagnosis_of_fallen(const RunReport& report);

}  // namespace voussoir
