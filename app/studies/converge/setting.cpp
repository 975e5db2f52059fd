#include "app/studies/converge/setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "app/results/settings.h"
#include "app/words/nearest_word.h"
#include "app/words/quantity.h"
#include "libdda/errors.h"

namespace voussoir::app::studies::converge
{
namespace
{

constexpr double default_step_factors[] = {4, 2, 1, 0.5, 0.25};
constexpr double default_stiffness_factors[] = {0.25, 0.5, 1, 2, 4};
// Of thresholds, which take some ten runs each: three steps show an order, two stiffnesses a sensitivity.
constexpr double threshold_step_factors[] = {2, 1, 0.5};
constexpr double threshold_stiffness_factors[] = {1, 2};

// Shares by which a step may miss a limit: a factor times a step is rounded.
constexpr double slack = 1e-9;

/// A value that is not positive or comes twice is a fault.
/// @param texts (factors) as they were given
void check(const std::vector<double>& factors, const std::vector<std::string>& texts, const std::string& option,
           std::vector<Fault>& faults)
{
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (!std::isfinite(factors[i]) || factors[i] <= 0)
            faults.push_back({option, texts[i], "give positive numbers"});
        if (std::count(factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>(i), factors[i]) > 0)
            faults.push_back({option, texts[i] + " is given twice", "give each once"});
    }
}

/// Why the time steps cannot be run with a factor; empty when they can.
std::string why_not_run(const Case& the_case, double factor)
{
    for (const Stage& stage : the_case.stages) {
        if (stage.type != StageType::dynamic) continue;
        const double step = factor * stage.control.time_step;
        if (step > stage.duration * (1 + slack))
            return fmt::format("longer than stage '{}', which lasts {:g} s", stage.name, stage.duration);
        if (step < stage.control.min_time_step * (1 - slack))
            return fmt::format("below min_time_step of stage '{}', {:g} s", stage.name,
                               stage.control.min_time_step);
    }
    return {};
}

/// The default series as far as it can be run; a note of every step that is left out.
std::vector<double> default_steps(const Case& the_case, bool of_threshold, std::vector<std::string>& notes)
{
    std::vector<double> factors;
    const std::span<const double> tried =
        of_threshold ? std::span<const double>(threshold_step_factors) : default_step_factors;
    for (const double factor : tried) {
        const std::string problem = why_not_run(the_case, factor);
        if (problem.empty())
            factors.push_back(factor);
        else
            notes.push_back(fmt::format("{} x the time step is left out: {}", factor, problem));
    }
    return factors;
}

std::vector<double> read_steps(const std::vector<std::string>& texts, const Case& the_case,
                               std::vector<Fault>& faults)
{
    const double own = first_dynamic_stage(the_case).control.time_step;
    std::vector<double> factors;
    std::vector<std::string> read;
    for (const std::string& text : texts) {
        const words::ParsedQuantity quantity = words::parse_quantity(text);
        if (quantity.problem.empty() && (quantity.bare || quantity.has(words::dimension::time))) {
            factors.push_back(quantity.value / own);
            read.push_back(text);
        } else
            faults.push_back(
                {"--time-steps", "\"" + text + "\" is not a time", "write 2 ms, or 0.002 in seconds"});
    }
    check(factors, read, "--time-steps", faults);
    for (std::size_t i = 0; i < factors.size(); ++i)
        if (const std::string problem = why_not_run(the_case, factors[i]); factors[i] > 0 && !problem.empty())
            faults.push_back({"--time-steps", read[i] + " is " + problem, "omit it"});
    return factors;
}

std::vector<double> read_stiffness(const std::vector<double>& given, bool of_threshold, std::vector<Fault>& faults)
{
    if (given.empty() && of_threshold)
        return {std::begin(threshold_stiffness_factors), std::end(threshold_stiffness_factors)};
    if (given.empty()) return {std::begin(default_stiffness_factors), std::end(default_stiffness_factors)};
    std::vector<std::string> texts;
    for (const double factor : given) texts.push_back(fmt::format("{}", factor));
    check(given, texts, "--stiffness-factors", faults);
    return given;
}

/// The case's own, and beside it those that are named; energy_decaying if none is, unless there is no choice.
std::vector<Integrator> read_integrators(const std::vector<std::string>& names, const StepControl& control,
                                         bool of_threshold, std::vector<Fault>& faults)
{
    const Integrator own = control.integrator;
    std::vector<Integrator> integrators{own};
    const bool is_free = control.open_close != OpenClose::published && !of_threshold;
    if (names.empty() && is_free && own != Integrator::energy_decaying)
        integrators.push_back(Integrator::energy_decaying);
    std::vector<std::string> known;
    for (const Integrator each : {Integrator::newmark, Integrator::energy_decaying}) {
        known.emplace_back(results::name_of(each));
        if (each != own && std::find(names.begin(), names.end(), known.back()) != names.end())
            integrators.push_back(each);
    }
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            faults.push_back({"--integrators", "\"" + name + "\"", words::suggestion(name, known)});
    return integrators;
}

}  // namespace

const Stage& first_dynamic_stage(const Case& the_case)
{
    for (const Stage& stage : the_case.stages)
        if (stage.type == StageType::dynamic) return stage;
    throw InputError(the_case.file.string() + ": stages", "none is dynamic",
                     "converge varies the time step of dynamic stages: add one, or look for a --threshold");
}

const Stage& leading_stage(const Case& the_case)
{
    for (const Stage& stage : the_case.stages)
        if (stage.type == StageType::dynamic) return stage;
    return the_case.stages.front();
}

ConvergePlan plan_of(const ConvergeChoices& choices, const Case& the_case)
{
    const bool of_threshold = choices.of_threshold;
    const Stage& leading = of_threshold ? leading_stage(the_case) : first_dynamic_stage(the_case);
    const bool has_steps = leading.type == StageType::dynamic;
    std::vector<Fault> faults;
    ConvergePlan plan;
    plan.compares = !of_threshold;
    plan.integrators = read_integrators(choices.integrators, leading.control, of_threshold, faults);
    if (!has_steps)
        plan.step_factors = {1};
    else
        plan.step_factors = choices.time_steps.empty() ? default_steps(the_case, of_threshold, plan.notes)
                                                       : read_steps(choices.time_steps, the_case, faults);
    if (!has_steps && !choices.time_steps.empty())
        faults.push_back({"--time-steps", "the case has no dynamic stage", "omit it: there is none to vary"});
    plan.stiffness_factors = read_stiffness(choices.stiffness_factors, of_threshold, faults);
    if (!faults.empty()) throw InputError(std::move(faults));
    std::sort(plan.step_factors.begin(), plan.step_factors.end(), std::greater<>());
    std::sort(plan.stiffness_factors.begin(), plan.stiffness_factors.end());
    return plan;
}

double scaled_step_error(double step_error, double step_factor)
{
    return step_error * step_factor * step_factor * step_factor;
}

Case with_setting(const Case& the_case, const ConvergeSetting& setting)
{
    Case changed = the_case;
    for (Stage& stage : changed.stages) {
        if (stage.type != StageType::dynamic) continue;
        stage.control.time_step *= setting.step_factor;
        stage.control.automatic = false;  // an order needs steps of one length
        stage.control.step_error = scaled_step_error(stage.control.step_error, setting.step_factor);
        if (stage.control.integrator == setting.integrator) continue;
        stage.control.integrator = setting.integrator;
        stage.control.dissipation = StepControl{}.dissipation;  // that of another integrator says nothing
        stage.control.step_error = 0;                           // and is estimated for energy_decaying alone
    }
    for (JointMaterial& joint : changed.model.joints) joint.stiffness.factor *= setting.stiffness_factor;
    return changed;
}

}  // namespace voussoir::app::studies::converge
