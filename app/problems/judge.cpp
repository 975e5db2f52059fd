#include "app/problems/judge.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <numeric>

#include "libdda/analysis/energies.h"
#include "libdda/step/advance.h"

namespace voussoir::app::problems
{

namespace
{

constexpr int patience_at_rest = 3;       // times the iterations of a step in time, as the static driver has it
constexpr double closely = 0.01;          // times the tolerance
constexpr double most_not_unique = 0.05;  // of all problems

double cpu_time()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

std::string_view words_of(Trouble trouble)
{
    switch (trouble) {
        case Trouble::none:
            return "it came upon contacts that it did not know";
        case Trouble::inverted_block:
            return "a block turned inside out";
        case Trouble::singular_system:
            return "the linear system is singular";
        case Trouble::inaccurate_solution:
            return "the linear solution leads uphill";
        case Trouble::chatter:
            break;
    }
    return "its iterations were used up";
}

std::string failure_of(const char* who, const MadeStep& step)
{
    return fmt::format("{}: {}, {:.2g} of a load unbalanced", who, words_of(step.report.trouble),
                       step.report.unbalanced);
}

std::string faults_of(const Model& model, const Stage& stage, const State& before, const MadeStep& fast,
                      const MadeStep& plain)
{
    const auto fault = [&](const char* who, const MadeStep& step) {
        const std::string found = fault_of(model, stage, before, step);
        return found.empty() ? found : std::string(who) + ": " + found;
    };
    const std::string of_fast = fault("fast", fast), of_plain = fault("plain", plain);
    return of_fast + (of_fast.empty() || of_plain.empty() ? "" : "; ") + of_plain;
}

void settle(const Model& model, const Stage& stage, const State& before, const MadeStep& fast,
            const MadeStep& plain, Judgement& found)
{
    if (!plain.holds()) {
        found.verdict = Verdict::plain_failed;
        found.why = failure_of("plain", plain) + (fast.holds() ? "" : "; " + failure_of("fast", fast));
        return;
    }
    if (!fast.holds()) {
        found.verdict = Verdict::fast_failed;
        found.why = failure_of("fast", fast);
        return;
    }
    found.difference = difference_between(model, stage, plain.report.time_step, plain.state, fast.state);
    const bool one_length = fast.report.time_step == plain.report.time_step;
    if (one_length && found.difference.worst <= most_difference) return;
    found.why = one_length ? faults_of(model, stage, before, fast, plain) : "steps of different length";
    found.verdict = found.why.empty() ? Verdict::not_unique : Verdict::wrong;
}

/// By the laws alone.
void settle_alone(const Model& model, const Stage& stage, const State& before, const MadeStep& fast,
                  Judgement& found)
{
    if (!fast.holds()) {
        found.verdict = Verdict::fast_failed;
        found.why = failure_of("fast", fast);
        return;
    }
    found.why = fault_of(model, stage, before, fast);
    found.verdict = found.why.empty() ? Verdict::lawful : Verdict::wrong;
}

Judgement begun(const Case& the_case, const StoredStep& problem, const MadeStep& fast)
{
    Judgement found;
    found.name = problem.name;
    found.blocks = static_cast<int>(the_case.model.blocks.size());
    found.tags = problem.tags;
    found.fast = fast.report;
    found.fast_seconds = fast.seconds;
    return found;
}

}  // namespace

std::string_view name_of(Verdict verdict)
{
    switch (verdict) {
        case Verdict::same:
            return "the same";
        case Verdict::not_unique:
            return "not unique";
        case Verdict::plain_failed:
            return "plain failed";
        case Verdict::fast_failed:
            return "fast failed";
        case Verdict::wrong:
            return "WRONG";
        case Verdict::lawful:
            break;
    }
    return "lawful";
}

MadeStep make_step(const Case& the_case, Stage stage, const StoredStep& problem, OpenClose open_close)
{
    stage.control.open_close = open_close;
    if (open_close == OpenClose::plain)
        stage.control.max_open_close = plain_open_close;
    else if (stage.type == StageType::static_equilibrium)
        stage.control.max_open_close *= patience_at_rest;
    stage.control.min_time_step = problem.time_step;  // no second attempt, by a shorter step
    MadeStep step;
    step.state = problem.state;
    step.energy = open_ledger(the_case.model, problem.state);
    Workspace work(the_case.model);
    const double start = cpu_time();
    step.report = advance(the_case.model, stage, problem.time_step, step.state, step.energy, work);
    step.seconds = cpu_time() - start;
    return step;
}

Judgement compare(const Case& the_case, const Stage& stage, const StoredStep& problem, const MadeStep& fast,
                  const MadeStep& plain)
{
    Judgement found = begun(the_case, problem, fast);
    found.plain = plain.report;
    found.plain_seconds = plain.seconds;
    settle(the_case.model, stage, problem.state, fast, plain, found);
    return found;
}

namespace
{

/// Of steps that are solved more closely, in units of what the stage tolerates; nothing when they cannot be made.
std::optional<double> difference_when_closer(const Case& the_case, const Stage& stage, const StoredStep& problem)
{
    Stage close = stage;
    close.control.force_tolerance *= closely;
    const MadeStep fast = make_step(the_case, close, problem, OpenClose::newton),
                   plain = make_step(the_case, close, problem, OpenClose::plain);
    if (!fast.holds() || !plain.holds()) return std::nullopt;
    return difference_between(the_case.model, stage, plain.report.time_step, plain.state, fast.state).worst;
}

}  // namespace

Judgement judge(const Case& the_case, const StoredStep& problem, const JudgeOptions& options)
{
    Stage stage = stage_of(problem, the_case);
    if (options.iterations > 0) stage.control.max_open_close = options.iterations;
    const MadeStep fast = make_step(the_case, stage, problem, OpenClose::newton);
    const int blocks = static_cast<int>(the_case.model.blocks.size());
    if (options.large_from == 0 || blocks < options.large_from) {
        Judgement both =
            compare(the_case, stage, problem, fast, make_step(the_case, stage, problem, OpenClose::plain));
        if (both.verdict != Verdict::not_unique) return both;
        both.closer = difference_when_closer(the_case, stage, problem);
        if (both.closer && *both.closer <= most_difference) both.verdict = Verdict::same;
        return both;
    }
    Judgement found = begun(the_case, problem, fast);
    settle_alone(the_case.model, stage, problem.state, fast, found);
    return found;
}

int fast_iterations(const std::vector<Judgement>& judgements)
{
    return std::accumulate(judgements.begin(), judgements.end(), 0,
                           [](int sum, const Judgement& each) { return sum + each.fast.open_close_iterations; });
}

bool passes(const std::vector<Judgement>& judgements, const JudgeOptions& options)
{
    const auto count = [&](Verdict verdict) {
        return std::count_if(judgements.begin(), judgements.end(),
                             [&](const Judgement& each) { return each.verdict == verdict; });
    };
    if (options.most_in_all > 0 && fast_iterations(judgements) > options.most_in_all) return false;
    const double most = options.most_not_unique >= 0 ? options.most_not_unique
                                                     : most_not_unique * static_cast<double>(judgements.size());
    return count(Verdict::wrong) == 0 && count(Verdict::fast_failed) == 0 &&
           static_cast<double>(count(Verdict::not_unique)) <= most;
}

}  // namespace voussoir::app::problems
