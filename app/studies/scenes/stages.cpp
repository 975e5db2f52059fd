#include "app/studies/scenes/stages.h"

#include <cmath>

namespace voussoir::app::studies::scenes
{

Stage rest_stage(double g)
{
    Stage stage;
    stage.name = "self-weight";
    stage.type = StageType::static_equilibrium;
    stage.gravity = {0, 0, -g};
    stage.control.time_step = 0.1;  // static stages take large steps
    return stage;
}

Stage motion_stage(double duration, double time_step, double g)
{
    Stage stage;
    stage.name = "motion";
    stage.duration = duration;
    stage.gravity = {0, 0, -g};
    stage.control.time_step = time_step;
    return stage;
}

// Every method starts from the same rest, found by the Newton iteration.
Stage static_stage(const SceneSetting& setting, const Eigen::Vector3d& g)
{
    Stage stage = rest_stage();
    stage.gravity = g;
    stage.control.integrator = setting.integrator;
    return stage;
}

Stage dynamic_stage(const SceneSetting& setting, double duration, const Eigen::Vector3d& g)
{
    Stage stage = motion_stage(duration, setting.time_step);
    stage.gravity = g;
    stage.control.integrator = setting.integrator;
    stage.control.open_close = setting.open_close;
    if (setting.open_close == OpenClose::published) stage.control.max_open_close = 6;
    stage.control.step_error = setting.error_rate * std::pow(setting.time_step, 3);
    return stage;
}

}  // namespace voussoir::app::studies::scenes
