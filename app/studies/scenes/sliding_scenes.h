// Scenes that slide: one small function each, which takes the setting it is to be built for.
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <optional>
#include <vector>

#include "app/studies/scenes/scene_setting.h"
#include "app/studies/scenes/stages.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::studies::scenes
{

constexpr double degree = std::numbers::pi / 180;  // rad

/// What run_engine brings to rest and then moves. x is horizontal (down the dip), z is up, y is the thickness.
struct SlidingScene {
    Model model;
    int block = 0;                                             // the measured one
    Eigen::Vector3d gravity{0, 0, -papers_gravity};            // m/s2
    std::optional<Eigen::Vector3d> rest_gravity;               // m/s2, while it comes to rest; if not `gravity`
    Eigen::Vector3d start_velocity = Eigen::Vector3d::Zero();  // m/s
    double duration = 0;                                       // s, of the motion
    std::vector<FoundationMotion> motions;
    std::vector<BodyAcceleration> body_accelerations;
};

/// A block that slides, and what it slides on.
struct SlidingBlock {
    Eigen::Vector3d size{1, 1, 0.3};  // m, along x, y, z
    BlockMaterial material{"stone", 2500, 1e10, 0.2};
    double friction = 0;  // rad
    ContactStiffness stiffness{};
    double shear_to_normal_stiffness = JointMaterial{}.shear_to_normal_stiffness;
    Eigen::Vector2d travel_from{-5, -5}, travel_to{25, 5};  // m, how far its base reaches from the block's centre
};

/// A block on a wide held block: on a plane, on an incline (by the direction of gravity), on a moving foundation.
SlidingScene block_on_base(const SceneSetting& setting, const SlidingBlock& block);

/// A wedge in a trough whose two planes dip by `left` and `right` [rad] across the line of intersection, x.
SlidingScene wedge_in_trough(const SceneSetting& setting, double left, double right, double friction);

/// Gravity as seen from a plane that dips by `angle` [rad] towards +x.
Eigen::Vector3d inclined_gravity(double angle);

/// Gravity on a block that cannot stay on such a plane while it is held: what friction cannot carry is taken off
/// along the plane. So it begins where a rigid block does when it is let go: at rest, with its friction mobilised
/// and its weight shared out as in sliding. (An unloaded shear spring would first give it sqrt(m/k) g sin(angle)
/// of speed.)
/// @param friction coefficient
Eigen::Vector3d held_gravity(double angle, double friction);

/// A horizontal acceleration down the dip in the frame of the plane: times cos along it, times sin off it.
void add_horizontal(SlidingScene& scene, const GroundMotion& horizontal, double angle);

/// a = amplitude sin(2 pi frequency t + phase) along an axis, as a body force on the scene's block.
void add_sine(SlidingScene& scene, int axis, double amplitude, double frequency);

/// The foundation moves by amplitude (1 - cos 2 pi frequency t) along an axis.
void add_cosine_motion(SlidingScene& scene, int axis, double amplitude, double frequency);

/// Gives the scene's joints `factor` times the contact stiffness they have by default [Pa/m]. Done by each scene.
void scale_stiffness(Model& model, double factor);

/// The stiffness of a contact point of the scene as it stands at the start [N/m], Shi's g0 of the papers.
double stiffness_per_point(const SlidingScene& scene);

}  // namespace voussoir::app::studies::scenes
