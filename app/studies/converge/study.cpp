#include "app/studies/converge/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "app/studies/converge/sample.h"
#include "libdda/errors.h"

namespace voussoir::app::studies::converge
{
namespace
{

std::size_t index_of(const ConvergeSetting& setting, std::vector<ConvergeSetting>& settings)
{
    const auto found = std::find(settings.begin(), settings.end(), setting);
    if (found != settings.end()) return found - settings.begin();
    settings.push_back(setting);
    return settings.size() - 1;
}

std::string in_words(const CollapseRule& rule)
{
    if (rule.length)
        return fmt::format("a block has moved more than {:g} m relative to the foot of the structure",
                           *rule.length);
    if (rule.sizes)
        return fmt::format("a block has moved more than {:g} x its size relative to the foot of the structure",
                           *rule.sizes);
    return "never";
}

/// The runs of one series, and what of them can be compared.
struct RunsOfSeries {
    std::vector<const MeasuredRun*> runs;  // coarse to fine
    const MeasuredRun* first_collapse = nullptr;
    std::vector<double> times;  // s, common to all that did not fail: of the coarsest, up to the first collapse
};

RunsOfSeries runs_of(const SeriesPlan& plan, const std::vector<MeasuredRun>& all)
{
    RunsOfSeries result;
    const MeasuredRun* coarsest = nullptr;
    for (const std::size_t index : plan.settings) {
        const MeasuredRun& run = all[index];
        result.runs.push_back(&run);
        if (!run.failure.empty()) continue;
        if (!coarsest) coarsest = &run;
        const bool earlier =
            run.collapse && (!result.first_collapse || run.collapse->time < result.first_collapse->collapse->time);
        if (earlier) result.first_collapse = &run;
    }
    if (!coarsest) return result;
    result.times = coarsest->recording.times;
    const double end = result.first_collapse ? result.first_collapse->collapse->time : result.times.back();
    std::erase_if(result.times, [&](double time) { return time > end; });
    return result;
}

std::string collapse_note(const RunsOfSeries& runs)
{
    const auto collapsed = std::count_if(runs.runs.begin(), runs.runs.end(),
                                         [](const auto* run) { return run->collapse.has_value(); });
    const Collapse& first = *runs.first_collapse->collapse;
    std::string text = fmt::format(
        "compared until t = {:.4g} s, when block '{}' is the first to collapse (criterion: "
        "--collapse-displacement)",
        first.time, first.block);
    if (collapsed < static_cast<std::ptrdiff_t>(runs.runs.size()))
        text +=
            fmt::format("; only {} of {} runs collapse: the case is near its threshold, which --threshold finds",
                        collapsed, runs.runs.size());
    return text;
}

/// Are the runs of the series to be compared by this quantity?
bool comparable(const Quantity& quantity, const RunsOfSeries& runs)
{
    const bool moves = !runs.times.empty() && runs.times.back() > 0;
    return moves && !(runs.first_collapse && quantity.measure == Measure::end);
}

// A component below this share of its vector is rounding.
constexpr double rounding = 1e-9;

/// Is a component nothing but rounding, in all runs?
bool rests(const Quantity& quantity, const std::vector<const MeasuredRun*>& runs,
           const std::vector<std::optional<Sample>>& samples)
{
    double size = 0, extent = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (!samples[i]) continue;
        size = std::max(size, size_of(*samples[i]));
        extent = std::max(extent, runs[i]->recording.extents[quantity.channel]);
    }
    return quantity.component >= 0 && extent > 0 && size <= rounding * extent;
}

Series judged(const Case& the_case, const SeriesPlan& plan, const Quantity& quantity, const RunsOfSeries& runs)
{
    Series series;
    series.varied = plan.varied;
    series.integrator = plan.integrator;
    std::vector<std::optional<Sample>> samples;
    for (const MeasuredRun* run : runs.runs) {
        series.rows.push_back(row_of(run->setting, the_case, run->cost, run->failure));
        series.rows.back().collapse = run->collapse;
        samples.emplace_back();
        if (run->failure.empty() && comparable(quantity, runs))
            samples.back() = sample_of(quantity, run->recording, runs.times);
    }
    if (runs.first_collapse) series.notes.push_back(collapse_note(runs));
    const bool resting = rests(quantity, runs.runs, samples);
    if (resting) samples.assign(samples.size(), std::nullopt);
    judge(series, samples, 0, [&](const Sample& sample) { return value_of(quantity, sample); });
    if (resting) series.no_order = fmt::format("it does not move along {}", "xyz"[quantity.component]);
    if (runs.first_collapse && quantity.measure == Measure::end)
        series.no_order = "end states are not compared: the structure collapses";
    return series;
}

QuantityStudy study_of(const Case& the_case, const std::vector<SeriesPlan>& plans,
                       const std::vector<MeasuredRun>& runs, const Quantity& quantity)
{
    QuantityStudy study{name_of(quantity, the_case), unit_of(quantity), {}, {}};
    for (const SeriesPlan& plan : plans)
        study.series.push_back(judged(the_case, plan, quantity, runs_of(plan, runs)));
    return study;
}

/// A measure that has to be looked at too, and why.
struct Addition {
    Measure measure;
    std::string reason;
};

/// What stands in for a quantity that cannot be compared as it is.
std::vector<Addition> additions_to(const QuantityStudy& study, Measure measure)
{
    for (const Series& series : study.series) {
        const bool collapses = std::any_of(series.rows.begin(), series.rows.end(),
                                           [](const SeriesRow& row) { return row.collapse.has_value(); });
        if (measure == Measure::end && collapses)
            return {{Measure::peak,
                     fmt::format("peak before the collapse, in place of {}, which is not compared", study.name)}};
        const auto compared = std::count_if(series.rows.begin(), series.rows.end(),
                                            [](const SeriesRow& row) { return row.value.has_value(); });
        const bool parts =
            series.varied == Varied::time_step && compared >= 3 && !series.order && !series.vanishes;
        if (measure != Measure::history || !parts || cheapest(series, tolerances[1])) continue;
        const std::string why =
            fmt::format("the histories of {} do not converge point by point: their ", study.name);
        std::vector<Addition> added{{Measure::peak, why + "peaks are compared here"}};
        if (!collapses) added.push_back({Measure::end, why + "ends are compared here"});
        return added;
    }
    return {};
}

void warn_of_factor_damping(const Case& the_case, ConvergeStudy& study)
{
    for (const Stage& stage : the_case.stages)
        if (stage.type == StageType::dynamic && stage.damping.factor_per_step != 1)
            study.notes.push_back(fmt::format(
                "stage '{}' has damping by a factor per step: its results depend on the time step by definition",
                stage.name));
}

}  // namespace

SettingList list_settings(const ConvergePlan& plan)
{
    SettingList list;
    for (const Integrator integrator : plan.integrators) {
        SeriesPlan series{Varied::time_step, integrator, {}};
        if (plan.step_factors.size() < 2 && (plan.compares || plan.stiffness_factors.size() > 1)) break;
        for (const double factor : plan.step_factors)
            series.settings.push_back(index_of({integrator, factor, 1}, list.settings));
        list.series.push_back(series);
    }
    if (plan.stiffness_factors.size() > 1) {
        SeriesPlan series{Varied::stiffness, plan.integrators.front(), {}};
        for (const double factor : plan.stiffness_factors)
            series.settings.push_back(index_of({plan.integrators.front(), 1, factor}, list.settings));
        list.series.push_back(series);
    }
    if (list.series.empty())
        throw InputError("converge", "with one time step and one stiffness there is nothing to compare",
                         "give two or more --time-steps or --stiffness-factors");
    return list;
}

ConvergeStudy begin_study(const Case& the_case, const CollapseRule& rule)
{
    ConvergeStudy study;
    study.case_file = the_case.file.string();
    study.title = the_case.title;
    study.overrides = the_case.overrides;
    study.collapse_rule = in_words(rule);
    study.threads = leading_stage(the_case).control.threads;
    for (std::size_t s = 0; s < the_case.stages.size(); ++s) {
        const Stage& stage = the_case.stages[s];
        if (stage.type == StageType::dynamic)
            study.stages.push_back({static_cast<int>(s), stage.name, stage.control.time_step,
                                    stage.control.step_error, stage.control.integrator});
    }
    for (const JointMaterial& joint : the_case.model.joints)
        study.joints.push_back(
            {joint.name, joint.stiffness.factor, joint.friction_angle * 180 / std::numbers::pi});
    study.may_be_ensemble = !the_case.output.histories.empty();
    warn_of_factor_damping(the_case, study);
    return study;
}

SeriesRow row_of(const ConvergeSetting& setting, const Case& the_case, const RunCost& cost,
                 const std::string& failure)
{
    SeriesRow row;
    row.setting = setting;
    row.time_step = setting.step_factor * leading_stage(the_case).control.time_step;
    row.cost = cost;
    row.failure = failure;
    return row;
}

ConvergeStudy run_study(const Case& the_case, const SettingList& list, const std::vector<Quantity>& quantities,
                        const CollapseRule& rule, const ConvergeWatch& watch)
{
    std::vector<MeasuredRun> runs;
    for (const ConvergeSetting& setting : list.settings) {
        runs.push_back(run_setting(the_case, setting, quantities, rule, watch));
        if (runs.back().failure.empty()) runs.back().failure = runs.back().no_rest;  // nothing to compare
    }
    ConvergeStudy study = begin_study(the_case, rule);
    for (const Quantity& quantity : quantities) {
        study.quantities.push_back(study_of(the_case, list.series, runs, quantity));
        for (const Addition& addition : additions_to(study.quantities.back(), quantity.measure)) {
            Quantity other = quantity;
            other.measure = addition.measure;
            const std::string name = name_of(other, the_case);
            const auto asked = [&](const Quantity& each) { return name_of(each, the_case) == name; };
            const auto there = [&](const QuantityStudy& each) { return each.name == name; };
            if (std::any_of(quantities.begin(), quantities.end(), asked) ||
                std::any_of(study.quantities.begin(), study.quantities.end(), there))
                continue;
            study.quantities.push_back(study_of(the_case, list.series, runs, other));
            study.quantities.back().added = addition.reason;
        }
    }
    return study;
}

}  // namespace voussoir::app::studies::converge
