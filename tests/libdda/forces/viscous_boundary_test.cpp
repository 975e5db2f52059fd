// Viscous boundaries: the integrals over faces, waves that leave and come in, what carries the faces at rest.
#include "libdda/forces/viscous_boundary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdda/ground_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class Boundary : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Boundary,
                         ::testing::Values(Kinematics::spatial_deformable, Kinematics::planar_deformable),
                         test_name);

/// Blocks of 1 m on top of one another, bonded, that go on for ever sideways; the lowest face is viscous.
Model column(Kinematics kinematics, int count, double joints = 1e4)
{
    JointMaterial bond = dry(30);
    bond.cohesion = bond.tensile_strength = 1e12;
    bond.stiffness = {ContactStiffness::Kind::per_area, joints * ground.young};
    bond.shear_to_normal_stiffness = 1;
    Model model = make_model(kinematics, ground, bond);
    for (int i = 0; i < count; ++i) {
        add_box(model, "layer " + std::to_string(i), {-0.5, -0.5, 1.0 * i}, {0.5, 0.5, i + 1.0});
        model.tied_sides.push_back(i);
    }
    model.boundaries.push_back({"base", {face_of_box(model, 0, -Vector3d::UnitZ())}, RestSupport::full});
    return model;
}

/// Largest velocity of the top of the column along an axis, and what is left of it at the end.
struct Passage {
    double largest = 0, last = 0, energy_at_end = 0, largest_energy = 0;
    RunReport report;
};
Passage pass(const Model& model, const Stage& stage, int axis)
{
    Passage passage;
    State state = initial_state(model);
    const int top = static_cast<int>(model.blocks.size()) - 1;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport& report) {
        const Vector3d velocity = velocity_of(model.kinematics, now, top) +
                                  map_rate_of(model.kinematics, now, top) * Vector3d(0, 0, 0.5);
        passage.largest = std::max(passage.largest, velocity[axis]);
        passage.last = velocity.norm();
        passage.energy_at_end = report.energy.kinetic + report.energy.strain + report.energy.contact;
        passage.largest_energy = std::max(passage.largest_energy, passage.energy_at_end);
    };
    passage.report = run(model, {stage}, state, observer);
    return passage;
}

}  // namespace

// A velocity that is uniform, and one that turns and stretches, on the whole side of a box, against the integrals
// by hand.
TEST_P(Boundary, IntegratesTheFieldOfVelocitiesOverTheFace)
{
    Model model = make_model(GetParam(), ground, dry(30));
    model.thickness = 1;
    add_box(model, "box", {-1, -0.5, -0.75}, {1, 0.5, 0.75});
    const double zp = std::sqrt(ground.density * modulus(true)), zs = std::sqrt(ground.density * modulus(false));
    const double area = 2 * 1, second = 2.0 / 3;  // of the lower side, about the y axis through its middle: m2, m4
    const BlockFace face = face_of_box(model, 0, -Vector3d::UnitZ());
    const auto check = [&](auto kinematics) {
        using K = decltype(kinematics);
        constexpr int z = K::dimension - 1, xx = K::dimension, zx = K::dimension + z;
        const typename K::Square c = step::dashpots_of<K>(model, face, K::Matrix::Identity());
        EXPECT_LT((c - c.transpose()).norm(), 1e-12 * c.norm());
        EXPECT_NEAR(c(0, 0), zs * area, 1e-9 * zs);
        EXPECT_NEAR(c(z, z), zp * area, 1e-9 * zp);
        EXPECT_NEAR(c(zx, zx), zp * second, 1e-9 * zp);                    // v_z = L_zx x
        EXPECT_NEAR(c(xx, xx), zs * second, 1e-9 * zs);                    // v_x = L_xx x
        EXPECT_NEAR(c(z, K::unknowns - 1), -0.75 * zp * area, 1e-9 * zp);  // v_z = L_zz z at z = -0.75 m
    };
    if (is_planar(GetParam()))
        check(step::PlanarDeformable());
    else
        check(step::SpatialDeformable());
}

// A wave of P and of S from below: the surface moves twice as much, and all of it leaves again.
TEST_P(Boundary, LetsAWaveInAndOutAgain)
{
    const Model model = column(GetParam(), 50);
    for (const int axis : {0, 2}) {
        const double speed = std::sqrt(modulus(axis == 2) / ground.density);
        Stage stage = dynamic_stage(145 / speed, 0.25 / speed, Vector3d::Zero());
        stage.control.dissipation = 0;
        stage.incoming_waves = {{0, axis, pulse(0.01, 40 / speed)}};
        const Passage passage = pass(model, stage, axis);
        EXPECT_EQ(passage.report.outcome, Outcome::completed);
        EXPECT_NEAR(passage.largest, 0.02, 0.01 * 0.02) << axis;
        EXPECT_LT(passage.last, 1e-3 * 0.01) << axis;
        EXPECT_LT(passage.energy_at_end, 1e-6 * passage.largest_energy) << axis;
        EXPECT_LT(passage.report.energy.relative_residual(), 1e-9);
        // Nothing stays of what the wave brought: the boundary took it all back.
        EXPECT_LT(std::abs(passage.report.energy.boundary_work), 1e-4 * passage.largest_energy);
    }
}

// All of the wave's energy: rho c V^2 and area, over the time.
TEST_P(Boundary, BringsTheEnergyOfTheWave)
{
    const Model model = column(GetParam(), 60);
    const double speed = std::sqrt(modulus(false) / ground.density);
    Stage stage = dynamic_stage(50 / speed, 0.25 / speed, Vector3d::Zero());
    stage.incoming_waves = {{0, 0, pulse(0.01, 40 / speed)}};
    const Passage passage = pass(model, stage, 0);
    const double expected = ground.density * speed * 0.01 * 0.01 * 3 / 8 * 40 / speed;
    EXPECT_NEAR(passage.report.energy.boundary_work, expected, 2e-3 * expected);
}

// Half the motion of an outcrop is the wave.
TEST_P(Boundary, TakesTheShareOfTheMotionThatIsTheWave)
{
    const Model model = column(GetParam(), 20);
    const double speed = std::sqrt(modulus(false) / ground.density);
    Stage stage = dynamic_stage(60 / speed, 0.1 / speed, Vector3d::Zero());
    stage.incoming_waves = {{0, 0, pulse(0.01, 30 / speed), 0.5}};
    EXPECT_NEAR(pass(model, stage, 0).largest, 0.01, 0.01 * 0.01);
}

// At rest the base is held; once it is viscous, what held it goes on carrying.
TEST_P(Boundary, CarriesItsReactionsOver)
{
    const Model model = column(GetParam(), 10);
    State state = initial_state(model);
    Stage settle = static_stage(0.1);
    const Stage after = dynamic_stage(0.2, 1e-3);
    ASSERT_EQ(run_quietly(model, {settle}, state).outcome, Outcome::completed);
    const double weight = 10 * ground.density * gravity;
    EXPECT_NEAR(state.boundary_reactions[dimension_of(GetParam()) - 1], weight, 1e-7 * weight);
    // Of its own weight a column of height H sinks by rho g H^2 / 2 M; centroids of blocks: less the half of the
    // last block's own.
    const double height = 10, m = modulus(true), sunk = 10 - 0.5 - centroid(model, state, 9).z();
    EXPECT_NEAR(sunk, ground.density * gravity * (height * height - 0.25) / (2 * m), 0.02 * sunk);
    const Vector3d before = centroid(model, state, 9);
    begin_stage(model, 0, state);
    const RunReport report = run_quietly(model, {after}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_LT((centroid(model, state, 9) - before).norm(), 1e-6 * sunk);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// A reaction that is lost lets the column sink at g H / c: the test above could fail.
TEST_P(Boundary, SinksWithoutItsReactions)
{
    const Model model = column(GetParam(), 10);
    State state = initial_state(model);
    Stage settle = static_stage(0.1);
    ASSERT_EQ(run_quietly(model, {settle}, state).outcome, Outcome::completed);
    std::fill(state.boundary_reactions.begin(), state.boundary_reactions.end(), 0.0);
    const Vector3d before = centroid(model, state, 0);
    begin_stage(model, 0, state);
    run_quietly(model, {dynamic_stage(0.5, 1e-3)}, state);
    const double speed = 10 * gravity / std::sqrt(modulus(true) / ground.density);
    EXPECT_NEAR(before.z() - centroid(model, state, 0).z(), 0.5 * speed, 0.1 * speed);
}

// The wave comes later where it has farther to go.
TEST_P(Boundary, DelaysTheWaveAlongTheGround)
{
    const Model model = column(GetParam(), 20);
    const double speed = std::sqrt(modulus(false) / ground.density);
    Stage stage = dynamic_stage(15 / speed, 0.1 / speed, Vector3d::Zero());
    stage.incoming_waves = {{0, 0, pulse(0.01, 30 / speed)}};
    IncomingWave late = stage.incoming_waves[0];
    late.slowness = {0.02, 0, 0};
    late.origin = {-0.1, 0, 0};  // 2 ms
    State now = initial_state(model), later = initial_state(model);
    run_quietly(model, {stage}, now);
    stage.incoming_waves = {late};
    stage.duration += 2e-3;
    run_quietly(model, {stage}, later);
    EXPECT_NEAR(centroid(model, later, 0).x(), centroid(model, now, 0).x(), 1e-3 * centroid(model, now, 0).x());
}

// Sides that are tied: under pressure from above they do not give way, and shear does not turn the block.
TEST_P(Boundary, TiesTheSidesOfAColumn)
{
    const Model model = column(GetParam(), 10);
    State state = initial_state(model);
    Stage stage = dynamic_stage(0.02, 1e-4, Vector3d::Zero());
    stage.incoming_waves = {{0, 0, pulse(0.1, 0.01)}, {0, 2, pulse(0.1, 0.01)}};
    run_quietly(model, {stage}, state);
    for (int b = 0; b < 10; ++b) {
        const Eigen::Matrix3d map = pose_of(model.kinematics, state, b).map;
        EXPECT_EQ(map.col(0), Vector3d::UnitX());
        EXPECT_EQ(map.col(1), Vector3d::UnitY());
        EXPECT_NE(map(0, 2), 0);
        EXPECT_NE(map(2, 2), 1);
    }
}

}  // namespace voussoir::testing
