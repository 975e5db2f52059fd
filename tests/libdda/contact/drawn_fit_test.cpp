// Stones that do not fit as drawn: what they share or lack within the tolerance is the zero of their contact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "libdda/contact/initial_contacts.h"
#include "tests/libdda/box_on_floor.h"

namespace voussoir::testing
{

using Eigen::Vector3d;

namespace
{

class DrawnFit : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, DrawnFit, every_kinematics(), test_name);

/// Five blocks of 1 x 1 x 0.4 m on one another, each joint as wide as told [m].
Model column(Kinematics kinematics, const std::array<double, 5>& joints)
{
    Model model = make_model(kinematics, stone(), dry(30));
    hold(model, add_box(model, "ground", {-1, -1, -1}, {1, 1, 0}));
    double top = 0;
    for (const double joint : joints) {
        const double bottom = top + joint;
        top = bottom + 0.4;
        add_box(model, "block", {-0.5, -0.5, bottom}, {0.5, 0.5, top});
    }
    return model;
}

template <int D>
double pressed(const ContactSetIn<D>& contacts)
{
    double force = 0;
    for (const ContactPointIn<D>& point : contacts.points) force += point.normal_force;
    return force;
}

/// Contacts between blocks, of a spatial scene or a planar one.
double all_normal_forces(const State& state)
{
    return pressed(state.contacts) + pressed(state.planar_contacts);
}

/// A box with a floor under it that is one stone of two parts, cut at x = 0.
struct BoxOnGluedFloor : BoxOnFloor {
    BoxOnGluedFloor()
    {
        ConvexPolyhedron left = make_box({-2, -2, -0.5}, {0, 2, 0.5}),
                         right = make_box({0, -2, -0.5}, {2, 2, 0.5});
        for (ConvexPolyhedron* part : {&left, &right}) {
            part->glued.assign(part->faces.size(), false);
            for (std::size_t f = 0; f < part->faces.size(); ++f) {
                const double into_cut = face_normal(*part, static_cast<int>(f)).x() * (part == &left ? 1 : -1);
                part->glued[f] = into_cut > 0.5;
            }
        }
        model.blocks[0] = make_block("floor", 0, 0, {left, right});
    }
};

}  // namespace

// The error of a survey makes a joint neither tight nor open. The force of a joint that is drawn wide acts on
// either stone at one place, by half the gap further from their middles than where they touch; deformable ones
// strain more by that.
TEST_P(DrawnFit, AColumnDrawnWithOverlapsAndGapsIsAsThePerfectOne)
{
    Model perfect = column(GetParam(), {0, 0, 0, 0, 0});
    Model drawn = column(GetParam(), {1e-3, -1e-3, 1e-3, -0.4e-3, -1e-3});
    drawn.fit_tolerance = 1.1e-3;
    // With the rule's stiffness the settlement would be 1e-8 m, of which rounding leaves too few digits.
    perfect.joints[0].stiffness.factor = drawn.joints[0].stiffness.factor = 0.1;
    State of_perfect = initial_state(perfect), of_drawn = initial_state(drawn);
    const State start_of_drawn = of_drawn;
    const RunReport first = run_quietly(perfect, {static_stage(1e-2), dynamic_stage(0.1, 1e-3)}, of_perfect);
    const RunReport second = run_quietly(drawn, {static_stage(1e-2), dynamic_stage(0.1, 1e-3)}, of_drawn);
    ASSERT_EQ(first.outcome, Outcome::completed);
    ASSERT_EQ(second.outcome, Outcome::completed);
    EXPECT_EQ(second.energy.start_contact, 0);
    const double error = is_deformable(GetParam()) ? 1e-3 / 0.4 : 1e-9;
    EXPECT_NEAR(second.energy.contact, first.energy.contact, error * first.energy.contact);
    EXPECT_NEAR(second.max_penetration, first.max_penetration,
                is_deformable(GetParam()) ? 1e-3 * first.max_penetration : 1e-12);
    EXPECT_NEAR(all_normal_forces(of_drawn), all_normal_forces(of_perfect), 1e-9 * all_normal_forces(of_perfect));
    for (int b = 1; b <= 5; ++b) {
        const double own = centroid(drawn, start_of_drawn, b).z() - centroid(drawn, of_drawn, b).z();
        const double due = 0.4 * b - 0.2 - centroid(perfect, of_perfect, b).z();
        EXPECT_GT(due, 1e-7) << "there is a settlement to compare";
        EXPECT_NEAR(own, due, error * due) << b;
    }
}

// Without the tolerance the same column pushes itself apart and falls together.
TEST_P(DrawnFit, WithoutToleranceStonesAreWhatIsDrawn)
{
    Model drawn = column(GetParam(), {1e-3, -1e-3, 0, 0, 0});
    State state = initial_state(drawn);
    run_quietly(drawn, {static_stage(1e-2)}, state);
    EXPECT_NEAR(centroid(drawn, state, 1).z(), 0.2, 1e-5) << "came down to the ground";
    EXPECT_NEAR(centroid(drawn, state, 2).z(), 0.6, 2e-5) << "was pushed out";
}

// 3 mm are a gap where the survey is good to 2 mm: it stays one until the stone has come down.
TEST_P(DrawnFit, AGapBeyondTheToleranceStaysOne)
{
    Model model = column(GetParam(), {3e-3, 0, 0, 0, 0});
    model.fit_tolerance = 2e-3;
    State state = initial_state(model);
    find_initial_contacts(model, state);
    for (const ContactPoint& p : state.contacts.points) EXPECT_EQ(p.rest_gap, 0);
    state = initial_state(model);
    run_quietly(model, {dynamic_stage(0.02, 1e-3)}, state);
    EXPECT_NEAR(centroid(model, state, 1).z(), 0.203 - gravity * 0.02 * 0.02 / 2, 1e-7) << "falls freely";
    run_quietly(model, {static_stage(1e-2)}, state = initial_state(model));
    EXPECT_NEAR(centroid(model, state, 1).z(), 0.2, 1e-4);
}

// A joint that was drawn wide stays found, though the stones are small and their own contact distance is a tenth.
TEST_P(DrawnFit, AWideJointStaysClosed)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "ground", {-0.1, -0.1, -0.1}, {0.1, 0.1, 0}));
    add_box(model, "block", {-0.05, -0.05, 0.002}, {0.05, 0.05, 0.102});
    model.fit_tolerance = 2.1e-3;
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(1e-2), dynamic_stage(0.5, 1e-3)}, state);
    ASSERT_EQ(report.outcome, Outcome::completed);
    EXPECT_NEAR(centroid(model, state, 1).z(), 0.052, 1e-6);
    EXPECT_NEAR(all_normal_forces(state) / (model.mass(1) * gravity), 1, 1e-3);
}

// Each corner by itself: a wedge is closed where it is narrow.
TEST(DrawnFit, AWedgeIsClosedAtTheCornersWithinTheTolerance)
{
    BoxOnFloor scene;
    scene.model.fit_tolerance = 2e-3;
    scene.put({0, 0, 1 + 1.5e-3}, turned(3e-3, Vector3d::UnitY()));  // corners at 0 and 3 mm
    const ContactSet found = scene.find();
    ASSERT_EQ(found.points.size(), 12);
    int closed = 0;
    for (const ContactPoint& p : corners_of(found, found.patches[0])) {
        const double gap = p.position.x() > 0 ? 0 : 3e-3;
        closed += gap == 0;
        EXPECT_NEAR(p.gap, gap, 1e-5);
        EXPECT_NEAR(p.rest_gap, 0, 1e-5);
    }
    EXPECT_EQ(closed, 2);
    scene.put({0, 0, 1 - 1e-3}, turned(-2e-3, Vector3d::UnitY()));  // 0 and 2 mm of overlap
    const ContactSet overlapping = scene.find();
    for (const ContactPoint& p : corners_of(overlapping, overlapping.patches[0])) {
        EXPECT_NEAR(p.gap, 0, 1e-15);
        EXPECT_NEAR(p.rest_gap, p.position.x() > 0 ? 0 : -2e-3, 1e-5);
    }
}

// A joint that has opened at one edge closes again where it was: the tolerance is no room that stones lose.
TEST(DrawnFit, AJointThatOpensKeepsItsZeroUntilTheStonesPart)
{
    for (const double drawn : {-1e-3, 1e-3}) {
        BoxOnFloor scene;
        scene.model.fit_tolerance = 1.5e-3;
        scene.put({0, 0, 1 + drawn});
        scene.remember(scene.find());
        scene.state.step = 1;
        for (const double opened : {0.0, 2e-3, 4e-3, 0.0}) {
            scene.put({0, 0, 1 + drawn + opened});
            scene.remember(scene.find(contact::NewOverlap::forgiven));
            ASSERT_EQ(scene.state.contacts.points.size(), 12);
            for (const ContactPoint& p : scene.state.contacts.points) {
                EXPECT_NEAR(p.rest_gap, drawn, 1e-15);
                EXPECT_NEAR(p.gap, opened, 1e-12);
            }
        }
        scene.put({0, 0, 1 + 0.1});
        scene.remember(scene.find());
        ASSERT_TRUE(scene.state.contacts.points.empty());
        scene.put({0, 0, 1 + 2e-3});
        for (const ContactPoint& p : scene.find(contact::NewOverlap::forgiven).points) {
            EXPECT_EQ(p.rest_gap, 0) << "stones that have parted are what is drawn";
            EXPECT_NEAR(p.gap, 2e-3, 1e-12);
        }
    }
}

// What is forgiven beyond the tolerance still goes as the stones part.
TEST(DrawnFit, OnlyTheToleranceOutlastsAnOpening)
{
    BoxOnFloor scene;
    scene.model.fit_tolerance = 1e-3;
    scene.put({0, 0, 1 - 3e-3});
    scene.state.step = 1;
    scene.remember(scene.find(contact::NewOverlap::forgiven));
    for (const ContactPoint& p : scene.state.contacts.points) EXPECT_NEAR(p.rest_gap, -3e-3, 1e-12);
    scene.put({0, 0, 1});
    for (const ContactPoint& p : scene.find(contact::NewOverlap::forgiven).points) {
        EXPECT_NEAR(p.rest_gap, -1e-3, 1e-12);
        EXPECT_NEAR(p.gap, 1e-3, 1e-12);
    }
}

// Over the cut between two parts of one stone the zero goes on as it was.
TEST(DrawnFit, AStoneThatSlidesToAnotherPartOfItsNeighbourStaysLevel)
{
    for (const double drawn : {-1e-3, 1e-3}) {
        BoxOnGluedFloor scene;
        scene.model.fit_tolerance = 1.5e-3;
        scene.put({-0.6, 0, 1 + drawn});
        scene.remember(scene.find());
        ASSERT_EQ(scene.state.contacts.patches.size(), 1);
        scene.state.step = 1;
        for (const double x : {-0.45, -0.1, 0.3, 0.6, 0.7}) {
            scene.put({x, 0, 1 + drawn});
            scene.remember(scene.find(contact::NewOverlap::forgiven));
            EXPECT_EQ(scene.state.contacts.patches.size(), std::abs(x) < 0.5 ? 2 : 1) << x;
            for (const ContactPoint& p : scene.state.contacts.points) {
                EXPECT_NEAR(p.rest_gap, drawn, 1e-12) << x;
                EXPECT_NEAR(p.gap, 0, 1e-12) << x;
            }
        }
    }
}

// A gap of a bed is none of the head joint that the stone falls against.
TEST(DrawnFit, AGapDoesNotGoOverToAFaceThatLooksElsewhere)
{
    BoxOnFloor scene;
    scene.model.fit_tolerance = 2e-3;
    scene.put({1.4, 0, 1 + 1e-3});
    scene.remember(scene.find());
    for (const ContactPoint& p : scene.state.contacts.points) ASSERT_NEAR(p.rest_gap, 1e-3, 1e-12);
    scene.state.step = 1;
    scene.put({2.5 + 0.5e-3, 0, 0.7});  // beside the floor's edge, half a millimetre off
    const ContactSet found = scene.find(contact::NewOverlap::forgiven);
    ASSERT_EQ(found.patches.size(), 1);
    ASSERT_GT(found.patches[0].normal.x(), 0.99);
    for (const ContactPoint& p : found.points) {
        EXPECT_EQ(p.rest_gap, 0);
        EXPECT_NEAR(p.gap, 0.5e-3, 1e-12);
    }
}

// A narrow box that lies askew over the edge of its floor, 2 mm deep at most: its lowest corner is beyond that
// edge, and the floor's highest beyond the box, so that of all planes the one of two crossing edges parts them
// soonest. What touches are the faces.
TEST(DrawnFit, FacesWithinTheToleranceTouchAsFaces)
{
    for (const double fit : {0.0, 1e-3, 2.2e-3}) {
        BoxOnFloor scene({1, 1, 1});
        scene.model.blocks[1] = make_block("box", 0, 0, {make_box({-0.5, -0.15, -0.5}, {0.5, 0.15, 0.5})});
        scene.model.fit_tolerance = fit;
        scene.put({0.9, 0, 1 - 5.5e-3}, turned(0.02, Vector3d::UnitY()) * turned(0.03, Vector3d::UnitX()));
        const ContactSet found = scene.find();
        ASSERT_EQ(found.patches.size(), 1);
        EXPECT_EQ(found.patches[0].edge_edge, fit < 2e-3) << fit;
    }
}

// Mortar fills what the survey may be wrong by.
TEST(DrawnFit, ABondReachesOverTheTolerance)
{
    for (const double fit : {0.0, 2e-3}) {
        BoxOnFloor scene;
        scene.model.joints[0].cohesion = scene.model.joints[0].tensile_strength = 1e6;
        scene.model.fit_tolerance = fit;
        for (const double drawn : {1.5e-3, -1.5e-3}) {
            scene.put({0, 0, 1 + drawn});
            const ContactSet found = scene.find();
            ASSERT_EQ(found.patches.size(), 1);
            EXPECT_EQ(found.patches[0].intact, fit > 0 || drawn < 0);
            for (const ContactPoint& p : found.points)
                EXPECT_NEAR(p.rest_gap, fit > 0 ? drawn : std::max(-1e-4, std::min(drawn, 0.0)), 1e-12);
        }
    }
}

}  // namespace voussoir::testing
