// Every boundary and every damping in one scene: the balance of the energy closes, and each term is needed.
#include <gtest/gtest.h>

#include <cmath>

#include "libdda/analysis/energies.h"
#include "tests/libdda/ground_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

constexpr int columns = 4, rows = 6;

/// A grid on a viscous base, its lower rows beside a free field, its upper ones tied across; a stone slides on it,
/// and another jumps on a base that moves.
Model ground_with_all()
{
    Model model = grid(Kinematics::planar_deformable, columns, rows);
    model.materials[0].rayleigh = {2, 1e-4};
    model.materials[0].branches = hysteretic_branches(0.05, 5, 200);
    ViscousBoundary base = base_of(model, columns);
    ViscousBoundary flanks{"flanks", {}, RestSupport::normal, {}};
    for (const bool left : {true, false})
        for (int j = 0; j < rows / 2; ++j) {
            const int edge = columns * j + (left ? 0 : columns - 1);
            flanks.faces.push_back(face_of_box(model, edge, (left ? -1.0 : 1.0) * Vector3d::UnitX()));
            const double x = left ? -5.0 : 4.0;
            const int block = add_box(model, "column", {x, -0.5, 1.0 * j}, {x + 1, 0.5, j + 1.0});
            model.tied_sides.push_back(block);
            flanks.free_field.push_back(block);
            if (j == 0) base.faces.push_back(face_of_box(model, block, -Vector3d::UnitZ()));
        }
    model.boundaries = {base, flanks};
    for (int j = rows / 2; j < rows; ++j)
        model.side_ties.push_back({face_of_box(model, columns * (j + 1) - 1, Vector3d::UnitX()),
                                   face_of_box(model, columns * j, -Vector3d::UnitX()), 100 * ground.young,
                                   100 * ground.young});
    // Stones of group 1, whose joints are dry and have dashpots.
    model.groups.push_back("stones");
    JointMaterial joint = dry(20);
    joint.relaxation_time = 1e-4;
    model.joints.push_back(joint);
    model.joint_of_groups = {0, 1, 1, 1};
    const double top = rows;
    for (const auto& [from, z] : {std::pair{-0.5, top}, {10.5, 0.0}})
        model.blocks[static_cast<std::size_t>(add_box(model, "stone", {from, -0.5, z}, {from + 1, 0.5, z + 0.4}))]
            .group = 1;
    const int table = add_box(model, "table", {8, -0.5, -1}, {14, 0.5, 0});
    model.blocks[static_cast<std::size_t>(table)].group = 1;
    hold(model, table);
    return model;
}

}  // namespace

// Kinetic and strain energy, the work of gravity and what the kinetic damping took are found from the motion by
// itself; the others each must be there, and half of any of them is missed.
TEST(WholeBalance, ClosesWithEveryBoundaryAndDamping)
{
    const Model model = ground_with_all();
    const int blocks = static_cast<int>(model.blocks.size()), table = blocks - 1, slider = blocks - 3,
              jumper = blocks - 2;
    State state = initial_state(model);
    ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
    begin_stage(model, 0, state);
    set_velocity(model, state, slider, {1, 0, 0});
    set_velocity(model, state, jumper, {0, 0, 0.3});
    Stage stage = dynamic_stage(0.12, 5e-4);
    stage.control.force_tolerance = 1e-9;
    stage.damping.rate = 0.5;
    stage.incoming_waves = {{0, 0, pulse(0.3, 0.1)}, {0, 2, pulse(0.1, 0.15)}};
    stage.motions = {{0, 0, pulse(0.5, 0.2)}};
    const State start = state;
    const auto ground_speed = [&](double time) { return stage.motions[0].motion->velocity(time); };
    double damped = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        // What is left is the ground's velocity and exp(-c h) of the velocity relative to it.
        State before = now;
        const double left = std::exp(-stage.damping.rate * stage.control.time_step);
        for (double& velocity : before.velocities) velocity /= left;
        for (int b = 0; b < blocks; ++b)
            before.velocities[6 * static_cast<std::size_t>(b)] -= ground_speed(now.stage_time) * (1 / left - 1);
        damped += kinetic_energy(model, before) - kinetic_energy(model, now);
    };
    const RunReport report = run(model, {stage}, state, observer);
    ASSERT_EQ(report.outcome, Outcome::completed);
    const EnergyLedger& e = report.energy;
    std::printf(
        "gravity %.1f, foundation %.1f, boundary %.1f, friction %.1f, kinetic damping %.2f (by the motion %.2f), "
        "dashpots of joints %.3f, material %.2f, integrator %.3f, kinetic %.1f J, residual %.1e\n",
        e.gravity_work, e.foundation_work, e.boundary_work, e.friction, e.damping_kinetic, damped,
        e.damping_contact, e.damping_material, e.algorithmic, e.kinetic, e.relative_residual());
    EXPECT_LT(e.relative_residual(), 1e-6);
    double lifted = 0;
    for (int b = 0; b < blocks; ++b)
        if (b != table) lifted += model.mass(b) * (centroid(model, state, b) - centroid(model, start, b)).z();
    EXPECT_NEAR(e.gravity_work, -gravity * lifted, 1e-6 * std::abs(gravity * lifted));
    EXPECT_NEAR(e.kinetic, kinetic_energy(model, state), 1e-9 * e.kinetic);
    EXPECT_NEAR(e.damping_kinetic, damped, 0.01 * damped);
    for (double EnergyLedger::*term :
         {&EnergyLedger::kinetic, &EnergyLedger::strain, &EnergyLedger::contact, &EnergyLedger::gravity_work,
          &EnergyLedger::foundation_work, &EnergyLedger::boundary_work, &EnergyLedger::friction,
          &EnergyLedger::damping_kinetic, &EnergyLedger::damping_contact, &EnergyLedger::damping_material}) {
        EXPECT_NE(e.*term, 0);
        EnergyLedger falsified = e;
        falsified.*term *= 0.5;
        EXPECT_GT(falsified.relative_residual(), 100 * e.relative_residual());
    }
}

}  // namespace voussoir::testing
