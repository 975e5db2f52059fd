#include "app/studies/verify/vault_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdda/analysis/joint_resultants.h"

namespace voussoir::app::studies::verify
{
namespace
{

using Eigen::Vector3d;

constexpr double gravity = scenes::papers_gravity;

std::vector<Reaction> reactions_of(const Model& model, const State& state)
{
    std::vector<Reaction> reactions;
    for (const JointResultant& joint : joint_resultants(model, state)) {
        const bool a = model.blocks[joint.block_a].group == support,
                   b = model.blocks[joint.block_b].group == support;
        if (a != b) reactions.push_back({a ? Vector3d(-joint.force) : joint.force, joint.pressure_centre});
    }
    return reactions;
}

double weight_of(const Model& model)
{
    double weight = 0;
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        if (model.blocks[b].group == masonry) weight += gravity * model.mass(static_cast<int>(b));
    return weight;
}

/// |sum of the vertical reactions / weight - 1|
double vertical_error(const std::vector<Reaction>& reactions, const Model& model)
{
    double sum = 0;
    for (const Reaction& reaction : reactions) sum += reaction.force.z();
    return std::abs(sum / weight_of(model) - 1);
}

/// The largest distance between corners of two stones that were one at the start [m].
double largest_parting(const importers::patterns::StoneGrid& grid, const Model& model, const State& state)
{
    std::vector<Vector3d> lowest(grid.corners().size(), Vector3d::Constant(INFINITY)), highest(lowest.size());
    for (Vector3d& x : highest) x = Vector3d::Constant(-INFINITY);
    for (std::size_t b = 0; b < grid.stones().size(); ++b) {
        const Pose pose = pose_of(model.kinematics, state, static_cast<int>(b));
        for (const std::vector<int>& face : grid.stones()[b].faces)
            for (const int c : face) {
                const Vector3d x =
                    pose.centroid + pose.map * (grid.corners()[c] - model.blocks[b].moments.centroid);
                lowest[c] = lowest[c].cwiseMin(x);
                highest[c] = highest[c].cwiseMax(x);
            }
    }
    double parting = 0;
    for (std::size_t c = 0; c < lowest.size(); ++c) parting = std::max(parting, (highest[c] - lowest[c]).norm());
    return parting;
}

}  // namespace

scenes::StagedScene vault_scene(const importers::patterns::StoneGrid& grid, const scenes::SceneSetting& setting,
                                double bearing)
{
    const JointMaterial dry = scenes::dry_joint_at_angle(rough, {});
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"stone", vault_unit_weight / gravity, 10e9, 0.2}, dry, 1);
    scene.model.groups = {"masonry", "support"};
    scene.model.joints.push_back(scenes::dry_joint_at_angle(bearing, {}));
    scene.model.joint_of_groups = {0, 1, 1, 1};
    for (const importers::patterns::StoneGrid::Stone& stone : grid.stones()) {
        const bool is_support = stone.name.starts_with("support");
        scene.model.blocks.push_back(
            make_block(stone.name, is_support ? support : masonry, 0, importers::patterns::parts_of(grid, stone)));
        if (is_support) scenes::hold(scene.model, static_cast<int>(scene.model.blocks.size()) - 1);
    }
    scene.stages = {scenes::static_stage(setting)};
    return scene;
}

Benchmark vault_row()
{
    Benchmark row;
    row.setting.kinematics = Kinematics::spatial_rigid;
    row.also = {Kinematics::spatial_deformable};
    row.source = "docs/vaults.md";
    row.paper_error = "none: not from a paper";
    row.tolerance = 0.01;
    return row;
}

std::vector<Reaction> rest(const scenes::StagedScene& scene, State& state, VerifyResult& result)
{
    state = initial_state(scene.model);
    run_scene(scene, state, {}, result);
    if (!result.failure.empty()) return {};
    std::vector<Reaction> reactions = reactions_of(scene.model, state);
    if (const double error = vertical_error(reactions, scene.model); error > 1e-4)
        result.failure = fmt::format("the vertical reactions differ from the weight by {:.1e} of it", error);
    return reactions;
}

std::string of_equilibrium(const importers::patterns::StoneGrid& grid, const Model& model, const State& state,
                           const std::vector<Reaction>& reactions)
{
    return fmt::format("vertical reactions / weight - 1 = {:.0e}, corners that were one parted by {:.3f} mm",
                       vertical_error(reactions, model), 1e3 * largest_parting(grid, model, state));
}

}  // namespace voussoir::app::studies::verify
