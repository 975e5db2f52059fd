// The spellings of how stiff a contact is.
#include <gtest/gtest.h>

#include "libdda/contact/initial_contacts.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

/// Total normal stiffness [N/m] of all contacts of a 1 x 2 x 0.4 m box (a beam's half) on a floor.
struct Floor {
    Model model;
    State state;

    Floor(Kinematics kinematics, const ContactStiffness& stiffness, bool held, int pieces = 1)
    {
        JointMaterial joint = dry(30);
        joint.stiffness = stiffness;
        model = make_model(kinematics, stone(2e9), joint);
        for (int i = 0; i < pieces; ++i) {
            const double from = -4 + 8.0 * i / pieces, to = -4 + 8.0 * (i + 1) / pieces;
            const int floor = add_box(model, "floor", {from, -4, -1.2}, {to, 4, 0});
            if (held) hold(model, floor);
        }
        add_box(model, "box", {-0.4, -1, 0}, {0.6, 1, 0.4});
        state = initial_state(model);
        find_initial_contacts(model, state);
    }
    double total() const
    {
        double sum = 0;
        for (const ContactPatch& patch : state.contacts.patches)
            for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
                sum += patch.stiffness * state.contacts.points[i].area;
        return sum;
    }
};

constexpr ContactStiffness::Kind from_modulus = ContactStiffness::Kind::from_modulus;
constexpr ContactStiffness::Kind per_point = ContactStiffness::Kind::per_point;
constexpr ContactStiffness::Kind per_area = ContactStiffness::Kind::per_area;

}  // namespace

// Shi's penalty: four corners of k each, whatever the floor is cut into.
TEST(ContactStiffness, PerPointIsThatOfTheCorners)
{
    for (const int pieces : {1, 2, 3}) {
        const Floor floor(Kinematics::spatial_deformable, {per_point, 1e8}, true, pieces);
        EXPECT_NEAR(floor.total(), 4e8, 1) << pieces << " floor blocks";
    }
}

TEST(ContactStiffness, PerAreaIsKTimesArea)
{
    for (const int pieces : {1, 2, 3}) {
        const Floor floor(Kinematics::spatial_deformable, {per_area, 50e6}, true, pieces);
        EXPECT_NEAR(floor.total(), 50e6 * 2, 1) << pieces << " floor blocks";
    }
}

// k = 2 f / (L_a/E + L_b/E), f = 30 between dry deformable stones, 300 bonded ones and 10 between rigid ones; a
// held floor adds no compliance.
TEST(ContactStiffness, DefaultFollowsModulusAndDepths)
{
    const ContactStiffness rule;
    const double young = 2e9, box = 0.4, floor = 1.2, area = 2;
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::spatial_rigid}) {
        const double factor = is_deformable(kinematics) ? 30 : 10;
        const double held = 2 * factor * young / box * area, free = 2 * factor * young / (box + floor) * area;
        EXPECT_NEAR(Floor(kinematics, rule, true).total(), held, 1e-12 * held);
        EXPECT_NEAR(Floor(kinematics, rule, false).total(), free, 1e-12 * free);
        Floor bonded(kinematics, rule, false);
        bonded.model.joints[0].cohesion = 1e6;
        bonded.model.joints[0].tensile_strength = 1e5;
        bonded.state = initial_state(bonded.model);
        find_initial_contacts(bonded.model, bonded.state);
        const double bonds = is_deformable(kinematics) ? 10 * free : free;
        EXPECT_NEAR(bonded.total(), bonds, 1e-12 * bonds);
    }
}

// As many E / L as are asked for, whatever the kinematics.
TEST(ContactStiffness, TimesTheModulusIsWhatWasAskedFor)
{
    const double held = 2 * 7 * 2e9 / 0.4 * 2;
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::spatial_rigid})
        EXPECT_NEAR(Floor(kinematics, {from_modulus, 7}, true).total(), held, 1e-12 * held);
}

TEST(ContactStiffness, FactorMultipliesEverySpelling)
{
    for (const ContactStiffness& given : {ContactStiffness{}, ContactStiffness{from_modulus, 7},
                                          ContactStiffness{per_point, 1e8}, ContactStiffness{per_area, 50e6}}) {
        ContactStiffness scaled = given;
        scaled.factor = 4;
        const double once = Floor(Kinematics::spatial_rigid, given, false).total();
        const double four_times = Floor(Kinematics::spatial_rigid, scaled, false).total();
        EXPECT_NEAR(four_times, 4 * once, 1e-12 * once) << static_cast<int>(given.kind);
    }
}

// Where the spring ends up: a rigid box of weight W sinks W / (4 k).
TEST(ContactStiffness, BoxSinksByWeightOverStiffness)
{
    Floor floor(Kinematics::spatial_rigid, {per_point, 1e7}, true);
    const double start = centroid(floor.model, floor.state, 1).z();
    ASSERT_EQ(run_quietly(floor.model, {static_stage(0.1)}, floor.state).outcome, Outcome::completed);
    const double sink = start - centroid(floor.model, floor.state, 1).z();
    const double exact = floor.model.mass(1) * gravity / 4e7;
    EXPECT_NEAR(sink, exact, 1e-6 * exact);
}

// Shear springs are a share of the normal ones: a rigid sticking box moves mg sin a / (share x 4 k) down the
// slope.
TEST(ContactStiffness, ShearFollowsItsShare)
{
    Floor floor(Kinematics::spatial_rigid, {per_point, 1e7}, true);
    floor.model.joints[0].shear_to_normal_stiffness = 0.25;
    const Eigen::Vector3d slope = inclined_gravity(10);
    const double low = floor.model.blocks[1].moments.centroid.z();
    ASSERT_EQ(run_quietly(floor.model, {static_stage(0.1, slope)}, floor.state).outcome, Outcome::completed);
    // Moments tilt the box on its springs: 4 k (1 m)^2 / 12 theta = mg sin a x low, seen at the height of the
    // centroid.
    const double pull = floor.model.mass(1) * slope.x();
    const double sheared = pull / (0.25 * 4e7), tilt = pull * low / (4e7 / 12);
    const double moved = centroid(floor.model, floor.state, 1).x() - 0.1;
    EXPECT_NEAR(moved, sheared + tilt * low, 2e-3 * moved);
}

}  // namespace voussoir::testing
