// The integrators: damping at structural frequencies, and no energy from impacts.
#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <memory>

#include "libdda/contact/initial_contacts.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

Stage with_integrator(Stage stage, Integrator integrator)
{
    stage.control.integrator = integrator;
    return stage;
}

/// Displacement along an axis and velocity / omega of a block that does not turn on a bonded elastic joint, after
/// n steps of omega h.
Eigen::Vector2d oscillate(Integrator integrator, int axis, double omega_h, int steps, double displacement,
                          double velocity)
{
    JointMaterial glued = dry(30);
    glued.cohesion = glued.tensile_strength = 1e15;
    glued.stiffness = {ContactStiffness::Kind::per_area, 1e9};
    Model model = make_model(Kinematics::spatial_rigid, stone(), glued);
    hold(model, add_box(model, "base", {-1, -1, -1}, {1, 1, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
    Foundation guide;
    guide.block = block;
    guide.translation_held = {false, false, false};
    model.foundations.push_back(guide);
    const double stiffness = axis == 2 ? 1e9 : glued.shear_to_normal_stiffness * 1e9;
    const double omega = std::sqrt(stiffness / model.mass(block)), h = omega_h / omega;
    const Eigen::Vector3d start = 0.5 * Eigen::Vector3d::UnitZ();
    State state = initial_state(model);
    find_initial_contacts(model, state);  // bonded where it rests
    state.coordinates[block * coordinates_per_block(model.kinematics) + axis] += displacement;
    const double sign = state.contacts.patches[0].block_a == block ? 1 : -1;
    if (axis != 2)  // shear springs know how far they were stretched
        for (ContactPoint& p : state.contacts.points) p.elastic_slip[axis] = sign * displacement;
    set_velocity(model, state, block, velocity * omega * Eigen::Vector3d::Unit(axis));
    Stage stage = with_integrator(dynamic_stage(steps * h, h, Eigen::Vector3d::Zero()), integrator);
    stage.control.force_tolerance = 1e-12;
    stage.control.dissipation = 0.1;  // of energy_decaying; its rule's falls with the step
    run_quietly(model, {stage}, state);
    return {(centroid(model, state, block) - start)[axis],
            velocity_of(model.kinematics, state, block)[axis] / omega};
}

/// Damping ratio of a linear mode: n steps shrink areas of the (displacement, velocity / omega) plane by
/// exp(-2 xi omega h n), whatever the phase.
double measured_damping(Integrator integrator, int axis, double omega_h)
{
    constexpr int steps = 20;
    constexpr double size = 1e-6;
    Eigen::Matrix2d area;
    area.col(0) = oscillate(integrator, axis, omega_h, steps, size, 0);
    area.col(1) = oscillate(integrator, axis, omega_h, steps, 0, size);
    return -std::log(area.determinant() / (size * size)) / (2 * omega_h * steps);
}

struct Drop {
    double rebound = 0;       // m, first
    double largest_gain = 0;  // J per step, of the total energy
    double start = 0;         // J
};

/// A stiff block falls 3 m onto a held plane. Source: docs/numerics.md 4.
Drop drop(Integrator integrator, double stiffness_per_corner, double h)
{
    JointMaterial joint = dry(31);
    joint.stiffness = {ContactStiffness::Kind::per_point, stiffness_per_corner};
    Model model = make_model(Kinematics::spatial_deformable, {"stone", 2500, 1e12, 0.2}, joint);
    hold(model, add_box(model, "plane", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 3}, {0.5, 0.5, 3.3});
    State state = initial_state(model);
    Drop result;
    result.start = model.mass(block) * gravity * 3;
    bool touched = false, falling_again = false;
    double last = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport& report) {
        const EnergyLedger& e = report.energy;
        const double total = e.kinetic + e.strain + e.contact - e.gravity_work;
        result.largest_gain = std::max(result.largest_gain, total - last);
        last = total;
        touched = touched || e.contact > 0;
        const double up = velocity_of(model.kinematics, now, block).z();
        const double height = centroid(model, now, block).z() - 0.15;
        if (touched && !falling_again)
            result.rebound = std::max(result.rebound, up > 0 || height < 0 ? height : 0.0);
        falling_again = falling_again || (touched && height > 0.01 && up < 0);
    };
    run(model, {with_integrator(dynamic_stage(2.4, h), integrator)}, state, observer);
    return result;
}

/// A running-bond wall one stone thick, on a held base that moves.
Model running_bond_wall(Kinematics kinematics, int courses, int stones)
{
    Model model = make_model(kinematics, {"stone", 2000, 2e9, 0.2}, dry(31));
    const double length = 0.6, height = 0.3, depth = 0.3;
    hold(model, add_box(model, "base", {-1, 0, -0.3}, {stones * length + 1, depth, 0}));
    for (int course = 0; course < courses; ++course) {
        const bool shifted = course % 2 == 1;
        const double z = course * height;
        for (int i = 0; i < stones + shifted; ++i) {
            const double from = std::max(0.0, (i - 0.5 * shifted) * length);
            const double to = std::min(stones * length, (i + 1 - 0.5 * shifted) * length);
            add_box(model, "stone " + std::to_string(course) + "." + std::to_string(i), {from, 0, z},
                    {to, depth, z + height});
        }
    }
    return model;
}

}  // namespace

// One step multiplies the phase-space area by det = (1 + W^2 (1 - theta)/4) / (1 + W^2 (1 + theta)/4), W = omega
// h, so that xi = -ln(det) / (2 W), theta W / 4 for small W.
TEST(Integrator, DampingRatioAgainstOmegaH)
{
    const auto exact = [](double theta, double w) {
        return -std::log((1 + w * w * (1 - theta) / 4) / (1 + w * w * (1 + theta) / 4)) / (2 * w);
    };
    std::printf("damping ratio of a linear mode\n  omega h   newmark   exact   energy_decaying   exact\n");
    for (const int axis : {2, 0})  // normal and shear springs
        for (const double omega_h : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0}) {
            const double newmark = measured_damping(Integrator::newmark, axis, omega_h);
            const double decaying = measured_damping(Integrator::energy_decaying, axis, omega_h);
            std::printf("  %7.2f %9.5f %9.5f %13.5f %9.5f\n", omega_h, newmark, exact(1, omega_h), decaying,
                        exact(0.1, omega_h));
            EXPECT_NEAR(newmark, exact(1, omega_h), 1e-3 * exact(1, omega_h));
            EXPECT_NEAR(decaying, exact(0.1, omega_h), 1e-3 * exact(0.1, omega_h));
        }
}

TEST(Integrator, ImpactNeverGainsEnergy)
{
    std::printf("drop of 3 m, h = 1 ms: first rebound [m]\n  N/m per corner   newmark   energy_decaying\n");
    for (const double k : {1e9, 1e11, 1e13}) {
        const Drop newmark = drop(Integrator::newmark, k, 1e-3);
        const Drop decaying = drop(Integrator::energy_decaying, k, 1e-3);
        std::printf("  %14.0e %9.3f %17.3f\n", k, newmark.rebound, decaying.rebound);
        for (const Drop& result : {newmark, decaying}) {
            EXPECT_LT(result.rebound, 3.0);
            EXPECT_LT(result.largest_gain, 1e-7 * result.start);
        }
    }
}

TEST(Integrator, ShakenWallNeverGainsEnergy)
{
    double duration = 1;
#if defined(__SANITIZE_ADDRESS__)
    duration = 0.1;  // forty times slower, and looking for faults of memory, not of physics
#endif
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::spatial_rigid})
        for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying}) {
            const Model model = running_bond_wall(kinematics, 10, 10);
            ASSERT_GE(model.blocks.size(), 100U);
            State state = initial_state(model);
            Stage shaking = with_integrator(dynamic_stage(duration, 2e-3), integrator);
            shaking.motions = {
                {0, 0,
                 std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(0.5 * gravity, 2.5, 0, 10))}};
            double least = 0, largest = 0, last = 0;
            RunObserver observer;
            observer.step = [&](const State&, const StepReport&, const RunReport& report) {
                const EnergyLedger& e = report.energy;
                least = std::min(least, e.algorithmic - last);
                largest = std::max(largest, e.kinetic);
                last = e.algorithmic;
            };
            const RunReport report = run(model, {static_stage(0.1), shaking}, state, observer);
            const EnergyLedger& e = report.energy;
            std::printf(
                "wall of %zu, %s, %s: %lld steps, %lld iterations, %lld cuts, kinetic at most %.0f J, friction "
                "%.0f J, algorithmic %.1f J (least per step %.1e), rotation %.1e, redetection %.1e, residual "
                "%.1e\n",
                model.blocks.size(), std::string(name_of(kinematics)).c_str(),
                integrator == Integrator::newmark ? "newmark" : "energy_decaying",
                static_cast<long long>(report.steps), static_cast<long long>(report.open_close_iterations),
                static_cast<long long>(report.step_cuts), largest, e.friction, e.algorithmic, least,
                e.algorithmic_rotation, e.redetection, e.relative_residual());
            EXPECT_EQ(report.outcome, Outcome::completed);
            EXPECT_GT(least, -1e-6 * largest);
            EXPECT_GE(e.friction, 0);
            EXPECT_LT(e.relative_residual(), 1e-3);
        }
}

// Where no contact changes its state a step is one linear problem: whatever the integrator, one solve.
TEST(Integrator, TakesOneIterationWhereNoContactChanges)
{
    for (const Kinematics kinematics : {Kinematics::spatial_rigid, Kinematics::planar_rigid})
        for (const double dissipation : {-1.0, 0.0, 0.1, 1.0}) {  // -1: newmark
            Model model = block_on_plane(kinematics, 45);
            add_box(model, "upper", {-0.4, -0.4, 0.3}, {0.4, 0.4, 0.6});
            Stage shaking = dynamic_stage(0.2, 1e-3);
            shaking.motions = {
                {0, 0, std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(0.1 * gravity, 5, 0, 1))}};
            if (dissipation >= 0) {
                shaking.control.integrator = Integrator::energy_decaying;
                shaking.control.dissipation = dissipation;
            }
            State state = initial_state(model);
            run_quietly(model, {static_stage(0.1)}, state);
            begin_stage(model, 0, state);
            const RunReport report = run_quietly(model, {shaking}, state);
            ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
            EXPECT_LE(report.open_close_iterations, report.steps + 5) << dissipation;
        }
}

}  // namespace voussoir::testing
