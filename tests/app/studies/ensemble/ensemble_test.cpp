// Statistics over members that differ by next to nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "app/reader/case_file.h"
#include "app/studies/converge/measured_run.h"
#include "app/studies/ensemble/report.h"
#include "libdda/errors.h"
#include "tests/app/studies/ensemble/scenes.h"
#include "tests/app/test_files.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();
const double unknown = std::nan("");

EnsembleStudy study_of(const std::string& text, const std::string& vary = testing::vary_friction,
                       const EnsembleChoices& choices = {})
{
    const TemporaryFolder folder;
    const Variation variation = read_variation(vary);
    return run_ensemble(read_members(folder.write("case.yaml", text), {}, variation, reader::case_reader),
                        variation, choices, {});
}

const MeasureStudy& measure(const EnsembleStudy& study, const std::string& part)
{
    for (const MeasureStudy& each : study.measures)
        if (each.measure.name.find(part) != std::string::npos) return each;
    throw std::runtime_error("no measure " + part);
}

void expect_refusal(const std::string& vary, const std::string& part)
{
    try {
        read_variation(vary);
        ADD_FAILURE() << vary << " is not refused";
    } catch (const InputError& error) {
        EXPECT_NE(to_sentence(error.faults[0]).find(part), std::string::npos) << to_sentence(error.faults[0]);
    }
}

}  // namespace

TEST(Ensemble, VariesListsAndMaps)
{
    const Variation variation =
        read_variation("foundation.motion.records=[a.at2,b.at2],[c.at2,d.at2],{x: 'e,f', y: 1}");
    EXPECT_EQ(variation.key, "foundation.motion.records");
    EXPECT_EQ(variation.values, (std::vector<std::string>{"[a.at2,b.at2]", "[c.at2,d.at2]", "{x: 'e,f', y: 1}"}));
}

TEST(EnsembleStatistics, MediansAndRanges)
{
    EXPECT_EQ(median_of({3, 1, 2}), 2);
    EXPECT_EQ(median_of({4, 1, 2, 3}), 2.5);
    EXPECT_EQ(median_of({1, infinite, infinite}), infinite);
    EXPECT_EQ(median_of({1, 2, infinite}), 2);
    EXPECT_TRUE(std::isnan(median_of({1, unknown, 2})));
    EXPECT_TRUE(std::isnan(median_of({})));
    EXPECT_EQ(range_of({3, 1, 2}), 2);
    EXPECT_EQ(range_of({infinite, infinite}), 0);
    EXPECT_EQ(range_of({1, infinite}), infinite);
    EXPECT_TRUE(std::isnan(range_of({1, unknown})));
}

TEST(EnsembleVariation, IsAKeyAndDifferentValues)
{
    const Variation variation = read_variation("blocks[0].house.imperfection.seed=1,2,3");
    EXPECT_EQ(variation.key, "blocks[0].house.imperfection.seed");
    EXPECT_EQ(variation.values, (std::vector<std::string>{"1", "2", "3"}));
    expect_refusal("seed", "names no key");
    expect_refusal("=1,2", "names no key");
    expect_refusal("seed=", "no value");
    EXPECT_EQ(read_variation("seed=1").values.size(), 1u);
    expect_refusal("seed=1,,2", "empty");
    expect_refusal("seed=1,2,1", "twice");
}

// Members that do not differ have no spread; then the tolerance decides, and at a step at which newmark damps the
// oscillator away it must say so.
TEST(Ensemble, TellsAStepThatIsSmallEnoughFromOneThatIsNot)
{
    const EnsembleStudy fine = study_of(testing::shaken_stone(testing::gentle_wave, "1 ms"));
    EXPECT_TRUE(fine.agrees()) << verdict_of(fine);
    EXPECT_EQ(measure(fine, "peak drift").ranges[1], 0);
    const EnsembleStudy coarse =
        study_of(testing::shaken_stone(testing::gentle_wave, "40 ms\n    integrator: newmark"));
    EXPECT_FALSE(measure(coarse, "peak drift").agrees);
    EXPECT_FALSE(coarse.agrees());
    EXPECT_NE(verdict_of(coarse).find("top: peak drift"), std::string::npos) << verdict_of(coarse);
}

// Pressed all the time, the oscillator's amplitude falls with its stiffness: of a slow wave, inversely.
TEST(Ensemble, ReportsTheStiffnessAsASensitivity)
{
    EnsembleChoices choices;
    choices.stiffness_factor = 8;
    const EnsembleStudy study =
        study_of(testing::shaken_stone(testing::gentle_wave, "1 ms"), testing::vary_friction, choices);
    ASSERT_EQ(study.settings.size(), 3u);
    const MeasureStudy& peak = measure(study, "peak drift");
    EXPECT_GT(peak.medians[0] / peak.medians[2], 5);
    EXPECT_LT(peak.medians[0] / peak.medians[2], 16);
    EXPECT_TRUE(study.agrees()) << "it is not judged";
    choices.stiffness_factor = 1;
    EXPECT_EQ(study_of(testing::shaken_stone(testing::gentle_wave, "1 ms"), testing::vary_friction, choices)
                  .settings.size(),
              2u);
}

// Half of what the weight does while the joint yields is taken from the block, 56 J: none of it in motion.
TEST(Ensemble, ComingToRestIsNoDampingOfTheMotion)
{
    const EnsembleStudy study = study_of(testing::shaken_stone(testing::gentle_wave, "1 ms"));
    EXPECT_EQ(study.runs[0][0].energy.damping, 0);
    EXPECT_GT(study.runs[0][0].energy.input, 0);
}

// A block that is lifted straight up opens its joint by what it rises.
TEST(Ensemble, CountsOpenJoints)
{
    const EnsembleStudy study = study_of(testing::shaken_stone(testing::lifting_wave, "1 ms"));
    EXPECT_EQ(study.runs[0][0].joints, 1);
    EXPECT_EQ(measure(study, "joints that were open").medians[0], 1);
    const double opening = measure(study, "largest opening").medians[0];
    EXPECT_GT(opening, 5);
    EXPECT_NEAR(opening, measure(study, "peak drift").medians[0], 0.1 * opening);
    EXPECT_EQ(
        measure(study_of(testing::shaken_stone(testing::gentle_wave, "1 ms")), "joints that were open").medians[0],
        0);
}

TEST(Ensemble, DoesNotDependOnHowManyRunsGoSideBySide)
{
    EnsembleChoices one, three;
    three.jobs = 3;
    const std::string text = testing::shaken_stone("x: {sine: {acceleration: 9 m/s2, frequency: 4 Hz}}", "2 ms");
    const EnsembleStudy a = study_of(text, testing::vary_friction, one),
                        b = study_of(text, testing::vary_friction, three);
    ASSERT_EQ(a.measures.size(), b.measures.size());
    for (std::size_t i = 0; i < a.measures.size(); ++i) EXPECT_EQ(a.measures[i].values, b.measures[i].values);
    EXPECT_GT(measure(a, "residual drift").ranges[0], 0) << "more friction, less sliding";
    EXPECT_LT(a.runs[0][0].energy.residual, 1e-3);
    EXPECT_GT(a.runs[0][0].energy.friction, 0.1);
}

TEST(Ensemble, ARunThatGivesUpLeavesNothingToJudge)
{
    std::string text = testing::shaken_stone(testing::lifting_wave, "1 ms");
    text.replace(text.find("type: static"), 12, "type: static, max_static_steps: 1");
    const EnsembleStudy study = study_of(text);
    EXPECT_FALSE(study.agrees());
    EXPECT_NE(verdict_of(study).find("failed to converge"), std::string::npos) << verdict_of(study);
    const nlohmann::json json = nlohmann::json::parse(ensemble_json(study));
    EXPECT_TRUE(json["measures"][0]["medians"][0].is_null());
}

// A wave that presses the stone more than 10 mm into its soft joint before it lifts it: what a run says of itself
// is not lost among the others.
TEST(Ensemble, PassesOnWhatItsRunsWarnOf)
{
    const EnsembleStudy study =
        study_of(testing::shaken_stone("z: {sine: {acceleration: -20 m/s2, frequency: 3 Hz}}", "1 ms"));
    const std::string page = ensemble_page(study, "", {}), table = ensemble_table(study);
    const nlohmann::json json = nlohmann::json::parse(ensemble_json(study));
    for (std::size_t i = 0; i < 3; ++i) {
        const MemberRun& run = study.runs[0][i];
        ASSERT_EQ(run.warnings.size(), 1u);
        EXPECT_NE(run.warnings[0].find("blocks 'stone' and 'floor' overlapped by"), std::string::npos);
        EXPECT_NE(page.find("- 1 ms, " + study.variation.values[i] + ": " + run.warnings[0] + "\n"),
                  std::string::npos);
        EXPECT_NE(table.find("warning: " + run.warnings[0]), std::string::npos);
        EXPECT_EQ(json["runs"][i]["warnings"], nlohmann::json{run.warnings[0]});
    }
    const EnsembleStudy quiet = study_of(testing::shaken_stone(testing::gentle_wave, "1 ms"));
    EXPECT_EQ(ensemble_page(quiet, "", {}).find("arning"), std::string::npos);
    EXPECT_EQ(ensemble_table(quiet).find("arning"), std::string::npos);
}

TEST(Ensemble, PassesOnWhatItsCaseWarnsOf)
{
    const TemporaryFolder folder;
    const Variation variation = read_variation(testing::vary_friction);
    std::vector<Case> members =
        read_members(folder.write("case.yaml", testing::shaken_stone(testing::gentle_wave, "1 ms")), {}, variation,
                     reader::case_reader);
    for (Case& member : members) member.warnings = {"arch.obj: a hole was closed"};
    const EnsembleStudy study = run_ensemble(members, variation, {}, {});
    EXPECT_NE(ensemble_page(study, "", {}).find("- arch.obj: a hole was closed\n"), std::string::npos);
    EXPECT_NE(ensemble_table(study).find("warning: arch.obj: a hole was closed\n"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(ensemble_json(study))["warnings"][0], "arch.obj: a hole was closed");
}

bool judged(std::vector<double> coarse, std::vector<double> fine, double tolerance = 0.1)
{
    MeasureStudy each;
    each.values = {std::move(coarse), std::move(fine)};
    judge(tolerance, each);
    return each.agrees;
}

// Many measures are judged at once: five members each must seldom be told apart where nothing but chance parts
// them, and mostly where three standard deviations do.
TEST(Ensemble, RarelyTellsOneDistributionApart)
{
    std::mt19937_64 draw(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same draws in every run
    const auto told_apart = [&](double shift) {
        constexpr int pairs = 20000;
        int count = 0;
        for (int i = 0; i < pairs; ++i) {
            std::normal_distribution<double> around(0, 1);
            std::vector<double> coarse(5), fine(5);
            for (double& value : coarse) value = shift + around(draw);
            for (double& value : fine) value = around(draw);
            count += !judged(coarse, fine, 0);
        }
        return static_cast<double>(count) / pairs;
    };
    EXPECT_NEAR(told_apart(0), 0.01, 0.003);
    EXPECT_NEAR(told_apart(3), 0.76, 0.02);
}

// The spread of members of which some collapsed is infinite: that is no licence.
TEST(Ensemble, ACollapseWidensNoTolerance)
{
    EXPECT_TRUE(judged({10, 11, 12}, {10, 11, 12}));
    EXPECT_TRUE(judged({10, 14, 15}, {10, 11, 15})) << "within the spread";
    EXPECT_TRUE(judged({10, 14, 18}, {10, 11, 11})) << "within the mean of both";
    EXPECT_FALSE(judged({16, 17, 18}, {10, 11, 15}));
    EXPECT_TRUE(judged({10, 12, infinite}, {10, 12.5, infinite})) << "within the tolerance";
    EXPECT_FALSE(judged({400, 500, 600}, {10, 12, infinite}));
    EXPECT_FALSE(judged({10, infinite, infinite}, {10, 12, infinite}));
    EXPECT_TRUE(judged({10, infinite, infinite}, {11, infinite, infinite}));
    EXPECT_FALSE(judged({10, 11, unknown}, {10, 11, 12}));
}

TEST(Ensemble, MembersThatCannotBeComparedAreRefused)
{
    const std::string text = testing::shaken_stone(testing::gentle_wave, "1 ms");
    EXPECT_THROW(study_of(text, "stages[1].time_step=1 ms,2 ms"), InputError);
    EXPECT_THROW(study_of(text, "stages[1].min_time_step=0.1 ms,0.9 ms"), InputError);
}

TEST(Ensemble, EndsWhenItIsToldTo)
{
    const TemporaryFolder folder;
    const Variation variation = read_variation(testing::vary_friction);
    const auto members =
        read_members(folder.write("case.yaml", testing::shaken_stone(testing::gentle_wave, "1 ms")), {}, variation,
                     reader::case_reader);
    int finished = 0;
    EnsembleWatch watch;
    watch.finished = [&](const MemberRun&, int, int) { ++finished; };
    watch.stop = [&] { return finished == 2; };
    EXPECT_THROW(run_ensemble(members, variation, {}, watch), converge::Interrupted);
    EXPECT_EQ(finished, 2);
}

}  // namespace voussoir::app::studies::ensemble
