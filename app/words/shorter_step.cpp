#include "app/words/shorter_step.h"

#include <fmt/format.h>

#include <cmath>

namespace voussoir::app::words
{

double rounded_down(double value)
{
    const double unit = std::pow(10, std::floor(std::log10(value)));
    return unit * std::floor(value / unit + 1e-9);
}

std::string shorter_step(const Stage& stage, double factor)
{
    const StepControl& control = stage.control;
    if (control.step_error > 0)
        return fmt::format("step_error: {:g} mm", 1e3 * rounded_down(control.step_error * std::pow(factor, 3)));
    return fmt::format("time_step: {:g} ms", 1e3 * rounded_down(control.time_step * factor));
}

const Stage* longest_step(const std::vector<Stage>& stages)
{
    const Stage* longest = nullptr;
    for (const Stage& stage : stages) {
        if (stage.type != StageType::dynamic) continue;
        if (!longest || stage.control.time_step > longest->control.time_step) longest = &stage;
    }
    return longest || stages.empty() ? longest : &stages.front();
}

}  // namespace voussoir::app::words
