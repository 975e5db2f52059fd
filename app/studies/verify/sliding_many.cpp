// The block on a shaking foundation, once and many times: what one costs and errs by does not depend on the
// others.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/run_scene.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double friction = 0.6, amplitude = 0.5, frequency = 2, duration = 5;  // -, m, Hz, s: foundation-1d
constexpr double omega = 2 * std::numbers::pi * frequency;
constexpr double place = 4;  // m, from block to block: 1 m between them

/// Blocks of 3 x 3 x 0.3 m in a row, planar along the motion and in space across it.
scenes::SlidingScene row_of_blocks(const scenes::SceneSetting& setting, int blocks)
{
    const bool along = is_planar(setting.kinematics);
    const double reach = 10 + place * (blocks - 1);
    scenes::SlidingScene scene =
        scenes::block_on_base(setting, {.size = {3, 3, 0.3},
                                        .material = {"stone", 2500, 1.1e10, 0.2},
                                        .friction = std::atan(friction),
                                        .travel_from = {-10, -10},
                                        .travel_to = {along ? reach : 10, along ? 10 : reach}});
    for (int i = 1; i < blocks; ++i) {
        const Eigen::Vector3d at = place * i * (along ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY());
        scenes::add_box(scene.model, fmt::format("block {}", i + 1), at + Eigen::Vector3d(-1.5, -1.5, 0),
                        at + Eigen::Vector3d(1.5, 1.5, 0.3));
    }
    scene.duration = duration;
    scenes::add_cosine_motion(scene, 0, amplitude, frequency);
    return scene;
}

/// Histories of all blocks [m].
struct Histories {
    std::vector<double> times;
    std::vector<std::vector<double>> moved;  // (times) of (blocks)
};

Histories shake(const scenes::SceneSetting& setting, int blocks, VerifyResult& result)
{
    const scenes::SlidingScene sliding = row_of_blocks(setting, blocks);
    scenes::StagedScene scene{sliding.model,
                              {scenes::static_stage(setting), scenes::dynamic_stage(setting, duration)}};
    scene.stages[1].motions = sliding.motions;
    std::vector<double> start;
    for (int i = 1; i <= blocks; ++i) start.push_back(scene.model.blocks[i].moments.centroid.x());
    Histories histories;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (now.stage == 0) return;
        histories.times.push_back(now.stage_time);
        std::vector<double>& moved = histories.moved.emplace_back();
        for (int i = 1; i <= blocks; ++i)
            moved.push_back(pose_of(scene.model.kinematics, now, i).centroid.x() - start[i - 1]);
    };
    State state = initial_state(scene.model);
    run_scene(scene, state, observer, result);
    return histories;
}

/// Largest distance of any block from equation 8 over the largest displacement.
double error_of(const Histories& histories, VerifyResult& result)
{
    references::SlidingProblem problem;
    problem.driving = [](double t) {
        return Eigen::Vector2d(-amplitude * omega * omega * std::cos(omega * t), 0);
    };
    problem.pressing = [](double) { return scenes::papers_gravity; };
    problem.friction = friction;
    const History exact = reference_history(problem, histories.times, [](double t) {
        return Eigen::Vector3d(amplitude * (1 - std::cos(omega * t)), 0, 0);
    });
    double worst = 0, largest = 0;
    std::vector<double> first, reference;
    for (std::size_t i = 0; i < histories.times.size(); ++i) {
        const double there = exact.displacements[i].x();
        largest = std::max(largest, std::abs(there));
        for (const double moved : histories.moved[i]) worst = std::max(worst, std::abs(moved - there));
        first.push_back(histories.moved[i].front());
        reference.push_back(there);
    }
    if (result.picture.curves.empty())
        result.picture = linear_diagram(
            "time [s]", "displacement [m]",
            {curve_of("reference", histories.times, reference, true), curve_of("engine", histories.times, first)});
    return worst / largest;
}

VerifyResult shake_all(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    double least = INFINITY;
    for (const int blocks : {1, 20, 200}) {
        VerifyResult one;
        const Histories histories = shake(setting, blocks, one);
        const double error = error_of(histories, result);
        result.error = std::max(result.error, error);
        least = std::min(least, error);
        result.cpu_time += one.cpu_time;
        result.simulated_time += blocks * duration;
        result.steps += one.steps;
        result.step_cuts += one.step_cuts;
        result.iterations += one.iterations;
        if (result.failure.empty()) result.failure = one.failure;
        result.answer.push_back(histories.moved.back().front());
        result.note += fmt::format("{}{} block{}: {:.2e}, {:.2e} s of CPU per simulated second and block",
                                   result.note.empty() ? "" : "; ", blocks, blocks == 1 ? "" : "s", error,
                                   one.cpu_time / (blocks * duration));
    }
    constexpr double alike = 1e-5;  // what a step may leave unbalanced
    if (result.failure.empty() && result.error - least > alike)
        result.failure = fmt::format("the errors differ by {:.1e}: {}", result.error - least, result.note);
    return result;
}

}  // namespace

std::vector<Benchmark> many_blocks_benchmarks()
{
    Benchmark benchmark;
    benchmark.name = "foundation-many";
    benchmark.title = "1, 20 and 200 blocks on the foundation of foundation-1d, at defaults";
    benchmark.source = "yagoda-biran-hatzor, section 3.4.2, equation 8, figure 13";
    benchmark.quantity =
        "largest distance of a block from equation 8 (integrated to 1e-8) / largest displacement of the block, "
        "the "
        "worst of three scenes, whose errors must be alike";
    benchmark.choices =
        "The block of foundation-1d, 1 m apart, across the motion or, planar, along it. CPU times are those per "
        "simulated second and block.";
    benchmark.paper_error = "below 1 % after 0.3 s";
    benchmark.paper_level = 0.01;
    benchmark.setting.time_step = 4e-3;
    benchmark.tolerance = 1e-4;
    benchmark.run = shake_all;
    add_planar(benchmark);
    return {benchmark};
}

}  // namespace voussoir::app::studies::verify
