// What a study comes to, from series whose limits are known.
#include "app/studies/converge/conclusion.h"

#include "app/studies/converge/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/studies/converge/report.h"

namespace voussoir::app::studies::converge
{
namespace
{

/// A row for each value; steps from 4 ms down by halves, or factors from 1 up by doubling. A run takes 1 s of CPU,
/// each finer one twice as much.
Series series_of(Varied varied, Integrator integrator, const std::vector<double>& values, double cpu = 1)
{
    Series series;
    series.varied = varied;
    series.integrator = integrator;
    std::vector<std::optional<Sample>> samples;
    double factor = varied == Varied::time_step ? 2 : 1;
    for (const double value : values) {
        SeriesRow row;
        row.setting = {integrator, varied == Varied::time_step ? factor : 1,
                       varied == Varied::stiffness ? factor : 1};
        row.time_step = 2e-3 * row.setting.step_factor;
        row.cost.cpu_dynamic = cpu;
        series.rows.push_back(row);
        samples.emplace_back(Sample::Constant(1, 1, value));
        factor *= varied == Varied::time_step ? 0.5 : 2;
        cpu *= 2;
    }
    judge(series, samples, 0, [](const Sample& sample) { return sample(0, 0); });
    return series;
}

/// A quantity 1 + c h with h in ms.
std::vector<double> first_order(double c)
{
    return {1 + 4 * c, 1 + 2 * c, 1 + c, 1 + c / 2, 1 + c / 4};
}

/// Of a case at 2 ms with newmark.
ConvergeStudy study_of(std::vector<QuantityStudy> quantities, double tolerance = 0.05)
{
    ConvergeStudy study;
    study.case_file = "arch.yaml";
    study.quantities = std::move(quantities);
    study.tolerance = tolerance;
    study.stages = {{1, "earthquake", 2e-3, 0, Integrator::newmark},
                    {2, "aftershock", 4e-3, 0, Integrator::newmark}};
    study.joints = {{"dry", 2, 30}};
    study.may_be_ensemble = true;
    return study;
}

bool says(const std::vector<std::string>& lines, const std::string& part)
{
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(part) != std::string::npos; });
}

constexpr Integrator newmark = Integrator::newmark, decaying = Integrator::energy_decaying;

TEST(Conclusion, IsTheCheapestThatMeetsTheToleranceAsLinesToPaste)
{
    // Errors of newmark: 20, 10, 5, 2.5, 1.25 % for 1, 2, 4, 8, 16 s; of energy_decaying a tenth of them for 3, 6,
    // ... s.
    const ConvergeStudy study = study_of({{"crown.d:peak",
                                           "m",
                                           {series_of(Varied::time_step, newmark, first_order(0.05)),
                                            series_of(Varied::time_step, decaying, first_order(0.005), 3)},
                                           ""}});
    const Conclusion conclusion = conclude(study);
    ASSERT_NE(conclusion.row, nullptr);
    EXPECT_TRUE(conclusion.meets);
    EXPECT_EQ(conclusion.row->setting, (ConvergeSetting{decaying, 2, 1})) << "3 s; newmark needs 0.5 ms and 8 s";
    EXPECT_EQ(
        conclusion.case_lines,
        (std::vector<std::string>{"# stages[1], 'earthquake'", "time_step: 4 ms", "integrator: energy_decaying",
                                  "# stages[2], 'aftershock'", "time_step: 8 ms", "integrator: energy_decaying"}));
    EXPECT_EQ(conclusion.set_options.front(), "stages[1].time_step=4 ms");
    EXPECT_EQ(conclusion.set_options.size(), 4);
    ASSERT_TRUE(conclusion.known[0].within);
    EXPECT_NEAR(*conclusion.known[0].within, 0.02, 0.002);
    EXPECT_TRUE(says(in_words(conclusion), "is the cheapest that meets it"));
    EXPECT_TRUE(says(in_words(conclusion), "crown.d:peak 1.02 m +- 2"));
    EXPECT_TRUE(says(conclusion.remarks, "newmark comes to the same"));
    EXPECT_EQ(share_in_words(6.22e-4), "0.0622 %") << "beside a value in deg a bare number would be degrees";

    ConvergeStudy strict = study;
    strict.tolerance = 1e-3;
    EXPECT_FALSE(conclude(strict).meets);
    EXPECT_EQ(conclude(strict).row->setting, (ConvergeSetting{decaying, 0.125, 1})) << "the best known";
    EXPECT_TRUE(says(in_words(conclude(strict)), "is the best of these"));
}

// Steps that follow their error change by the factor too.
TEST(Conclusion, ChangesTheStepErrorWithTheThirdPowerOfTheStep)
{
    ConvergeStudy study =
        study_of({{"crown.d:peak", "m", {series_of(Varied::time_step, newmark, first_order(0.005), 3)}, ""}});
    study.stages.front().step_error = 1e-5;
    const Conclusion conclusion = conclude(study);
    ASSERT_EQ(conclusion.row->setting.step_factor, 2);
    EXPECT_EQ(conclusion.case_lines,
              (std::vector<std::string>{"# stages[1], 'earthquake'", "time_step: 4 ms", "step_error: 8e-05 m",
                                        "# stages[2], 'aftershock'", "time_step: 8 ms"}));
}

// Of runs that take a millisecond chance decides which took longer: the coarser one is the cheaper.
TEST(Conclusion, DoesNotTellRunsOfAMillisecondApart)
{
    Series series = series_of(Varied::time_step, newmark, first_order(1e-4), 1.2e-3);
    series.rows[1].cost.cpu_dynamic = 0.9e-3;
    EXPECT_EQ(cheapest(series, 0.01), &series.rows[0]);
    EXPECT_EQ(conclude(study_of({{"crown.d:peak", "m", {series}, ""}})).row->setting.step_factor, 2);
    for (SeriesRow& row : series.rows) row.cost.cpu_dynamic *= 1000;
    EXPECT_EQ(cheapest(series, 0.01), &series.rows[1]);
}

TEST(Conclusion, OfTheCasesOwnSettingChangesNothing)
{
    const ConvergeStudy study =
        study_of({{"crown.d:peak", "m", {series_of(Varied::time_step, newmark, first_order(0.02))}, ""}});
    const Conclusion conclusion = conclude(study);
    EXPECT_EQ(conclusion.row->setting, (ConvergeSetting{newmark, 1, 1}));
    EXPECT_TRUE(conclusion.case_lines.empty());
    EXPECT_TRUE(says(in_words(conclusion), "nothing to change"));
}

// A peak that converges and an end that does not: the one is known, the other is left to an ensemble.
TEST(Conclusion, SaysWhatIsKnownAndWhatIsNot)
{
    const std::vector<double> scattered{0.9, 1.6, 0.7, 1.3, 0.8};
    const ConvergeStudy study =
        study_of({{"crown.d:peak", "m", {series_of(Varied::time_step, newmark, first_order(0.02))}, ""},
                  {"crown.d:end", "m", {series_of(Varied::time_step, newmark, scattered)}, ""}});
    const Conclusion conclusion = conclude(study);
    EXPECT_FALSE(conclusion.meets);
    EXPECT_EQ(conclusion.row->setting, (ConvergeSetting{newmark, 1, 1}))
        << "the cheapest that meets it in the peak";
    EXPECT_TRUE(conclusion.known[0].within);
    EXPECT_FALSE(conclusion.known[1].within);
    EXPECT_TRUE(says(in_words(conclusion), "crown.d:end not known: 1.6 m in this run, uncertain by"));
    EXPECT_TRUE(says(conclusion.remarks,
                     "voussoir ensemble arch.yaml --vary \"joints.dry.friction=29.94 deg,29.97 deg,30 deg,30.03 "
                     "deg,30.06 deg\""));
}

TEST(Conclusion, LeavesOutWhatIsNotCompared)
{
    Series resting = series_of(Varied::time_step, newmark, {0, 0, 0, 0, 0});
    for (SeriesRow& row : resting.rows) row.value = row.error = row.difference = std::nullopt;
    resting.reference = std::nullopt;
    resting.no_order = "it does not move along y";
    const ConvergeStudy study =
        study_of({{"crown.dy:peak", "m", {resting}, ""},
                  {"crown.dx:peak", "m", {series_of(Varied::time_step, newmark, first_order(0.02))}, ""}});
    const Conclusion conclusion = conclude(study);
    EXPECT_TRUE(conclusion.meets);
    EXPECT_TRUE(says(in_words(conclusion), "crown.dy:peak: not compared, it does not move along y"));
    EXPECT_FALSE(says(conclusion.remarks, "ensemble"));

    const Conclusion of_nothing = conclude(study_of({{"crown.dy:peak", "m", {resting}, ""}}));
    EXPECT_EQ(of_nothing.row, nullptr);
    EXPECT_TRUE(says(in_words(of_nothing), "no run gave a value"));
}

// 1 + 0.2 / k tends to 1: from x 4 on it is within 5 %.
TEST(Conclusion, SaysWhichJointsAreRigid)
{
    const ConvergeStudy study =
        study_of({{"crown.d:peak",
                   "m",
                   {series_of(Varied::time_step, newmark, first_order(0.001)),
                    series_of(Varied::stiffness, newmark, {1 + 0.2, 1 + 0.1, 1 + 0.05, 1 + 0.025, 1 + 0.0125})},
                   ""}});
    const Conclusion conclusion = conclude(study);
    ASSERT_EQ(conclusion.joint_lines.size(), 2);
    EXPECT_EQ(conclusion.joint_lines[0], "# joints.dry");
    EXPECT_EQ(conclusion.joint_lines[1], "contact_stiffness_factor: 16") << "8 times the case's own factor of 2";
    EXPECT_TRUE(says(conclusion.remarks, "doubling the contact stiffness changes crown.d:peak by 8.33 %"));

    ConvergeStudy stiff = study;
    stiff.tolerance = 0.3;
    EXPECT_TRUE(conclude(stiff).joint_lines.empty());
    EXPECT_TRUE(says(conclude(stiff).remarks, "within 30 % of rigid ones"));
    stiff.tolerance = 1e-3;
    EXPECT_TRUE(says(conclude(stiff).remarks, "try --stiffness-factors 16,64,256"));
}

TEST(Conclusion, IsInTheJson)
{
    const ConvergeStudy study =
        study_of({{"crown.d:peak", "m", {series_of(Varied::time_step, newmark, first_order(0.05))}, ""}});
    const auto json = nlohmann::json::parse(converge_json(study))["conclusion"];
    EXPECT_EQ(json["meets"], true);
    EXPECT_EQ(json["setting"]["time_step_s"], 5e-4);
    EXPECT_EQ(json["known"][0]["quantity"], "crown.d:peak");
    EXPECT_EQ(json["case_lines"].size(), 4);
    EXPECT_EQ(json["set"][0], "stages[1].time_step=0.5 ms");
}

}  // namespace
}  // namespace voussoir::app::studies::converge
