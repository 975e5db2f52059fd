#include "app/reader/automatic_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "libdda/analysis/longest_step.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double fewest_steps = 50;  // of a stage

/// The longest part of `whole` that is no longer than `step`.
double part_of(double whole, double step)
{
    return whole / std::ceil(whole / step - 1e-9);
}

}  // namespace

double most_work_of_modes(const Case& the_case)
{
    if (the_case.output.trust == TrustFigures::always) return std::numeric_limits<double>::max();
    return work_worth_the_modes(the_case.model, the_case.stages);
}

void choose_time_steps(Case& the_case, Findings& findings)
{
    std::optional<NaturalModes> modes;
    for (std::size_t s = 0; s < the_case.stages.size(); ++s) {
        Stage& stage = the_case.stages[s];
        StepControl& control = stage.control;
        if (!control.automatic) continue;
        if (!modes) {
            ModesSearch search;
            search.most_work = most_work_of_modes(the_case);
            modes = natural_modes(the_case.model, initial_state(the_case.model), search);
        }
        double step = std::min(longest_step(*modes, stage), stage.duration / fewest_steps);
        if (the_case.output.every > 0) step = part_of(the_case.output.every, step);
        control.time_step = std::max(step, control.min_time_step);
        findings.defaults.push_back(
            {fmt::format("stages[{}]", s), "time_step", fmt::format("auto, {:.4g} s", control.time_step)});
    }
}

}  // namespace voussoir::app::reader
