// Ground that waves run through, as several tests have it.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

/// The face of a box that looks along `normal`.
inline BlockFace face_of_box(const Model& model, int block, const Eigen::Vector3d& normal)
{
    if (!is_planar(model.kinematics)) {
        const ConvexPolyhedron& shape = model.blocks[block].parts[0];
        for (int f = 0; f < static_cast<int>(shape.faces.size()); ++f)
            if (face_normal(shape, f).dot(normal) > 0.99) return {block, 0, f};
    } else {
        const auto& corners = model.blocks[block].outlines[0].vertices;
        for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
            const Eigen::Vector2d along = corners[(i + 1) % corners.size()] - corners[i];
            if (Eigen::Vector2d(along.y(), -along.x()).normalized().dot(from_space<2>(normal)) > 0.99)
                return {block, 0, i};
        }
    }
    ADD_FAILURE() << "no such face";
    return {};
}

inline const BlockMaterial ground{"ground", 2000, 2.5e9, 0.25};  // c_p 1225 m/s, c_s 707 m/s

/// Of P or of S waves [Pa].
inline double modulus(bool pressure)
{
    const double mu = ground.young / (2 * (1 + ground.poisson));
    return pressure ? ground.young * (1 - ground.poisson) / ((1 + ground.poisson) * (1 - 2 * ground.poisson)) : mu;
}

/// A smooth pulse of velocity [m/s]: one half wave of 1 - cos, its length [s].
inline std::shared_ptr<const GroundMotion> pulse(double peak, double length)
{
    std::vector<double> samples;
    for (int i = 0; i <= 2000; ++i)
        samples.push_back(0.5 * peak * (1 - std::cos(2 * std::numbers::pi * i / 2000)));
    samples.push_back(0);
    return std::make_shared<const GroundMotion>(GroundMotion::from_velocity(samples, length / 2000, "pulse"));
}

/// Joints that never open and are so many times as stiff as a metre of the ground [Pa/m over Pa].
inline JointMaterial bond(double stiffness)
{
    JointMaterial joint = dry(30);
    joint.cohesion = joint.tensile_strength = 1e12;
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness * ground.young};
    joint.shear_to_normal_stiffness = 1;
    return joint;
}

/// Blocks of 1 m on a grid of columns and rows, from the middle of the lower side; block i + columns j is in
/// column i and row j.
inline Model grid(Kinematics kinematics, int columns, int rows, double joints = 100)
{
    Model model = make_model(kinematics, ground, bond(joints));
    const double left = -0.5 * columns;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            add_box(model, "block " + std::to_string(i + columns * j), {left + i, -0.5, 1.0 * j},
                    {left + i + 1, 0.5, j + 1.0});
    return model;
}

/// Lowest faces of the first blocks.
inline ViscousBoundary base_of(const Model& model, int blocks)
{
    ViscousBoundary base{"base", {}, RestSupport::full, {}};
    for (int i = 0; i < blocks; ++i) base.faces.push_back(face_of_box(model, i, -Eigen::Vector3d::UnitZ()));
    return base;
}

}  // namespace voussoir::testing
