// Sides that are one and the same: a model some blocks wide moves as ground that goes on for ever.
#include "libdda/forces/side_ties.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdda/ground_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class SideTies : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, SideTies,
                         ::testing::Values(Kinematics::spatial_deformable, Kinematics::planar_deformable),
                         test_name);

/// Ties the last block of every row to the first.
void tie_rows(Model& model, int columns, int rows, double stiffness)
{
    for (int j = 0; j < rows; ++j)
        model.side_ties.push_back({face_of_box(model, columns * (j + 1) - 1, Vector3d::UnitX()),
                                   face_of_box(model, columns * j, -Vector3d::UnitX()), stiffness, stiffness});
}

constexpr int columns = 4, rows = 12;

Model tied_grid(Kinematics kinematics)
{
    Model model = grid(kinematics, columns, rows);
    model.boundaries.push_back(base_of(model, columns));
    tie_rows(model, columns, rows, 100 * ground.young);
    return model;
}

}  // namespace

// P along z: sides that were free would give way sideways, and the wave would be slower. (In space the other two
// sides are free, so that S is what both have.)
TEST_P(SideTies, MoveAsOne)
{
    const bool pressure = is_planar(GetParam());
    const Model model = tied_grid(GetParam());
    const double speed = std::sqrt(modulus(pressure) / ground.density);
    Stage stage = dynamic_stage(60 / speed, 0.25 / speed, Vector3d::Zero());
    stage.control.dissipation = 0;
    stage.control.force_tolerance = 1e-10;
    stage.incoming_waves = {{0, pressure ? 2 : 0, pulse(0.01, 36 / speed)}};
    State state = initial_state(model);
    std::vector<double> largest(columns, 0);
    RunObserver observer;
    double most = 0;
    observer.step = [&](const State& now, const StepReport&, const RunReport& report) {
        for (int i = 0; i < columns; ++i) {
            const Vector3d v = velocity_of(model.kinematics, now, columns * (rows - 1) + i);
            largest[i] = std::max(largest[i], pressure ? v.z() : v.x());
        }
        most = std::max(most, report.energy.kinetic);
    };
    const RunReport report = run(model, {stage}, state, observer);
    EXPECT_EQ(report.outcome, Outcome::completed);
    for (const double each : largest) EXPECT_NEAR(each, 0.02, 0.01 * 0.02);
    EXPECT_LT(report.energy.relative_residual(), 1e-8);
    // All of it leaves through the base again.
    EXPECT_LT(report.energy.kinetic + report.energy.strain, 1e-3 * most);
}

// What leaves on one side comes in on the other: blocks pushed sideways all alike drift on, and a push on one is
// felt by its neighbour across the side as by the one beside it.
TEST_P(SideTies, CarryAPushAcross)
{
    Model model = grid(GetParam(), columns, 1);
    tie_rows(model, columns, 1, 100 * ground.young);
    State state = initial_state(model);
    set_velocity(model, state, 0, {0.01, 0, 0});
    Stage stage = dynamic_stage(3e-3, 1e-5, Vector3d::Zero());
    stage.control.dissipation = 0;
    stage.control.force_tolerance = 1e-10;
    const RunReport report = run_quietly(model, {stage}, state);
    EXPECT_NEAR(centroid(model, state, columns - 1).x() - 1.5, centroid(model, state, 1).x() + 0.5, 4e-8);
    EXPECT_GT(centroid(model, state, columns - 1).x() - 1.5, 1e-6);
    double momentum = 0;
    for (int b = 0; b < columns; ++b) momentum += velocity_of(GetParam(), state, b).x();
    EXPECT_NEAR(momentum, 0.01, 1e-9);
    EXPECT_LT(report.energy.relative_residual(), 1e-8);
}

// With the integrator's own damping the loss of the ties is booked with the others'.
TEST_P(SideTies, BookWhatTheIntegratorTakes)
{
    Model model = grid(GetParam(), columns, 1);
    tie_rows(model, columns, 1, 100 * ground.young);
    State state = initial_state(model);
    set_velocity(model, state, 0, {0.01, 0, 0});
    Stage stage = dynamic_stage(0.05, 2e-4, Vector3d::Zero());
    stage.control.dissipation = 1;
    stage.control.force_tolerance = 1e-10;
    const RunReport report = run_quietly(model, {stage}, state);
    EXPECT_GT(report.energy.algorithmic, 0.1 * report.energy.start_kinetic);
    EXPECT_LT(report.energy.relative_residual(), 1e-7);
}

}  // namespace voussoir::testing
