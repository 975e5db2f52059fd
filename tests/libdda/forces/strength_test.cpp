// Joints with cohesion and tensile strength: where they break, and what is left.
#include <gtest/gtest.h>

#include "libdda/analysis/dry_joints.h"
#include "libdda/analysis/joint_resultants.h"
#include "libdda/analysis/overlaps.h"
#include "libdda/contact/initial_contacts.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

JointMaterial mortar(double friction_degrees, double cohesion, double tensile_strength)
{
    JointMaterial joint = dry(friction_degrees);
    joint.cohesion = cohesion;
    joint.tensile_strength = tensile_strength;
    joint.stiffness = {ContactStiffness::Kind::per_area, 1e10};
    return joint;
}

/// Static equilibrium under growing loads; the load factor at which the joint breaks lies in the interval.
struct Interval {
    double holds = 0, breaks = 0;
    double middle() const { return 0.5 * (holds + breaks); }
};

bool holds_under(const Model& model, const Vector3d& g)
{
    State state = initial_state(model);
    Stage loading = static_stage(0.1, g);
    loading.max_static_steps = 30;  // a block that has broken off falls on
    run_quietly(model, {loading}, state);
    bool intact = false;
    for (const ContactPatch& patch : state.contacts.patches) intact = intact || patch.intact;
    return intact;
}

/// Bisection on the size of gravity.
Interval breaking_gravity(const Model& model, const Vector3d& direction, double least, double most)
{
    Interval interval{least, most};
    EXPECT_TRUE(holds_under(model, least * direction));
    EXPECT_FALSE(holds_under(model, most * direction));
    while (interval.breaks - interval.holds > 2e-3 * interval.breaks) {
        const double middle = interval.middle();
        (holds_under(model, middle * direction) ? interval.holds : interval.breaks) = middle;
    }
    return interval;
}

/// A prism with the given outline in the plane x, y, from z = low to high.
ConvexPolyhedron prism(const std::vector<Eigen::Vector2d>& outline, double low, double high)
{
    const int n = static_cast<int>(outline.size());
    std::vector<Vector3d> vertices;
    for (const double z : {low, high})
        for (const Eigen::Vector2d& p : outline) vertices.emplace_back(p.x(), p.y(), z);
    std::vector<std::vector<int>> faces(2);
    for (int i = 0; i < n; ++i) {
        faces[0].push_back(n - 1 - i);
        faces[1].push_back(n + i);
        const int next = (i + 1) % n;
        faces.push_back({i, next, n + next, n + i});
    }
    return make_convex_polyhedron(vertices, faces);
}

std::vector<Eigen::Vector2d> regular_polygon(int corners)
{
    std::vector<Eigen::Vector2d> outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / corners;
        outline.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle));
    }
    return outline;
}

class Strength : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Strength, spatial_kinematics(), test_name);

class BondedAsItStands : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, BondedAsItStands, every_kinematics(), test_name);

}  // namespace

// A block hung below a held one: breaks when its weight is sigma_t A.
TEST_P(Strength, HungBlockFallsWhenItsWeightExceedsTheTensileStrength)
{
    const double strength = 30e3;
    Model model = make_model(GetParam(), stone(), mortar(35, 50e3, strength));
    hold(model, add_box(model, "above", {-2, -2, 0}, {2, 2, 1}));
    const int block = add_box(model, "block", {-0.5, -0.4, -1}, {0.5, 0.4, 0});
    const double exact = strength * 0.8 / model.mass(block);
    const Interval g = breaking_gravity(model, {0, 0, -1}, 0.5 * exact, 2 * exact);
    std::printf("hung block: breaks at %.4f sigma_t A\n", g.middle() / exact);
    EXPECT_NEAR(g.middle(), exact, 1e-2 * exact);
}

// However soft the joint: it stretches by 15 mm, far more than stones that only touch are looked for, and no more
// of it is lost.
TEST_P(Strength, SoftBondsBreakByTheirStrengthAndNotBefore)
{
    const double strength = 30e3;
    JointMaterial soft = mortar(35, 50e3, strength);
    soft.stiffness = {ContactStiffness::Kind::per_area, 2e6};
    Model model = make_model(GetParam(), stone(), soft);
    hold(model, add_box(model, "above", {-2, -2, 0}, {2, 2, 1}));
    const int block = add_box(model, "block", {-0.5, -0.4, -1}, {0.5, 0.4, 0});
    const double exact = strength * 0.8 / model.mass(block);
    const Interval g = breaking_gravity(model, {0, 0, -1}, 0.2 * exact, 2 * exact);
    EXPECT_NEAR(g.middle(), exact, 1e-2 * exact);
}

TEST_P(Strength, HungBlockHangsStillAndThenFallsFreely)
{
    Model model = make_model(GetParam(), stone(), mortar(35, 50e3, 30e3));
    hold(model, add_box(model, "above", {-2, -2, 0}, {2, 2, 1}));
    const int block = add_box(model, "block", {-0.5, -0.4, -1}, {0.5, 0.4, 0});
    const double limit = 30e3 * 0.8 / model.mass(block);
    State state = initial_state(model);
    Stage hanging = static_stage(0.1, {0, 0, -0.9 * limit});
    const RunReport still = run_quietly(model, {hanging}, state);
    EXPECT_EQ(still.outcome, Outcome::completed) << ::testing::PrintToString(still.diagnosis);
    double pull = 0;
    for (const ContactPoint& p : state.contacts.points) pull -= p.normal_force;
    EXPECT_NEAR(pull, model.mass(block) * 0.9 * limit, 1e-6 * pull);

    const double start = centroid(model, state, block).z(), g = 1.2 * limit;
    begin_stage(model, 0, state);
    const RunReport falling = run_quietly(model, {dynamic_stage(0.5, 1e-3, {0, 0, -g})}, state);
    EXPECT_EQ(falling.outcome, Outcome::collapsed);
    ASSERT_TRUE(falling.diagnosis);
    EXPECT_EQ(falling.diagnosis->blocks, std::vector{block});
    EXPECT_EQ(falling.simulated_time, 0.5);
    EXPECT_NEAR(start - centroid(model, state, block).z(), 0.5 * g * 0.25, 1e-3 * g);
    const double stored = 0.5 * pull * pull / (1e10 * 0.8);
    EXPECT_NEAR(falling.energy.fracture, stored, 1e-3 * stored);
    EXPECT_LT(falling.energy.relative_residual(), 1e-6);
}

// A block glued sideways to a wall: bending m g L / 2 against sigma_t W. Shear is kept out by a high cohesion.
TEST_P(Strength, CantileverBreaksAtTheMomentOfLinearStress)
{
    const double strength = 200e3, length = 1, depth = 0.3, width = 0.5;
    Model model = make_model(GetParam(), stone(), mortar(35, 1e9, strength));
    hold(model, add_box(model, "wall", {-1, -2, -2}, {0, 2, 2}));
    const int block = add_box(model, "cantilever", {0, 0, 0}, {length, width, depth});
    const double modulus = width * depth * depth / 6;
    const double exact = strength * modulus / (model.mass(block) * length / 2);
    const Interval g = breaking_gravity(model, {0, 0, -1}, 0.5 * exact, 2 * exact);
    std::printf("cantilever: breaks at %.4f sigma_t W\n", g.middle() / exact);
    EXPECT_NEAR(g.middle(), exact, 2e-2 * exact);
}

// The same for prisms: a regular polygon has the section modulus I / r, r to the corner that opens first.
TEST_P(Strength, PrismOnItsSideBreaksAtTheMomentOfLinearStress)
{
    for (const int corners : {3, 4, 6, 8}) {
        const double strength = 200e3, length = 1;
        Model model = make_model(GetParam(), stone(), mortar(35, 1e9, strength));
        const auto outline = regular_polygon(corners);
        hold(model, add_box(model, "wall", {-2, -2, -1}, {2, 2, 0}));
        model.blocks.push_back(make_block("prism", 0, 0, {prism(outline, 0, length)}));
        double second = 0, furthest = 0;
        for (int i = 0; i < corners; ++i) {
            const Eigen::Vector2d &p = outline[i], &q = outline[(i + 1) % corners];
            const double cross = p.x() * q.y() - p.y() * q.x();
            second += cross / 12 * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
            furthest = std::max(furthest, -p.x());  // gravity along +x opens the side of -x
        }
        const double exact = strength * second / furthest / (model.mass(1) * length / 2);
        const Interval g = breaking_gravity(model, {1, 0, 0}, 0.3 * exact, 3 * exact);
        std::printf("prism of %d sides: breaks at %.4f sigma_t W\n", corners, g.middle() / exact);
        EXPECT_NEAR(g.middle(), exact, 2e-2 * exact) << corners << " sides";
    }
}

// On an incline a bonded block holds up to c A + mu N.
TEST_P(Strength, InclineHoldsUpToCohesionPlusFriction)
{
    const double cohesion = 10e3;
    Model model = make_model(GetParam(), stone(), mortar(20, cohesion, 27e3));
    hold(model, add_box(model, "plane", {-5, -5, -1}, {25, 5, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    const Vector3d down = inclined_gravity(40).normalized();
    const double exact = cohesion / (model.mass(block) *
                                     (std::sin(40 * degrees) - std::cos(40 * degrees) * std::tan(20 * degrees)));
    const Interval g = breaking_gravity(model, down, 0.5 * exact, 2 * exact);
    std::printf("bonded incline: breaks at %.4f (c A + mu N)\n", g.middle() / exact);
    EXPECT_NEAR(g.middle(), exact, 1e-2 * exact);
}

// Once broken, friction is all that is left, and the joint does not heal.
TEST_P(Strength, BrokenJointSlidesLikeADryOne)
{
    Model model = make_model(GetParam(), stone(), mortar(20, 1e3, 2.7e3));
    hold(model, add_box(model, "plane", {-5, -5, -1}, {25, 5, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    const double x0 = centroid(model, state, block).x();
    Stage slide = dynamic_stage(1, 1e-3, inclined_gravity(45));
    slide.control.force_tolerance = 1e-8;  // what the iteration leaves over is in no term of the energy
    const RunReport report = run_quietly(model, {slide}, state);
    const double exact =
        0.5 * gravity * (std::sin(45 * degrees) - std::cos(45 * degrees) * std::tan(20 * degrees));
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_NEAR(centroid(model, state, block).x() - x0, exact, 2e-3 * exact);
    for (const ContactPatch& patch : state.contacts.patches) EXPECT_FALSE(patch.intact);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);

    // At rest on the level, then inclined to below the friction angle and above it: no cohesion has come back.
    begin_stage(model, 0, state);
    set_velocity(model, state, block, Vector3d::Zero());
    const double place = centroid(model, state, block).x();
    run_quietly(model, {dynamic_stage(0.2, 1e-3, inclined_gravity(15))}, state);
    EXPECT_NEAR(centroid(model, state, block).x(), place, 1e-5);
    begin_stage(model, 0, state);
    run_quietly(model, {dynamic_stage(0.2, 1e-3, inclined_gravity(30))}, state);
    EXPECT_GT(centroid(model, state, block).x(), place + 0.02);
}

// All reach their strength in the same step, whatever its length: each gets its own iterations.
TEST_P(Strength, AnyNumberOfJointsMayBreakAtOnce)
{
    Model model = make_model(GetParam(), stone(), mortar(35, 50e3, 1e3));
    hold(model, add_box(model, "ceiling", {-1, -1, 0}, {60, 2, 1}));
    constexpr int count = 40;
    for (int i = 0; i < count; ++i) add_box(model, "stone", {1.4 * i, 0, -1}, {1.4 * i + 1, 0.8, 0});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {dynamic_stage(0.1, 1e-3)}, state);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    for (const ContactPatch& patch : state.contacts.patches) EXPECT_FALSE(patch.intact);
    EXPECT_EQ(report.step_cuts, 0);
}

// Mortar that adheres in shear only, in joints that nothing presses: a stone between two others stays where it is.
TEST_P(Strength, CohesionAloneHoldsInAnUnloadedJoint)
{
    for (const double cohesion : {100e3, 1e3}) {  // 6.1 kPa would do
        Model model = make_model(GetParam(), stone(), mortar(35, cohesion, 0));
        hold(model, add_box(model, "left", {-1, 0, -1}, {0, 0.8, 1}));
        hold(model, add_box(model, "right", {0.5, 0, -1}, {1.5, 0.8, 1}));
        const int block = add_box(model, "stone", {0, 0, -0.25}, {0.5, 0.8, 0.25});
        State state = initial_state(model);
        const double start = centroid(model, state, block).z();
        run_quietly(model, {dynamic_stage(0.2, 1e-3)}, state);
        const double fallen = start - centroid(model, state, block).z();
        if (cohesion > 10e3)
            EXPECT_LT(fallen, 1e-4);
        else
            EXPECT_GT(fallen, 0.1);
    }
}

// The model leaves a wedge between the stones, 0 to 60 micrometres wide, or lets them overlap by as much: mortar
// fills it, and nothing moves or presses until there is a load. Then the joint yields by W / (k A), from there on.
TEST_P(BondedAsItStands, HasNoStressOfItsOwn)
{
    for (const double gap : {60e-6, -60e-6}) {
        Model model = make_model(GetParam(), stone(), mortar(35, 50e4, 30e4));
        hold(model, add_box(model, "above", {-2, -2, 0}, {2, 2, 1}));
        const int block = add_box(model, "block", {-0.5, -0.4, -1}, {0.5, 0.4, 0});
        State state = initial_state(model);
        const Eigen::Matrix3d tilt = turned(gap, Vector3d::UnitY());
        set_pose(model, state, block, {0, 0, -0.5 - 0.5 * gap}, tilt);
        begin_stage(model, 0, state);
        const double start = centroid(model, state, block).z();
        const double weight = model.mass(block) * gravity;
        Stage rest = static_stage(0.1, {0, 0, -1e-2 * gravity});
        rest.unbalanced_tolerance = 1e-7;  // of a hundredth of its weight, of which rounding leaves 1e-8
        const RunReport alone = run_quietly(model, {rest}, state);
        ASSERT_EQ(alone.outcome, Outcome::completed) << ::testing::PrintToString(alone.diagnosis);
        ASSERT_EQ(joint_resultants(model, state).size(), 1);
        const JointResultant still = joint_resultants(model, state)[0];
        EXPECT_NEAR(still.normal_force, -1e-2 * weight, 1e-6 * weight);
        EXPECT_LT(still.moment.norm(), 1e-6 * weight);
        EXPECT_LT(alone.energy.start_contact, 1e-9);

        begin_stage(model, 0, state);
        const RunReport hanging = run_quietly(model, {static_stage(0.1)}, state);
        ASSERT_EQ(hanging.outcome, Outcome::completed) << ::testing::PrintToString(hanging.diagnosis);
        const JointResultant loaded = joint_resultants(model, state)[0];
        EXPECT_NEAR(loaded.normal_force, -weight, 1e-6 * weight);
        EXPECT_LT(loaded.moment.norm(), 1e-3 * weight);
        if (!is_deformable(GetParam())) {
            const double yield = weight / (1e10 * loaded.area);
            EXPECT_NEAR(start - centroid(model, state, block).z(), yield, 1e-3 * yield);
        }
    }
}

// A wedge of a millimetre is no joint: nothing is pulled together, no energy is there from the start, and the run
// says that the strength it was given counts for nothing.
TEST_P(BondedAsItStands, IsDryAndSaidToBeWhereItGapes)
{
    for (const double gap : {60e-6, 1e-3, 0.05}) {
        Model model = make_model(GetParam(), stone(), mortar(35, 50e4, 30e4));
        hold(model, add_box(model, "below", {-2, -2, -1}, {2, 2, 0}));
        const int block = add_box(model, "block", {-0.5, -0.4, 0}, {0.5, 0.4, 1});
        State state = initial_state(model);
        set_pose(model, state, block, {0, 0, 0.5 + 0.5 * gap}, turned(gap, Vector3d::UnitY()));
        if (gap > 0.01) {  // it stands on its edge, as it was meant to
            EXPECT_FALSE(dry_joints_warning(model, state));
            continue;
        }
        begin_stage(model, 0, state);
        const RunReport report = run_quietly(model, {static_stage(0.1)}, state);
        ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        EXPECT_LT(report.energy.start_contact, 1e-3) << gap;
        if (gap < 1e-4) {
            EXPECT_TRUE(report.warnings.empty()) << ::testing::PrintToString(report.warnings);
            continue;
        }
        ASSERT_EQ(report.warnings.size(), 1u);
        EXPECT_EQ(report.warnings[0].kind, DiagnosisKind::dry_joints) << report.warnings[0];
        EXPECT_EQ(report.warnings[0].blocks, (std::vector{block, 0}));
        EXPECT_EQ(value_of(report.warnings[0], "joints"), 1);
        EXPECT_NEAR(value_of(report.warnings[0], "widest_gap_m"), gap, 0.01 * gap);
    }
}

// An overlap that no mortar could be is not hidden by the bond.
TEST_P(BondedAsItStands, StillShowsStonesThatOverlap)
{
    Model model = make_model(GetParam(), stone(), mortar(35, 50e4, 30e4));
    hold(model, add_box(model, "below", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "block", {-0.5, -0.4, -0.02}, {0.5, 0.4, 1});
    State state = initial_state(model);
    find_initial_contacts(model, state);
    RunReport report;
    note_overlap(model, OverlapWatch(model), state, report);
    EXPECT_NEAR(report.deepest.depth, 0.02, 1e-12);
    const double limit = 1e-4 * size_of(model, 1);
    EXPECT_NEAR(joint_resultants(model, state)[0].widest_gap, 0, 1e-12);
    for (const ContactPoint& p : state.contacts.points) EXPECT_NEAR(p.gap, limit - 0.02, 1e-9);
    for (const ContactPointIn<2>& p : state.planar_contacts.points) EXPECT_NEAR(p.gap, limit - 0.02, 1e-9);
}

// Only joints closed at the start of the run are bonded: a stone that falls on another does not stick to it.
TEST_P(Strength, LaterContactsAreDry)
{
    Model model = make_model(GetParam(), stone(), mortar(35, 1e6, 1e6));
    hold(model, add_box(model, "plane", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "block", {-0.5, -0.5, 0.01}, {0.5, 0.5, 0.31});
    State state = initial_state(model);
    run_quietly(model, {dynamic_stage(0.2, 1e-3)}, state);
    ASSERT_FALSE(state.contacts.patches.empty());
    for (const ContactPatch& patch : state.contacts.patches) EXPECT_FALSE(patch.intact);
}

}  // namespace voussoir::testing
