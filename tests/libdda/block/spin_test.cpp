// A torque-free tumbling block: momentum, energy and volume over 100 turns.
#include <gtest/gtest.h>
#include <Eigen/LU>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

constexpr double spin_rate = 2;  // rad/s
const Eigen::Vector3d spin_axis = Eigen::Vector3d(0.3, 1, 0.2).normalized();

Model tumbling_block(Kinematics kinematics)
{
    Model model = make_model(kinematics, {"stone", 2400, 4.5e9, 0.25}, dry(30));
    add_box(model, "block", {-0.5, -0.3, -0.15}, {0.5, 0.3, 0.15});
    return model;
}

struct Tumbling {
    double momentum_error = 0, energy_error = 0, volume_error = 0, late_volume_error = 0;
};

Tumbling tumble(Kinematics kinematics, double h, double turns)
{
    const Model model = tumbling_block(kinematics);
    State state = initial_state(model);
    set_velocity(model, state, 0, Eigen::Vector3d::Zero(), spin_rate * spin_axis);
    const Eigen::Vector3d momentum = angular_momentum(model, state, 0);
    const double energy = kinetic_energy(model, state), duration = turns * 2 * std::numbers::pi / spin_rate;
    Tumbling worst;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const double momentum_error = (angular_momentum(model, now, 0) - momentum).norm() / momentum.norm();
        const double total = kinetic_energy(model, now) + strain_energy(model, now);
        const double volume = std::abs(pose_of(model.kinematics, now, 0).map.determinant() - 1);
        worst.momentum_error = std::max(worst.momentum_error, momentum_error);
        worst.energy_error = std::max(worst.energy_error, std::abs(total / energy - 1));
        worst.volume_error = std::max(worst.volume_error, volume);
        if (now.time > 0.9 * duration) worst.late_volume_error = std::max(worst.late_volume_error, volume);
    };
    run(model, {dynamic_stage(duration, h, Eigen::Vector3d::Zero())}, state, observer);
    return worst;
}

}  // namespace

TEST(Spin, RigidBlockKeepsMomentumVolumeAndEnergy)
{
    const Tumbling coarse = tumble(Kinematics::spatial_rigid, 1e-2, 20);
    const Tumbling fine = tumble(Kinematics::spatial_rigid, 5e-3, 20);
    const Tumbling full = tumble(Kinematics::spatial_rigid, 5e-3, 100);
    const double order = std::log2(coarse.energy_error / fine.energy_error);
    std::printf("rigid spin, 100 turns at 5 ms: momentum %.1e, volume %.1e, energy %.1e, order in h %.2f\n",
                full.momentum_error, full.volume_error, full.energy_error, order);
    EXPECT_LT(full.momentum_error, 1e-9);
    EXPECT_LT(full.volume_error, 1e-12);
    EXPECT_LT(full.energy_error, 1e-5);
    EXPECT_GT(order, 1.8);
}

// Centrifugal volume strain (1 - 2 nu)/E rho w^2 (Lx^2 + Ly^2)/12, for the axis where it is largest.
TEST(Spin, DeformableBlockStretchesNoMoreThanItShould)
{
    const Tumbling full = tumble(Kinematics::spatial_deformable, 5e-3, 100);
    const double strain = (1 - 2 * 0.25) / 4.5e9 * 2400 * spin_rate * spin_rate * (1 + 0.36) / 12;
    std::printf(
        "deformable spin, 100 turns at 5 ms: momentum %.1e, volume strain %.2e (last tenth %.2e, closed form "
        "%.2e), energy %.1e\n",
        full.momentum_error, full.volume_error, full.late_volume_error, strain, full.energy_error);
    EXPECT_LT(full.momentum_error, 1e-9);
    EXPECT_LT(full.volume_error, 2 * strain);
    EXPECT_LT(full.late_volume_error, 1.05 * full.volume_error);
}

}  // namespace voussoir::testing
