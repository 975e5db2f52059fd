// A run that goes wrong stops, names the blocks, and keeps the state before.
#include "libdda/analysis/diagnosis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "libdda/analysis/overlaps.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class Diagnosing : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Diagnosing, every_kinematics(), test_name);

/// Of that kind, and whole.
void expect_kind(const std::optional<Diagnosis>& diagnosis, DiagnosisKind kind)
{
    ASSERT_TRUE(diagnosis) << "nothing is said of " << form_of(kind).name;
    EXPECT_EQ(form_of(diagnosis->kind).name, form_of(kind).name) << *diagnosis;
    EXPECT_TRUE(is_whole(*diagnosis)) << *diagnosis;
}

}  // namespace

TEST_P(Diagnosing, WidthsAreThoseOfTheThinnestDirection)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "slab", {-5, -4, 0}, {5, 4, 0.1});
    add_box(model, "column", {0, 0, 0}, {0.3, 7, 9});
    const std::vector<double> widths = least_widths(model);
    EXPECT_NEAR(widths[0], 0.1, 1e-12);
    EXPECT_NEAR(widths[1], 0.3, 1e-12);
}

// A contact so soft that the stone would sink into its base: said, and not computed on.
TEST_P(Diagnosing, OfAContactTooSoftForItsLoad)
{
    JointMaterial joint = dry(30);
    joint.stiffness = {ContactStiffness::Kind::per_area, 1e5};  // sinks in by 2500 g 0.3 / 1e5 = 74 mm
    Model model = make_model(GetParam(), stone(), joint);
    hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.01)}, state);
    EXPECT_EQ(report.outcome, Outcome::gave_up);
    expect_kind(report.diagnosis, DiagnosisKind::deep_overlap);
    EXPECT_EQ(report.diagnosis->blocks, (std::vector{1, 0}));
    EXPECT_EQ(report.diagnosis->stage, 0);
    EXPECT_GT(value_of(*report.diagnosis, "depth_m"), 0.03);
    EXPECT_NEAR(value_of(*report.diagnosis, "share"), value_of(*report.diagnosis, "depth_m") / 0.3, 1e-9);
    // The state before the trouble: not yet deeper than the limit.
    EXPECT_GT(pose_of(model.kinematics, state, 1).centroid.z(), 0.15 - 0.03);

    // The remedy it names is one.
    joint.stiffness.value *= 10;
    model.joints[0] = joint;
    state = initial_state(model);
    const RunReport stiffer = run_quietly(model, {static_stage(0.01)}, state);
    EXPECT_EQ(stiffer.outcome, Outcome::completed);
    // At 7.4 mm of 300 it is still part of the answer, and the run says so; ten times stiffer it is not. On its
    // way there the stone swings, as under a sudden load, through up to twice the depth.
    const double depth = 2500 * gravity * 0.3 / 1e6;
    EXPECT_NEAR(0.15 - pose_of(model.kinematics, state, 1).centroid.z(), depth, 1e-3 * depth);
    EXPECT_GE(stiffer.deepest.depth, 0.999 * depth);
    EXPECT_LE(stiffer.deepest.depth, 2 * depth);
    ASSERT_EQ(stiffer.warnings.size(), 1u);
    expect_kind(stiffer.warnings[0], DiagnosisKind::overlap);
    EXPECT_EQ(stiffer.warnings[0].blocks, (std::vector{1, 0}));
    EXPECT_EQ(value_of(stiffer.warnings[0], "depth_m"), stiffer.deepest.depth);
    EXPECT_EQ(value_of(stiffer.warnings[0], "forgiven_m"), 0);
    joint.stiffness.value *= 25;
    model.joints[0] = joint;
    state = initial_state(model);
    EXPECT_TRUE(run_quietly(model, {static_stage(0.01)}, state).warnings.empty());
}

// A stone that stands on a toe of 10 mm and sinks into a soft joint: a shift by the toe's width would not part the
// two, and the run must stop as for any other.
TEST_P(Diagnosing, OfANarrowToeThatSinks)
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
    expect_kind(report.diagnosis, DiagnosisKind::deep_overlap);
    EXPECT_EQ(report.diagnosis->blocks, (std::vector{1, 0}));
    EXPECT_EQ(value_of(*report.diagnosis, "overlap_time_s"), 0);
    EXPECT_EQ(value_of(*report.diagnosis, "forgiven_m"), 0);
}

// How much of an overlap contacts were forgiven is told: a stiffer contact is no remedy for it.
TEST_P(Diagnosing, OfAnOverlapThatWasForgiven)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "one", {0, 0, 0}, {1, 1, 1});
    add_box(model, "another", {0, 0, 0.8}, {1, 1, 1.8});
    const State state = initial_state(model);
    RunReport report;
    report.deepest = {0.2, 0.3, 0.15, 3, 0, 1};
    const std::optional<Diagnosis> wrong = diagnose(model, state, report), warning = overlap_warning(report);
    expect_kind(wrong, DiagnosisKind::deep_overlap);
    expect_kind(warning, DiagnosisKind::overlap);
    for (const Diagnosis& diagnosis : {*wrong, *warning}) {
        EXPECT_EQ(diagnosis.blocks, (std::vector{0, 1}));
        EXPECT_EQ(value_of(diagnosis, "share"), 0.2);
        EXPECT_EQ(value_of(diagnosis, "depth_m"), 0.3);
        EXPECT_EQ(value_of(diagnosis, "forgiven_m"), 0.15);
        EXPECT_EQ(value_of(diagnosis, "overlap_time_s"), 3);
    }
}

TEST_P(Diagnosing, OfEnergyThatNothingAccountsFor)
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
    expect_kind(energy_warning(report.energy), DiagnosisKind::energy_unaccounted);
    EXPECT_DOUBLE_EQ(value_of(*energy_warning(report.energy), "share"), 5.0 / 90);
    report.energy.kinetic = 150;
    const std::optional<Diagnosis> appeared = diagnose(model, state, report);
    expect_kind(appeared, DiagnosisKind::energy_from_nowhere);
    EXPECT_EQ(appeared->blocks, std::vector{0});
    EXPECT_DOUBLE_EQ(value_of(*appeared, "speed_m_s"), 3);
    EXPECT_DOUBLE_EQ(value_of(*appeared, "share"), 50.0 / 90);
    report.energy.kinetic = 50;
    expect_kind(diagnose(model, state, report), DiagnosisKind::energy_vanished);
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
    expect_kind(energy_warning(energy), DiagnosisKind::energy_given);
    EXPECT_DOUBLE_EQ(value_of(*energy_warning(energy), "share"), 0.05);
    energy.redetection = 5;  // what contacts took later is no excuse
    energy.kinetic = 90;
    expect_kind(energy_warning(energy), DiagnosisKind::energy_given);
    EXPECT_DOUBLE_EQ(value_of(*energy_warning(energy), "share"), 0.05);
    energy.peak_given = 0;  // contacts that lose energy are a loss like others
    EXPECT_FALSE(energy_warning(energy));
}

// Ground that starts or stops dead strikes the structure: a stage that ends while it moves, and one that does not
// start from rest. Only held directions count, and a smooth start is none.
TEST_P(Diagnosing, OfGroundThatJumpsBetweenTwoStages)
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
    const std::vector<Diagnosis> stopped = warnings_of(pushed, 2);
    ASSERT_EQ(stopped.size(), 1);
    expect_kind(stopped[0], DiagnosisKind::ground_jump);
    EXPECT_EQ(stopped[0].stage, 1);
    EXPECT_EQ(stopped[0].blocks, std::vector{0});
    EXPECT_NEAR(value_of(stopped[0], "velocity_jump_m_s"), 0.125, 1e-12);
    const std::vector<Diagnosis> started = warnings_of(jerked, 0);
    ASSERT_EQ(started.size(), 1);
    EXPECT_EQ(started[0].stage, 0);
    EXPECT_NEAR(value_of(started[0], "velocity_jump_m_s"), 0.02, 1e-12);
    model.foundations[0].translation_held = {false, true, true};
    EXPECT_TRUE(warnings_of(jerked, 0).empty());
}

// Beyond a tenth it is no answer any more.
TEST_P(Diagnosing, OfEnergyThatContactsMade)
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
    const std::optional<Diagnosis> wrong = diagnose(model, initial_state(model), report);
    expect_kind(wrong, DiagnosisKind::energy_from_contacts);
    EXPECT_DOUBLE_EQ(value_of(*wrong, "share"), 0.15);
}

TEST_P(Diagnosing, OfPlacesThatAreNoNumbers)
{
    RunReport overflowed;
    overflowed.energy.contact = std::numeric_limits<double>::quiet_NaN();
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    EXPECT_FALSE(diagnose(model, state, {}));
    expect_kind(diagnose(model, state, overflowed), DiagnosisKind::energy_no_number);
    state.velocities[0] = std::numeric_limits<double>::quiet_NaN();
    expect_kind(diagnose(model, state, {}), DiagnosisKind::no_number);
}

// Each cause has its own kind, with the block that it was seen at.
TEST(DiagnosisOfAStep, NamesCauseAndBlock)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    add_box(model, "keystone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    StepReport step;
    step.worst_block = 0;
    step.cuts = 7;
    step.unbalanced = 0.25;
    const Stage stage = dynamic_stage(1, 1e-3);
    State state = initial_state(model);
    state.time = 0.5;
    const std::pair<Trouble, DiagnosisKind> cases[] = {
        {Trouble::inverted_block, DiagnosisKind::inverted_block},
        {Trouble::singular_system, DiagnosisKind::singular_system},
        {Trouble::inaccurate_solution, DiagnosisKind::inaccurate_solution},
        {Trouble::chatter, DiagnosisKind::chatter},
        {Trouble::none, DiagnosisKind::unbalanced}};
    for (const auto& [trouble, kind] : cases) {
        step.trouble = trouble;
        const Diagnosis diagnosis = explain(stage, state, step);
        expect_kind(diagnosis, kind);
        EXPECT_EQ(diagnosis.stage, 0);
        EXPECT_EQ(diagnosis.blocks, std::vector{0});
        EXPECT_EQ(value_of(diagnosis, "time_s"), 0.5);
        EXPECT_EQ(value_of(diagnosis, "cuts"), 7);
        EXPECT_EQ(value_of(diagnosis, "min_time_step_s"), stage.control.min_time_step);
        EXPECT_EQ(value_of(diagnosis, "unbalanced"), 0.25);
    }
    step.worst_block = -1;
    EXPECT_TRUE(explain(stage, state, step).blocks.empty());
}

TEST(DiagnosisForms, HaveNamesOfTheirOwnAndTellWhatIsWhole)
{
    std::set<std::string_view> names;
    for (int k = 0; k < diagnosis_kinds; ++k) {
        const auto kind = static_cast<DiagnosisKind>(k);
        const DiagnosisForm& form = form_of(kind);
        EXPECT_FALSE(form.name.empty()) << k;
        names.insert(form.name);
        Diagnosis diagnosis{kind, form.has_stage ? 0 : -1, {}, {}};
        diagnosis.blocks.assign(std::max(form.fewest_blocks, form.blocks), 0);
        diagnosis.values.assign(form.values.size(), 1.0);
        EXPECT_TRUE(is_whole(diagnosis)) << diagnosis;
        Diagnosis other = diagnosis;
        other.values.push_back(1);
        EXPECT_FALSE(is_whole(other)) << other;
        other = diagnosis;
        other.stage = form.has_stage ? -1 : 0;
        EXPECT_FALSE(is_whole(other)) << other;
        other = diagnosis;
        other.blocks.push_back(0);
        EXPECT_FALSE(is_whole(other)) << other;
    }
    EXPECT_EQ(names.size(), diagnosis_kinds);
    EXPECT_FALSE(is_whole({static_cast<DiagnosisKind>(diagnosis_kinds), 0, {}, {}}));
}

TEST(DiagnosisForms, AreWrittenOutForLogs)
{
    std::ostringstream text;
    text << Diagnosis{DiagnosisKind::overlap, -1, {4, 2}, {0.02, 0.05, 0, 1.5, 0.01}};
    EXPECT_EQ(text.str(),
              "overlap: blocks 4 2, depth_m 0.02, share 0.05, forgiven_m 0, overlap_time_s 1.5, drawn_m 0.01");
}

}  // namespace voussoir::testing
