// One time step: the function to read first.
#pragma once

#include <memory>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Scratch memory that lives from step to step. Nothing in it may change a result.
class Workspace
{
 public:
    explicit Workspace(const Model& model);
    ~Workspace();
    Workspace(Workspace&&) noexcept;
    Workspace& operator=(Workspace&&) noexcept;

    struct Implementation;  // per kinematics, in the .cpp
    std::unique_ptr<Implementation> implementation;
};

/// Advances the state by one time step of at most `time_step` [s]: finds contacts, assembles, iterates open-close,
/// judges or cuts the step, updates. On gave_up the state is untouched. Energies of the step are added to
/// `energy`.
StepReport advance(const Model& model, const Stage& stage, double time_step, State& state, EnergyLedger& energy,
                   Workspace& work);

/// Finds the contacts of the state as it stands (gaps, areas, no forces): for `check` and the first frame.
void find_initial_contacts(const Model& model, State& state);

}  // namespace voussoir
