#include "app/studies/verify/run_scene.h"

#include <cmath>
#include <ctime>

#include "app/words/diagnosis_words.h"

namespace voussoir::app::studies::verify
{

using Eigen::Vector3d;

RunReport run_scene(const scenes::StagedScene& scene, State& state, const RunObserver& observer,
                    VerifyResult& result)
{
    const std::clock_t start = std::clock();
    RunReport report = run(scene.model, scene.stages, state, observer);
    result.cpu_time += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    result.simulated_time += report.simulated_time;
    result.steps += report.steps;
    result.step_cuts += report.step_cuts;
    result.iterations += report.open_close_iterations;
    if (has_no_answer(report.outcome)) result.failure = words::message_of(report, scene.model, scene.stages);
    return report;
}

double lean_of(const Model& model, const State& state, int block)
{
    const Eigen::Matrix3d map = pose_of(model.kinematics, state, block).map;
    return std::atan2(map(0, 2), map(2, 2));
}

double own_damping(const scenes::SceneSetting& setting, double omega)
{
    StepControl control;
    control.time_step = setting.time_step;
    const double share = setting.integrator == Integrator::newmark ? 1 : control.dissipation_used();
    return share * omega * setting.time_step / 4;
}

std::vector<scenes::SceneSetting> sweep_of(scenes::SceneSetting base, const std::vector<double>& time_steps)
{
    std::vector<scenes::SceneSetting> sweep;
    for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying})
        for (const double h : time_steps) {
            base.integrator = integrator;
            base.time_step = h;
            sweep.push_back(base);
        }
    return sweep;
}

}  // namespace voussoir::app::studies::verify
