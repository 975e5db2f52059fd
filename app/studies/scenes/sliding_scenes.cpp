#include "app/studies/scenes/sliding_scenes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studies/scenes/materials.h"
#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/shapes.h"

namespace voussoir::app::studies::scenes
{
namespace
{

using Eigen::Vector3d;

/// Longer than any benchmark: a sine that does not end.
constexpr double for_ever = 1e6;  // s

int add_prism(Model& model, const std::string& name, ConvexPolyhedron shape)
{
    model.blocks.push_back(make_block(name, 0, 0, {std::move(shape)}));
    return static_cast<int>(model.blocks.size()) - 1;
}

}  // namespace

SlidingScene block_on_base(const SceneSetting& setting, const SlidingBlock& block)
{
    SlidingScene scene;
    scene.model = make_scene_model(setting, block.material, dry_joint_at_angle(block.friction, block.stiffness),
                                   block.size.y());
    scene.model.joints[0].shear_to_normal_stiffness = block.shear_to_normal_stiffness;
    const Vector3d lower(block.travel_from.x(), block.travel_from.y(), -1);
    const Vector3d upper(block.travel_to.x(), block.travel_to.y(), 0);
    hold(scene.model, add_box(scene.model, "base", lower, upper));
    const Vector3d half = block.size / 2, centre(0, 0, half.z());
    scene.block = add_box(scene.model, "block", centre - half, centre + half);
    if (setting.stiffness_factor) scale_stiffness(scene.model, *setting.stiffness_factor);
    return scene;
}

SlidingScene wedge_in_trough(const SceneSetting& setting, double left, double right, double friction)
{
    constexpr double depth = 1, reach = 30, thickness = 1;  // m
    SlidingScene scene;
    const JointMaterial joint = joint_in(setting, dry_joint_at_angle(friction, {}));
    scene.model = make_model(setting.kinematics, {"stone", 2500, 1e10, 0.2}, joint);
    const Eigen::Vector2d down_left(-std::cos(left), std::sin(left)), down_right(std::cos(right), std::sin(right));
    const Eigen::Vector2d under_left(-std::sin(left), -std::cos(left));
    const Eigen::Vector2d under_right(std::sin(right), -std::cos(right));
    const double side = 2 * depth / std::sin(std::min(left, right));
    const Eigen::Vector2d apex(0, 0);
    const std::vector<Eigen::Vector2d> wall_left{apex, side * down_left, side * down_left + thickness * under_left,
                                                 thickness * under_left};
    const std::vector<Eigen::Vector2d> wall_right{apex, thickness * under_right,
                                                  side * down_right + thickness * under_right, side * down_right};
    hold(scene.model, add_prism(scene.model, "left plane", prism(wall_left, -5, reach)));
    hold(scene.model, add_prism(scene.model, "right plane", prism(wall_right, -5, reach)));
    const std::vector<Eigen::Vector2d> section{apex, depth / std::sin(right) * down_right,
                                               depth / std::sin(left) * down_left};
    scene.block = add_prism(scene.model, "wedge", prism(section, -1, 1));
    if (setting.stiffness_factor) scale_stiffness(scene.model, *setting.stiffness_factor);
    return scene;
}

Vector3d inclined_gravity(double angle)
{
    return papers_gravity * Vector3d(std::sin(angle), 0, -std::cos(angle));
}

Vector3d held_gravity(double angle, double friction)
{
    constexpr double mobilised = 1 - 1e-5;  // a static stage has no answer at the limit itself
    Vector3d gravity = inclined_gravity(angle);
    gravity.x() = std::min(gravity.x(), mobilised * friction * -gravity.z());
    return gravity;
}

void add_horizontal(SlidingScene& scene, const GroundMotion& horizontal, double angle)
{
    const auto part = [&](double share) { return std::make_shared<const GroundMotion>(horizontal.scaled(share)); };
    scene.body_accelerations.push_back({scene.block, 0, part(std::cos(angle))});
    scene.body_accelerations.push_back({scene.block, 2, part(std::sin(angle))});
}

void add_sine(SlidingScene& scene, int axis, double amplitude, double frequency)
{
    const GroundMotion sine = GroundMotion::sine_acceleration(amplitude, frequency, 0, for_ever);
    scene.body_accelerations.push_back({scene.block, axis, std::make_shared<const GroundMotion>(sine)});
}

void add_cosine_motion(SlidingScene& scene, int axis, double amplitude, double frequency)
{
    const double omega = 2 * std::numbers::pi * frequency;
    const GroundMotion motion =
        GroundMotion::sine_acceleration(amplitude * omega * omega, frequency, std::numbers::pi / 2, for_ever);
    scene.motions.push_back({0, axis, std::make_shared<const GroundMotion>(motion)});
}

void scale_stiffness(Model& model, double factor)
{
    const double stiffness = factor * start_contact(model).stiffness;
    for (JointMaterial& joint : model.joints) joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
}

double stiffness_per_point(const SlidingScene& scene)
{
    const StartContact contact = start_contact(scene.model);
    return contact.stiffness * contact.area_per_point;
}

}  // namespace voussoir::app::studies::scenes
