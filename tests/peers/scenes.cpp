#include "tests/peers/scenes.h"

#include <cmath>
#include <numbers>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/stages.h"
#include "app/studies/verify/limit_masonry.h"
#include "libdda/model/standard_gravity.h"
#include "tests/running_bond_wall.h"

namespace voussoir::peers
{
namespace
{

using app::studies::scenes::papers_gravity;
using Eigen::Vector3d;

constexpr double for_ever = 100;  // s

Scene empty_scene(double friction, double gravity, const BlockMaterial& material)
{
    Scene scene;
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = std::atan(friction);
    scene.model = make_model(Kinematics::spatial_rigid, material, joint);
    scene.friction = friction;
    scene.gravity = gravity;
    return scene;
}

void add_box(Scene& scene, const Vector3d& lower, const Vector3d& upper, bool held)
{
    const std::string name = "b" + std::to_string(scene.bodies.size());
    const int block = app::studies::scenes::add_box(scene.model, name, lower, upper);
    if (held) app::studies::scenes::hold(scene.model, block);
    scene.bodies.push_back({held, true, (upper - lower) / 2});
}

std::shared_ptr<const GroundMotion> sine(double amplitude, double frequency, double phase, double duration)
{
    return std::make_shared<const GroundMotion>(
        GroundMotion::sine_acceleration(amplitude, frequency, phase, duration));
}

}  // namespace

std::vector<FoundationWave> foundation_waves(bool across)
{
    if (across) return {{0.3, 2}, {0.2, 4}};
    return {{0.5, 2}, {}};
}

Scene sliding_block(bool across)
{
    Scene scene = empty_scene(0.6, papers_gravity, {"stone", 2500, 1.1e10, 0.2});
    add_box(scene, {-10, -10, -1}, {10, 10, 0}, true);
    add_box(scene, {-1.5, -1.5, 0}, {1.5, 1.5, 0.3}, false);
    scene.slides = true;
    scene.rest = 0.2;
    scene.duration = 5;
    int axis = 0;
    for (const FoundationWave& wave : foundation_waves(across)) {
        const double omega = 2 * std::numbers::pi * wave.frequency;
        const double amplitude = -wave.amplitude * omega * omega;
        if (amplitude != 0) scene.push[axis] = sine(amplitude, wave.frequency, std::numbers::pi / 2, for_ever);
        ++axis;
    }
    return scene;
}

Scene rocking_block(double duration)
{
    const double b = rocking_half_width;
    Scene scene = empty_scene(std::tan(std::numbers::pi / 3), papers_gravity, {"stone", 2500, 1e12, 0.2});
    add_box(scene, {-15 * b, -0.5, -1}, {15 * b, 0.5, 0}, true);
    add_box(scene, {-b, -0.5, 0}, {b, 0.5, 2 * rocking_half_height}, false);
    scene.rest = 0.2;
    scene.duration = duration;
    scene.push[0] = sine(-rocking_amplitude, rocking_frequency, 0, 0.5 / rocking_frequency);
    return scene;
}

Scene shaken_wall(int courses, int blocks)
{
    Scene scene;
    scene.model = running_bond_wall(Kinematics::spatial_rigid, courses, blocks);
    for (const Block& block : scene.model.blocks) {
        Vector3d half = Vector3d::Zero();
        for (const Vector3d& vertex : block.parts.front().vertices) half = half.cwiseMax(vertex);
        scene.bodies.push_back({scene.bodies.empty(), true, half});
    }
    scene.friction = 0.6;
    scene.gravity = standard_gravity;
    scene.rest = 0.5;
    scene.duration = 2;
    scene.push[0] = sine(0.3 * standard_gravity, 2, 0, for_ever);
    return scene;
}

Scene semicircular_arch(double share)
{
    Scene scene = empty_scene(0.7, papers_gravity, {"stone", 2200, 1e10, 0.2});
    // The joints of the verify row arch-least-thickness: limit analysis knows of no compliance.
    JointMaterial& joint = scene.model.joints[0];
    joint.stiffness.value = 300;
    const double inner = arch_radius - share * arch_radius / 2;
    importers::patterns::BarrelVault vault;
    vault.span = 2 * inner;
    vault.rise = inner;
    vault.thickness = share * arch_radius;
    vault.length = 1;
    vault.courses = 27;
    vault.stones = 1;
    vault.bonded = false;
    app::studies::verify::add_arch(scene.model, vault);
    scene.bodies.assign(scene.model.blocks.size(), {.held = false, .is_box = false});
    for (const Foundation& foundation : scene.model.foundations) scene.bodies[foundation.block].held = true;
    scene.duration = 3;
    return scene;
}

}  // namespace voussoir::peers
