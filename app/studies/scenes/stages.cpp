#include "app/studies/scenes/stages.h"

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

namespace
{

StepControl control_of(const SceneSetting& setting)
{
    StepControl control;
    control.integrator = setting.integrator;
    control.open_close = setting.open_close;
    if (setting.open_close == OpenClose::published) control.max_open_close = 6;
    control.time_step = setting.time_step;
    return control;
}

}  // namespace

Stage static_stage(const SceneSetting& setting, const Eigen::Vector3d& g)
{
    Stage stage;
    stage.name = "self-weight";
    stage.type = StageType::static_equilibrium;
    stage.gravity = g;
    stage.control = control_of(setting);
    stage.control.open_close = OpenClose::newton;  // every method starts from the same rest
    stage.control.max_open_close = StepControl{}.max_open_close;
    stage.control.time_step = 0.1;
    return stage;
}

Stage dynamic_stage(const SceneSetting& setting, double duration, const Eigen::Vector3d& g)
{
    Stage stage;
    stage.name = "motion";
    stage.duration = duration;
    stage.gravity = g;
    stage.control = control_of(setting);
    return stage;
}

}  // namespace voussoir::app::studies::scenes
