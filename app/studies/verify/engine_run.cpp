#include "app/studies/verify/engine_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/verify/picture.h"
#include "app/words/diagnosis_words.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double static_step = 0.1;  // s; static stages take large ones

Stage stage_of(const scenes::SlidingScene& scene, const scenes::SceneSetting& setting, StageType type)
{
    const bool at_rest = type == StageType::static_equilibrium;
    Stage stage;
    stage.name = at_rest ? "rest" : "motion";
    stage.type = type;
    stage.gravity = at_rest ? scene.rest_gravity.value_or(scene.gravity) : scene.gravity;
    stage.control.time_step = at_rest ? static_step : setting.time_step;
    stage.control.integrator = setting.integrator;
    if (at_rest) return stage;
    stage.control.open_close = setting.open_close;
    if (setting.open_close == OpenClose::published) stage.control.max_open_close = 6;
    stage.duration = scene.duration;
    stage.motions = scene.motions;
    stage.body_accelerations = scene.body_accelerations;
    return stage;
}

/// Runs one stage from the state and counts into `result`, which says why it did not come to its end.
void run_stage(const Model& model, const Stage& stage, State& state, const RunObserver& observer,
               VerifyResult& result)
{
    const RunReport report = run(model, {stage}, state, observer);
    result.steps += report.steps;
    result.step_cuts += report.step_cuts;
    result.iterations += report.open_close_iterations;
    result.simulated_time += report.simulated_time;
    if (report.outcome != Outcome::completed) result.failure = words::message_of(report, model, {stage});
}

void watch(const scenes::SlidingScene& scene, const Eigen::Vector3d& start, RunObserver& observer,
           History& history)
{
    observer.step = [&scene, start, &history](const State& now, const StepReport&, const RunReport&) {
        history.times.push_back(now.stage_time);
        history.displacements.push_back(pose_of(scene.model.kinematics, now, scene.block).centroid - start);
        history.velocities.push_back(velocity_of(scene.model.kinematics, now, scene.block));
    };
}

}  // namespace

EngineRun run_engine(const scenes::SlidingScene& scene, const scenes::SceneSetting& setting)
{
    EngineRun run_out;
    const std::clock_t start = std::clock();
    const Model& model = scene.model;
    State state = initial_state(model);
    run_stage(model, stage_of(scene, setting, StageType::static_equilibrium), state, {}, run_out.result);
    if (run_out.result.failure.empty()) {
        state.stage = 0;
        begin_stage(model, 0, state);
        scenes::set_velocity(model, state, scene.block, scene.start_velocity);
        RunObserver observer;
        watch(scene, pose_of(model.kinematics, state, scene.block).centroid, observer, run_out.history);
        run_stage(model, stage_of(scene, setting, StageType::dynamic), state, observer, run_out.result);
    }
    run_out.result.cpu_time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return run_out;
}

double worst_error(const History& ours, const History& reference)
{
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < ours.displacements.size(); ++i) {
        worst = std::max(worst, (ours.displacements[i] - reference.displacements[i]).norm());
        largest = std::max(largest, reference.displacements[i].norm());
    }
    return worst / largest;
}

std::vector<double> answer_of(const History& history)
{
    if (history.displacements.empty()) return {};
    const Eigen::Vector3d& end = history.displacements.back();
    return {end.begin(), end.end()};
}

plots::Diagram picture_of(const History& ours, const History& reference)
{
    plots::Diagram picture = linear_diagram("time [s]", "displacement [m]", {});
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> engine, exact;
        double largest = 0;
        for (std::size_t i = 0; i < ours.displacements.size(); ++i) {
            engine.push_back(ours.displacements[i][axis]);
            exact.push_back(reference.displacements[i][axis]);
            largest = std::max(largest, std::abs(exact.back()));
        }
        if (largest == 0) continue;
        const std::string name = std::string("engine, ") + "xyz"[axis];
        picture.curves.push_back(curve_of("reference", ours.times, exact, true));
        picture.curves.push_back(curve_of(name, ours.times, engine));
    }
    return picture;
}

double worst_relative(const History& ours, const History& reference, double from)
{
    double worst = 0;
    for (std::size_t i = 0; i < ours.displacements.size(); ++i) {
        const double exact = reference.displacements[i].norm();
        if (ours.times[i] < from || exact == 0) continue;
        worst = std::max(worst, std::abs(exact - ours.displacements[i].norm()) / exact);
    }
    return worst;
}

void add_run(VerifyResult& total, const VerifyResult& one)
{
    total.error = std::max(total.error, one.error);
    if (one.paper_measure) total.paper_measure = std::max(total.paper_measure.value_or(0), *one.paper_measure);
    total.simulated_time += one.simulated_time;
    total.cpu_time += one.cpu_time;
    total.steps += one.steps;
    total.step_cuts += one.step_cuts;
    total.iterations += one.iterations;
    total.answer.insert(total.answer.end(), one.answer.begin(), one.answer.end());
    if (total.picture.curves.empty()) total.picture = one.picture;
    if (total.failure.empty()) total.failure = one.failure;
    if (one.note.empty()) return;
    total.note += total.note.empty() ? one.note : "; " + one.note;
}

}  // namespace voussoir::app::studies::verify
