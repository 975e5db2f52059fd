// What a contact remembers from step to step: its face, its points, its slip.
#include <gtest/gtest.h>

#include "libdda/contact/find_contacts.h"
#include "libdda/contact/narrow_phase.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A small box on a large one; both free to be put anywhere.
struct Scene {
    Model model = make_model(Kinematics::spatial_deformable, stone(), dry(30));
    State state;

    explicit Scene(const Vector3d& floor = {4, 4, 1})
    {
        add_box(model, "floor", -0.5 * floor, 0.5 * floor);
        add_box(model, "box", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
        state = initial_state(model);
    }
    void put(const Vector3d& centre, const Matrix3d& rotation = Matrix3d::Identity())
    {
        set_pose(model, state, 1, centre, rotation);
    }
    ContactSet find(NewOverlap overlap = NewOverlap::presses) const
    {
        ContactSet found;
        std::vector<PlacedPart> parts;
        find_contacts(model, state, std::vector<double>(2, 5e-3), 1, parts, found, overlap);
        return found;
    }
    void remember(const ContactSet& found)
    {
        state.contacts.patches = found.patches;
        state.contacts.points = found.points;
    }
};

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

}  // namespace

TEST(ContactHistory, last_face_keeps_its_contact_against_a_slightly_better_one)
{
    // Two unit cubes overlapping at an edge: 1 mm in x, a little more or less in z.
    Scene scene({1, 1, 1});
    const auto face_at = [&](double depth_z, const std::optional<LastContact>& last) {
        scene.put({1 - 1e-3, 0, 1 - depth_z});
        const std::vector<PlacedPart> parts = placed(scene.model, scene.state);
        return contact_polygon(parts[0], parts[1], 1e-2, last);
    };
    const auto sideways = face_at(3e-3, {}), upwards = face_at(0.2e-3, {});
    ASSERT_TRUE(sideways && upwards);
    EXPECT_NEAR(std::abs(sideways->normal.x()), 1, 1e-12);
    EXPECT_NEAR(std::abs(upwards->normal.z()), 1, 1e-12);

    const LastContact x{sideways->second_is_reference, false, sideways->reference_feature};
    const LastContact z{upwards->second_is_reference, false, upwards->reference_feature};
    // Within 1e-3 of the size the last face stays, whichever it was; beyond, the better one wins.
    for (const double depth_z : {0.5e-3, 0.9e-3, 1.1e-3, 1.5e-3}) {
        EXPECT_NEAR(std::abs(face_at(depth_z, x)->normal.x()), 1, 1e-12) << depth_z;
        EXPECT_NEAR(std::abs(face_at(depth_z, z)->normal.z()), 1, 1e-12) << depth_z;
    }
    EXPECT_NEAR(std::abs(face_at(3e-3, z)->normal.x()), 1, 1e-12);
}

TEST(ContactHistory, features_and_slips_survive_sliding)
{
    Scene scene;
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

TEST(ContactHistory, slip_is_laid_into_the_new_tangent_plane)
{
    Scene scene;
    scene.put({0, 0, 1 - 1e-4});
    scene.remember(scene.find());
    for (ContactPoint& p : scene.state.contacts.points) p.elastic_slip = {1e-4, 0, 5e-5};
    const ContactSet found = scene.find();
    for (const ContactPoint& p : found.points) EXPECT_LT((p.elastic_slip - Vector3d(1e-4, 0, 0)).norm(), 1e-18);
}

// Over the edge of the floor the polygon gets new corners: they take what lies next to them, or the mean.
TEST(ContactHistory, new_points_take_the_mean_slip_of_the_patch)
{
    Scene scene;
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
TEST(ContactHistory, a_patch_that_grows_keeps_its_shear_force)
{
    const auto force_in = [](const ContactSet& contacts) {
        double force = 0;
        for (const ContactPoint& p : contacts.points)
            force += contacts.patches[0].stiffness * p.area * p.elastic_slip.x();
        return force;
    };
    Scene scene;
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
TEST(ContactHistory, new_corners_at_the_same_area_lose_no_shear_force)
{
    Scene scene;
    const auto force = [&] {
        double sum = 0;
        for (const ContactPoint& p : scene.state.contacts.points) sum += p.area * p.elastic_slip.x();
        return sum;
    };
    const double angle = 0.3, reach = 0.5 * (std::cos(angle) + std::sin(angle));  // of the foremost corner
    const auto put_to = [&](double beyond) {
        scene.put({2 - reach + beyond, 0, 1 - 1e-4}, turned(angle, {0, 0, 1}));
        scene.remember(scene.find());
    };
    put_to(-5e-3);  // all of the box on the floor
    for (ContactPoint& p : scene.state.contacts.points) p.elastic_slip = {1e-4, 0, 0};
    const double before = force();
    std::size_t fewest = 100, most = 0;
    for (int i = 0; i < 20; ++i) {
        put_to(i % 2 == 0 ? 5e-3 : -5e-3);
        fewest = std::min(fewest, scene.state.contacts.points.size());
        most = std::max(most, scene.state.contacts.points.size());
    }
    EXPECT_LT(fewest, most);
    EXPECT_NEAR(force() / before, 1, 0.01) << fewest << " to " << most << " corners";
}

// A box on its edge has the floor as reference. A history in which the box was the reference holds the slip of the
// floor over the box: the same slip with the other sign.
TEST(ContactHistory, slip_changes_sign_when_the_bodies_change_places)
{
    Scene scene;
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

// Corners keep their rest gap while they slide and when the bodies change places, and gaps count from there.
TEST(ContactHistory, rest_gaps_stay_with_their_corners)
{
    Scene scene;
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
TEST(ContactHistory, rest_gaps_of_new_corners_lie_between_those_of_the_old)
{
    Scene scene;
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
TEST(ContactHistory, a_joint_is_bonded_if_it_is_closed_at_every_corner)
{
    Scene scene;
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

double pressed_energy(const ContactSet& contacts)
{
    double energy = 0;
    for (const ContactPoint& p : contacts.points)
        energy += 0.5 * contacts.patches[0].stiffness * p.area * std::pow(std::min(p.gap, 0.0), 2);
    return energy;
}

// A contact that presses and goes over to another face has another area and depth from one step to the next: its
// springs store what they stored. It is as stiff as ever, and presses again at once where the stones had parted
// to.
TEST(ContactHistory, a_contact_that_changes_its_face_gives_no_energy)
{
    constexpr NewOverlap forgiven = NewOverlap::forgiven;
    for (const double share : {1e-6, 0.02, 0.5, 50.0}) {  // of the area that the contact had on the other face
        Scene scene;
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
TEST(ContactHistory, a_forgiven_overlap_outlives_a_change_to_a_stage_where_overlaps_press)
{
    for (const int turned : {0, 1}) {
        Scene scene;
        scene.put({0, 0, 1 - 1e-3});
        scene.remember(scene.find(NewOverlap::forgiven));  // found late: nothing was stored
        for (const ContactPoint& p : scene.state.contacts.points) {
            EXPECT_NEAR(p.gap, 0, 1e-15);
            EXPECT_NEAR(p.rest_gap, -1e-3, 1e-12);
        }
        ContactPatch& patch = scene.state.contacts.patches[0];
        patch.feature_b = (patch.feature_b + turned) % 6;
        scene.put({0, 0, 1 - 1.2e-3});
        scene.remember(scene.find(NewOverlap::presses));
        for (const ContactPoint& p : scene.state.contacts.points) {
            EXPECT_NEAR(p.gap, -0.2e-3, 1e-12);
            EXPECT_NEAR(p.rest_gap, -1e-3, 1e-12);
        }
        scene.put({0, 0, 1 - 0.3e-3});
        scene.remember(scene.find(NewOverlap::presses));
        for (const ContactPoint& p : scene.state.contacts.points) {
            EXPECT_NEAR(p.gap, 0, 1e-15);
            EXPECT_NEAR(p.rest_gap, -0.3e-3, 1e-12);
        }
        scene.put({0, 0, 1 + 1e-4});
        scene.remember(scene.find(NewOverlap::presses));
        scene.put({0, 0, 1 - 1e-3});
        for (const ContactPoint& p : scene.find(NewOverlap::presses).points) EXPECT_NEAR(p.gap, -1e-3, 1e-12);
    }
}

// Mortar stays, whatever face the stones turn to one another, and bonds are forgiven nothing.
TEST(ContactHistory, rest_gaps_of_joints_that_break_stay_what_they_were)
{
    for (const bool intact : {false, true}) {
        Scene scene;
        scene.put({0, 0, 1 - 1e-5});
        scene.remember(scene.find());
        ContactPatch& patch = scene.state.contacts.patches[0];
        patch.feature_b = (patch.feature_b + 1) % 6;
        patch.intact = intact;
        for (ContactPoint& p : scene.state.contacts.points) {
            p.rest_gap = 3e-5;
            p.gap = -4e-5;
        }
        for (const ContactPoint& p : scene.find(NewOverlap::forgiven).points) {
            EXPECT_NEAR(p.rest_gap, 3e-5, 1e-15) << intact;
            EXPECT_NEAR(p.gap, -4e-5, 1e-15) << intact;
        }
    }
}

// Half of a box's face slides over the edge in a run; its stored shear must not depend on corners that die.
TEST(ContactHistory, contact_that_ends_is_forgotten)
{
    Scene scene;
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
