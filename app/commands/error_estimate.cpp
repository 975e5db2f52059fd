#include "app/commands/error_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/commands/interrupt.h"
#include "app/commands/say.h"
#include "app/results/histories.h"
#include "app/results/scene_vectors.h"
#include "app/studies/converge/setting.h"
#include "app/words/diagnosis_words.h"
#include "libdda/analysis/ground.h"
#include "libdda/run/run.h"

namespace voussoir::app::commands
{
namespace
{

/// A case beside, and what it is.
struct Beside {
    std::string name, key;
    Case the_case;
};

/// A dissipation that is not given follows the step by itself.
/// @param shortest of the run, where its steps became shorter [s]
void halve_step(double shortest, StepControl& control)
{
    control.time_step = 0.5 * std::min(shortest, control.time_step);
    control.automatic = false;
    control.step_error = studies::converge::scaled_step_error(control.step_error, 0.5);
    control.min_time_step = std::min(control.min_time_step, control.time_step);
}

std::vector<Beside> cases_beside(const Case& the_case, const RunReport& report)
{
    std::vector<Beside> all;
    const auto is_dynamic = [](const Stage& stage) { return stage.type == StageType::dynamic; };
    if (std::any_of(the_case.stages.begin(), the_case.stages.end(), is_dynamic)) {
        all.push_back({"half the time step", "half_step", the_case});
        double shortest = std::numeric_limits<double>::infinity();
        for (const ShorterSteps& shorter : report.shorter_steps) shortest = std::min(shortest, shorter.time_step);
        for (Stage& stage : all.back().the_case.stages)
            if (is_dynamic(stage)) halve_step(shortest, stage.control);
    }
    // A measured stiffness is no error of the computation.
    const auto follows_rule = [](const JointMaterial& joint) {
        return joint.stiffness.kind != ContactStiffness::Kind::per_area;
    };
    const std::vector<JointMaterial>& joints = the_case.model.joints;
    if (std::any_of(joints.begin(), joints.end(), follows_rule)) {
        all.push_back({"twice the stiffness", "twice_stiffness", the_case});
        for (JointMaterial& joint : all.back().the_case.model.joints)
            if (follows_rule(joint)) joint.stiffness.factor *= 2;
    }
    return all;
}

void tell(const std::string& what, bool quiet)
{
    if (quiet) return;
    say(fmt::format("error estimate: {}", what));
    std::fflush(stdout);
}

/// @returns none when the user interrupts
std::optional<RecordedRun> run_beside(const Case& the_case)
{
    RecordedRun beside{HistoryRecorder(the_case), initial_state(the_case.model), {}};
    RunObserver observer;
    observer.every = the_case.output.every;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) { beside.histories.step(now); };
    observer.stop = interrupted;
    beside.report = run(the_case.model, the_case.stages, beside.state, observer);
    if (beside.report.outcome == Outcome::interrupted) return std::nullopt;
    return beside;
}

/// Between the steps that a run took; none outside them.
std::optional<double> value_at(double time, const std::vector<double>& times, const std::vector<double>& values)
{
    if (times.empty() || time < times.front() || time > times.back()) return std::nullopt;
    const auto next = std::lower_bound(times.begin(), times.end(), time);
    const auto i = static_cast<std::size_t>(next - times.begin());
    if (*next == time || i == 0) return values[i];
    const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
    return values[i - 1] + share * (values[i] - values[i - 1]);
}

double largest_size(const std::vector<double>& values)
{
    double most = 0;
    for (const double value : values) most = std::max(most, std::abs(value));
    return most;
}

/// Of one history, at the times of the run itself.
double largest_difference(const HistoryRecorder& own, const HistoryRecorder& other, std::size_t column)
{
    double most = 0;
    for (std::size_t i = 0; i < own.times.size(); ++i)
        if (const auto value = value_at(own.times[i], other.times, other.columns[column]))
            most = std::max(most, std::abs(*value - own.columns[column][i]));
    return most;
}

/// A figure of a whole run.
struct Result {
    std::string name, unit;
    double value = 0;
};

std::vector<Result> results_of(const Model& model, const RecordedRun& of)
{
    double opening = 0, slip = 0, moved = 0;
    for (const JointPeaks& joint : of.report.joints) {
        opening = std::max(opening, joint.opening);
        slip = std::max(slip, joint.slip);
    }
    const std::vector<bool> is_ground = ground_marks(model);
    for (std::size_t b = 0; b < is_ground.size(); ++b) {
        if (is_ground[b]) continue;
        const bool is_judged = of.report.verdict.has_value();  // else nothing can stand: there is no foot
        moved =
            std::max(moved, is_judged ? of.report.verdict->blocks[b].displacement
                                      : displacement_of(model, of.state, {static_cast<int>(b), {0, 0, 0}}).norm());
    }
    return {{"largest opening of a joint", "m", opening},
            {"largest slip of a joint", "m", slip},
            {"largest displacement at the end", "m", moved},
            {"energy put in", "J", of.report.energy.input()},
            {"energy lost to friction", "J", of.report.energy.friction}};
}

std::string outcome_of(const RecordedRun& of, const Case& the_case)
{
    const std::string message = words::message_of(of.report, the_case.model, the_case.stages);
    return std::string(name_of(of.report.outcome)) + (message.empty() ? "" : ": " + message);
}

void compare(const RecordedRun& own, const RecordedRun& other, const Model& model,
             results::ErrorEstimate& estimate)
{
    std::size_t row = 0;
    for (; row < own.histories.columns.size(); ++row)
        estimate.quantities[row].differences.push_back(largest_difference(own.histories, other.histories, row));
    const std::vector<Result> mine = results_of(model, own), its = results_of(model, other);
    for (std::size_t i = 0; i < mine.size(); ++i, ++row)
        estimate.quantities[row].differences.push_back(std::abs(its[i].value - mine[i].value));
}

results::ErrorEstimate quantities_of(const RecordedRun& own, const Model& model)
{
    results::ErrorEstimate estimate;
    for (std::size_t i = 0; i < own.histories.columns.size(); ++i)
        estimate.quantities.push_back(
            {own.histories.names[i], own.histories.units[i], largest_size(own.histories.columns[i]), {}});
    for (const Result& result : results_of(model, own))
        estimate.quantities.push_back({result.name, result.unit, std::abs(result.value), {}});
    return estimate;
}

}  // namespace

HistoryRecorder::HistoryRecorder(const Case& the_case) : model_(&the_case.model)
{
    for (const HistoryPoint& point : the_case.output.histories) {
        points_.push_back(results::material_point(*model_, point));
        for (const char* kind : {"u", "v"})
            for (const std::string& axis : results::axis_names(model_->kinematics)) {
                names.push_back(fmt::format("{} {}{}", point.name, kind, axis));
                units.emplace_back(*kind == 'u' ? "m" : "m/s");
            }
    }
    columns.resize(names.size());
}

void HistoryRecorder::step(const State& state)
{
    if (points_.empty() || state.time <= 0) return;
    times.push_back(state.time);
    std::vector<double> line;
    for (const MaterialPoint& point : points_) {
        results::append_vector(line, displacement_of(*model_, state, point), model_->kinematics);
        results::append_vector(line, velocity_of(*model_, state, point), model_->kinematics);
    }
    for (std::size_t i = 0; i < line.size(); ++i) columns[i].push_back(line[i]);
}

std::optional<results::ErrorEstimate> error_of(const Case& the_case, const RecordedRun& own, bool is_complete,
                                               bool quiet)
{
    const Outcome outcome = own.report.outcome;
    if (outcome == Outcome::interrupted || has_no_answer(outcome)) return std::nullopt;
    const auto ran = [&](const std::string& what, const Case& beside) {
        tell(what, quiet);
        std::optional<RecordedRun> other = run_beside(beside);
        if (!other) tell("interrupted, there is none", quiet);
        return other;
    };
    std::optional<RecordedRun> again;
    if (!is_complete) {
        again = ran("the run itself once more, for its histories", the_case);
        if (!again) return std::nullopt;
    }
    const RecordedRun& judged = again ? *again : own;
    results::ErrorEstimate estimate = quantities_of(judged, the_case.model);
    for (const Beside& beside : cases_beside(the_case, judged.report)) {
        const std::optional<RecordedRun> other = ran(beside.name, beside.the_case);
        if (!other) return std::nullopt;
        estimate.runs.push_back({beside.name, beside.key, outcome_of(*other, beside.the_case)});
        compare(judged, *other, the_case.model, estimate);
    }
    return estimate;
}

void print_estimate(const results::ErrorEstimate& estimate, Outcome outcome)
{
    say_part(fmt::format("error estimate, largest differences{:>9}", ""));
    for (const results::RunBeside& run : estimate.runs) say_part(fmt::format("  {:>21}", run.name));
    say("");
    for (const results::ComparedQuantity& quantity : estimate.quantities) {
        say_part(fmt::format("  {:<31} {:>9.3g} {:<3}", quantity.name, quantity.size, quantity.unit));
        for (const double difference : quantity.differences)
            say_part(fmt::format("  {:>10.3g} ({:>6.3g} %)", difference,
                                 quantity.size > 0 ? 100 * difference / quantity.size : 0.0));
        say("");
    }
    for (const std::string& doubt : results::doubts_of(estimate, outcome))
        say(fmt::format("  warning: {}", doubt));
}

}  // namespace voussoir::app::commands
