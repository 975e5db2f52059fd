#include "app/verify/scenes_dynamic.h"

#include <cmath>
#include <ctime>

#include "app/words/diagnosis_words.h"

namespace voussoir::dynamic_scenes
{

using Eigen::Vector3d;

double default_stiffness(Kinematics kinematics, double compliance)
{
    return 2 * (is_deformable(kinematics) ? 10 : 1) / compliance;
}

ContactStiffness stiffness_by_rule(const VerifySetting& setting, double compliance)
{
    if (!setting.stiffness_factor) return {};
    return {ContactStiffness::Kind::per_area,
            *setting.stiffness_factor * default_stiffness(setting.kinematics, compliance)};
}

namespace
{

StepControl control_of(const VerifySetting& setting)
{
    StepControl control;
    control.integrator = setting.integrator;
    control.open_close = setting.open_close;
    if (setting.open_close == OpenClose::published) control.max_open_close = 6;
    control.time_step = setting.time_step;
    return control;
}

}  // namespace

Stage static_stage(const VerifySetting& setting, const Vector3d& g)
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

Stage dynamic_stage(const VerifySetting& setting, double duration, const Vector3d& g)
{
    Stage stage;
    stage.name = "motion";
    stage.duration = duration;
    stage.gravity = g;
    stage.control = control_of(setting);
    return stage;
}

RunReport run_scene(const Scene& scene, State& state, const RunObserver& observer, VerifyResult& result)
{
    const std::clock_t start = std::clock();
    RunReport report = run(scene.model, scene.stages, state, observer);
    result.cpu_time += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    result.simulated_time += report.simulated_time;
    result.steps += report.steps;
    result.step_cuts += report.step_cuts;
    result.iterations += report.open_close_iterations;
    if (report.outcome == Outcome::gave_up) result.failure = message_of(report, scene.model, scene.stages);
    return report;
}

double lean_of(const Model& model, const State& state, int block)
{
    const Eigen::Matrix3d map = pose_of(model.kinematics, state, block).map;
    return std::atan2(map(0, 2), map(2, 2));
}

double own_damping(const VerifySetting& setting, double omega)
{
    const double share = setting.integrator == Integrator::newmark ? 1 : StepControl{}.dissipation;
    return share * omega * setting.time_step / 4;
}

std::vector<VerifySetting> sweep_of(VerifySetting base, const std::vector<double>& time_steps)
{
    std::vector<VerifySetting> sweep;
    for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying})
        for (const double h : time_steps) {
            base.integrator = integrator;
            base.time_step = h;
            sweep.push_back(base);
        }
    return sweep;
}

}  // namespace voussoir::dynamic_scenes
