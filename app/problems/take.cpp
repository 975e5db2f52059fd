#include "app/problems/take.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "app/problems/tags.h"
#include "app/reader/case_file.h"
#include "libdda/errors.h"
#include "libdda/run/run.h"

namespace voussoir::app::problems
{

namespace
{

/// How long the driver of dynamic stages tries to make the step that begins with this state [s].
double attempted(const Stage& stage, const State& before, const StepReport& step)
{
    const double nominal = stage.control.time_step;
    if (stage.type == StageType::static_equilibrium)
        return before.next_time_step > 0 ? before.next_time_step : nominal;
    if (step.cuts == 0 && !step.divided) return step.time_step;
    const double end = std::min(static_cast<double>(before.grid + 1) * nominal, stage.duration);
    const double left = end - before.stage_time;
    return before.next_time_step > 0 ? std::min(before.next_time_step, left) : left;
}

bool stands_still(const State& state)
{
    return std::all_of(state.velocities.begin(), state.velocities.end(), [](double v) { return v == 0; });
}

/// Watches a run and keeps what is asked for.
class Taker
{
 public:
    Taker(const TakeArguments& arguments, const Case& the_case, State start, const EnergyLedger& energy)
        : arguments_(arguments), case_(the_case), before_(std::move(start)), energy_(energy)
    {
        times_ = arguments.at;
        std::sort(times_.begin(), times_.end());
    }

    void note_step(const State& after, const StepReport& step, const RunReport& report)
    {
        const Stage& stage = case_.stages[static_cast<std::size_t>(after.stage)];
        found_.reset();
        const bool began_here = before_.stage == after.stage;
        if (began_here && is_asked_for()) found_ = problem_of(stage, after, step, report.energy);
        before_ = after;
        energy_ = report.energy;
        if (stage.type == StageType::dynamic) keep();
    }

    /// Static steps: how they were made is told only here.
    void note_position(const RunPosition& position)
    {
        const int stage_index = before_.stage;
        const Stage& stage = case_.stages[static_cast<std::size_t>(stage_index)];
        if (stage.type != StageType::static_equilibrium || position.static_steps == noted_steps_) return;
        noted_steps_ = position.static_steps;
        const double unbalanced = position.static_steps == 1 ? 1 : unbalanced_;
        unbalanced_ = position.step_unbalanced;
        if (!found_) return;
        found_->increment = position.load_increments + 1;
        found_->force_tolerance =
            std::min(stage.control.force_tolerance, 0.1 * std::max(unbalanced, stage.unbalanced_tolerance));
        keep();
    }

    bool has_enough() const
    {
        return has_all() || (arguments_.every == 0 && !arguments_.at.empty() && times_.empty());
    }

    std::vector<StoredStep> problems;

 private:
    /// Whether the step that begins with `before_` is.
    bool is_asked_for()
    {
        if (arguments_.every == 0 && arguments_.at.empty()) return true;
        const bool in_turn = arguments_.every > 0 && before_.step % arguments_.every == 0;
        const auto later = std::find_if(times_.begin(), times_.end(), [&](double t) { return t > before_.time; });
        const bool in_time = later != times_.begin();
        times_.erase(times_.begin(), later);
        return in_turn || in_time;
    }

    std::optional<StoredStep> problem_of(const Stage& stage, const State& after, const StepReport& step,
                                         const EnergyLedger& energy) const
    {
        if (stage.type == StageType::static_equilibrium && !(stands_still(before_) && stands_still(after)))
            return std::nullopt;
        StoredStep problem;
        char number[32];
        std::snprintf(number, sizeof number, ".%06lld", static_cast<long long>(before_.step));
        problem.name = arguments_.name + number;
        problem.time_step = attempted(stage, before_, step);
        problem.force_tolerance = stage.control.force_tolerance;
        problem.tags =
            tags_of(case_.model, stage,
                    {before_, after, step, energy.impact - energy_.impact, energy.fracture - energy_.fracture});
        problem.state = before_;
        const bool is_of = arguments_.of.empty() ||
                           std::any_of(problem.tags.begin(), problem.tags.end(), [&](const std::string& tag) {
                               return std::count(arguments_.of.begin(), arguments_.of.end(), tag) > 0;
                           });
        return is_of ? std::optional(std::move(problem)) : std::nullopt;
    }

    void keep()
    {
        if (found_ && !has_all()) problems.push_back(std::move(*found_));
        found_.reset();
    }

    bool has_all() const { return arguments_.most > 0 && static_cast<int>(problems.size()) >= arguments_.most; }

    const TakeArguments& arguments_;
    const Case& case_;
    State before_;
    EnergyLedger energy_;
    std::vector<double> times_;        // s, ascending, not yet taken
    std::optional<StoredStep> found_;  // of the step under way
    int noted_steps_ = 0;              // static: of the increment
    double unbalanced_ = 1;            // static: after the last step
};

CaseText text_of(const TakeArguments& arguments)
{
    // Faults of the case are told with its own name, and only then whether it names other files.
    const Case whole = reader::read_case(arguments.file, arguments.settings);
    CaseText text{whole.text, arguments.settings};
    try {
        read(text);
    } catch (const InputError&) {
        throw InputError(arguments.file.string(), "the case names other files",
                         "a step problem holds none: give waves instead of records, and stones instead of meshes");
    }
    return text;
}

std::vector<StoredStep> problems_of(const TakeArguments& arguments, const Case& the_case)
{
    State state = initial_state(the_case.model);
    RunPosition position = start_position(the_case.model, the_case.stages, state);
    State start = state;
    begin_stage(the_case.model, 0, start);
    Taker taker(arguments, the_case, std::move(start), position.report.energy);
    RunObserver observer;
    observer.step = [&](const State& after, const StepReport& step, const RunReport& report) {
        taker.note_step(after, step, report);
    };
    observer.save = [&](const State&, const RunPosition& at) { taker.note_position(at); };
    observer.stop = [&] { return taker.has_enough(); };
    run(the_case.model, the_case.stages, state, observer, std::move(position));
    return std::move(taker.problems);
}

}  // namespace

Corpus take(const TakeArguments& arguments)
{
    TakeArguments named = arguments;
    if (named.name.empty()) named.name = arguments.file.stem().string();
    Corpus corpus;
    corpus.cases.push_back(text_of(arguments));
    Case the_case = read(corpus.cases.front());
    for (Stage& stage : the_case.stages) stage.control.threads = 1;
    corpus.problems = problems_of(named, the_case);
    return corpus;
}

}  // namespace voussoir::app::problems
