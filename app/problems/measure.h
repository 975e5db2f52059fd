// By how much two steps from the same state differ, and whether one obeys the laws.
#pragma once

#include <string>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::app::problems
{

/// A step that was made, or not.
struct MadeStep {
    StepReport report;
    State state;          // after it
    EnergyLedger energy;  // opened just before it
    double seconds = 0;   // of CPU
    /// Whether it was made at the first attempt.
    bool holds() const { return report.outcome == StepOutcome::converged && report.cuts == 0; }
};

/// The block whose difference is largest.
struct Difference {
    double worst = 0;  // times the force that the step may leave unbalanced at that block
    int block = -1;    // index into Model::blocks
};

/// Weight of each block and what its contact points press with [N].
std::vector<double> loads_of(const Model& model, const Stage& stage, const State& state);

/// The force that inertia needs for the difference of two states after a step of h [s], 2 m |dx| / h^2 of the
/// centroid and of the map times the block's size, in units of what the step may leave unbalanced. Rounding of
/// coordinates and of stresses is no difference. @param one the state whose loads are the scale
Difference difference_between(const Model& model, const Stage& stage, double h, const State& one,
                              const State& other);

/// What in an accepted step breaks a law, in a few words; empty: nothing. Every block is in equilibrium within the
/// tolerance; contact points push, and rub within their bound of friction; the energies of the step add up, and
/// are those of the state that it led to.
std::string fault_of(const Model& model, const Stage& stage, const State& before, const MadeStep& step);

}  // namespace voussoir::app::problems
