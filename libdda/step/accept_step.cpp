#include "libdda/step/accept_step.h"

#include <algorithm>

#include "libdda/problem/part_timer.h"
#include "libdda/step/energy_book.h"
#include "libdda/step/update.h"

namespace voussoir::step
{

namespace
{

/// Books the spring energy that changed when contacts were found anew [J]. In the first step it is that of blocks
/// which the model has within one another; in a static stage nothing of it is left when the velocity has been
/// taken away.
void book_redetection(const Stage& stage, const State& state, double given, EnergyLedger& energy)
{
    if (state.step == 0)
        energy.start_contact += given;
    else if (stage.type == StageType::static_equilibrium)
        energy.damping_static -= given;
    else
        energy.redetection -= given;
}

/// A static step is solved no better than it deserves, and is long: what its residual and its integration did goes
/// with what the stage takes from the stones.
template <class K>
void book_with_what_the_stage_takes(const StepProblem<K>& problem, const EnergyLedger& before,
                                    EnergyLedger& energy)
{
    energy.damping_static -= problem.residual.dot(problem.d);
    for (double EnergyLedger::*term :
         {&EnergyLedger::closing, &EnergyLedger::algorithmic, &EnergyLedger::algorithmic_rotation}) {
        energy.damping_static += energy.*term - before.*term;
        energy.*term = before.*term;
    }
}

void advance_clocks(const Stage& stage, double h, State& state)
{
    if (stage.type == StageType::dynamic) state.time += h;
    state.stage_time += h;
    ++state.step;
}

/// Largest displacement of a centroid in the step [m].
template <class K>
double max_displacement(const StepProblem<K>& problem)
{
    double largest = 0;
    for (const BlockStep<K>& block : problem.blocks)
        if (block.row >= 0)
            largest = std::max(largest, problem.d.template segment<K::dimension>(K::unknowns * block.row).norm());
    return largest;
}

/// Largest force that inertia still had to balance, as a share of the block's load: what a static stage must bring
/// to nothing. With the velocity zeroed it is the unbalanced force itself.
template <class K>
double inertia_ratio(const StepProblem<K>& problem)
{
    constexpr int n = K::unknowns;
    double worst = 0;
    for (std::size_t row = 0; row < problem.block_of_row.size(); ++row) {
        const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
        const typename K::Unknowns force = block.inertia * problem.d.template segment<n>(n * row);
        const double size = std::max(force.template head<K::dimension>().norm(),
                                     force.template tail<n - K::dimension>().norm() / block.size);
        if (size > 0) worst = std::max(worst, size / problem.load[row]);
    }
    return worst;
}

}  // namespace

template <class K>
void accept_step(const Model& model, const Stage& stage, const Work<K>& work, State& state, EnergyLedger& energy,
                 StepReport& report)
{
    const PartTimer timer(report.seconds, Part::update);
    const StepProblem<K>& problem = work.problem;
    report.time_step = problem.h;
    book_redetection(stage, state, contact::spring_energy(model, work.contacts) - energy.contact, energy);
    update_blocks(problem, state);
    const EnergyLedger before = energy;
    book_step(state, problem, work.contacts, energy);
    if (stage.type == StageType::static_equilibrium) book_with_what_the_stage_takes(problem, before, energy);
    problem.others.each([&](const auto& group) { update_forces(model, stage, problem.blocks, group, state); });
    update_contacts(model, stage, problem, work.contacts, state, report);
    advance_clocks(stage, problem.h, state);
    damp_velocities(model, stage, problem, state, energy);
    report.max_displacement = max_displacement(problem);
    if (stage.type == StageType::static_equilibrium)
        report.inertia_ratio = inertia_ratio(problem) + report.unbalanced;
}

#define VOUSSOIR_INSTANTIATE(K) \
    template void accept_step(const Model&, const Stage&, const Work<K>&, State&, EnergyLedger&, StepReport&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
