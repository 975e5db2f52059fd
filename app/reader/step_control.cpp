#include "app/reader/step_control.h"

#include <fmt/core.h>

#include <optional>

namespace voussoir::app::reader
{
namespace
{

// A static step has no inertia to resolve: it only scales the inertia that guides the iteration.
constexpr double static_time_step = 1;  // s
// Resolves 25 Hz with 20 steps a period, above what shakes masonry.
constexpr double dynamic_time_step = 2e-3;  // s
// Shi's six passes; his scheme does not improve with more.
constexpr int published_open_close = 6;

void read_integrator(YamlCursor& stage, StepControl& control)
{
    control.integrator = stage.choice_or<Integrator>(
        "integrator", {{"newmark", Integrator::newmark}, {"energy_decaying", Integrator::energy_decaying}},
        control.integrator);
    if (control.integrator == Integrator::newmark) {
        for (const char* key : {"dissipation", "step_error"})
            stage.forbid(key, "it belongs to integrator: energy_decaying");
        return;
    }
    control.dissipation = stage.find_quantity("dissipation", words::dimension::number, {0, 1, true, true});
    control.step_error =
        stage.find_quantity("step_error", words::dimension::length, words::Range::positive()).value_or(0);
}

void read_open_close(YamlCursor& stage, StepControl& control)
{
    control.open_close = stage.choice_or<OpenClose>(
        "open_close",
        {{"newton", OpenClose::newton}, {"plain", OpenClose::plain}, {"published", OpenClose::published}},
        control.open_close);
    if (control.open_close == OpenClose::published) {
        for (const char* key : {"max_open_close", "force_tolerance"})
            stage.forbid(key, "the published iteration has six passes and no force tolerance");
        control.max_open_close = published_open_close;
        control.integrator = Integrator::newmark;
        return;
    }
    if (control.open_close == OpenClose::plain) control.max_open_close = plain_open_close;
    control.max_open_close = stage.integer_or("max_open_close", 1, 100'000, control.max_open_close);
    control.force_tolerance = stage.quantity_or("force_tolerance", words::dimension::number, {0, 1, false, false},
                                                control.force_tolerance);
}

/// A step that is left to the program is chosen when the whole case has been read.
void read_time_step(YamlCursor& stage, bool is_static, StepControl& control)
{
    const std::optional<YamlCursor> given = stage.find("time_step");
    const bool is_auto = given && given->is_scalar() && given->as_text() == "auto";
    control.time_step = is_static ? static_time_step : dynamic_time_step;
    control.automatic = !is_static && (!given || is_auto);
    if (is_auto && is_static)
        given->fault("auto in a static stage", "its step is no time: leave it out, or give one such as 1 s");
    else if (is_static || !control.automatic)
        control.time_step =
            stage.quantity_or("time_step", words::dimension::time, words::Range::positive(), control.time_step);
}

/// Shi's iteration is for comparison: its steps are what they are told to be.
void read_published_step(YamlCursor& stage, StepControl& control)
{
    if (control.automatic && stage.find("time_step"))
        stage.fault("time_step: auto with open_close: published", "give a step such as 0.1 ms");
    else if (control.automatic)
        stage.took_default("time_step", fmt::format("{:g} s", control.time_step));
    control.automatic = false;
}

/// What only dynamic stages have.
void read_motion_control(YamlCursor& stage, StepControl& control)
{
    if (control.open_close == OpenClose::published) {
        for (const char* key : {"integrator", "dissipation", "step_error", "divide_up_to_blocks"})
            stage.forbid(key, "the published iteration has the integrator newmark and undivided steps");
        return;
    }
    read_integrator(stage, control);
    control.divide_up_to_blocks =
        stage.integer_or("divide_up_to_blocks", 0, 1'000'000'000, control.divide_up_to_blocks);
}

}  // namespace

StepControl read_step_control(YamlCursor& stage, StageType type)
{
    StepControl control;
    const bool is_static = type == StageType::static_equilibrium;
    read_time_step(stage, is_static, control);
    control.min_time_step = stage.quantity_or("min_time_step", words::dimension::time, words::Range::positive(),
                                              control.min_time_step);
    if (control.min_time_step > control.time_step)
        stage.fault("min_time_step exceeds time_step", "it must be the smaller one");
    read_open_close(stage, control);
    if (control.is_published()) read_published_step(stage, control);
    if (!is_static) read_motion_control(stage, control);
    using Kind = LinearSolverKind;
    control.linear_solver = stage.choice_or<Kind>("linear_solver",
                                                  {{"automatic", Kind::automatic},
                                                   {"cholmod", Kind::cholmod},
                                                   {"conjugate_gradients", Kind::conjugate_gradients}},
                                                  control.linear_solver);
    control.linear_tolerance = stage.quantity_or("linear_tolerance", words::dimension::number,
                                                 {0, 1, false, false}, control.linear_tolerance);
    return control;
}

}  // namespace voussoir::app::reader
