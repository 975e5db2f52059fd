// What stones had when a contact began, a gap that a bond was made over or an overlap that was forgiven, stays
// with them.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdda/box_on_floor.h"

namespace voussoir::testing
{

using Eigen::Vector3d;

namespace
{

/// A rest gap that is linear over the patch: 50 um at its middle, and as much more or less at x = +-0.5 from
/// there.
double rest_gap_at(const Vector3d& place, const Vector3d& middle)
{
    return 5e-5 + 1e-4 * (place.x() - middle.x());
}

void give_rest_gap(State& state, const Vector3d& middle)
{
    state.contacts.patches[0].intact = true;
    for (ContactPoint& p : state.contacts.points) p.rest_gap = rest_gap_at(p.position, middle);
}

double pressed_energy(const ContactSet& contacts)
{
    double energy = 0;
    for (const ContactPoint& p : contacts.points)
        energy += 0.5 * contacts.patches[0].stiffness * p.area * std::pow(std::min(p.gap, 0.0), 2);
    return energy;
}

}  // namespace

// Corners keep their rest gap while they slide and when the bodies change places, and gaps count from there.
TEST(RestGap, RestGapsStayWithTheirCorners)
{
    BoxOnFloor scene;
    scene.model.joints[0].face = FaceLaw::corners;
    scene.put({0.3, 0, 1 + 5e-5});
    scene.remember(scene.find());
    give_rest_gap(scene.state, {0.3, 0, 0});
    for (const bool swapped : {false, true}) {
        if (swapped) {
            std::swap(scene.state.contacts.patches[0].block_a, scene.state.contacts.patches[0].block_b);
            std::swap(scene.state.contacts.patches[0].feature_a, scene.state.contacts.patches[0].feature_b);
        }
        scene.put({0.31, 0, 1 + 5e-5});
        const ContactSet found = scene.find();
        ASSERT_EQ(found.points.size(), 4);
        for (const ContactPoint& p : found.points) {
            const double rest = rest_gap_at(p.position, {0.31, 0, 0});
            EXPECT_NEAR(p.rest_gap, rest, 1e-18);
            EXPECT_NEAR(p.gap, 5e-5 - rest, 1e-15);
        }
    }
}

// A box that leaves the floor by its edge: the new corners there lie between the old ones, and so do their gaps.
TEST(RestGap, RestGapsOfNewCornersLieBetweenThoseOfTheOld)
{
    BoxOnFloor scene;
    scene.model.joints[0].face = FaceLaw::corners;
    scene.put({1.4, 0, 1 - 1e-4});
    scene.remember(scene.find());
    give_rest_gap(scene.state, {1.4, 0, 0});
    scene.put({1.7, 0, 1 - 1e-4});
    int fresh = 0;
    for (const ContactPoint& p : scene.find().points) {
        if (p.position.x() < 2 - 1e-9) continue;
        ++fresh;
        EXPECT_NEAR(p.rest_gap, rest_gap_at({2, 0, 0}, {1.7, 0, 0}), 2e-5);
    }
    EXPECT_EQ(fresh, 2);
}

// Mortar fills a gap of up to 1e-4 of the stone. A joint that gapes by more at a corner is none: springs that
// begin stretched would pull the stones together. An overlap that no mortar could be presses.
TEST(RestGap, AJointIsBondedIfItIsClosedAtEveryCorner)
{
    BoxOnFloor scene;
    scene.model.joints[0].face = FaceLaw::corners;
    scene.model.joints[0].cohesion = scene.model.joints[0].tensile_strength = 1e6;
    const double limit = 1e-4 * size_of(scene.model, 1);
    for (const double share : {0.9, 1.1, 10.0, -10.0}) {  // of the limit, at the two corners on one side
        scene.put({0, 0, 1 + 0.5 * share * limit}, turned(share * limit, Vector3d::UnitY()));
        const ContactSet found = scene.find();
        ASSERT_EQ(found.points.size(), 4);
        EXPECT_EQ(found.patches[0].intact, share < 1) << share;
        double most = 0;
        for (const ContactPoint& p : found.points) {
            EXPECT_LE(std::abs(p.rest_gap), limit);
            EXPECT_LE(p.rest_gap == 0 ? 0 : p.gap, 1e-12) << "nothing is stretched";
            most = std::max(most, -p.gap);
        }
        EXPECT_NEAR(most, share < 0 ? 9 * limit : 0, 0.1 * limit);
    }
}

// A contact that presses and goes over to another face has another area and depth from one step to the next: its
// springs store what they stored. It is as stiff as ever, and presses again at once where the stones had parted
// to.
TEST(RestGap, AContactThatChangesItsFaceGivesNoEnergy)
{
    constexpr contact::NewOverlap forgiven = contact::NewOverlap::forgiven;
    for (const double share : {1e-6, 0.02, 0.5, 50.0}) {  // of the area that the contact had on the other face
        BoxOnFloor scene;
        scene.put({0, 0, 1 - 1e-3});
        const ContactSet first = scene.find();
        scene.remember(first);
        ContactPatch& patch = scene.state.contacts.patches[0];
        patch.feature_b = (patch.feature_b + 1) % 6;
        for (ContactPoint& p : scene.state.contacts.points) p.area *= share;
        const double stored = pressed_energy(scene.state.contacts), full = pressed_energy(first);
        for (int step = 0; step < 2; ++step) {  // it stays on this face
            scene.remember(scene.find(forgiven));
            EXPECT_EQ(scene.state.contacts.patches[0].stiffness, first.patches[0].stiffness);
            EXPECT_NEAR(pressed_energy(scene.state.contacts), std::min(stored, full), 1e-9 * full) << share;
            for (const ContactPoint& p : scene.state.contacts.points)
                EXPECT_NEAR(p.gap + p.rest_gap, -1e-3, 1e-12);
        }
        const double rest = scene.state.contacts.points[0].rest_gap;
        for (const double gap : {-0.4e-3, -0.9e-3}) {  // apart by more than it was pressed, and back
            scene.put({0, 0, 1 + gap});
            scene.remember(scene.find(forgiven));
            for (const ContactPoint& p : scene.state.contacts.points)
                EXPECT_NEAR(p.gap, gap - std::max(rest, -0.4e-3), 1e-12) << share;
        }
        scene.put({0, 0, 1 + 1e-4});
        scene.remember(scene.find(forgiven));
        for (const ContactPoint& p : scene.state.contacts.points) EXPECT_EQ(p.rest_gap, 0) << share;
    }
}

// A static stage after a dynamic one does not throw out at once what the dynamic one forgave: on the same face as
// on another the stones keep it until they part. What is new there presses.
TEST(RestGap, AForgivenOverlapOutlivesAChangeToAStageWhereOverlapsPress)
{
    for (const int turned : {0, 1}) {
        BoxOnFloor scene;
        scene.put({0, 0, 1 - 1e-3});
        scene.remember(scene.find(contact::NewOverlap::forgiven));  // found late: nothing was stored
        for (const ContactPoint& p : scene.state.contacts.points) {
            EXPECT_NEAR(p.gap, 0, 1e-15);
            EXPECT_NEAR(p.rest_gap, -1e-3, 1e-12);
        }
        ContactPatch& patch = scene.state.contacts.patches[0];
        patch.feature_b = (patch.feature_b + turned) % 6;
        scene.put({0, 0, 1 - 1.2e-3});
        scene.remember(scene.find(contact::NewOverlap::presses));
        for (const ContactPoint& p : scene.state.contacts.points) {
            EXPECT_NEAR(p.gap, -0.2e-3, 1e-12);
            EXPECT_NEAR(p.rest_gap, -1e-3, 1e-12);
        }
        scene.put({0, 0, 1 - 0.3e-3});
        scene.remember(scene.find(contact::NewOverlap::presses));
        for (const ContactPoint& p : scene.state.contacts.points) {
            EXPECT_NEAR(p.gap, 0, 1e-15);
            EXPECT_NEAR(p.rest_gap, -0.3e-3, 1e-12);
        }
        scene.put({0, 0, 1 + 1e-4});
        scene.remember(scene.find(contact::NewOverlap::presses));
        scene.put({0, 0, 1 - 1e-3});
        for (const ContactPoint& p : scene.find(contact::NewOverlap::presses).points)
            EXPECT_NEAR(p.gap, -1e-3, 1e-12);
    }
}

// Mortar stays, whatever face the stones turn to one another, and bonds are forgiven nothing.
TEST(RestGap, RestGapsOfJointsThatBreakStayWhatTheyWere)
{
    for (const bool intact : {false, true}) {
        BoxOnFloor scene;
        scene.put({0, 0, 1 - 1e-5});
        scene.remember(scene.find());
        ContactPatch& patch = scene.state.contacts.patches[0];
        patch.feature_b = (patch.feature_b + 1) % 6;
        patch.intact = intact;
        for (ContactPoint& p : scene.state.contacts.points) {
            p.rest_gap = 3e-5;
            p.gap = -4e-5;
        }
        for (const ContactPoint& p : scene.find(contact::NewOverlap::forgiven).points) {
            EXPECT_NEAR(p.rest_gap, 3e-5, 1e-15) << intact;
            EXPECT_NEAR(p.gap, -4e-5, 1e-15) << intact;
        }
    }
}

}  // namespace voussoir::testing
