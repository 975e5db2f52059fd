#include "app/studies/converge/measured_run.h"

#include <ctime>
#include <utility>

#include "app/words/diagnosis_words.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::converge
{
namespace
{

double simulated_time(const std::vector<Stage>& stages)
{
    double sum = 0;
    for (const Stage& stage : stages) sum += stage.type == StageType::dynamic ? stage.duration : 0;
    return sum;
}

/// Books the CPU time since the last call on the kind of stage the step was of.
class CpuBooks
{
 public:
    void book(const Stage& stage, RunCost& cost)
    {
        const std::clock_t now = std::clock();
        double& account = stage.type == StageType::dynamic ? cost.cpu_dynamic : cost.cpu_static;
        account += static_cast<double>(now - last_) / CLOCKS_PER_SEC;
        last_ = now;
    }

 private:
    std::clock_t last_ = std::clock();
};

}  // namespace

RunCost& RunCost::operator+=(const RunCost& other)
{
    cpu_static += other.cpu_static;
    cpu_dynamic += other.cpu_dynamic;
    steps += other.steps;
    step_cuts += other.step_cuts;
    iterations += other.iterations;
    return *this;
}

MeasuredRun run_setting(const Case& the_case, const ConvergeSetting& setting,
                        const std::vector<Quantity>& channels, const CollapseRule& rule,
                        const ConvergeWatch& watch)
{
    const Case changed = with_setting(the_case, setting);
    const double duration = simulated_time(changed.stages);
    MeasuredRun result;
    result.setting = setting;
    CpuBooks books;
    State state = initial_state(changed.model);
    Recorder recorder(changed, channels, rule);
    RunObserver observer;
    bool stopped = false;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        recorder.step(now);
        books.book(changed.stages[now.stage], result.cost);
        if (watch.progress) watch.progress(setting, duration > 0 ? now.time / duration : 0);
    };
    observer.stop = [&] {
        stopped = watch.stop && watch.stop();
        return stopped || recorder.collapse;
    };
    const RunReport report = run(changed.model, changed.stages, state, observer);
    if (stopped) throw Interrupted();
    result.collapsed = report.outcome == Outcome::collapsed;
    if (has_no_answer(report.outcome)) result.failure = words::message_of(report, changed.model, changed.stages);
    if (result.collapsed && report.simulated_time == 0)
        result.no_rest = words::message_of(report, changed.model, changed.stages);
    result.cost.steps = report.steps;
    result.cost.step_cuts = report.step_cuts;
    result.cost.iterations = report.open_close_iterations;
    result.recording = std::move(recorder.recording);
    result.collapse = std::move(recorder.collapse);
    return result;
}

}  // namespace voussoir::app::studies::converge
