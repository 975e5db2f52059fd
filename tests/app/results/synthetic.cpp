#include "tests/app/results/synthetic.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace voussoir::synthetic
{

using Eigen::Vector3d;

namespace
{

constexpr double inner = 4, thickness = 1, width = 2;

app::Case empty_case(Kinematics kinematics, const std::string& title)
{
    app::Case result;
    result.file = "synthetic.yaml";
    result.title = title;
    result.text = "title: " + title + "\nmaterials: {stone: {density: 2400 kg/m3}}\n";
    result.overrides = {"stages[1].time_step=1 ms"};
    result.defaults = {"gravity 9.80665 m/s2 downwards"};
    const BlockMaterial stone{"stone", 2400, 4.5e9, 0.25};
    JointMaterial dry;
    dry.name = "dry";
    dry.friction_angle = 0.5;
    result.model = make_model(kinematics, stone, dry);
    result.model.thickness = width;
    result.model.groups = {"masonry", "foundation"};
    result.model.joint_of_groups = {0, 0, 0, 0};
    Stage settle, shake;
    settle.name = "self-weight";
    settle.type = StageType::static_equilibrium;
    shake.name = "earthquake";
    shake.duration = 2;
    shake.control.time_step = 2e-3;
    result.stages = {settle, shake};
    return result;
}

/// A block of a spatial scene, or of a planar one with the outlines of its parts.
Block make_either(const Model& model, const std::string& name, int group, const ConvexPolyhedron& shape)
{
    if (!is_planar(model.kinematics)) return make_block(name, group, 0, {shape});
    double depth = 0;
    return make_planar_block(name, group, 0, {outline_of(shape, depth)}, model.thickness);
}

ConvexPolyhedron voussoir_stone(double from, double to)
{
    std::vector<Vector3d> vertices;
    for (const double y : {-width / 2, width / 2}) {
        for (const double angle : {from, to}) {
            for (const double radius : {inner, inner + thickness}) {
                vertices.emplace_back(-radius * std::cos(angle), y, radius * std::sin(angle));
            }
        }
    }
    // 0 from-inner, 1 from-outer, 2 to-inner, 3 to-outer at the front (y < 0); 4 to 7 the same behind
    return make_convex_polyhedron(
        vertices, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

void add_foundation(Model& model, const std::string& name, const Vector3d& lower, const Vector3d& upper)
{
    Foundation foundation;
    foundation.block = static_cast<int>(model.blocks.size());
    model.blocks.push_back(make_either(model, name, 1, make_box(lower, upper)));
    model.foundations.push_back(foundation);
}

/// A joint between neighbours a < b, of four corners or, planar, two ends; open at one side and slid, as far as
/// `amount` says.
template <int D>
void add_joint(const Model& model, int a, int b, double amount, State& state)
{
    const PoseIn<D> pose_a = pose_in<D>(model.kinematics, state, a),
                    pose_b = pose_in<D>(model.kinematics, state, b);
    ContactSetIn<D>& contacts = contacts_in<D>(state);
    const int rows = 2, columns = D - 1;
    ContactPatchIn<D> patch;
    patch.block_a = a;
    patch.block_b = b;
    patch.feature_a = 2;
    patch.feature_b = 3;
    patch.stiffness = 1e9;
    patch.normal = (pose_a.centroid - pose_b.centroid).normalized();
    patch.first_point = static_cast<int>(contacts.points.size());
    patch.point_count = rows * columns;
    const Vector3d middle = to_space(VectorIn<D>(0.5 * (pose_a.centroid + pose_b.centroid)));
    const Vector3d across = Vector3d::UnitY(), along = to_space(patch.normal).cross(across).normalized();
    for (int corner = 0; corner < patch.point_count; ++corner) {
        ContactPointIn<D> point;
        point.feature = static_cast<std::uint32_t>(corner);
        const int column = corner % columns, row = corner / columns;
        point.position =
            from_space<D>(Vector3d(middle + (column - 0.5) * width * across + (row - 0.5) * thickness * along));
        point.area = width * thickness / patch.point_count;
        const bool opens = row == 0 && amount > 0;
        point.gap = opens ? amount : -1e-5;
        point.status = opens ? ContactStatus::open : ContactStatus::locked;
        point.normal_force = opens ? 0 : 1e4;
        if (amount < 0) point.plastic_slip = from_space<D>(Vector3d(-amount * along));
        contacts.points.push_back(point);
    }
    contacts.patches.push_back(patch);
}

}  // namespace

app::Case arch(Kinematics kinematics, int voussoirs)
{
    app::Case result = empty_case(kinematics, "A half-round arch");
    Model& model = result.model;
    add_foundation(model, "abutment_left", {-inner - thickness - 1, -1.5, -1.5}, {-inner + 0.3, 1.5, 0});
    for (int i = 0; i < voussoirs; ++i) {
        const double from = std::numbers::pi * i / voussoirs, to = std::numbers::pi * (i + 1) / voussoirs;
        model.blocks.push_back(
            make_either(model, "voussoir_" + std::to_string(i + 1), 0, voussoir_stone(from, to)));
    }
    add_foundation(model, "abutment_right", {inner - 0.3, -1.5, -1.5}, {inner + thickness + 1, 1.5, 0});
    result.output.histories = {{"crown", "voussoir_" + std::to_string(voussoirs / 2 + 1), {}}};
    return result;
}

app::Case tower(Kinematics kinematics, int boxes)
{
    app::Case result = empty_case(kinematics, "A tower of boxes");
    add_foundation(result.model, "ground", {-3, -3, -0.5}, {3, 3, 0});
    for (int i = 0; i < boxes; ++i) {
        const ConvexPolyhedron drum = make_box({-0.75, -0.75, 1.0 * i}, {0.75, 0.75, 1.0 * i + 1});
        result.model.blocks.push_back(make_either(result.model, "drum_" + std::to_string(i + 1), 0, drum));
    }
    return result;
}

State swaying(const app::Case& the_case, double time)
{
    const Model& model = the_case.model;
    State state = initial_state(model);
    state.time = time;
    state.step = std::lround(time / 2e-3);
    state.stage = time > 0 ? 1 : 0;
    const int n = coordinates_per_block(model.kinematics), unknowns = unknowns_per_block(model.kinematics);
    const int dimension = dimension_of(model.kinematics);
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        double* x = state.coordinates.data() + b * n;
        x[0] += 0.05 * time;  // the ground
        if (model.blocks[b].group == 1) continue;
        const double height = model.blocks[b].moments.centroid.z();
        x[0] += 0.004 * time * height;
        x[dimension - 1] -= 0.002 * time * height;
        state.velocities[b * unknowns] = 0.05 + 0.004 * height;
        if (!is_deformable(model.kinematics)) continue;
        x[dimension] += 1e-5 * time;                 // stretch along x
        x[n - 1] -= 1e-4 * time * (6 - height) / 6;  // and shortening along z
    }
    for (std::size_t b = 0; b + 1 < model.blocks.size(); ++b) {
        const double amount = time * (b % 5 == 1 ? 2e-3 : b % 5 == 3 ? -2e-3 : 0);
        const int lower = static_cast<int>(b);
        if (dimension == 2)
            add_joint<2>(model, lower, lower + 1, amount, state);
        else
            add_joint<3>(model, lower, lower + 1, amount, state);
    }
    return state;
}

}  // namespace voussoir::synthetic
