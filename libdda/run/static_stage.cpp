#include "libdda/run/static_stage.h"

#include <algorithm>
#include <utility>

namespace voussoir::driver
{

namespace
{

constexpr double inexactness = 1e-2;  // residual a static step may keep, as a share of its unbalanced force

/// Where stones are falling there is no equilibrium to be found, and that is a result.
bool give_up_resting(const Stage& stage, RunProgress& progress)
{
    auto falling = falling_blocks(progress.model, progress.watch, stage.gravity, progress.before, progress.state);
    if (falling) {
        progress.report.outcome = Outcome::collapsed;
        progress.report.diagnosis = std::move(falling);
        return false;
    }
    ++progress.report.unconverged_steps;
    return give_up({DiagnosisKind::no_equilibrium,
                    progress.state.stage,
                    {},
                    {static_cast<double>(progress.position.static_steps), progress.report.static_unbalanced}},
                   progress);
}

/// One step at rest under `loaded`; false when the run ends here.
bool step_at_rest(const Stage& stage, Stage& loaded, RunProgress& progress)
{
    RunPosition& at = progress.position;
    State& state = progress.state;
    // A step need only be solved as well as its own unbalanced force deserves: far from equilibrium the
    // last digits are friction points taking turns; near it the tolerance must not hide what is left.
    loaded.control.force_tolerance =
        std::min(stage.control.force_tolerance,
                 std::max(inexactness * at.step_unbalanced, 0.1 * stage.unbalanced_tolerance));
    StepReport step;
    const double grown = state.next_time_step;
    const double h = grown > 0 ? std::min(grown, stage.control.time_step) : stage.control.time_step;
    if (!step_once(loaded, h, progress, step)) return false;
    state.next_time_step = regrowth * step.time_step;
    progress.report.static_unbalanced = at.step_unbalanced = step.inertia_ratio;
    const bool balanced = step.inertia_ratio <= stage.unbalanced_tolerance && !step.contact_state_changed;
    at.quiet_steps = balanced ? at.quiet_steps + 1 : 0;
    ++at.static_steps;
    if (progress.observer.step) progress.observer.step(state, step, progress.report);
    if (at.quiet_steps < 2 && at.static_steps == stage.max_static_steps) return give_up_resting(loaded, progress);
    save(progress);
    return goes_on(progress);
}

}  // namespace

bool run_static(const Stage& stage, RunProgress& progress)
{
    RunPosition& at = progress.position;
    Stage loaded = stage;
    for (; at.load_increments < stage.gravity_increments; ++at.load_increments) {
        loaded.gravity = stage.gravity * (at.load_increments + 1) / stage.gravity_increments;
        while (at.quiet_steps < 2) {
            if (!step_at_rest(stage, loaded, progress)) return false;
        }
        at.static_steps = at.quiet_steps = 0;
        at.step_unbalanced = 1;
    }
    return true;
}

}  // namespace voussoir::driver
