// The step of libdda/step/advance.cpp without cutting and division, which can be made wrongly.
#pragma once

#include <functional>

#include "libdda/analysis/energies.h"
#include "libdda/iterate/newton.h"
#include "libdda/step/energy_book.h"
#include "libdda/step/update.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

/// What may be done wrongly, at the place in the step where it would be.
template <class K>
struct Mistake {
    using System = step::StepProblem<K>;
    // Between assembly and solution.
    std::function<void(System&)> in_equations = [](System&) {};
    // Between solution and update.
    std::function<void(System&)> in_forces = [](System&) {};
    std::function<void(const System&, State&)> in_update = [](const System&, State&) {};
    // Between update and audit.
    std::function<void(System&)> in_the_book = [](System&) {};
};

/// Steps of one length, all of which must converge. @param seen of each state that a step has left
template <class K>
EnergyLedger step_by_hand(
    const Model& model, const Stage& stage, int steps, const Mistake<K>& mistake, State& state,
    const std::function<void(const State&)>& seen = [](const State&) {})
{
    EnergyLedger energy = open_ledger(model, state);
    step::StepProblem<K> system;
    step::Iteration<K> iteration;
    contact::SearchMemory<K::dimension> search;
    ContactSetIn<K::dimension> contacts;
    const double h = stage.control.time_step;
    const std::vector<double> reach(model.blocks.size(), 0.05);
    StepReport report;
    for (int step = 0; step < steps; ++step) {
        contact::find_contacts(model, state, reach, 1, search, contacts,
                               step > 0 ? contact::NewOverlap::forgiven : contact::NewOverlap::presses);
        step::assemble_blocks<K>(model, stage, state, contacts, h, {}, system);
        iteration.begin(stage.control, system);
        mistake.in_equations(system);
        EXPECT_TRUE(step::iterate_newton(model, stage, contacts, system, iteration, report)) << "step " << step;
        energy.redetection += energy.contact - contact::spring_energy(model, contacts);
        mistake.in_forces(system);
        step::update_blocks(system, state);
        mistake.in_update(system, state);
        mistake.in_the_book(system);
        step::book_step(state, system, contacts, energy);
        step::update_contacts(model, stage, system, contacts, state, report);
        state.stage_time += h;
        step::damp_velocities(model, stage, system, state, energy);
        seen(state);
    }
    return energy;
}

}  // namespace voussoir::testing
