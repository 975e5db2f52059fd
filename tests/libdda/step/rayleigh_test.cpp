// Rayleigh damping: a block that stretches by itself loses its amplitude at the rate that was asked for.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdda/block/kinematics_traits.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class Rayleigh : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Rayleigh,
                         ::testing::Values(Kinematics::spatial_deformable, Kinematics::planar_deformable),
                         test_name);

// One free block of Poisson's ratio 0 and length L, whose stretch is an oscillator: V E q + rho V L^2/12 q'' = 0.
constexpr double length = 2, density = 2000, young = 2e8;
const double omega = std::sqrt(12 * young / density) / length;  // 1/s

Model block_with(Kinematics kinematics, const RayleighDamping& damping)
{
    BlockMaterial material{"ground", density, young, 0};
    material.rayleigh = damping;
    Model model = make_model(kinematics, material, dry(30));
    add_box(model, "block", {-0.5, -0.5, -0.5 * length}, {0.5, 0.5, 0.5 * length});
    return model;
}

/// Gives the block a rate of stretch along z [1/s].
void stretch(const Model& model, double rate, State& state)
{
    state.velocities[unknowns_per_block(model.kinematics) - 1] = rate;
}

}  // namespace

// The amplitude after ten cycles, of damping by mass, by stiffness and by both.
TEST_P(Rayleigh, DecaysAtTheRatioAskedFor)
{
    const double ratio = 0.02, cycle = 2 * std::numbers::pi / (omega * std::sqrt(1 - ratio * ratio));
    for (const RayleighDamping damping :
         {RayleighDamping{2 * ratio * omega, 0}, {0, 2 * ratio / omega}, {ratio * omega, ratio / omega}}) {
        const Model model = block_with(GetParam(), damping);
        State state = initial_state(model);
        stretch(model, 1e-4 * omega, state);
        Stage stage = dynamic_stage(10 * cycle, cycle / 200, Vector3d::Zero());
        stage.control.dissipation = 0;
        const RunReport report = run_quietly(model, {stage}, state);
        const double kept = state.velocities[unknowns_per_block(GetParam()) - 1] / (1e-4 * omega);
        EXPECT_NEAR(std::log(kept), -ratio * omega * 10 * cycle, 0.01 * ratio * omega * 10 * cycle);
        EXPECT_NEAR(report.energy.damping_material, (1 - kept * kept) * report.energy.start_kinetic,
                    1e-3 * report.energy.start_kinetic);
        EXPECT_LT(report.energy.relative_residual(), 1e-8);
        EXPECT_NEAR(report.energy.algorithmic, 0, 1e-10 * report.energy.start_kinetic);
        EXPECT_NEAR(report.energy.algorithmic_rotation, 0, 1e-6 * report.energy.start_kinetic);
    }
}

// A block in flight is slowed by mass damping alone: v = v0 exp(-a t), its spin alike; stiffness knows no flight.
TEST_P(Rayleigh, SlowsAFlightByItsMassPart)
{
    const Model model = block_with(GetParam(), {2, 1e-3});
    State state = initial_state(model);
    set_velocity(model, state, 0, {1, 0, 2}, {0, 0.3, 0});
    const RunReport report = run_quietly(model, {dynamic_stage(0.7, 1e-3, Vector3d::Zero())}, state);
    const double kept = std::exp(-2 * 0.7);
    EXPECT_NEAR(velocity_of(GetParam(), state, 0).z(), 2 * kept, 1e-4);
    EXPECT_NEAR(angular_velocity_of(model, state, 0).y(), 0.3 * kept, 1e-4);
    EXPECT_LT(report.energy.relative_residual(), 1e-8);
}

// A static stage has none of it: it neither slows nor is booked.
TEST_P(Rayleigh, LeavesStaticStagesAlone)
{
    const auto settled = [&](const RayleighDamping& damping) {
        Model model = block_with(GetParam(), damping);
        hold(model, add_box(model, "floor", {-1, -1, -2}, {1, 1, -0.5 * length}));
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {static_stage(0.1)}, state);
        EXPECT_EQ(report.energy.damping_material, 0);
        return hash_of(state);
    };
    EXPECT_EQ(settled({2, 1e-3}), settled({}));
}

}  // namespace voussoir::testing
