// Small scenes that several tests share.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "libdda/analysis/energies.h"
#include "libdda/analysis/run.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::testing
{

constexpr double degrees = std::numbers::pi / 180;
constexpr double gravity = 9.81;

inline BlockMaterial stone(double young = 1e10)
{
    return {"stone", 2500, young, 0.2};
}

inline JointMaterial dry(double friction_degrees)
{
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = friction_degrees * degrees;
    return joint;
}

/// Adds a box to a model; its group is 0.
inline int add_box(Model& model, const std::string& name, const Eigen::Vector3d& lower,
                   const Eigen::Vector3d& upper)
{
    model.blocks.push_back(make_block(name, 0, 0, {make_box(lower, upper)}));
    return static_cast<int>(model.blocks.size()) - 1;
}

inline void hold(Model& model, int block)
{
    Foundation foundation;
    foundation.block = block;
    model.foundations.push_back(foundation);
}

/// A 1 x 1 x 0.3 m block on a wide plane. The incline is in the direction of gravity, which is an input.
inline Model block_on_plane(Kinematics kinematics, double friction_degrees)
{
    Model model = make_model(kinematics, stone(), dry(friction_degrees));
    hold(model, add_box(model, "plane", {-5, -5, -1}, {25, 5, 0}));
    add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    return model;
}

/// Gravity as seen from a plane inclined by `angle` [degrees] towards +x.
inline Eigen::Vector3d inclined_gravity(double angle)
{
    return gravity * Eigen::Vector3d(std::sin(angle * degrees), 0, -std::cos(angle * degrees));
}

inline Stage dynamic_stage(double duration, double time_step, const Eigen::Vector3d& g = {0, 0, -gravity})
{
    Stage stage;
    stage.name = "motion";
    stage.type = StageType::dynamic;
    stage.duration = duration;
    stage.gravity = g;
    stage.control.time_step = time_step;
    return stage;
}

inline Stage static_stage(double time_step, const Eigen::Vector3d& g = {0, 0, -gravity})
{
    Stage stage;
    stage.name = "self-weight";
    stage.type = StageType::static_equilibrium;
    stage.gravity = g;
    stage.control.time_step = time_step;
    return stage;
}

inline Eigen::Vector3d centroid(const Model& model, const State& state, int block)
{
    return pose_of(model.kinematics, state, block).centroid;
}

inline void set_velocity(const Model& model, State& state, int block, const Eigen::Vector3d& v,
                         const Eigen::Vector3d& spin = Eigen::Vector3d::Zero())
{
    const int n = unknowns_per_block(model.kinematics);
    double* rates = state.velocities.data() + block * n;
    Eigen::Map<Eigen::Vector3d>{rates} = v;
    if (!is_deformable(model.kinematics)) {
        Eigen::Map<Eigen::Vector3d>{rates + 3} = spin;
        return;
    }
    const Eigen::Matrix3d map = pose_of(model.kinematics, state, block).map;
    for (int j = 0; j < 3; ++j)
        Eigen::Map<Eigen::Vector3d>{rates + 3 + 3 * j} = spin.cross(Eigen::Vector3d(map.col(j)));
}

inline RunReport run_quietly(const Model& model, const std::vector<Stage>& stages, State& state)
{
    return run(model, stages, state, {});
}

}  // namespace voussoir::testing
