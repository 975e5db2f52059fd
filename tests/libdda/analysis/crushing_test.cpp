// Edge stresses of joints against the strength of their stones.
#include "libdda/analysis/crushing.h"

#include <gtest/gtest.h>

#include "libdda/analysis/edge_stress.h"
#include "libdda/analysis/joint_resultants.h"
#include "libdda/contact/initial_contacts.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class Crushing : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Crushing, every_kinematics(), test_name);

constexpr double width = 1, height = 2;

struct Box {
    Eigen::Vector3d lower, upper;
};

/// A block of boxes glued together.
int add_glued(Model& model, const std::string& name, const std::vector<Box>& boxes)
{
    std::vector<ConvexPolyhedron> parts;
    std::vector<ConvexPolygon> outlines;
    for (const Box& box : boxes) {
        parts.push_back(make_box(box.lower, box.upper));
        outlines.push_back(make_rectangle(from_space<2>(box.lower), from_space<2>(box.upper)));
    }
    model.blocks.push_back(is_planar(model.kinematics) ? make_planar_block(name, 0, 0, outlines, model.thickness)
                                                       : make_block(name, 0, 0, parts));
    return static_cast<int>(model.blocks.size()) - 1;
}

/// A pillar 1 m wide and 2 m high on a held base of one or more boxes, all of one stone.
Model pillar(Kinematics kinematics, double strength, double friction_degrees = 40,
             const std::vector<Box>& base = {{{-2, -2, -1}, {2, 2, 0}}})
{
    BlockMaterial material = stone();
    material.compressive_strength = strength;
    Model model = make_model(kinematics, material, dry(friction_degrees));
    hold(model, add_glued(model, "base", base));
    add_box(model, "pillar", {-width / 2, -width / 2, 0}, {width / 2, width / 2, height});
    return model;
}

/// Gravity of the same weight that leans sideways by `slope`: the resultant meets the base at slope x height / 2.
Eigen::Vector3d leaning(double slope)
{
    return {gravity * slope, 0, -gravity};
}

}  // namespace

// N over the part of the joint that it acts in the middle of: N / (b - 2 e).
TEST_P(Crushing, EdgeStressIsTheResultantOverTheEffectiveArea)
{
    for (const double slope : {0.0, 0.1, 0.2, 0.35}) {
        const Model model = pillar(GetParam(), 0);
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {static_stage(0.1, leaning(slope))}, state);
        ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        const std::vector<JointResultant> joints = joint_resultants(model, state);
        ASSERT_EQ(joints.size(), 1);
        const double eccentricity = slope * height / 2;
        const double area = model.mass(1) * gravity / joints[0].normal_force * width;  // a strip if planar
        const double exact = model.mass(1) * gravity / (joints[0].area * (1 - 2 * eccentricity / width));
        EXPECT_NEAR(joints[0].edge_stress, exact, 0.02 * exact) << slope << " " << area;
        const JointResultant without = joint_resultants(model, state, EdgeStress::left_out)[0];
        EXPECT_EQ(without.edge_stress, 0);
        EXPECT_EQ(without.force, joints[0].force);
        EXPECT_EQ(without.pressure_centre, joints[0].pressure_centre);
    }
}

// The base is glued of two parts that meet under the pillar: one bed all the same.
TEST_P(Crushing, PatchesInOnePlaneAreOneBed)
{
    const Model model = pillar(GetParam(), 0, 40, {{{-2, -2, -1}, {0.1, 2, 0}}, {{0.1, -2, -1}, {2, 2, 0}}});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.1, leaning(0.2))}, state);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    const std::vector<JointResultant> joints = joint_resultants(model, state);
    ASSERT_EQ(joints.size(), 1);
    const double exact = model.mass(1) * gravity / (joints[0].area * (1 - 2 * 0.2 * height / 2 / width));
    EXPECT_NEAR(joints[0].edge_stress, exact, 0.02 * exact);
}

// The same where it rocks, until the patch under the lifted side is out of reach.
TEST_P(Crushing, OneBedStaysOneWhenTheStoneRocks)
{
    const Model whole = pillar(GetParam(), 0);
    const Model glued = pillar(GetParam(), 0, 40, {{{-2, -2, -1}, {0.1, 2, 0}}, {{0.1, -2, -1}, {2, 2, 0}}});
    double largest_turn = 0;
    for (const double duration : {0.04, 0.06, 0.08}) {
        double stress[2] = {}, area[2] = {};
        for (const Model* model : {&whole, &glued}) {
            State state = initial_state(*model);
            const std::vector<Stage> stages = {static_stage(0.1), dynamic_stage(duration, 1e-3, leaning(0.7))};
            ASSERT_EQ(run_quietly(*model, stages, state).outcome, Outcome::completed);
            const std::vector<JointResultant> joints = joint_resultants(*model, state);
            ASSERT_EQ(joints.size(), 1);
            stress[model == &glued] = joints[0].edge_stress * joints[0].area / joints[0].normal_force;
            area[model == &glued] = joints[0].bearing_area;
            const Eigen::Matrix3d map = pose_of(model->kinematics, state, 1).map;
            largest_turn = std::max(largest_turn, std::asin(std::abs(map(0, 2))));
        }
        EXPECT_NEAR(stress[1], stress[0], 0.02 * stress[0]) << duration;
        EXPECT_NEAR(area[1], area[0], 0.02 * area[0]) << duration;
    }
    EXPECT_GT(largest_turn, 0.2 * degrees);
}

// Two treads of one stair, 2 cm apart in height, under a stone of two feet: each foot bears half the weight on its
// own tread, however thick the planar scene is.
TEST_P(Crushing, TreadsOfDifferentHeightsAreBedsOfTheirOwn)
{
    for (const double thickness : {1e-3, 1.0, 10.0}) {
        BlockMaterial material = stone();
        Model model = make_model(GetParam(), material, dry(40));
        model.thickness = thickness;
        hold(model, add_glued(model, "stair", {{{-2, -2, -1}, {0, 2, 0}}, {{0, -2, -1}, {2, 2, 0.02}}}));
        add_glued(model, "stone", {{{-0.5, -0.5, 0}, {0, 0.5, 1}}, {{0, -0.5, 0.02}, {0.5, 0.5, 1}}});
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {static_stage(0.1, leaning(0.2))}, state);
        ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        const std::vector<JointResultant> joints = joint_resultants(model, state);
        ASSERT_EQ(joints.size(), 1);
        // The tread on the side of the lean carries 1/2 + e / (half the width) of the weight on half the area, at
        // an eccentricity of its own.
        EXPECT_LT(joints[0].bearing_area, 0.5 * joints[0].area);
        EXPECT_GT(joints[0].edge_stress, 1.2 * joints[0].normal_force / joints[0].area) << thickness;
    }
}

// A stone of two feet whose soles are tilted by two degrees, on a flat floor: one bed, whichever block comes
// first.
TEST_P(Crushing, TheSameBedWhateverTheOrderOfTheBlocks)
{
    double stress[2] = {}, area[2] = {};
    for (const int stone_first : {0, 1}) {
        Model model = make_model(GetParam(), stone(), dry(40));
        const auto add_stone = [&] {
            const double rise = 0.5 * std::tan(2 * degrees);
            const auto foot = [&](double outer) {
                const double left = std::min(outer, 0.0), right = std::max(outer, 0.0);
                const double z0 = left < 0 ? rise : 0, z1 = right > 0 ? rise : 0;
                return make_convex_polyhedron(
                    {{left, -0.5, z0},
                     {right, -0.5, z1},
                     {right, -0.5, 1},
                     {left, -0.5, 1},
                     {left, 0.5, z0},
                     {right, 0.5, z1},
                     {right, 0.5, 1},
                     {left, 0.5, 1}},
                    {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}});
            };
            double depth = 0;
            if (is_planar(GetParam()))
                model.blocks.push_back(
                    make_planar_block("stone", 0, 0, {outline_of(foot(-0.5), depth), outline_of(foot(0.5), depth)},
                                      model.thickness));
            else
                model.blocks.push_back(make_block("stone", 0, 0, {foot(-0.5), foot(0.5)}));
        };
        if (stone_first) add_stone();
        hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
        if (!stone_first) add_stone();
        State state = initial_state(model);
        find_initial_contacts(model, state);
        auto press = [](auto& points) {
            for (auto& p : points) p.normal_force = p.gap < 1e-6 ? 1e3 : 10;
        };
        press(state.contacts.points);
        press(state.planar_contacts.points);
        const std::vector<JointResultant> joints = joint_resultants(model, state);
        ASSERT_EQ(joints.size(), 1);
        stress[stone_first] = joints[0].edge_stress;
        area[stone_first] = joints[0].bearing_area;
    }
    EXPECT_NEAR(stress[0], stress[1], 5e-3 * stress[0]);
    EXPECT_NEAR(area[0], area[1], 5e-3 * area[0]);
    EXPECT_GT(area[0], 0.9) << "both feet are one bed, pressed in the middle";
}

// A pillar in the corner of floor and wall, which are one block, pushed against the wall without friction: the
// floor carries its weight on the width, the wall half of it on twice the width.
TEST_P(Crushing, BedsInDifferentPlanesAreJudgedEach)
{
    const Model model = pillar(GetParam(), 0, 0, {{{-2, -2, -1}, {2, 2, 0}}, {{width / 2, -2, 0}, {2, 2, 3}}});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.1, leaning(0.5))}, state);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    const std::vector<JointResultant> joints = joint_resultants(model, state);
    ASSERT_EQ(joints.size(), 1);
    const double exact = model.mass(1) * gravity / (joints[0].area * width / (width + height));
    EXPECT_NEAR(joints[0].edge_stress, exact, 0.02 * exact);
}

// A square bed has no principal axes of its own: its sides count, however it is turned in plan.
TEST(SquareBed, IsJudgedAlongItsSides)
{
    for (const double turn : {0.0, 0.3, 45 * degrees, 1.1}) {
        Model model = make_model(Kinematics::spatial_rigid, stone(), dry(40));
        hold(model, add_box(model, "base", {-3, -3, -1}, {3, 3, 0}));
        add_box(model, "pillar", {-width / 2, -width / 2, 0}, {width / 2, width / 2, height});
        State state = initial_state(model);
        const Eigen::Matrix3d rotation = turned(turn, Eigen::Vector3d::UnitZ());
        set_pose(model, state, 1, {0, 0, height / 2}, rotation);
        const Eigen::Vector3d lean = rotation * leaning(0.35);
        begin_stage(model, 0, state);
        const RunReport report = run_quietly(model, {static_stage(0.1, lean)}, state);
        ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        const std::vector<JointResultant> joints = joint_resultants(model, state);
        ASSERT_EQ(joints.size(), 1);
        EXPECT_NEAR(joints[0].bearing_area, width * (width - 2 * 0.35 * height / 2), 0.02) << turn;
    }
}

// A stone that rocks has its resultant on the very edge: it bears on a tenth of the joint, and light stones crush
// none.
TEST_P(Crushing, ARockingStoneBearsOnATenthOfItsJoint)
{
    const double weight_stress = stone().density * gravity * height;
    const Model model = pillar(GetParam(), 30 * weight_stress);
    State state = initial_state(model);
    const Eigen::Vector3d tipping = leaning(1.2 * width / height);
    const RunReport report = run_quietly(model, {static_stage(0.1), dynamic_stage(0.3, 1e-3, tipping)}, state);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    const std::vector<JointResultant> joints = joint_resultants(model, state);
    ASSERT_EQ(joints.size(), 1);
    ASSERT_GT(joints[0].widest_gap, 1e-3);
    ASSERT_GT(joints[0].normal_force, 0);
    const double exact = 10 * joints[0].normal_force / joints[0].area;
    EXPECT_NEAR(joints[0].edge_stress, exact, 1e-6 * exact);
    EXPECT_TRUE(report.crushed.empty()) << ::testing::PrintToString(crushed_warning(report));
}

// The same on its very corner: a tenth of the bed in all, not a tenth of each side.
TEST(RockingStone, BearsOnATenthOfItsJointAtACornerToo)
{
    for (const Kinematics kinematics : {Kinematics::spatial_rigid, Kinematics::spatial_deformable}) {
        const Model model = pillar(kinematics, 0);
        State state = initial_state(model);
        Eigen::Vector3d tipping = leaning(1.2 * width / height);
        tipping.y() = tipping.x();
        const RunReport report = run_quietly(model, {static_stage(0.1), dynamic_stage(0.3, 1e-3, tipping)}, state);
        ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        const std::vector<JointResultant> joints = joint_resultants(model, state);
        ASSERT_EQ(joints.size(), 1);
        const Eigen::Vector3d off = joints[0].pressure_centre - joints[0].centre;
        ASSERT_GT(off.head<2>().cwiseAbs().minCoeff(), 0.49 * width) << "it stands on a corner";
        EXPECT_NEAR(joints[0].bearing_area, 0.1 * joints[0].area, 1e-6);
    }
}

// The toe is a block of the strength that is centred under the resultant: the most that it carries is N = strength
// x width x 2 e, e the distance of the resultant from the edge.
TEST_P(Crushing, AToeCrushesWhereNoStressBlockCarriesItsForce)
{
    for (const double slope : {0.1, 0.3, 0.42}) {
        const double to_edge = width / 2 - slope * height / 2;
        const double force = stone().density * gravity * width * width * height;  // N, per m of depth if planar
        const double strength = force / (width * 2 * to_edge);
        for (const double share : {0.97, 1.03}) {
            const Model model = pillar(GetParam(), share * strength);
            State state = initial_state(model);
            const RunReport report = run_quietly(model, {static_stage(0.1, leaning(slope))}, state);
            ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
            EXPECT_EQ(report.crushed.size(), share < 1 ? 1 : 0) << slope;
            EXPECT_EQ(crushed_warning(report).has_value(), share < 1) << slope;
        }
    }
}

// Eight drums that rock, 0.2 MPa in the lowest joint and 5 MPa of strength: corners of a tenth by a tenth of the
// joint, by which they were judged before, would have been crushed many times over.
TEST(RockingTower, OfModerateStressGivesNoAlarmAndOneOfHighStressDoes)
{
    constexpr double strength = 5e6, side = 1, drum = 1;
    for (const double share : {1.0, 0.04}) {
        BlockMaterial material = stone();
        material.compressive_strength = share * strength;
        JointMaterial joint = dry(40);
        joint.stiffness = {ContactStiffness::Kind::per_area, 3e11};
        Model model = make_model(Kinematics::spatial_rigid, material, joint);
        hold(model, add_box(model, "base", {-3, -3, -1}, {3, 3, 0}));
        for (int k = 0; k < 8; ++k)
            add_box(model, "drum", {-side / 2, -side / 2, k * drum}, {side / 2, side / 2, (k + 1) * drum});
        Stage shaken = shaking(1.5, 2e-3);
        shaken.control.integrator = Integrator::energy_decaying;
        State state = initial_state(model);
        double corner_stress = 0, opening = 0;
        RunObserver observer;
        observer.step = [&](const State& now, const StepReport&, const RunReport&) {
            for (const JointResultant& each : joint_resultants(model, now)) {
                const Eigen::Vector3d off = (each.pressure_centre - each.centre).cwiseAbs() * 2 / side;
                opening = std::max(opening, each.widest_gap);
                if (off.x() > 0.9 && off.y() > 0.9)
                    corner_stress = std::max(corner_stress, each.normal_force / (0.01 * each.area));
            }
        };
        const RunReport report = run(model, {static_stage(0.1), shaken}, state, observer);
        ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        EXPECT_GT(opening, 0.005) << "it rocks";
        EXPECT_GT(corner_stress, strength);
        EXPECT_EQ(crushed_warning(report).has_value(), share < 1) << report.crushed.size();
    }
}

// A joint that presses with three times its strength while `pressed` is true, in steps of 2 ms.
TEST(BriefCrushing, OfAMomentIsCountedAndNoAlarm)
{
    Model model = pillar(Kinematics::spatial_rigid, 1e6);
    State state = initial_state(model);
    find_initial_contacts(model, state);
    RunReport report;
    const auto step = [&](bool pressed) {
        for (ContactPoint& point : state.contacts.points) point.normal_force = (pressed ? 3e6 : 1e5) * point.area;
        state.time += 2e-3;
        note_crushing(model, state, 2e-3, report);
    };
    step(false);
    EXPECT_TRUE(report.crushed.empty());
    for (int i = 0; i < 10; ++i) step(true);
    step(false);
    for (int i = 0; i < 9; ++i) step(true);
    ASSERT_EQ(report.crushed.size(), 1);
    EXPECT_NEAR(report.crushed[0].first_time, 4e-3, 1e-12);
    EXPECT_NEAR(report.crushed[0].worst_stress, 3e6, 1);
    EXPECT_NEAR(report.crushed[0].duration, 0.038, 1e-12);
    EXPECT_NEAR(report.crushed[0].longest, 0.02, 1e-12);
    EXPECT_FALSE(crushed_warning(report)) << "as long as an impact, twice";
    step(true);
    step(true);
    ASSERT_TRUE(crushed_warning(report));
    EXPECT_NEAR(value_of(*crushed_warning(report), "duration_s"), 0.042, 1e-12);
    EXPECT_NEAR(value_of(*crushed_warning(report), "stress_to_strength"), 3, 1e-6);
    report.crushed.push_back({0, 1, 1e6, 0, 0, 9e6, 0.01, 0.01, 0, false});
    EXPECT_EQ(value_of(*crushed_warning(report), "joints"), 1);
    EXPECT_EQ(value_of(*crushed_warning(report), "brief_joints"), 1);
    EXPECT_NEAR(value_of(*crushed_warning(report), "stress_to_strength"), 3, 1e-6) << "of the lasting one";
    note_crushing(model, state, 0, report);
    EXPECT_TRUE(report.crushed[0].at_rest);
}

// Two edges that cross have a contact of no area that could be judged.
TEST(EdgeOnEdge, HasNoStressToJudge)
{
    BedPatch crossing;
    crossing.normal = Eigen::Vector3d::UnitZ();
    crossing.edge_edge = true;
    crossing.points.push_back({{0, 0, 0}, 0.01, 1e6});
    EXPECT_EQ(hardest_bearing({crossing}, 1).stress, 0);
}

TEST_P(Crushing, IsToldPerJointWithItsTime)
{
    const double weight_stress = stone().density * gravity * height;
    for (const double share : {0.9, 1.1}) {
        const Model model = pillar(GetParam(), share * weight_stress / (1 - 2 * 0.2));
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {static_stage(0.1, leaning(0.2))}, state);
        ASSERT_EQ(report.crushed.size(), share < 1 ? 1 : 0) << ::testing::PrintToString(report.diagnosis);
        if (share > 1) continue;
        EXPECT_EQ(report.crushed[0].block_b, 1);
        EXPECT_EQ(report.crushed[0].first_time, 0) << "static steps take no time";
        EXPECT_NEAR(report.crushed[0].worst_stress, report.crushed[0].strength / share, 0.05 * weight_stress);
        ASSERT_EQ(report.warnings.size(), 1);
        EXPECT_EQ(report.warnings[0].kind, DiagnosisKind::crushed_joints) << report.warnings[0];
        EXPECT_EQ(report.warnings[0].blocks, (std::vector{report.crushed[0].block_a, report.crushed[0].block_b}));
        EXPECT_EQ(value_of(report.warnings[0], "joints"), 1);
        EXPECT_TRUE(report.crushed[0].at_rest);
        EXPECT_EQ(report.crushed[0].duration, 0);
        EXPECT_NEAR(value_of(report.warnings[0], "stress_to_strength"), 1 / share, 0.05 / share);
    }
}

TEST_P(Crushing, IsJudgedByTheWeakerStoneAndOnlyIfAsked)
{
    Model model = pillar(GetParam(), 0);
    EXPECT_FALSE(has_compressive_strength(model));
    model.materials.push_back(stone());
    model.materials.back().compressive_strength = 1;
    model.blocks[1].material = 1;
    EXPECT_TRUE(has_compressive_strength(model));
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.1)}, state);
    ASSERT_EQ(report.crushed.size(), 1);
    EXPECT_EQ(report.crushed[0].strength, 1);
}

}  // namespace voussoir::testing
