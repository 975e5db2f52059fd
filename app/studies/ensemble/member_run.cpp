#include "app/studies/ensemble/member_run.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/words/diagnosis_words.h"
#include "importers/process/thread_time.h"
#include "libdda/analysis/joint_openings.h"
#include "libdda/analysis/verdict.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

EnergyShares shares_of(const EnergyLedger& energy)
{
    EnergyShares shares;
    shares.residual = energy.relative_residual();
    shares.input = energy.input() + energy.start_kinetic + energy.start_strain + energy.start_contact;
    if (!(shares.input > 0)) {  // a share of nothing
        shares.algorithmic = shares.friction = shares.damping = std::numeric_limits<double>::quiet_NaN();
        return shares;
    }
    shares.algorithmic =
        (energy.closing + energy.algorithmic + energy.algorithmic_rotation + energy.redetection) / shares.input;
    shares.friction = energy.friction / shares.input;
    // What coming to rest under the weight takes is none of the motion.
    shares.damping = (energy.damping_kinetic + energy.damping_contact + energy.damping_material + energy.fracture +
                      energy.yielding) /
                     shares.input;
    return shares;
}

/// The joints of the model, looked at again and again.
class OpeningBook
{
 public:
    OpeningBook(const Model& model, double limit)
        : model_(model), limit_(limit), joints_(joints_at_start(model, initial_state(model)))
    {
    }

    void look(const State& state, MemberRun& run)
    {
        const std::vector<PlacedBlock> blocks = placed_blocks(model_, state);
        if (state.time == 0) {  // at rest: what a static stage ends with replaces what was before
            count_from(model_, state.coordinates, joints_);
            opened_.assign(joints_.size(), false);
        }
        run.joints = static_cast<int>(joints_.size());
        run.open = 0;
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            const double opening = since(joints_[i].at_rest, motion_of(joints_[i], blocks)).opening;
            run.largest_opening = std::max(run.largest_opening, opening);
            run.open += opening > limit_;
            if (opening > limit_) opened_[i] = true;
        }
        run.opened = static_cast<int>(std::count(opened_.begin(), opened_.end(), true));
    }

 private:
    const Model& model_;
    double limit_;
    std::vector<WatchedJoint> joints_;
    std::vector<bool> opened_;
};

std::vector<converge::Quantity> drifts_of(const Case& member)
{
    std::vector<converge::Quantity> drifts;
    drifts.reserve(member.output.histories.size());
    for (int point = 0; point < static_cast<int>(member.output.histories.size()); ++point)
        drifts.push_back({converge::Field::drift, point, -1, converge::Measure::history, point});
    return drifts;
}

bool has_lost_stones(const Case& member, const std::vector<WatchedJoint>& joints, const State& now)
{
    const Stage& stage = member.stages[static_cast<std::size_t>(now.stage)];
    const RunStart from{initial_state(member.model).coordinates, {}};
    const std::optional<Verdict> verdict = verdict_of(member.model, joints, from, stage.gravity, now);
    return verdict && !verdict->lost.empty();
}

}  // namespace

MemberRun run_member(const Case& member, const converge::ConvergeSetting& setting, double limit,
                     const std::function<bool()>& stop)
{
    Case changed = converge::with_setting(member, setting);
    for (std::size_t i = 0; i < changed.stages.size(); ++i) {
        changed.stages[i].control.threads = 1;
        changed.stages[i].control.integrator = member.stages[i].control.integrator;
    }
    MemberRun result;
    OpeningBook openings(changed.model, limit);
    State state = initial_state(changed.model);
    converge::Recorder recorder(changed, drifts_of(changed), {});
    const double start = importers::process::thread_time();
    double rest = start;
    RunObserver observer;
    observer.every = changed.output.every;
    // What has gone far may stand all the same: at the next frame the verdict says.
    const std::vector<WatchedJoint> joints = joints_at_start(changed.model, state);
    observer.frame = [&](const State& now, const RunReport&) {
        openings.look(now, result);
        if (recorder.collapse && has_lost_stones(changed, joints, now)) result.collapse = recorder.collapse;
        recorder.collapse.reset();
    };
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        recorder.step(now);
        if (now.time == 0) rest = importers::process::thread_time();
    };
    observer.stop = [&] { return (stop && stop()) || result.collapse; };
    const RunReport report = run(changed.model, changed.stages, state, observer);
    result.cpu = importers::process::thread_time() - start;
    result.cpu_dynamic = importers::process::thread_time() - rest;
    const bool fell_at_rest = report.outcome == Outcome::collapsed && report.simulated_time == 0;
    if (has_no_answer(report.outcome) || fell_at_rest)
        result.failure = words::message_of(report, changed.model, changed.stages);
    result.warnings = words::warnings_of(report, changed.model, changed.stages);
    result.steps = report.steps;
    result.step_cuts = report.step_cuts;
    result.iterations = report.open_close_iterations;
    result.simulated = report.simulated_time;
    result.energy = shares_of(report.energy);
    result.recording = std::move(recorder.recording);
    if (!result.collapse && report.outcome == Outcome::collapsed && !report.fallen.empty()) {
        const FallenBlock& first = report.fallen.front();
        result.collapse = converge::Collapse{first.time, changed.model.blocks[first.block].name};
    }
    return result;
}

}  // namespace voussoir::app::studies::ensemble
