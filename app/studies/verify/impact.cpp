// Li's cube: falling, bouncing, settling.
#include "app/studies/verify/impact.h"

#include <fmt/format.h>

#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/references/rebound.h"
#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

scenes::StagedScene li_scene(const scenes::SceneSetting& setting, const LiBlock& block, double duration)
{
    const BlockMaterial material{"block", block.density, block.young, li_poisson};
    JointMaterial joint;
    joint.name = "smooth";
    // Planar, each of the two corners stands for two.
    const double springs_per_corner = is_planar(setting.kinematics) ? 2 : 1;
    joint.stiffness = {ContactStiffness::Kind::per_point, springs_per_corner * block.corner_spring};
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, material, joint, li_side);
    const double half = 0.5 * li_side;
    // Held, the plate is rigid: "the elastic modulus of the flat plate is very large".
    scenes::hold(scene.model, scenes::add_box(scene.model, "plate", {-5, -half, -1}, {5, half, 0}));
    scenes::add_box(scene.model, "block", {-half, -half, block.height}, {half, half, block.height + li_side});
    scene.stages = {scenes::dynamic_stage(setting, duration)};
    return scene;
}

Bounces drop(const scenes::SceneSetting& setting, const LiBlock& block, int count, VerifyResult& result)
{
    const scenes::StagedScene scene = li_scene(setting, block, 20);
    State state = initial_state(scene.model);
    const double rest = 0.5 * li_side;
    Bounces bounces;
    bounces.heights = {block.height};
    double rise = 0;  // m/s, at the last step
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport& step, const RunReport&) {
        const double z = pose_of(scene.model.kinematics, now, 1).centroid.z() - rest;
        const double rate = velocity_of(scene.model.kinematics, now, 1).z();
        // In flight the speed at the end of the step tells how far above z the apex was.
        if (rise > 0 && rate <= 0 && step.closed_points == 0)
            bounces.heights.push_back(z + rate * rate / (2 * scenes::papers_gravity));
        if (bounces.heights.size() == 1) {
            bounces.corner_depth = std::max(bounces.corner_depth, step.max_penetration);
            bounces.centroid_depth = std::max(bounces.centroid_depth, -z);
        }
        rise = rate;
    };
    observer.stop = [&] { return static_cast<int>(bounces.heights.size()) > count; };
    run_scene(scene, state, observer, result);
    if (static_cast<int>(bounces.heights.size()) <= count && result.failure.empty())
        result.failure = fmt::format("only {} of {} bounces in 20 s", bounces.heights.size() - 1, count);
    return bounces;
}

namespace
{

/// A cube set down with its springs unloaded, watched until the integrator has taken its motion away.
VerifyResult run_open_close(const scenes::SceneSetting& setting)
{
    const LiBlock block{2000, 3e12, 3e8, 0};
    const double omega = std::sqrt(4 * block.corner_spring / (block.density * std::pow(li_side, 3)));
    const double settled = 25 / (own_damping(setting, omega) * omega);  // s: exp(-25) of the motion is left
    const scenes::StagedScene scene = li_scene(setting, block, settled);
    const double expected = references::settled_penetration(
        {li_side, block.density, block.young, li_poisson, 4 * block.corner_spring, 0, scenes::papers_gravity});
    VerifyResult result;
    State state = initial_state(scene.model);
    double deepest = 0, last = 0;
    RunObserver observer;
    observer.step = [&](const State&, const StepReport& step, const RunReport&) {
        last = step.max_penetration;
        deepest = std::max(deepest, last);
    };
    run_scene(scene, state, observer, result);
    result.answer = {last};
    result.error = std::abs(last / expected - 1);
    result.note = fmt::format(
        "settles at {:.4e} m = {:.4f} % of the side (printed: about 0.01 %); largest transient penetration {:.2f} "
        "times that",
        last, 100 * last / li_side, deepest / expected);
    return result;
}

}  // namespace

std::vector<Benchmark> impact_benchmarks()
{
    Benchmark settled;
    settled.name = "open-close";
    settled.title = "A block settling on its contact springs";
    settled.source = "li, block open-close iteration model";
    settled.quantity = "settled penetration against weight / sum of the contact springs";
    settled.paper_error = "about 0.01 % of the side, and inversely proportional to the spring";
    settled.setting = as_in_papers({.kinematics = Kinematics::spatial_deformable, .time_step = 1e-3});
    settled.tolerance = 1e-4;
    settled.sweep = sweep_of(settled.setting, {4e-3, 2e-3, 1e-3, 5e-4});
    settled.run = run_open_close;
    // Not beside the rebounds: a cube that bounces also vibrates across the plane.
    add_planar(settled);
    std::vector<Benchmark> benchmarks{settled};
    for (Benchmark& row : rebound_rows()) benchmarks.push_back(std::move(row));
    return benchmarks;
}

}  // namespace voussoir::app::studies::verify
