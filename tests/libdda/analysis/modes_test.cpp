// Natural frequencies of structures whose exact ones are known.
#include "libdda/analysis/modes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "libdda/contact/initial_contacts.h"
#include "libdda/model/elasticity.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double joint_stiffness = 3e8;  // Pa/m

JointMaterial springs(double stiffness = joint_stiffness)
{
    JointMaterial joint = dry(35);
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    return joint;
}

/// A rigid box of 0.6 x 0.8 x 1 m on a held floor.
Model block_on_springs(Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(), springs());
    model.thickness = 0.8;
    hold(model, add_box(model, "floor", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "block", {-0.3, -0.4, 0}, {0.3, 0.4, 1});
    return model;
}

/// The mode that has most of the mass along an axis.
NaturalMode along(int axis, const NaturalModes& found)
{
    NaturalMode most;
    for (const NaturalMode& mode : found.modes)
        if (mode.mass_share[axis] > most.mass_share[axis]) most = mode;
    return most;
}

class Block : public ::testing::TestWithParam<Kinematics>
{
};

TEST_P(Block, OnSpringsHasTheFrequenciesOfARigidBody)
{
    const Model model = block_on_springs(GetParam());
    const NaturalModes found = natural_modes(model, initial_state(model));
    ASSERT_EQ(found.outcome, ModesOutcome::found);
    EXPECT_EQ(found.loose, 0);
    EXPECT_EQ(found.modes.size(), is_planar(GetParam()) ? 3 : 6);

    const double area = 0.6 * 0.8, mass = 2500 * area, k = joint_stiffness * area;
    const NaturalMode up = along(2, found);
    EXPECT_NEAR(up.frequency, std::sqrt(k / mass) / two_pi, 1e-9 * up.frequency);
    EXPECT_NEAR(up.mass_share.z(), 1, 1e-9);
    EXPECT_NEAR(up.joint_share, 1, 1e-9);
    EXPECT_EQ(up.lowered_by_joints, 0) << "the stiffness was given as measured";

    // Sway along x and rocking about y are coupled: the centre of mass is 0.5 m above the springs, whose second
    // moment is that of the bed.
    const double b = 0.3, inertia = mass * (0.36 + 1) / 12, shear = 0.5 * k;
    Matrix2d stiffness, masses = Matrix2d::Zero();
    stiffness << shear, -0.5 * shear, -0.5 * shear, 0.25 * shear + k * b * b / 3;
    masses.diagonal() << mass, inertia;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix2d> exact(stiffness, masses);
    const double expected = std::sqrt(exact.eigenvalues()[0]) / two_pi;
    const NaturalMode& sway = along(0, found);
    EXPECT_NEAR(sway.frequency, expected, 1e-9 * expected);
}

INSTANTIATE_TEST_SUITE_P(Modes, Block, ::testing::Values(Kinematics::spatial_rigid, Kinematics::planar_rigid),
                         [](const auto& name) { return is_planar(name.param) ? "Planar" : "Spatial"; });

constexpr double young = 6e9, density = 2400, length = 0.5;  // Pa, kg/m3, m of a stone

/// A rod of square stones of no Poisson's ratio that stands on a held block; its joints are f E / L stiff.
Model rod(Kinematics kinematics, int stones, double f)
{
    Model model = make_model(kinematics, {"stone", density, young, 0}, dry(35));
    hold(model, add_box(model, "base", {-1, -1, -1}, {1, 1, 0}));
    for (int i = 0; i < stones; ++i)
        add_box(model, "stone", {-0.1, -0.1, i * length}, {0.1, 0.1, (i + 1) * length});
    // The factor of the rule that gives this stiffness, whatever the rule's own factor is. The base is rigid.
    State state = initial_state(model);
    find_initial_contacts(model, state);
    const double whole = (stones > 1 ? 1 : 2) * f * young / length;
    const double now = is_planar(kinematics) ? state.planar_contacts.patches.back().stiffness
                                             : state.contacts.patches.back().stiffness;
    model.joints[0].stiffness.factor = whole / now;
    return model;
}

/// omega^2 of the rod, exactly: stones of a displacement and a uniform strain each, joints f E / L stiff, the one
/// at the base twice that.
VectorXd exact_rod(int stones, double f)
{
    const double area = 1, mass = density * area * length;
    MatrixXd k = MatrixXd::Zero(2 * stones, 2 * stones), m = k;
    for (int i = 0; i < stones; ++i) {
        m(2 * i, 2 * i) = mass;
        m(2 * i + 1, 2 * i + 1) = mass * length * length / 12;
        k(2 * i + 1, 2 * i + 1) = young * area * length;
        VectorXd opening = VectorXd::Zero(2 * stones);
        opening[2 * i] = 1;
        opening[2 * i + 1] = -length / 2;
        if (i > 0) {
            opening[2 * i - 2] = -1;
            opening[2 * i - 1] = -length / 2;
        }
        k += (i > 0 ? 1 : 2) * f * young / length * area * opening * opening.transpose();
    }
    return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(k, m).eigenvalues();
}

TEST(Modes, OfARodAreThoseOfItsStonesExactly)
{
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::planar_deformable})
        for (const int stones : {1, 3, 8})
            for (const double f : {10.0, 300.0}) {
                const Model model = rod(kinematics, stones, f);
                const NaturalModes found = natural_modes(model, initial_state(model), {.count = 12});
                ASSERT_EQ(found.outcome, ModesOutcome::found);
                const NaturalMode axial = along(2, found);
                const double expected = std::sqrt(exact_rod(stones, f)[0]) / two_pi;
                EXPECT_NEAR(axial.frequency, expected, 1e-7 * expected) << stones << " stones, f " << f;
                // What the joints take away is told without knowing the rod that has none.
                const double stiff = std::sqrt(exact_rod(stones, 1e7)[0]) / two_pi;
                const double lowered = 1 - expected / stiff;
                EXPECT_NEAR(axial.lowered_by_joints, lowered, 0.15 * lowered) << stones << " stones, f " << f;
            }
}

TEST(Modes, TellWhatStonesThatDoNotBendAreWorth)
{
    // On corners a slender column bends in its joints alone. What is said of it leads back to the column of Euler
    // and Bernoulli, which stones that bend are.
    constexpr int stones = 40;
    constexpr double height = stones * length;
    for (const double f : {30.0, 300.0}) {
        Model column = rod(Kinematics::planar_deformable, stones, f);
        const NaturalModes bent = natural_modes(column, initial_state(column), {.count = 2});
        column.joints[0].face = FaceLaw::corners;
        const NaturalModes found = natural_modes(column, initial_state(column), {.count = 2});
        ASSERT_EQ(bent.outcome, ModesOutcome::found);
        ASSERT_EQ(found.outcome, ModesOutcome::found);
        const NaturalMode& sway = found.modes.front();
        const double bending =
            1.8751 * 1.8751 * std::sqrt(young * 0.04 / 12 / density) / (height * height) / two_pi;
        EXPECT_GT(sway.frequency, 4 * bending) << "f " << f;
        EXPECT_NEAR(sway.frequency / (1 + sway.raised_by_stones), bending, 0.03 * bending) << "f " << f;
        EXPECT_NEAR(bent.modes[0].frequency, bending, 5e-3 * bending) << "f " << f;
        EXPECT_LT(bent.modes[0].raised_by_stones, 0.6 / f) << "f " << f;
    }
    const Model stretched = rod(Kinematics::planar_deformable, 8, 300);
    EXPECT_LT(along(2, natural_modes(stretched, initial_state(stretched), {.count = 12})).raised_by_stones, 0.05);
}

TEST(Modes, OfAShearLayerAreThoseOfItsStonesExactly)
{
    // A stack 400 times as wide as a course is high shears and does not bend.
    constexpr int courses = 6;
    constexpr double height = 0.5, f = 40;
    Model model =
        make_model(Kinematics::planar_deformable, {"soil", density, young, 0.2}, springs(f * young / height));
    model.joints[0].face = FaceLaw::corners;  // not even as little as that wide courses bend
    hold(model, add_box(model, "base", {-101, 0, -1}, {101, 1, 0}));
    for (int i = 0; i < courses; ++i) add_box(model, "course", {-100, 0, i * height}, {100, 1, (i + 1) * height});
    const NaturalModes found = natural_modes(model, initial_state(model), {.count = 4});
    ASSERT_EQ(found.outcome, ModesOutcome::found);
    // The same chain as the rod's, with G for E and half the joint stiffness across it, all joints alike.
    const double shear = young / 2.4, joint = 0.5 * f * young / height;
    MatrixXd k = MatrixXd::Zero(2 * courses, 2 * courses), m = k;
    for (int i = 0; i < courses; ++i) {
        m(2 * i, 2 * i) = density * height;
        m(2 * i + 1, 2 * i + 1) = density * height * height * height / 12;
        k(2 * i + 1, 2 * i + 1) = shear * height;
        VectorXd slip = VectorXd::Zero(2 * courses);
        slip[2 * i] = 1;
        slip[2 * i + 1] = -height / 2;
        if (i > 0) {
            slip[2 * i - 2] = -1;
            slip[2 * i - 1] = -height / 2;
        }
        k += joint * slip * slip.transpose();
    }
    const double expected =
        std::sqrt(Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(k, m).eigenvalues()[0]) / two_pi;
    EXPECT_NEAR(along(0, found).frequency, expected, 1e-4 * expected);
    EXPECT_GT(along(0, found).mass_share.x(), 0.75);
}

TEST(Modes, DoNotDependOnHowAStructureIsTurned)
{
    // A square tower: bending modes come in pairs.
    Model tower = make_model(Kinematics::spatial_deformable, stone(), springs());
    hold(tower, add_box(tower, "base", {-1, -1, -1}, {1, 1, 0}));
    for (int i = 0; i < 4; ++i) add_box(tower, "stone", {-0.3, -0.3, 0.5 * i}, {0.3, 0.3, 0.5 * (i + 1)});
    const NaturalModes found = natural_modes(tower, initial_state(tower), {.count = 4});
    ASSERT_EQ(found.modes.size(), 4);
    EXPECT_NEAR(found.modes[1].frequency / found.modes[0].frequency, 1, 1e-9);
    EXPECT_GT(found.modes[3].frequency, 1.5 * found.modes[0].frequency);
    EXPECT_NEAR((found.modes[0].mass_share + found.modes[1].mass_share).x(),
                (found.modes[0].mass_share + found.modes[1].mass_share).y(), 1e-9);
}

TEST(Modes, OfLooseStonesAreNone)
{
    Model model = block_on_springs(Kinematics::spatial_rigid);
    add_box(model, "flying", {-0.3, -0.4, 3}, {0.3, 0.4, 4});
    EXPECT_EQ(natural_modes(model, initial_state(model)).modes.size(), 6) << "a stone that touches nothing";
    Model falling = make_model(Kinematics::spatial_rigid, stone(), springs());
    add_box(falling, "lower", {0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(natural_modes(falling, initial_state(falling)).outcome, ModesOutcome::nothing_closed);
    add_box(falling, "upper", {0, 0, 1}, {1, 1, 2});
    const NaturalModes two = natural_modes(falling, initial_state(falling));
    EXPECT_EQ(two.loose, 6) << "two stones that hold each other and nothing else";
    EXPECT_EQ(two.modes.size(), 6);
}

TEST(Modes, AreNotSoughtWhereThatIsTooMuchWork)
{
    const Model model = block_on_springs(Kinematics::spatial_rigid);
    EXPECT_EQ(natural_modes(model, initial_state(model), {.count = 6, .most_work = 100}).outcome,
              ModesOutcome::too_costly);
}

TEST(Modes, CountOnlyJointsThatPressAfterAStep)
{
    // A block that leans on a wall at the start and is pulled off it: the wall is no support any more.
    Model model = block_on_springs(Kinematics::spatial_rigid);
    hold(model, add_box(model, "wall", {0.3, -0.4, 0}, {1, 0.4, 1}));
    State state = initial_state(model);
    const double with_wall = along(0, natural_modes(model, state)).frequency;
    Stage stage;
    stage.name = "pull";
    stage.type = StageType::static_equilibrium;
    stage.gravity = {-1, 0, -gravity};
    stage.control.time_step = 1;
    ASSERT_EQ(run(model, {stage}, state, {}).outcome, Outcome::completed);
    const double alone = along(0, natural_modes(model, state)).frequency;
    const Model free = block_on_springs(Kinematics::spatial_rigid);
    EXPECT_NEAR(alone, along(0, natural_modes(free, initial_state(free))).frequency, 1e-4 * alone);
    EXPECT_GT(with_wall, 1.3 * alone);
}

}  // namespace

}  // namespace voussoir::testing
