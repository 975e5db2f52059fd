// What a run is said to be worth: the damping of integrators as it is, and warnings where they are due and nowhere
// else.
#include "libdda/analysis/trust.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "libdda/analysis/integrator_accuracy.h"
#include "libdda/contact/initial_contacts.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

constexpr double two_pi = 2 * std::numbers::pi;
using Kind = TrustFinding::Kind;

bool has(const Trust& trust, Kind kind)
{
    return std::any_of(trust.findings.begin(), trust.findings.end(),
                       [&](const TrustFinding& finding) { return finding.kind == kind; });
}

TEST(IntegratorAccuracy, FollowsItsExpansionForShortSteps)
{
    for (const double share : {0.0, 0.02, 0.1, 1.0}) {
        const double angle = 1e-2;
        const IntegratorAccuracy accuracy = integrator_accuracy(angle, share);
        EXPECT_NEAR(accuracy.damping, share * angle / 4, 1e-3 * angle * share + 1e-12);
        const double expected = angle * angle / 12;
        if (share < 0.5) {
            EXPECT_NEAR(accuracy.period_error, expected, 0.02 * angle * angle);
        }
    }
    EXPECT_NEAR(integrator_accuracy(100, 0).damping, 0, 1e-12) << "the mean force conserves energy at any step";
    EXPECT_EQ(integrator_accuracy(10, 1).damping, 1) << "newmark: gone after a step";
}

/// A rigid block on springs that is let go half way between where it would lift off and where it would rest.
struct Bouncing {
    Model model;
    State state;
    Stage stage;

    Bouncing(Integrator integrator, double dissipation, double frequency, double step)
    {
        JointMaterial joint = dry(35);
        const double omega = two_pi * frequency;
        joint.stiffness = {ContactStiffness::Kind::per_area, 2500 * 0.3 * omega * omega};
        model = make_model(Kinematics::planar_rigid, stone(), joint);
        hold(model, add_box(model, "floor", {-2, 0, -1}, {2, 1, 0}));
        add_box(model, "block", {-0.3, 0, 0}, {0.3, 1, 0.3});
        state = initial_state(model);
        state.coordinates[3 + 1] -= 0.5 * gravity / (omega * omega);
        stage = dynamic_stage(2, step);
        stage.control.integrator = integrator;
        stage.control.dissipation = dissipation;
    }
};

TEST(IntegratorAccuracy, IsWhatTheEngineDoesToAVibration)
{
    const struct {
        Integrator integrator;
        double dissipation, share, step;
    } cases[] = {{Integrator::newmark, 0, 1, 2e-3},
                 {Integrator::newmark, 0, 1, 8e-3},
                 {Integrator::energy_decaying, 0.1, 0.1, 8e-3}};
    for (const auto& each : cases) {
        Bouncing scene(each.integrator, each.dissipation, 10, each.step);
        const double start = scene.model.mass(1) * gravity * gravity / std::pow(two_pi * 10, 2) / 8;
        const RunReport report = run(scene.model, {scene.stage}, scene.state, {});
        const EnergyLedger& e = report.energy;
        // Of the vibration about the place of rest, which lies as deep below the start as its amplitude is large.
        const double left = e.kinetic + e.contact - e.gravity_work;
        const IntegratorAccuracy accuracy = integrator_accuracy(two_pi * 10 * each.step, each.share);
        const double turns = 2 * 10 / (1 + accuracy.period_error);
        const double exponent = 2 * accuracy.damping * two_pi * turns;
        EXPECT_NEAR(std::log(start / left), exponent, 0.05 * exponent + 0.01) << "step " << each.step;
    }
}

/// Joints f E / L stiff, by a factor on the rule, whatever the rule's own factor is.
void set_joint_factor(Model& model, double f, double young, double depth)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    const double now = is_planar(model.kinematics) ? state.planar_contacts.patches.back().stiffness
                                                   : state.contacts.patches.back().stiffness;
    model.joints[0].stiffness.factor = f * young / depth / now;
}

/// Wide courses on rigid ground, which shear and do not bend. @param f of their joints; that of the rule if none
Model layer(Kinematics kinematics, std::optional<double> f = {})
{
    Model model = make_model(kinematics, stone(2e8), dry(35));
    hold(model, add_box(model, "base", {-20, -20, -1}, {20, 20, 0}));
    for (int i = 0; i < 8; ++i) add_box(model, "stone", {-20, -20, 0.5 * i}, {20, 20, 0.5 * (i + 1)});
    if (f) set_joint_factor(model, *f, 2e8, 0.5);
    return model;
}

Trust trust_before(const Model& model, Integrator integrator, double dissipation, double step)
{
    Stage stage = dynamic_stage(1, step);
    stage.control.integrator = integrator;
    stage.control.dissipation = dissipation;
    const State state = initial_state(model);
    TrustStart start{false, natural_modes(model, state), {}};
    return trust_in(start, {stage}, {});
}

TEST(Trust, WarnsOfTheOldSettingsAndNotOfTheNewOnes)
{
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::spatial_rigid,
                                        Kinematics::planar_deformable, Kinematics::planar_rigid}) {
        const bool deformable = is_deformable(kinematics);
        const double old_factor = deformable ? 10 : 1;
        const Trust old = trust_before(layer(kinematics, old_factor), Integrator::newmark, 0, 2e-3);
        EXPECT_TRUE(old.of_modes);
        EXPECT_TRUE(has(old, Kind::algorithmic_damping)) << name_of(kinematics);
        // Rigid stones with joints of E / L yield as elastic stones do.
        EXPECT_EQ(has(old, Kind::soft_joints), deformable) << name_of(kinematics);
        const Trust now = trust_before(layer(kinematics), Integrator::energy_decaying, 0.02, 2e-3);
        EXPECT_TRUE(now.findings.empty()) << name_of(kinematics);
        EXPECT_FALSE(now.start.modes.modes.empty());
    }
}

// Joints of f E / L add a share of 1/f to the compliance of the stones, which is 1 / (2f) of a frequency; that on
// the held base adds half as much.
TEST(Trust, AllowsTheJointsOfTheRuleAndNoneMuchSofter)
{
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::planar_deformable}) {
        for (const double f : {30, 60, 20, 10}) {
            const bool is_default = f == 30;
            const Model model = is_default ? layer(kinematics) : layer(kinematics, f);
            const Trust trust = trust_before(model, Integrator::energy_decaying, 0.02, 2e-3);
            // The first that moves it aside: by half of what the joints yield.
            const auto& modes = trust.start.modes.modes;
            const auto sways = std::find_if(modes.begin(), modes.end(),
                                            [](const NaturalMode& mode) { return mode.mass_share.sum() > 0.5; });
            ASSERT_NE(sways, modes.end());
            const double lowered = sways->lowered_by_joints;
            EXPECT_LT(lowered, 0.5 / f) << name_of(kinematics);
            EXPECT_GT(lowered, 0.75 * 0.5 / f) << name_of(kinematics);
            EXPECT_EQ(has(trust, Kind::soft_joints), f < 24) << name_of(kinematics) << ", f " << f;
        }
    }
}

// The joints of rigid stones are all that yields. In shear, E / (2 + 2 nu) of a stone against half of f E, they
// lower a frequency only where f (1 + nu) is below 1.
TEST(Trust, TakesTheJointsOfRigidStonesForTheirElasticity)
{
    for (const Kinematics kinematics : {Kinematics::spatial_rigid, Kinematics::planar_rigid}) {
        for (const std::optional<double> f : {std::optional<double>(), {1.0}, {0.5}}) {
            const Model model = layer(kinematics, f);
            const Trust trust = trust_before(model, Integrator::energy_decaying, 0.02, 2e-3);
            EXPECT_TRUE(trust.start.modes.rigid);
            const double due = std::max(0.0, 1 - std::sqrt(f.value_or(10) * (1 + model.materials[0].poisson)));
            // A hundredth of the motion is no shear: the layer is ten times as wide as high.
            EXPECT_NEAR(trust.start.modes.modes.at(0).lowered_by_joints, due, 0.02 * due) << name_of(kinematics);
            EXPECT_EQ(has(trust, Kind::soft_joints), due > 0) << name_of(kinematics);
        }
    }
}

TEST(Trust, WarnsOfStonesThatDoNotBend)
{
    // A column 8 m high and half a metre thick, of one stone a course.
    Model model = make_model(Kinematics::planar_deformable, stone(1e9), dry(35));
    hold(model, add_box(model, "base", {-1, -1, -1}, {1, 1, 0}));
    for (int i = 0; i < 16; ++i) add_box(model, "stone", {-0.25, 0, 0.5 * i}, {0.25, 1, 0.5 * (i + 1)});
    set_joint_factor(model, 300, 1e9, 0.5);
    const Trust deformable = trust_before(model, Integrator::energy_decaying, 0.02, 2e-3);
    EXPECT_TRUE(has(deformable, Kind::stiff_stones));
    EXPECT_EQ(deformable.findings.size(), 1);
    model.kinematics = Kinematics::planar_rigid;
    EXPECT_FALSE(has(trust_before(model, Integrator::energy_decaying, 0.02, 2e-3), Kind::stiff_stones))
        << "who asks for rigid stones gets them";
}

TEST(Trust, JudgesStiffOrLooseStructuresAtTenHertz)
{
    const Model stiff = block_on_plane(Kinematics::spatial_rigid, 35);
    const Trust old = trust_before(stiff, Integrator::newmark, 0, 2e-3);
    EXPECT_FALSE(old.of_modes) << "its first mode is faster than what shakes it";
    ASSERT_EQ(old.damping.size(), 3);
    EXPECT_TRUE(has(old, Kind::algorithmic_damping));
    for (const double step : {1e-3, 2e-3, 4e-3, 8e-3})
        EXPECT_FALSE(
            has(trust_before(stiff, Integrator::energy_decaying, 10 * step, step), Kind::algorithmic_damping))
            << step;
}

// What such a step damps is no larger than the error that it may make.
TEST(Trust, LeavesToStepsThatFollowTheirErrorHowLongTheyAre)
{
    const Model model = layer(Kinematics::planar_deformable, 300);
    const TrustStart start{false, natural_modes(model, initial_state(model)), {}};
    Stage stage = dynamic_stage(1, 2e-2);
    stage.control.integrator = Integrator::newmark;
    EXPECT_TRUE(has(trust_in(start, {stage}, {}), Kind::algorithmic_damping));
    EXPECT_TRUE(has(trust_in(start, {stage}, {}), Kind::period));
    stage.control.step_error = 1e-5;
    EXPECT_FALSE(has(trust_in(start, {stage}, {}), Kind::algorithmic_damping));
    EXPECT_FALSE(has(trust_in(start, {stage}, {}), Kind::period));
}

TEST(Trust, SaysWhenTheIntegratorTookTheEnergy)
{
    for (const bool old : {true, false}) {
        Bouncing scene(old ? Integrator::newmark : Integrator::energy_decaying, 0.02, 5, 2e-3);
        TrustStart start{false, natural_modes(scene.model, scene.state), open_ledger(scene.model, scene.state)};
        const RunReport report = run(scene.model, {scene.stage}, scene.state, {});
        const Trust trust = trust_in(start, {scene.stage}, report.energy);
        EXPECT_EQ(has(trust, Kind::integrator_energy), old);
        EXPECT_GT(trust.shares.put_in, 0);
        EXPECT_NEAR(trust.shares.friction, 0, 1e-9);
    }
}

TEST(Trust, SaysWhenClosingContactsTookTheEnergy)
{
    Stage stage = dynamic_stage(1, 1e-3);
    EnergyLedger energy;
    energy.foundation_work = 100;
    for (const double taken : {4.0, 6.0}) {
        energy.closing = taken;
        const Trust trust = trust_in({}, {stage}, energy);
        EXPECT_EQ(has(trust, Kind::closing_energy), taken > 5);
        EXPECT_FALSE(has(trust, Kind::integrator_energy));
        EXPECT_NEAR(trust.shares.closing, taken / 100, 1e-12);
    }
}

TEST(Trust, MeasuresDampingAgainstWhatWasAskedFor)
{
    const Model model = layer(Kinematics::planar_deformable, 300);
    const double first = natural_modes(model, initial_state(model)).modes[0].frequency;
    Stage stage = dynamic_stage(1, 2e-3);
    stage.control.integrator = Integrator::newmark;
    const TrustStart start{false, natural_modes(model, initial_state(model)), {}};
    // Newmark's damping of the first mode is a tenth of a damping that is ten times as large, and then no fault of
    // it.
    const double own = integrator_accuracy(two_pi * first * 2e-3, 1).damping;
    stage.damping.rate = 2 * two_pi * first * 10.5 * own;
    const Trust enough = trust_in(start, {stage}, {});
    EXPECT_NEAR(enough.damping[0].asked, 10.5 * own, 1e-9);
    EXPECT_LT(enough.damping[0].algorithmic, 0.1 * enough.damping[0].asked);
    stage.damping.rate = 2 * two_pi * first * 9.5 * own;
    const Trust little = trust_in(start, {stage}, {});
    EXPECT_TRUE(has(little, Kind::algorithmic_damping));
}

TEST(Trust, KnowsTheDampingOfDashpots)
{
    Model model = layer(Kinematics::planar_rigid, 3);
    model.joints[0].relaxation_time = 1e-3;
    const Trust trust = trust_before(model, Integrator::energy_decaying, 0.02, 2e-3);
    EXPECT_TRUE(has(trust, Kind::dashpots));
    // All strain energy is in the joints: the mode has the damping of each of them.
    const DampingAt& first = trust.damping.front();
    EXPECT_NEAR(first.dashpots, 0.5 * two_pi * first.frequency * 1e-3, 1e-9);
}

}  // namespace

}  // namespace voussoir::testing
