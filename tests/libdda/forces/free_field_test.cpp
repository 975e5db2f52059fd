// Ground beside a model that moves as it would without it: its sides neither drain a wave from below nor send one
// back.
#include "libdda/forces/free_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdda/ground_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class FreeField : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, FreeField,
                         ::testing::Values(Kinematics::spatial_deformable, Kinematics::planar_deformable),
                         test_name);

constexpr int columns = 6, rows = 16;

/// What the sides of the grid are.
enum class Sides { open, viscous, free_field };

/// A grid on a viscous base. Its columns of ground are two metres to its sides; the first blocks are the grid's.
Model ground_with(Kinematics kinematics, Sides sides)
{
    Model model = grid(kinematics, columns, rows);
    model.joints[0].face = FaceLaw::corners;  // ground that shears and stretches: nothing of it bends
    ViscousBoundary base = base_of(model, columns);
    ViscousBoundary flanks{"flanks", {}, RestSupport::normal, {}};
    const double half = 0.5 * columns;
    for (const bool left : {true, false})
        for (int j = 0; j < rows; ++j) {
            const int edge = columns * j + (left ? 0 : columns - 1);
            flanks.faces.push_back(face_of_box(model, edge, (left ? -1.0 : 1.0) * Vector3d::UnitX()));
            const double x = left ? -half - 3 : half + 2;
            const int block = add_box(model, "column", {x, -0.5, 1.0 * j}, {x + 1, 0.5, j + 1.0});
            model.tied_sides.push_back(block);
            flanks.free_field.push_back(block);
            if (j == 0) base.faces.push_back(face_of_box(model, block, -Vector3d::UnitZ()));
        }
    if (sides == Sides::viscous) flanks.free_field.clear();
    model.boundaries.push_back(base);
    if (sides != Sides::open) model.boundaries.push_back(flanks);
    return model;
}

/// Largest velocity along an axis of each block of the surface.
std::vector<double> surface_of(const Model& model, int axis, RunReport& report)
{
    const double speed = std::sqrt(modulus(axis == 2) / ground.density);
    Stage stage = dynamic_stage(60 / speed, 0.5 / speed, Vector3d::Zero());
    stage.incoming_waves = {{0, axis, pulse(0.01, 40 / speed)}};
    State state = initial_state(model);
    std::vector<double> largest(columns, 0);
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        for (int i = 0; i < columns; ++i)
            largest[i] = std::max(largest[i], velocity_of(model.kinematics, now, columns * (rows - 1) + i)[axis]);
    };
    report = run(model, {stage}, state, observer);
    EXPECT_EQ(report.outcome, Outcome::completed);
    return largest;
}

}  // namespace

// The surface moves twice as much as the wave, at the sides as in the middle; viscous sides alone take a good
// part.
TEST_P(FreeField, DrainsNoWaveThatRunsUpwards)
{
    for (const int axis : {0, 2}) {
        if (axis == 2 && !is_planar(GetParam())) continue;  // its other sides are open
        RunReport report;
        for (const double each : surface_of(ground_with(GetParam(), Sides::free_field), axis, report))
            EXPECT_NEAR(each, 0.02, 0.01 * 0.02) << axis;
        EXPECT_LT(report.energy.relative_residual(), 1e-8);
        const std::vector<double> drained = surface_of(ground_with(GetParam(), Sides::viscous), axis, report);
        EXPECT_LT(drained.front(), 0.9 * 0.02);
    }
}

// Its stress is half of it: where the sides are open, P from below finds no resistance sideways.
TEST_P(FreeField, PressesAsTheGroundDoes)
{
    if (!is_planar(GetParam())) return;
    RunReport report;
    const std::vector<double> open = surface_of(ground_with(GetParam(), Sides::open), 2, report);
    EXPECT_GT(std::abs(open.front() / 0.02 - 1), 0.02);
}

// A push in the middle leaves through the sides as it would through dashpots against ground at rest.
TEST_P(FreeField, LetsWavesOutSideways)
{
    const auto left_over = [&](Sides sides) {
        const Model model = ground_with(GetParam(), sides);
        State state = initial_state(model);
        for (int j = 4; j < 12; ++j) set_velocity(model, state, columns * j + columns / 2, {0.01, 0, 0});
        const double before = kinetic_energy(model, state);
        const double speed = std::sqrt(modulus(false) / ground.density);
        Stage stage = dynamic_stage(40 / speed, 0.25 / speed, Vector3d::Zero());
        stage.control.force_tolerance = 1e-9;
        const RunReport report = run_quietly(model, {stage}, state);
        EXPECT_LT(report.energy.relative_residual(), 1e-8);
        double grid_only = 0;
        for (int b = 0; b < columns * rows; ++b)
            grid_only += 0.5 * model.mass(b) * velocity_of(GetParam(), state, b).squaredNorm();
        return grid_only / before;
    };
    const double open = left_over(Sides::open), sides = left_over(Sides::free_field);
    EXPECT_LT(sides, 0.2 * open);
    EXPECT_NEAR(sides, left_over(Sides::viscous), 1e-9);
}

// The columns feel nothing of the grid: they move alike whatever stands beside them.
TEST_P(FreeField, FeelsNothingOfTheModel)
{
    const Model model = ground_with(GetParam(), Sides::free_field);
    State state = initial_state(model);
    set_velocity(model, state, columns / 2, {0.1, 0, 0});
    run_quietly(model, {dynamic_stage(0.02, 2e-4, Vector3d::Zero())}, state);
    for (const int block : model.tied_sides) EXPECT_LT(velocity_of(GetParam(), state, block).norm(), 1e-12);
    EXPECT_GT(velocity_of(GetParam(), state, 0).norm(), 1e-6);
}

// At rest the columns press on the sides by rho g z nu / (1 - nu), so that the grid settles as ground without
// sides, and nothing moves when the dashpots take over.
TEST_P(FreeField, RestsAsTheGroundDoes)
{
    if (!is_planar(GetParam())) return;
    const Model model = ground_with(GetParam(), Sides::free_field);
    State state = initial_state(model);
    ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
    const int edge = columns * 4, column = columns * rows + 4;
    const double sunk = 4.5 - centroid(model, state, column).z();
    EXPECT_GT(sunk, 1e-6);
    EXPECT_NEAR(4.5 - centroid(model, state, edge).z(), sunk, 0.01 * sunk);
    const Eigen::Matrix3d stress = stress_of(model, state, edge);
    EXPECT_NEAR(stress(0, 0) / stress(2, 2), ground.poisson / (1 - ground.poisson), 0.01);
    const Vector3d before = centroid(model, state, edge);
    begin_stage(model, 0, state);
    const RunReport report = run_quietly(model, {dynamic_stage(0.1, 1e-3)}, state);
    EXPECT_LT((centroid(model, state, edge) - before).norm(), 1e-4 * sunk);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

}  // namespace voussoir::testing
