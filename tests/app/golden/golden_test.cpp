// The golden scenes do what they are there for, and a hash moves when the engine does something else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/golden/hashes.h"
#include "libdda/run/run.h"

namespace voussoir::golden
{
namespace
{

/// What a scene went through, seen step by step.
struct Course {
    RunReport report;
    double largest_turn = 0;  // rad, of a block
    bool edges_met = false, bonds_broke = false, something_slid = false, something_stuck = false;
    bool opened = false;  // a corner of a contact that carries at others
};

template <int D>
void watch(const ContactSetIn<D>& contacts, std::size_t& bonds, Course& course)
{
    std::size_t intact = 0;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        intact += patch.intact ? 1 : 0;
        course.edges_met = course.edges_met || patch.edge_edge;
        int open = 0;
        for (int i = 0; i < patch.point_count; ++i) {
            const ContactStatus status = contacts.points[patch.first_point + i].status;
            open += status == ContactStatus::open ? 1 : 0;
            course.something_slid = course.something_slid || status == ContactStatus::sliding;
            course.something_stuck = course.something_stuck || status == ContactStatus::locked;
        }
        course.opened = course.opened || (open > 0 && open < patch.point_count);
    }
    course.bonds_broke = course.bonds_broke || intact < bonds;
    bonds = intact;
}

Course course_of(const app::golden::Scene& scene)
{
    Course course;
    std::size_t bonds = 0;
    RunObserver observer;
    observer.step = [&](const State& state, const StepReport&, const RunReport&) {
        if (is_planar(scene.model.kinematics))
            watch(state.planar_contacts, bonds, course);
        else
            watch(state.contacts, bonds, course);
        for (std::size_t b = 0; b < scene.model.blocks.size(); ++b) {
            const Eigen::Matrix3d map = pose_of(scene.model.kinematics, state, static_cast<int>(b)).map;
            course.largest_turn = std::max(course.largest_turn, std::atan2(map(2, 0), map(0, 0)));
        }
    };
    State state = scene.state;
    course.report = run(scene.model, scene.stages, state, observer);
    return course;
}

class EveryScene : public ::testing::TestWithParam<app::golden::NamedScene>
{
};
INSTANTIATE_TEST_SUITE_P(Golden, EveryScene, ::testing::ValuesIn(app::golden::scenes()), [](const auto& info) {
    std::string name = info.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ' ' || c == ','; }, '_');
    return name;
});

TEST_P(EveryScene, ComesToItsEndWithContactsAndWorkDone)
{
    app::golden::Scene scene = GetParam().make();
    State end;
    const RunReport report = app::golden::run_scene(scene, end);
    EXPECT_NE(report.outcome, Outcome::gave_up)
        << (report.diagnosis ? ::testing::PrintToString(*report.diagnosis) : "");
    EXPECT_GE(report.steps, 10);
    EXPECT_GT(report.open_close_iterations, report.steps);
    EXPECT_LT(report.energy.relative_residual(), 0.01);
    EXPECT_GT(std::abs(report.energy.input()) + report.energy.peak_stored, 0);
}

// In every hash, that of the state and that of the report.
TEST_P(EveryScene, HashMovesWithTheLastBitOfADensity)
{
    app::golden::Scene scene = GetParam().make();
    State end, other;
    const RunReport report = app::golden::run_scene(scene, end);
    scene.model.materials[0].density = std::nextafter(scene.model.materials[0].density, 1e9);
    const RunReport other_report = app::golden::run_scene(scene, other);
    EXPECT_NE(voussoir::hash_of(other), voussoir::hash_of(end));
    EXPECT_NE(app::golden::hash_of(other_report), app::golden::hash_of(report));
}

/// All scenes of a name, in whatever unknowns. @returns how many
template <typename Expectation>
int for_scenes(const std::string& name, const Expectation& expect)
{
    int count = 0;
    for (const app::golden::NamedScene& each : app::golden::scenes()) {
        if (each.name.rfind(name + ",", 0) != 0) continue;
        SCOPED_TRACE(each.name);
        expect(course_of(each.make()));
        ++count;
    }
    return count;
}

// Those of space converge within their two iterations; those in the plane do not always.
TEST(GoldenScenes, KnockAndCutSteps)
{
    int with_cuts = 0;
    EXPECT_EQ(for_scenes("knocks",
                         [&](const Course& course) {
                             with_cuts += course.report.step_cuts > 0;
                             EXPECT_GT(course.report.divided_steps, 0);
                             EXPECT_TRUE(course.something_slid && course.something_stuck && course.opened);
                         }),
              4);
    EXPECT_GE(with_cuts, 2);
}

TEST(GoldenScenes, RockAfterTheySettled)
{
    EXPECT_EQ(for_scenes("column",
                         [](const Course& course) {
                             EXPECT_GT(course.largest_turn, 0.02);
                             EXPECT_GT(course.report.energy.damping_static, 0);
                             EXPECT_GT(course.report.energy.foundation_work, 0);
                             EXPECT_GT(course.report.energy.friction, 0);
                             EXPECT_GT(course.report.energy.algorithmic, 0);
                             EXPECT_TRUE(course.opened);
                         }),
              4);
}

TEST(GoldenScenes, BreakAreCrushedAndDamped)
{
    EXPECT_EQ(for_scenes("mortar",
                         [](const Course& course) {
                             EXPECT_TRUE(course.bonds_broke);
                             EXPECT_GT(course.report.energy.fracture, 0);
                             EXPECT_GT(course.report.energy.damping_contact, 0);
                             EXPECT_NE(course.report.energy.damping_kinetic, 0);
                             EXPECT_NE(course.report.energy.load_work, 0);
                             EXPECT_FALSE(course.report.crushed.empty());
                         }),
              4);
}

TEST(GoldenScenes, AreSolvedByBothSolvers)
{
    EXPECT_EQ(for_scenes("column by cholmod",
                         [](const Course& course) {
                             // Only the whole tangent, which is not symmetric, is iterated for.
                             EXPECT_LT(course.report.linear_iterations, course.report.factorisations);
                         }),
              2);
    EXPECT_EQ(for_scenes("column by conjugate gradients",
                         [](const Course& course) {
                             EXPECT_GE(course.report.linear_iterations, course.report.factorisations);
                         }),
              2);
}

TEST(GoldenScenes, OpenInSoftJoints)
{
    EXPECT_EQ(for_scenes("opening",
                         [](const Course& course) {
                             EXPECT_TRUE(course.opened && course.something_stuck);
                             EXPECT_NE(course.report.energy.redetection, 0);
                         }),
              4);
}

TEST(GoldenScenes, GoByThePublishedIteration)
{
    EXPECT_EQ(for_scenes("published",
                         [](const Course& course) {
                             EXPECT_GT(course.report.step_cuts, 0);
                             EXPECT_NE(course.report.energy.damping_kinetic, 0);
                             EXPECT_TRUE(course.something_slid && course.something_stuck && course.opened);
                         }),
              2);
}

TEST(GoldenScenes, TumbleOverEdgesAndFall)
{
    EXPECT_EQ(for_scenes("tumbling", [](const Course& course) { EXPECT_TRUE(course.edges_met); }), 2);
    EXPECT_EQ(for_scenes("ledge",
                         [](const Course& course) {
                             EXPECT_EQ(course.report.outcome, Outcome::collapsed);
                             EXPECT_EQ(course.report.fallen.size(), 1U);
                         }),
              2);
}

// The loops of the wall run on two threads; on one they must give the same bits.
TEST(GoldenScenes, DoNotDependOnThreads)
{
    for (const app::golden::NamedScene& each : app::golden::scenes()) {
        if (each.name != "wall, spatial rigid") continue;
        app::golden::Scene scene = each.make();
        State two, one;
        EXPECT_EQ(scene.stages[0].control.threads, 2);
        app::golden::run_scene(scene, two);
        scene.stages[0].control.threads = 1;
        app::golden::run_scene(scene, one);
        EXPECT_EQ(voussoir::hash_of(one), voussoir::hash_of(two));
        EXPECT_GT(two.contacts.patches.size(), 256U) << "from where on the engine uses threads";
        return;
    }
    FAIL() << "no wall";
}

TEST(Behaviour, IsOfAllHashesAndNames)
{
    const std::vector<app::golden::SceneHashes> all{{"a", 1, 2}, {"b", 3, 4}};
    EXPECT_EQ(app::golden::behaviour(all).size(), 12U);
    EXPECT_EQ(app::golden::behaviour(all).find_first_not_of("0123456789abcdef"), std::string::npos);
    for (const std::vector<app::golden::SceneHashes>& other : {std::vector<app::golden::SceneHashes>{{"a", 1, 2}},
                                                               {{"a", 1, 2}, {"c", 3, 4}},
                                                               {{"a", 1, 2}, {"b", 4, 4}},
                                                               {{"a", 1, 2}, {"b", 3, 5}},
                                                               {{"b", 3, 4}, {"a", 1, 2}}})
        EXPECT_NE(app::golden::behaviour(other), app::golden::behaviour(all));
}

}  // namespace
}  // namespace voussoir::golden
