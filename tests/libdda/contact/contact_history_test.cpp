// What a contact remembers from step to step: its face, its points, its slip.
#include <gtest/gtest.h>

#include "libdda/contact/narrow_phase.h"
#include "tests/libdda/box_on_floor.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A slip of its own for each point, in the plane of the contact.
Vector3d slip_of(std::size_t i)
{
    return {1e-4 * static_cast<double>(i + 1), -2e-5 * static_cast<double>(i), 0};
}

void give_slip(State& state)
{
    for (std::size_t i = 0; i < state.contacts.points.size(); ++i) {
        state.contacts.points[i].elastic_slip = slip_of(i);
        state.contacts.points[i].plastic_slip = 3 * slip_of(i);
        state.contacts.points[i].status = ContactStatus::sliding;
    }
}

/// Turned on its bed, with its foremost corner so far beyond the edge of the floor [m].
void put_turned(BoxOnFloor& scene, double beyond)
{
    const double angle = 0.3, reach = 0.5 * (std::cos(angle) + std::sin(angle));
    scene.put({2 - reach + beyond, 0, 1 - 1e-4}, turned(angle, {0, 0, 1}));
    scene.remember(scene.find());
}

/// Over the edge and back ten times: corners come and go, next to no area does.
void swing_over_the_edge(BoxOnFloor& scene)
{
    std::size_t fewest = 100, most = 0;
    for (int i = 0; i < 20; ++i) {
        put_turned(scene, i % 2 == 0 ? 5e-3 : -5e-3);
        fewest = std::min(fewest, scene.state.contacts.points.size());
        most = std::max(most, scene.state.contacts.points.size());
    }
    EXPECT_LT(fewest, most);
}

}  // namespace

TEST(ContactHistory, LastFaceKeepsItsContactAgainstASlightlyBetterOne)
{
    // Two unit cubes overlapping at an edge: 1 mm in x, a little more or less in z.
    BoxOnFloor scene({1, 1, 1});
    const auto face_at = [&](double depth_z, const std::optional<contact::LastContact>& last) {
        scene.put({1 - 1e-3, 0, 1 - depth_z});
        const std::vector<contact::PlacedPart> parts = placed(scene.model, scene.state);
        return contact::contact_polygon(parts[0], parts[1], 1e-2, last);
    };
    const auto sideways = face_at(3e-3, {}), upwards = face_at(0.2e-3, {});
    ASSERT_TRUE(sideways && upwards);
    EXPECT_NEAR(std::abs(sideways->normal.x()), 1, 1e-12);
    EXPECT_NEAR(std::abs(upwards->normal.z()), 1, 1e-12);

    const contact::LastContact x{sideways->second_is_reference, false, sideways->reference_feature};
    const contact::LastContact z{upwards->second_is_reference, false, upwards->reference_feature};
    // Within 1e-3 of the size the last face stays, whichever it was; beyond, the better one wins.
    for (const double depth_z : {0.5e-3, 0.9e-3, 1.1e-3, 1.5e-3}) {
        EXPECT_NEAR(std::abs(face_at(depth_z, x)->normal.x()), 1, 1e-12) << depth_z;
        EXPECT_NEAR(std::abs(face_at(depth_z, z)->normal.z()), 1, 1e-12) << depth_z;
    }
    EXPECT_NEAR(std::abs(face_at(3e-3, z)->normal.x()), 1, 1e-12);
}

TEST(ContactHistory, FeaturesAndSlipsSurviveSliding)
{
    BoxOnFloor scene;
    scene.model.joints[0].face = FaceLaw::corners;
    for (const double start : {0.3, 1.8}) {  // wholly on the floor, and over its edge
        scene.put({start, 0.1, 1 - 1e-4});
        scene.remember({});
        const ContactSet before = scene.find();
        ASSERT_EQ(before.points.size(), 4U);
        scene.remember(before);
        give_slip(scene.state);
        scene.put({start + 0.02, 0.11, 1 - 1e-4});
        const ContactSet after = scene.find();
        ASSERT_EQ(after.points.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(after.points[i].feature, before.points[i].feature);
            EXPECT_GT((after.points[i].position - before.points[i].position).norm(), 5e-3);
            EXPECT_LT((after.points[i].elastic_slip - slip_of(i)).norm(), 1e-18);
            EXPECT_LT((after.points[i].plastic_slip - 3 * slip_of(i)).norm(), 1e-18);
            EXPECT_EQ(after.points[i].status, ContactStatus::sliding);
        }
        EXPECT_EQ(after.patches[0].stiffness, before.patches[0].stiffness);
    }
}

TEST(ContactHistory, SlipIsLaidIntoTheNewTangentPlane)
{
    BoxOnFloor scene;
    scene.put({0, 0, 1 - 1e-4});
    scene.remember(scene.find());
    for (ContactPoint& p : scene.state.contacts.points) p.elastic_slip = {1e-4, 0, 5e-5};
    const ContactSet found = scene.find();
    for (const ContactPoint& p : found.points) EXPECT_LT((p.elastic_slip - Vector3d(1e-4, 0, 0)).norm(), 1e-18);
}

// Over the edge of the floor the polygon gets new corners: they take what lies next to them, or the mean.
TEST(ContactHistory, NewPointsTakeTheMeanSlipOfThePatch)
{
    BoxOnFloor scene;
    scene.model.joints[0].face = FaceLaw::corners;
    scene.put({1.4, 0, 1 - 1e-4});
    scene.remember(scene.find());
    give_slip(scene.state);
    Vector3d mean = Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i) mean += slip_of(i) / 4;
    scene.put({1.7, 0, 1 - 1e-4});
    int fresh = 0;
    const ContactSet found = scene.find();
    for (const ContactPoint& p : found.points) {
        bool known = false;
        for (std::size_t i = 0; i < 4; ++i)
            known = known || (scene.state.contacts.points[i].feature == p.feature &&
                              (p.elastic_slip - slip_of(i)).norm() < 1e-18);
        if (known) continue;
        ++fresh;
        EXPECT_LT((p.elastic_slip - mean).norm(), 1e-18);
    }
    EXPECT_EQ(fresh, 2);
}

// What has only now come into touch has not been sheared: the shear force of the patch goes on as it was. Where
// the patch shrinks, what has left takes its force along.
TEST(ContactHistory, APatchThatGrowsKeepsItsShearForce)
{
    const auto force_in = [](const ContactSet& contacts) {
        double force = 0;
        for (const ContactPoint& p : contacts.points)
            force += contacts.patches[0].stiffness * p.area * p.elastic_slip.x();
        return force;
    };
    BoxOnFloor scene;
    const auto force_after = [&](double from, double to) {
        scene.put({from, 0, 1 - 1e-4});
        scene.state.contacts = {};
        scene.remember(scene.find());
        for (ContactPoint& p : scene.state.contacts.points) p.elastic_slip = {1e-4, 0, 0};
        const double before = force_in(scene.state.contacts);
        scene.put({to, 0, 1 - 1e-4});
        return force_in(scene.find()) / before;
    };
    EXPECT_NEAR(force_after(1.9, 1.7), 1, 1e-12);     // 0.6 m of the box on the floor, then 0.8 m
    EXPECT_NEAR(force_after(1.4, 1.45), 1, 1e-12);    // all of it, as before
    EXPECT_NEAR(force_after(1.5, 1.75), 0.75, 1e-6);  // a quarter has left the floor
}

// Corners come and go where a box passes an edge and comes back; as long as no area is gained or lost, no shear
// force is.
TEST(ContactHistory, NewCornersAtTheSameAreaLoseNoShearForce)
{
    BoxOnFloor scene;
    const auto force = [&] {
        double sum = 0;
        for (const ContactPoint& p : scene.state.contacts.points) sum += p.area * p.elastic_slip.x();
        return sum;
    };
    put_turned(scene, -5e-3);  // all of the box on the floor
    for (ContactPoint& p : scene.state.contacts.points) p.elastic_slip = {1e-4, 0, 0};
    const double before = force();
    swing_over_the_edge(scene);
    EXPECT_NEAR(force() / before, 1, 0.01);
}

// The same of the couple of its slips, by which the stones are twisted: they twist twenty times as far as the
// joint turns here, and would store a part more or less with every corner.
TEST(ContactHistory, NewCornersLeaveTheCoupleOfTheSlips)
{
    BoxOnFloor scene;
    const auto couple = [&] {
        Vector3d centre = Vector3d::Zero();
        double area = 0, sum = 0;
        for (const ContactPoint& p : scene.state.contacts.points) {
            centre += p.area * p.position;
            area += p.area;
        }
        centre /= area;
        for (const ContactPoint& p : scene.state.contacts.points)
            sum += p.area * (p.position - centre).cross(p.elastic_slip).z();
        return sum;
    };
    put_turned(scene, -5e-3);
    for (std::size_t i = 0; i < scene.state.contacts.points.size(); ++i)
        scene.state.contacts.points[i].elastic_slip = slip_of(i);
    const double before = couple();
    swing_over_the_edge(scene);
    EXPECT_NEAR(couple() / before, 1, 1e-3);
}

// A box on its edge has the floor as reference. A history in which the box was the reference holds the slip of the
// floor over the box: the same slip with the other sign.
TEST(ContactHistory, SlipChangesSignWhenTheBodiesChangePlaces)
{
    BoxOnFloor scene;
    scene.put({0, 0, 0.5 + std::sqrt(0.5) - 1e-4}, turned(45 * degrees, Vector3d::UnitY()));
    const ContactSet first = scene.find();
    ASSERT_EQ(first.patches.size(), 1U);
    ASSERT_EQ(first.patches[0].block_b, 0);
    scene.remember(first);
    give_slip(scene.state);
    std::swap(scene.state.contacts.patches[0].block_a, scene.state.contacts.patches[0].block_b);
    std::swap(scene.state.contacts.patches[0].feature_a, scene.state.contacts.patches[0].feature_b);
    const ContactSet found = scene.find();
    ASSERT_EQ(found.patches[0].block_b, 0);
    ASSERT_EQ(found.points.size(), first.points.size());
    for (std::size_t i = 0; i < found.points.size(); ++i) {
        EXPECT_LT((found.points[i].elastic_slip + slip_of(i)).norm(), 1e-18);
        EXPECT_LT((found.points[i].plastic_slip + 3 * slip_of(i)).norm(), 1e-18);
    }
}

TEST(ContactHistory, ContactThatEndsIsForgotten)
{
    BoxOnFloor scene;
    scene.put({0, 0, 1 - 1e-4});
    scene.remember(scene.find());
    give_slip(scene.state);
    scene.put({0, 0, 2});
    const ContactSet apart = scene.find();
    EXPECT_TRUE(apart.patches.empty());
    scene.remember(apart);
    scene.put({0, 0, 1 - 1e-4});
    for (const ContactPoint& p : scene.find().points) EXPECT_EQ(p.elastic_slip.norm(), 0);
}

}  // namespace voussoir::testing
