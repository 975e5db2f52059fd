#include "libdda/run/automatic_step.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "libdda/analysis/longest_step.h"
#include "libdda/analysis/trust.h"

namespace voussoir::driver
{

namespace
{

constexpr double shortest_automatic = 0.1e-3;  // s
constexpr double worth_judging = 0.1;          // of energy_of_motions()
constexpr double least_left = 0.1;             // of what a limit allows, where one blow has taken more

double fastest(const GroundMotion& motion, double duration, double step)
{
    double most = 0;
    const auto steps = static_cast<std::int64_t>(std::min(duration, motion.duration()) / step);
    for (std::int64_t i = 0; i <= steps; ++i)
        most = std::max(most, std::abs(motion.velocity(static_cast<double>(i) * step)));
    return most;
}

double moving_mass(const Model& model)
{
    double mass = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) mass += model.mass(b);
    for (const Foundation& foundation : model.foundations)
        if (foundation.fully_held()) mass -= model.mass(foundation.block);
    return mass;
}

TakenBySteps taken_so_far(const RunPosition& at)
{
    const EnergyShares shares = shares_of(at.report.energy, *at.before_motion, at.rested);
    return {shares.put_in, shares.put_in * shares.integrator, shares.put_in * shares.closing,
            shares.put_in * shares.contacts};
}

}  // namespace

double energy_of_motions(const Model& model, const Stage& stage)
{
    std::set<const GroundMotion*> seen;
    double most = 0;
    const auto consider = [&](const auto& uses) {
        for (const auto& use : uses)
            if (use.motion && seen.insert(use.motion.get()).second)
                most = std::max(most, fastest(*use.motion, stage.duration, stage.control.time_step));
    };
    consider(stage.motions);
    consider(stage.body_accelerations);
    consider(stage.incoming_waves);
    return 0.5 * moving_mass(model) * most * most;
}

double longest_so_far(const Stage& stage, const RunPosition& position)
{
    return std::ldexp(stage.control.time_step, -position.halvings);
}

void suit_to_vibrations(const std::vector<Stage>& stages, int stage, RunProgress& progress)
{
    const Stage& entered = stages[stage];
    if (!entered.control.automatic || progress.state.step == 0) return;
    ModesSearch search;
    search.most_work = work_worth_the_modes(progress.model, stages);
    RunPosition& at = progress.position;
    at.halvings = halvings_for(natural_modes(progress.model, progress.state, search), entered);
    if (at.halvings > 0)
        progress.report.shorter_steps.push_back({stage, progress.state.time, longest_so_far(entered, at), true});
}

void shorten_where_steps_take_much(const Stage& stage, double motions, RunProgress& progress)
{
    RunPosition& at = progress.position;
    const double step = longest_so_far(stage, at);
    if (!stage.control.automatic || !at.before_motion ||
        step / 2 < std::max(shortest_automatic, stage.control.min_time_step))
        return;
    const TakenBySteps now = taken_so_far(at), &then = at.at_halving;
    const double put_in = std::max(now.put_in, worth_judging * motions);
    const auto takes_much = [&](double TakenBySteps::*term, double limit) {
        const double allowed = limit * put_in, left = std::max(allowed - then.*term, least_left * allowed);
        return now.*term > allowed / 2 && now.*term - then.*term > left / 2;
    };
    if (!takes_much(&TakenBySteps::integrator, most_taken_by_integrator) &&
        !takes_much(&TakenBySteps::closing, most_taken_by_closing) &&
        !takes_much(&TakenBySteps::contacts, residual_worth_a_warning))
        return;
    at.at_halving = now;
    ++at.halvings;
    progress.report.shorter_steps.push_back({progress.state.stage, progress.state.time, step / 2, false});
}

}  // namespace voussoir::driver
