// A run that goes wrong stops, names the blocks, and keeps the state before.
#include "libdda/analysis/diagnosis.h"

#include <gtest/gtest.h>

#include <limits>

#include "libdda/analysis/overlaps.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class Diagnosis : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Diagnosis, every_kinematics(), test_name);

void expect_in(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in \"" << text << "\"";
}

}  // namespace

TEST_P(Diagnosis, WidthsAreThoseOfTheThinnestDirection)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "slab", {-5, -4, 0}, {5, 4, 0.1});
    add_box(model, "column", {0, 0, 0}, {0.3, 7, 9});
    const std::vector<double> widths = least_widths(model);
    EXPECT_NEAR(widths[0], 0.1, 1e-12);
    EXPECT_NEAR(widths[1], 0.3, 1e-12);
}

// A contact so soft that the stone would sink into its base: said, and not computed on.
TEST_P(Diagnosis, OfAContactTooSoftForItsLoad)
{
    JointMaterial joint = dry(30);
    joint.stiffness = {ContactStiffness::Kind::per_area, 1e5};  // sinks in by 2500 g 0.3 / 1e5 = 74 mm
    Model model = make_model(GetParam(), stone(), joint);
    hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.01)}, state);
    EXPECT_EQ(report.outcome, Outcome::gave_up);
    expect_in(report.message, "'stone'");
    expect_in(report.message, "'base'");
    expect_in(report.message, "too soft");
    // The state before the trouble: not yet deeper than the limit.
    EXPECT_GT(pose_of(model.kinematics, state, 1).centroid.z(), 0.15 - 0.03);

    // The remedy it names is one.
    joint.stiffness.value *= 10;
    model.joints[0] = joint;
    state = initial_state(model);
    const RunReport stiffer = run_quietly(model, {static_stage(0.01)}, state);
    EXPECT_EQ(stiffer.outcome, Outcome::completed);
    // At 7.4 mm of 300 it is still part of the answer, and the run says so; ten times stiffer it is not.
    EXPECT_NEAR(stiffer.deepest.depth, 2500 * gravity * 0.3 / 1e6, 2e-4);
    ASSERT_EQ(stiffer.warnings.size(), 1u);
    expect_in(stiffer.warnings[0], "overlapped by");
    expect_in(stiffer.warnings[0], "contact_stiffness 25 times as large");
    joint.stiffness.value *= 25;
    model.joints[0] = joint;
    state = initial_state(model);
    EXPECT_TRUE(run_quietly(model, {static_stage(0.01)}, state).warnings.empty());
}

// A stone that stands on a toe of 10 mm and sinks into a soft joint: a shift by the toe's width would not part the
// two, and the run must stop as for any other.
TEST_P(Diagnosis, OfANarrowToeThatSinks)
{
    JointMaterial joint = dry(30);
    joint.stiffness = {ContactStiffness::Kind::per_area, 1e6};
    Model model = make_model(GetParam(), stone(), joint);
    hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    const ConvexPolyhedron wedge = make_convex_polyhedron(
        {{-0.005, -0.15, 0},
         {0.005, -0.15, 0},
         {0.15, -0.15, 0.3},
         {-0.15, -0.15, 0.3},
         {-0.005, 0.15, 0},
         {0.005, 0.15, 0},
         {0.15, 0.15, 0.3},
         {-0.15, 0.15, 0.3}},
        {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}});
    double depth = 0;
    if (is_planar(GetParam()))
        model.blocks.push_back(make_planar_block("wedge", 0, 0, {outline_of(wedge, depth)}, model.thickness));
    else
        model.blocks.push_back(make_block("wedge", 0, 0, {wedge}));
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.01)}, state);
    EXPECT_EQ(report.outcome, Outcome::gave_up);
    expect_in(report.message, "'wedge' and 'base' overlap");
    expect_in(report.message, "at t = 0 s");
    expect_in(report.message, "too soft");
}

// Where contacts were forgiven most of an overlap, a stiffer contact is no remedy.
TEST_P(Diagnosis, OfAnOverlapThatWasForgiven)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "one", {0, 0, 0}, {1, 1, 1});
    add_box(model, "another", {0, 0, 0.8}, {1, 1, 1.8});
    const State state = initial_state(model);
    RunReport report;
    report.deepest = {0.2, 0.2, 0.05, 3, 0, 1};
    expect_in(diagnose(model, state, report).value(), "too soft for its load or its impact; give the joint");
    expect_in(overlap_warning(model, report).value(), "t = 3 s: contacts so soft are part of the answer");
    report.deepest.forgiven = 0.15;
    for (const std::string& words :
         {diagnose(model, state, report).value(), overlap_warning(model, report).value()}) {
        expect_in(words, "by 0.2 m, 20 % of the thinner one's width, at t = 3 s: 0.15 m of it is without stress");
        expect_in(words, "try a smaller time_step");
        EXPECT_EQ(words.find("stiffness"), std::string::npos) << words;
    }
}

TEST_P(Diagnosis, OfEnergyThatNothingAccountsFor)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "comet", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    set_velocity(model, state, 0, {3, 0, 0});
    RunReport report;
    report.energy.kinetic = 100;
    report.energy.start_kinetic = report.energy.peak_stored = 90;
    report.energy.gravity_work = 10;
    EXPECT_FALSE(diagnose(model, state, report));
    EXPECT_FALSE(energy_warning(report.energy));
    report.energy.kinetic = 105;  // 5 of 90 from nowhere
    EXPECT_FALSE(diagnose(model, state, report));
    expect_in(energy_warning(report.energy).value(), "unaccounted");
    report.energy.kinetic = 150;
    expect_in(diagnose(model, state, report).value(), "appeared from nowhere; the fastest block is 'comet'");
    report.energy.kinetic = 50;
    expect_in(diagnose(model, state, report).value(), "vanished");
}

TEST(DiagnosisOfEnergy, ThatContactsFoundAnewGaveIsWorthAWarningThoughItIsAccountedFor)
{
    EnergyLedger energy;
    energy.start_kinetic = energy.peak_stored = 100;
    energy.kinetic = 100;
    energy.redetection = -0.5;
    energy.algorithmic = energy.peak_given = 0.5;  // takes it again
    EXPECT_FALSE(energy_warning(energy));
    energy.redetection = -5;
    energy.algorithmic = energy.peak_given = 5;
    EXPECT_EQ(energy.residual(), 0);
    expect_in(energy_warning(energy).value(), "5 % of the energy came from contacts");
    energy.redetection = 5;  // what contacts took later is no excuse
    energy.kinetic = 90;
    expect_in(energy_warning(energy).value(), "5 % of the energy came from contacts");
    energy.peak_given = 0;  // contacts that lose energy are a loss like others
    EXPECT_FALSE(energy_warning(energy));
}

// Ground that starts or stops dead strikes the structure: a stage that ends while it moves, and one that does not
// start from rest. Only held directions count, and a smooth start is none.
TEST_P(Diagnosis, OfGroundThatJumpsBetweenTwoStages)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    const auto pushed = std::make_shared<GroundMotion>(
        GroundMotion::from_acceleration({0.0, 1.0, 1.0, 1.0}, 0.05, "push"));  // 0.125 m/s at its end
    const auto jerked =
        std::make_shared<GroundMotion>(GroundMotion::from_velocity({0.02, 0.02, 0.02}, 0.05, "jerk"));
    const auto warnings_of = [&](std::shared_ptr<const GroundMotion> motion, int stages) {
        std::vector<Stage> all(stages, dynamic_stage(0.05, 0.01));
        all.insert(all.begin(), dynamic_stage(0.15, 0.01));
        if (motion) all[0].motions = {{0, 0, motion}};
        State state = initial_state(model);
        return run_quietly(model, all, state).warnings;
    };
    EXPECT_TRUE(warnings_of(nullptr, 1).empty());
    EXPECT_TRUE(warnings_of(pushed, 0).empty());
    const std::vector<std::string> stopped = warnings_of(pushed, 2);
    ASSERT_EQ(stopped.size(), 1);
    expect_in(stopped[0], "starts with a blow: the ground of block 'base' changes its velocity by 0.125 m/s");
    const std::vector<std::string> started = warnings_of(jerked, 0);
    ASSERT_EQ(started.size(), 1);
    expect_in(started[0], "by 0.02 m/s");
    model.foundations[0].translation_held = {false, true, true};
    EXPECT_TRUE(warnings_of(jerked, 0).empty());
}

// Beyond a tenth it is no answer any more.
TEST_P(Diagnosis, OfEnergyThatContactsMade)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    RunReport report;
    report.energy.start_kinetic = report.energy.peak_stored = report.energy.kinetic = 100;
    report.energy.redetection = -5;
    report.energy.algorithmic = report.energy.peak_given = 5;
    EXPECT_FALSE(diagnose(model, initial_state(model), report));
    report.energy.redetection = -15;
    report.energy.algorithmic = report.energy.peak_given = 15;
    EXPECT_EQ(report.energy.residual(), 0);
    expect_in(diagnose(model, initial_state(model), report).value(), "15 % of the energy came from contacts");
}

TEST_P(Diagnosis, OfPlacesThatAreNoNumbers)
{
    RunReport overflowed;
    overflowed.energy.contact = std::numeric_limits<double>::quiet_NaN();
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    EXPECT_FALSE(diagnose(model, state, {}));
    expect_in(diagnose(model, state, overflowed).value(), "an energy is no number");
    state.velocities[0] = std::numeric_limits<double>::quiet_NaN();
    expect_in(diagnose(model, state, {}).value(), "no number");
}

// Each cause has its own sentence, with the block and a remedy.
TEST(DiagnosisOfASteps, FailureNamesCauseBlockAndRemedy)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    add_box(model, "keystone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    StepReport step;
    step.worst_block = 0;
    const Stage stage = dynamic_stage(1, 1e-3);
    const std::pair<Trouble, const char*> cases[] = {{Trouble::inverted_block, "inside out"},
                                                     {Trouble::singular_system, "cannot be solved"},
                                                     {Trouble::inaccurate_solution, "rounding"},
                                                     {Trouble::chatter, "keep switching"}};
    for (const auto& [trouble, words] : cases) {
        step.trouble = trouble;
        const std::string message = explain(model, stage, initial_state(model), step);
        expect_in(message, "'keystone'");
        expect_in(message, words);
        EXPECT_TRUE(message.find("try") != std::string::npos || message.find("look at") != std::string::npos);
    }
}

}  // namespace voussoir::testing
