// Small scenes that several tests share.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "libdda/analysis/energies.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/run/run.h"

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

/// Adds a box to a model; its group is 0. A planar scene takes its section in x and z, whatever its extent in y.
inline int add_box(Model& model, const std::string& name, const Eigen::Vector3d& lower,
                   const Eigen::Vector3d& upper)
{
    if (is_planar(model.kinematics))
        model.blocks.push_back(make_planar_block(
            name, 0, 0, {make_rectangle(from_space<2>(lower), from_space<2>(upper))}, model.thickness));
    else
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

/// Of a planar scene what lies in its plane counts.
inline void set_velocity(const Model& model, State& state, int block, const Eigen::Vector3d& v,
                         const Eigen::Vector3d& spin = Eigen::Vector3d::Zero())
{
    const int n = unknowns_per_block(model.kinematics), dimension = dimension_of(model.kinematics);
    double* rates = state.velocities.data() + block * n;
    const Eigen::Matrix3d map = pose_of(model.kinematics, state, block).map;
    Eigen::Matrix3d rate;
    for (int j = 0; j < 3; ++j) rate.col(j) = spin.cross(Eigen::Vector3d(map.col(j)));
    const auto axis = [&](int k) { return dimension == 3 ? k : axis_in_space<2>(k); };
    for (int k = 0; k < dimension; ++k) rates[k] = v[axis(k)];
    if (is_deformable(model.kinematics)) {
        for (int j = 0; j < dimension; ++j)
            for (int i = 0; i < dimension; ++i) rates[dimension * (1 + j) + i] = rate(axis(i), axis(j));
    } else if (dimension == 3) {
        Eigen::Map<Eigen::Vector3d>{rates + 3} = spin;
    } else {
        rates[2] = -spin.y();
    }
}

/// For tests that run on every kinematics, or on the spatial ones alone.
inline auto every_kinematics()
{
    return ::testing::Values(Kinematics::spatial_deformable, Kinematics::spatial_rigid,
                             Kinematics::planar_deformable, Kinematics::planar_rigid);
}
inline auto spatial_kinematics()
{
    return ::testing::Values(Kinematics::spatial_deformable, Kinematics::spatial_rigid);
}

/// The name of a kinematics within a test's name.
inline std::string test_name(const ::testing::TestParamInfo<Kinematics>& info)
{
    std::string name(name_of(info.param));
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

inline RunReport run_quietly(const Model& model, const std::vector<Stage>& stages, State& state)
{
    return run(model, stages, state, {});
}

}  // namespace voussoir::testing
