// The verdict at the end of a run, of structures whose state is known: what stands, what moves, what has come off.
#include "libdda/analysis/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

class VerdictOf : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, VerdictOf, every_kinematics(), test_name);

/// A floor 10 m long, top at z = 0.
Model floor_model(Kinematics kinematics, double friction = 35)
{
    Model model = make_model(kinematics, stone(), dry(friction));
    hold(model, add_box(model, "floor", {-5, -1, -1}, {5, 1, 0}));
    return model;
}

/// Boxes on one another, from the floor up.
void add_stack(Model& model, int count, double width, double height)
{
    for (int i = 0; i < count; ++i)
        add_box(model, "stone", {-width / 2, -width / 2, i * height}, {width / 2, width / 2, (i + 1) * height});
}

Verdict verdict_after(const Model& model, const std::vector<Stage>& stages, State& state)
{
    const RunReport report = run_quietly(model, stages, state);
    EXPECT_TRUE(report.verdict);
    if (!report.verdict) return {};
    const bool fell = !report.verdict->lost.empty();
    EXPECT_EQ(report.outcome, fell ? Outcome::collapsed : Outcome::completed);
    return *report.verdict;
}

Verdict verdict_after(const Model& model, const std::vector<Stage>& stages)
{
    State state = initial_state(model);
    return verdict_after(model, stages, state);
}

/// The verdict on stones that are put where they are. @param pose of a block
Verdict verdict_of_placed(const Model& model, int block, const Eigen::Vector3d& centroid,
                          const Eigen::Matrix3d& map)
{
    State state = initial_state(model);
    const std::vector<WatchedJoint> joints = joints_at_start(model, state);
    const RunStart from{state.coordinates, state.coordinates};
    set_pose(model, state, block, centroid, map);
    return verdict_of(model, joints, from, {0, 0, -gravity}, state).value();
}

/// Ground that goes to one side and stops: a pulse of acceleration there and back [m/s2], each `part` s long.
std::shared_ptr<const GroundMotion> jolt(double acceleration, double part)
{
    constexpr int samples = 20;
    std::vector<double> values(2 * samples + 1, 0.0);
    for (int i = 1; i < samples; ++i) values[i] = acceleration, values[samples + i] = -acceleration;
    return std::make_shared<GroundMotion>(GroundMotion::from_acceleration(values, part / samples, "jolt"));
}

}  // namespace

TEST_P(VerdictOf, AStackAtRestStandsUndamaged)
{
    Model model = floor_model(GetParam());
    add_stack(model, 4, 0.5, 0.3);
    const Verdict verdict = verdict_after(model, {static_stage(0.1), dynamic_stage(0.1, 1e-3)});
    EXPECT_EQ(verdict.standing, Standing::stands);
    EXPECT_EQ(verdict.damage, DamageLevel::none);
    EXPECT_EQ(verdict.blocks.size(), 5U);
    for (const BlockEnd& block : verdict.blocks) EXPECT_LT(block.displacement, 1e-5);
}

TEST_P(VerdictOf, APillarOnItsSideHasFallenThoughItLiesStill)
{
    Model model = floor_model(GetParam());
    const int pillar = add_box(model, "pillar", {-0.25, -0.25, 0}, {0.25, 0.25, 2});
    Stage shaking = dynamic_stage(4, 2e-3);
    shaking.motions.push_back({0, 0, jolt(6, 0.5)});
    const Verdict verdict = verdict_after(model, {static_stage(0.1), shaking});
    EXPECT_EQ(verdict.standing, Standing::fallen);
    EXPECT_EQ(verdict.lost, std::vector{pillar});
    EXPECT_EQ(verdict.lost_share, 1);
    EXPECT_NEAR(verdict.blocks[static_cast<std::size_t>(pillar)].turn, 90 * degrees, 1 * degrees);
}

TEST_P(VerdictOf, APillarThatIsFallingMoves)
{
    Model model = floor_model(GetParam());
    const int pillar = add_box(model, "pillar", {-0.25, -0.25, 0}, {0.25, 0.25, 2});
    model.initial_motions = {{pillar, {1.5, 0, 0}, {0, 1.5, 0}}};
    const Verdict verdict = verdict_after(model, {dynamic_stage(0.2, 1e-3)});
    EXPECT_EQ(verdict.standing, Standing::moves);
    EXPECT_EQ(verdict.fastest, pillar);
    EXPECT_GT(verdict.speed, 0.5);
    EXPECT_GE(verdict.go_on, 1);
}

// It has gone further than its size, but it stands.
TEST_P(VerdictOf, ABlockThatHasSlidStandsDislocated)
{
    Model model = floor_model(GetParam(), 10);
    const int box = add_box(model, "box", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    model.initial_motions = {{box, {2, 0, 0}, {0, 0, 0}}};
    const Verdict verdict = verdict_after(model, {static_stage(0.1), dynamic_stage(2, 1e-3)});
    const double way = 2 * 2 / (2 * gravity * std::tan(10 * degrees));
    EXPECT_GT(way, size_of(model, box));
    EXPECT_EQ(verdict.standing, Standing::stands);
    EXPECT_EQ(verdict.damage, DamageLevel::significant_damage);
    EXPECT_NEAR(verdict.worst.slip, way, 0.02 * way);
    EXPECT_NEAR(verdict.blocks[static_cast<std::size_t>(box)].displacement, way, 0.02 * way);
}

TEST_P(VerdictOf, AStackWithoutItsTopHasLostOneStone)
{
    Model model = floor_model(GetParam());
    add_stack(model, 4, 0.5, 0.3);
    const int top = 4;
    const Verdict verdict = verdict_of_placed(model, top, {1, 0, 0.15}, Eigen::Matrix3d::Identity());
    EXPECT_EQ(verdict.standing, Standing::lost_stones);
    EXPECT_EQ(verdict.lost, std::vector{top});
    EXPECT_NEAR(verdict.lost_share, 0.25, 1e-9);
}

// Supports that sink alike, or go aside, are no failure: all is told relative to them.
TEST_P(VerdictOf, WhatMovesWithItsSupportsStandsUndamaged)
{
    Model model = floor_model(GetParam());
    add_stack(model, 3, 0.5, 0.3);
    Stage moving = dynamic_stage(2, 2e-3);
    moving.motions.push_back({0, 0, jolt(0.5, 1)});
    const Verdict verdict = verdict_after(model, {static_stage(0.1), moving});
    EXPECT_EQ(verdict.standing, Standing::stands);
    EXPECT_EQ(verdict.damage, DamageLevel::none);
    EXPECT_LT(verdict.blocks[3].displacement, 1e-3);
}

// A beam whose supports move apart: the gap opens, nothing falls; the joint that opens is told.
TEST_P(VerdictOf, SupportsThatPartOpenAJointAndNoMore)
{
    Model model = make_model(GetParam(), stone(), dry(35));
    hold(model, add_box(model, "left", {-1, -0.5, -0.5}, {0, 0.5, 0}));
    hold(model, add_box(model, "right", {0, -0.5, -0.5}, {1, 0.5, 0}));
    add_box(model, "on left", {-0.5, -0.25, 0}, {0, 0.25, 0.5});
    add_box(model, "on right", {0, -0.25, 0}, {0.5, 0.25, 0.5});
    Stage parting = dynamic_stage(2, 2e-3);
    parting.motions.push_back({1, 0, jolt(0.05, 1)});
    const Verdict verdict = verdict_after(model, {static_stage(0.1), parting});
    EXPECT_EQ(verdict.standing, Standing::stands);
    EXPECT_EQ(verdict.damage, DamageLevel::significant_damage);
    EXPECT_EQ(verdict.worst.block_a, 2);
    EXPECT_EQ(verdict.worst.block_b, 3);
    EXPECT_NEAR(verdict.worst.opening, 0.05 * 0.95, 0.005);
}

TEST_P(VerdictOf, AStoneThatFliesAndLandsHasNotFallen)
{
    Model model = floor_model(GetParam());
    add_stack(model, 1, 0.5, 0.5);
    add_box(model, "in the air", {2, -0.25, 1}, {2.5, 0.25, 1.5});
    const Verdict verdict = verdict_after(model, {dynamic_stage(2, 1e-3)});
    EXPECT_EQ(verdict.standing, Standing::stands);
    EXPECT_TRUE(verdict.lost.empty());
}

TEST_P(VerdictOf, WithoutGroundOrGravityThereIsNone)
{
    Model free = make_model(GetParam(), stone(), dry(35));
    add_box(free, "stone", {0, 0, 0}, {1, 1, 1});
    State flying = initial_state(free);
    EXPECT_FALSE(run_quietly(free, {dynamic_stage(1, 1e-2)}, flying).verdict) << "no ground";
    Model model = floor_model(GetParam());
    add_stack(model, 1, 0.5, 0.5);
    State weightless = initial_state(model);
    EXPECT_FALSE(run_quietly(model, {dynamic_stage(0.1, 1e-2, {0, 0, 0})}, weightless).verdict) << "no gravity";
}

// What settles under its own weight is no damage.
TEST_P(VerdictOf, OfARunThatOnlyComesToRestNoDamageIsTold)
{
    Model model = floor_model(GetParam());
    model.joints[0].stiffness.factor = 0.001;
    add_stack(model, 3, 0.5, 0.3);
    const Verdict verdict = verdict_after(model, {static_stage(0.1)});
    EXPECT_EQ(verdict.standing, Standing::stands);
    EXPECT_EQ(verdict.worst.block_a, -1);
    EXPECT_EQ(verdict.damage, DamageLevel::none);
}

TEST_P(VerdictOf, LevelsOfDamageAreThoseOfTheScale)
{
    Model model = floor_model(GetParam());
    const int box = add_box(model, "box", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
    const double size = size_of(model, box);
    const Eigen::Vector3d home = model.blocks[static_cast<std::size_t>(box)].moments.centroid;
    const auto at = [&](double share) {
        return verdict_of_placed(model, box, home + Eigen::Vector3d(share * size, 0, 0),
                                 Eigen::Matrix3d::Identity());
    };
    EXPECT_EQ(at(0.0049).damage, DamageLevel::none);
    EXPECT_EQ(at(0.0051).damage, DamageLevel::limited_deformation);
    EXPECT_EQ(at(0.0101).damage, DamageLevel::light_damage);
    EXPECT_EQ(at(0.0201).damage, DamageLevel::significant_damage);
    EXPECT_EQ(at(0.0201).standing, Standing::stands);
    EXPECT_NEAR(at(0.0201).worst.share, 0.0201, 1e-9);
    EXPECT_EQ(at(0.6).standing, Standing::fallen) << "in no contact, and far away";
}

TEST_P(VerdictOf, WhatLeansByThirtyDegreesHasTurnedOver)
{
    Model model = floor_model(GetParam());
    const int pillar = add_box(model, "pillar", {-0.2, -0.2, 0}, {0.2, 0.2, 2});
    const auto leaning = [&](double angle) {
        const Eigen::Matrix3d map = turned(angle * degrees, Eigen::Vector3d::UnitY());
        const Eigen::Vector3d edge(0.2, 0, 0);
        return verdict_of_placed(model, pillar, edge + map * Eigen::Vector3d(-0.2, 0, 1), map);
    };
    EXPECT_EQ(leaning(29).standing, Standing::stands);
    EXPECT_EQ(leaning(31).standing, Standing::fallen);
}

// It slides down, metres deep, but its bed still carries it.
TEST_P(VerdictOf, ABlockOnAnInclineSlidesAndHasNotFallen)
{
    Model model = floor_model(GetParam(), 10);
    const int box = add_box(model, "box", {-4, -0.25, 0}, {-3.5, 0.25, 0.25});
    Stage stage = dynamic_stage(1, 1e-3, inclined_gravity(30));
    const Verdict verdict = verdict_after(model, {stage});
    EXPECT_EQ(verdict.standing, Standing::moves);
    EXPECT_EQ(verdict.fastest, box);
    EXPECT_GT(verdict.blocks[static_cast<std::size_t>(box)].displacement * std::sin(30 * degrees), 0.5);
}

// A drum that has turned about its own axis stands.
TEST(Verdicts, ATwistIsNoFall)
{
    Model model = floor_model(Kinematics::spatial_rigid);
    const int drum = add_box(model, "drum", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
    const Verdict verdict = verdict_of_placed(model, drum, {0, 0, 0.5}, turned(40 * degrees, {0, 0, 1}));
    EXPECT_EQ(verdict.standing, Standing::stands);
    EXPECT_NEAR(verdict.blocks[static_cast<std::size_t>(drum)].turn, 40 * degrees, 1e-9);
}

TEST(Verdicts, AStoneThatHangsFromABarIsCarried)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(35));
    hold(model, add_box(model, "beam", {-1, -0.25, 2}, {1, 0.25, 2.5}));
    const int low = add_box(model, "low", {-0.25, -0.25, 0}, {0.25, 0.25, 0.5});
    Bar bar;
    bar.block_a = 0;
    bar.block_b = low;
    model.bars.push_back(bar);
    State state = initial_state(model);
    const Verdict verdict =
        verdict_of(model, joints_at_start(model, state), {state.coordinates, {}}, {0, 0, -gravity}, state).value();
    EXPECT_TRUE(verdict.lost.empty());
    EXPECT_GT(verdict.mass, 0);
}

}  // namespace voussoir::testing
