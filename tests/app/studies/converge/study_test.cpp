// Studies of cases whose exact answers are known: the estimated errors beside the true ones.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/reader/case_file.h"
#include "app/studies/converge/conclusion.h"
#include "app/studies/converge/report.h"
#include "app/studies/converge/sample.h"
#include "app/studies/converge/study.h"
#include "app/studies/converge/threshold.h"
#include "app/studies/converge/verdict.h"
#include "libdda/errors.h"
#include "tests/app/test_files.h"

namespace voussoir::app::studies::converge
{
namespace
{

// A block of 1 m3 on a joint of 5 MPa/m, shaken upwards and downwards while it stays pressed: a linear oscillator.
const std::string oscillator_case = R"(kinematics: spatial_rigid
materials: {stone: {density: 2400 kg/m3, young: 10 GPa, poisson: 0.2}}
joints: {soft: {friction: 30 deg, contact_stiffness: 5 MPa/m}}
blocks:
  - {box: {name: floor, lower: [-1, -1, -1], upper: [1, 1, 0]}, group: foundation}
  - {box: {name: stone, lower: [-0.5, -0.5, 0], upper: [0.5, 0.5, 1]}}
foundation: {blocks: foundation}
stages:
  - {name: rest, type: static}
  - name: shaking
    type: dynamic
    duration: 0.32 s
    time_step: 1 ms
    integrator: newmark
    body_acceleration: [{blocks: masonry, z: {sine: {acceleration: 2 m/s2, frequency: 3 Hz}}}]
output: {histories: {top: {block: stone}}}
)";

/// A/(w^2 - W^2) (sin W t - W/w sin w t): from rest, of an oscillator w driven at W.
double oscillator(double t)
{
    const double own = std::sqrt(5e6 / 2400), driven = 2 * std::numbers::pi * 3;
    return 2 / (own * own - driven * driven) * (std::sin(driven * t) - driven / own * std::sin(own * t));
}

TEST(Study, OfAnOscillatorEstimatesItsTrueErrorAndTheOrderOfTheMethod)
{
    const TemporaryFolder folder;
    const Case the_case = reader::read_case(folder.write("case.yaml", oscillator_case), {});
    const std::vector<Quantity> quantities = read_quantities({"top.dz", "top.dz:end"}, the_case);
    const std::vector<double> factors{2, 1, 0.5, 0.25, 0.125};
    std::vector<Sample> samples;
    std::vector<double> true_errors, times;
    for (const double factor : factors) {
        const MeasuredRun run = run_setting(the_case, {Integrator::newmark, factor, 1}, quantities, {}, {});
        ASSERT_EQ(run.failure, "");
        if (times.empty()) times = run.recording.times;
        samples.push_back(sample_of(quantities[0], run.recording, times));
        double worst = 0, largest = 0;
        for (std::size_t i = 0; i < times.size(); ++i) {
            const double exact = oscillator(times[i]);
            worst = std::max(worst, std::abs(samples.back()(0, static_cast<Eigen::Index>(i)) - exact));
            largest = std::max(largest, std::abs(exact));
        }
        true_errors.push_back(worst / largest);
    }
    const Estimate found = estimate(samples, factors);
    ASSERT_TRUE(found.order) << found.no_order;
    EXPECT_NEAR(*found.order, 1, 0.1);
    EXPECT_LT(found.uncertainty, 0.01);
    for (std::size_t i = 0; i < factors.size(); ++i) {
        RecordProperty("error_" + std::to_string(i), std::to_string(found.errors[i]));
        EXPECT_NEAR(found.errors[i], true_errors[i], 2 * found.uncertainty) << factors[i] << " ms";
    }
}

TEST(Study, NamesTheCheapestSettingAndTheSensitivity)
{
    const TemporaryFolder folder;
    const Case the_case = reader::read_case(folder.write("case.yaml", oscillator_case), {});
    const SettingList list =
        list_settings(plan_of({{"1 ms", "0.5 ms", "0.25 ms"}, {1, 2, 4, 8}, {"newmark"}}, the_case));
    EXPECT_EQ(list.settings.size(), 6u);  // the case's own is in both series and runs once
    const ConvergeStudy study = run_study(the_case, list, read_quantities({"top.dz:peak"}, the_case), {}, {});
    ASSERT_EQ(study.quantities.size(), 1u);
    ASSERT_EQ(study.quantities[0].series.size(), 2u);
    const Series& steps = study.quantities[0].series[0];
    ASSERT_TRUE(steps.order) << steps.no_order;
    const SeriesRow* cheap = cheapest(steps, 0.05);
    ASSERT_NE(cheap, nullptr);
    EXPECT_LE(*cheap->error + steps.uncertainty, 0.05);
    // Far above the driving frequency an oscillator follows as 1/k: doubling k halves the displacement.
    const std::optional<double> change = change_per_doubling(study.quantities[0].series[1]);
    ASSERT_TRUE(change);
    EXPECT_GT(*change, 0.4);
    EXPECT_TRUE(study.quantities[0].series[1].vanishes);
    const auto json = nlohmann::json::parse(converge_json(study));
    EXPECT_EQ(json["quantities"][0]["series"][1]["varies"], "contact_stiffness");
    EXPECT_EQ(json["quantities"][0]["series"][0]["rows"].size(), 3u);
    EXPECT_NE(converge_table(study).find("cheapest that meets 5 %"), std::string::npos);
    EXPECT_NE(converge_page(study, "voussoir converge", {"01_x"}).find("converge/01_x.png"), std::string::npos);
}

Case incline(const std::vector<std::string>& overrides)
{
    std::vector<std::string> rigid{"kinematics=spatial_rigid"};
    rigid.insert(rigid.end(), overrides.begin(), overrides.end());
    return reader::read_case(VOUSSOIR_CASES "/incline.yaml", rigid);
}

// g (sin 45 - cos 45 tan phi) t^2 / 2 reaches 1 cm in the case's 1 s at this angle.
TEST(Threshold, OfAnInclineIsFoundWithinItsBracket)
{
    const double limit =
        std::atan(1 - 2 * 0.01 / (9.80665 * std::cos(std::numbers::pi / 4))) * 180 / std::numbers::pi;
    const Case the_case = incline({});
    const Threshold threshold = read_threshold("joints.dry.friction=50..42 deg");
    EXPECT_EQ(threshold.unit, "deg");
    const SettingList list = list_settings(plan_of({{"4 ms", "2 ms"}, {1, 4}, {}}, the_case));
    const ConvergeStudy study =
        run_threshold_study(the_case, list, threshold, {{}, 0.01}, 1, {}, reader::case_reader);
    ASSERT_EQ(study.quantities.size(), 1u);
    for (const Series& series : study.quantities[0].series) {
        EXPECT_GT(series.uncertainty, 0.001);
        for (const SeriesRow& row : series.rows) {
            ASSERT_TRUE(row.value) << row.failure;
            EXPECT_NEAR(*row.value, limit, 0.5 * threshold.bracket * limit);
        }
    }
}

TEST(Threshold, ThatIsNotBetweenTheValuesIsAFailureOfTheSetting)
{
    const Case the_case = incline({});
    const SettingList list = list_settings(plan_of({{"4 ms", "2 ms"}, {1}, {}}, the_case));
    const auto failure = [&](const std::string& text) {
        const ConvergeStudy study =
            run_threshold_study(the_case, list, read_threshold(text), {{}, 0.01}, 1, {}, reader::case_reader);
        const Series& series = study.quantities[0].series[0];
        EXPECT_FALSE(series.reference);
        EXPECT_EQ(cheapest(series, 0.05), nullptr);
        EXPECT_NE(converge_table(study).find(series.rows[0].failure), std::string::npos);
        EXPECT_FALSE(converge_figures(study)[0].notes.empty());
        return series.rows[0].failure;
    };
    EXPECT_EQ(failure("joints.dry.friction=50 deg..46 deg"), "still stands at joints.dry.friction = 46 deg");
    EXPECT_EQ(failure("joints.dry.friction=40 deg..30 deg"), "collapses already at joints.dry.friction = 40 deg");
}

// 285 Pa of 1 MPa hold the block (its shear stress less the friction): a bracket of 1 % of that is not worth it.
TEST(Threshold, NextToZeroEnds)
{
    const Case the_case = incline({"joints.dry.friction=44 deg", "joints.dry.tensile_strength=1 MPa"});
    const SettingList list = list_settings(plan_of({{"4 ms", "2 ms"}, {1}, {}}, the_case));
    const Threshold threshold = read_threshold("joints.dry.cohesion=1 MPa..0 MPa");
    const ConvergeStudy study =
        run_threshold_study(the_case, list, threshold, {{}, 0.001}, 1, {}, reader::case_reader);
    for (const SeriesRow& row : study.quantities[0].series[0].rows) {
        ASSERT_TRUE(row.value) << row.failure;
        EXPECT_LT(*row.value, 0.01);
    }
}

TEST(Threshold, IsReadStrictly)
{
    for (const char* text : {"a", "a=1", "=1..2", "a=x..2", "a=1..", "a=1 m..2 s", "a=3..3"})
        EXPECT_THROW(read_threshold(text), InputError) << text;
    const Threshold threshold = read_threshold("stages[0].motion.x.sine.acceleration=0.1 g..0.5 g");
    EXPECT_EQ(threshold.key, "stages[0].motion.x.sine.acceleration");
    EXPECT_EQ(threshold.stands, 0.1);
    EXPECT_EQ(threshold.collapses, 0.5);
    EXPECT_EQ(threshold.unit, "g");
}

// A key that the case does not have, and must have: the case is read with the threshold in it.
TEST(Threshold, TakesKeysThatAreNotWrittenAndSeveralAtOnce)
{
    const TemporaryFolder folder;
    const std::string text = R"(kinematics: planar_rigid
materials: {stone: {density: 2400 kg/m3, young: 10 GPa, poisson: 0.2}}
joints: {dry: {}, smooth: {}}
default_joint: dry
blocks:
  - {box: {name: floor, lower: [-3, -1], upper: [3, 0]}, group: foundation}
  - {box: {name: stone, lower: [-0.5, 0], upper: [0.5, 0.2]}}
foundation: {blocks: foundation}
stages:
  - name: pull
    type: dynamic
    duration: 0.5 s
    time_step: 2 ms
    integrator: newmark
    body_acceleration: [{blocks: masonry, x: {sine: {acceleration: 4 m/s2, frequency: 0.05 Hz, phase: 90 deg}}}]
)";
    const Threshold threshold = read_threshold("joints.dry.friction, joints.smooth.friction=40..10 deg");
    EXPECT_EQ(threshold.keys, (std::vector<std::string>{"joints.dry.friction", "joints.smooth.friction"}));
    EXPECT_EQ(settings_of(threshold, 40),
              (std::vector<std::string>{"joints.dry.friction=40 deg", "joints.smooth.friction=40 deg"}));
    const Case the_case = reader::read_case(folder.write("case.yaml", text), settings_of(threshold, 40));
    const SettingList list = list_settings(plan_of({{"2 ms"}, {1}, {}, true}, the_case));
    EXPECT_EQ(list.settings.size(), 1u) << "a single one will do";
    const ConvergeStudy study =
        run_threshold_study(the_case, list, threshold, {{}, 1e-4}, 1, {}, reader::case_reader);
    const SeriesRow& row = study.quantities[0].series[0].rows[0];
    ASSERT_TRUE(row.value) << row.failure;
    EXPECT_NEAR(*row.value, std::atan(4 / 9.80665) * 180 / std::numbers::pi, 0.4) << "atan(a / g)";
    EXPECT_NE(converge_table(study).find("a single run says nothing about its error"), std::string::npos)
        << converge_table(study);
}

// What a study tries unless it is told: the default integrator is always among it.
TEST(Plan, HasTheDefaultIntegratorBesideTheCasesOwn)
{
    const Case of_newmark = incline({"stages[0].integrator=newmark"});
    EXPECT_EQ(plan_of({}, of_newmark).integrators,
              (std::vector<Integrator>{Integrator::newmark, Integrator::energy_decaying}));
    EXPECT_EQ(plan_of({{}, {}, {"newmark"}}, of_newmark).integrators,
              std::vector<Integrator>{Integrator::newmark});
    const Case of_energy = incline({"stages[0].integrator=energy_decaying", "stages[0].dissipation=0.7"});
    EXPECT_EQ(plan_of({}, of_energy).integrators, std::vector<Integrator>{Integrator::energy_decaying});
    EXPECT_EQ(plan_of({}, incline({"stages[0].open_close=published"})).integrators.size(), 1u);
    EXPECT_EQ(plan_of({}, of_newmark).step_factors.size(), 5u);
    EXPECT_EQ(plan_of({}, of_newmark).stiffness_factors.size(), 5u);
    const ConvergePlan of_threshold = plan_of({{}, {}, {}, true}, of_newmark);
    EXPECT_EQ(of_threshold.integrators.size(), 1u);
    EXPECT_EQ(of_threshold.step_factors, (std::vector<double>{2, 1, 0.5}));
    EXPECT_EQ(of_threshold.stiffness_factors, (std::vector<double>{1, 2}));
    // The dissipation of a case is that of its own integrator.
    const ConvergeSetting finer{Integrator::energy_decaying, 0.5, 1};
    EXPECT_EQ(with_setting(of_energy, finer).stages[0].control.dissipation, 0.7);
    EXPECT_EQ(with_setting(of_newmark, finer).stages[0].control.dissipation, StepControl{}.dissipation);
    const Case of_error = incline({"stages[0].step_error=0.8 mm"});
    EXPECT_DOUBLE_EQ(with_setting(of_error, {Integrator::energy_decaying, 0.5, 1}).stages[0].control.step_error,
                     1e-4);
    EXPECT_EQ(with_setting(of_error, {Integrator::newmark, 0.5, 1}).stages[0].control.step_error, 0);
}

// Three blocks on one another whose top one leans out: a static stage has no equilibrium from an overhang on.
TEST(Threshold, OfAStaticCaseNeedsNoDynamicStage)
{
    const TemporaryFolder folder;
    const std::string text = R"(kinematics: planar_rigid
materials: {stone: {density: 2400 kg/m3, young: 10 GPa, poisson: 0.2}}
joints: {dry: {friction: 40 deg}}
blocks:
  - {box: {name: floor, lower: [-3, -1], upper: [3, 0]}, group: foundation}
  - {box: {name: stone, lower: [0, 0], upper: [1, 2]}}
foundation: {blocks: foundation}
gravity: {direction: [0.2, -1]}
stages: [{type: static, max_static_steps: 300}]
)";
    const auto file = folder.write("case.yaml", text);
    const Case the_case = reader::read_case(file, {});
    EXPECT_THROW(plan_of({}, the_case), InputError);
    EXPECT_THROW(plan_of({{"1 ms"}, {}, {}, true}, the_case), InputError);
    const ConvergePlan plan = plan_of({{}, {}, {}, true}, the_case);
    EXPECT_EQ(plan.step_factors, std::vector<double>{1});
    const ConvergeStudy study =
        run_threshold_study(the_case, list_settings(plan), read_threshold("gravity.direction[0]=0.2..0.8"),
                            {0.2, {}}, 1, {}, reader::case_reader);
    ASSERT_EQ(study.quantities[0].series.size(), 1u);
    EXPECT_EQ(study.quantities[0].series[0].varied, Varied::stiffness);
    for (const SeriesRow& row : study.quantities[0].series[0].rows) {
        ASSERT_TRUE(row.value) << row.failure;
        EXPECT_NEAR(*row.value, 0.5, 0.01) << "half width over half height";
    }
}

// The block slides by more than its size: end states give way to the peak before.
TEST(Study, OfACollapseComparesPeaksBeforeIt)
{
    const Case the_case = incline({});
    const SettingList list = list_settings(plan_of({{"4 ms", "2 ms", "1 ms"}, {1}, {}}, the_case));
    const ConvergeStudy study = run_study(the_case, list, read_quantities({"block.d:end"}, the_case), {}, {});
    ASSERT_EQ(study.quantities.size(), 2u);
    EXPECT_FALSE(study.quantities[0].series[0].reference);
    EXPECT_EQ(study.quantities[1].name, "block.d:peak");
    const Series& peaks = study.quantities[1].series[0];
    const double size = std::cbrt(0.5);  // m, of the block
    ASSERT_TRUE(peaks.reference);
    EXPECT_NEAR(*peaks.reference, size, 0.02);
    for (const SeriesRow& row : peaks.rows) EXPECT_TRUE(row.collapse);
    ASSERT_FALSE(peaks.notes.empty());
    EXPECT_NE(peaks.notes[0].find("block 'block' is the first to collapse"), std::string::npos);
}

TEST(Study, DoesNotCompareWhatDoesNotMove)
{
    const Case the_case = incline({"stages[0].duration=0.1 s"});
    const SettingList list = list_settings(plan_of({{"4 ms", "2 ms", "1 ms"}, {1}, {}}, the_case));
    const auto conclusion = [&](const std::vector<std::string>& words) {
        const ConvergeStudy study = run_study(the_case, list, read_quantities(words, the_case), {}, {});
        EXPECT_EQ(study.quantities.size(), words.size()) << study.quantities.back().added;
        const Series& series = study.quantities[0].series[0];
        EXPECT_FALSE(series.reference);
        EXPECT_EQ(series.no_order, "it does not move along y");
        return in_words(conclude(study));
    };
    EXPECT_EQ(conclusion({"block.dy", "block.vy:peak"}).size(), 1u);
    const std::vector<std::string> lines = conclusion({"block.dy", "block.dx"});
    EXPECT_NE(lines[0].find("is the cheapest that meets it"), std::string::npos) << lines[0];
}

TEST(Study, KeepsRunsThatGiveUpAsRows)
{
    const Case the_case = incline(
        {"stages[0].max_open_close=1", "stages[0].force_tolerance=1e-15", "stages[0].min_time_step=0.9 ms"});
    const SettingList list = list_settings(plan_of({{"2 ms", "1 ms"}, {1}, {}}, the_case));
    const ConvergeStudy study = run_study(the_case, list, read_quantities({}, the_case), {}, {});
    const Series& series = study.quantities[0].series[0];
    ASSERT_EQ(series.rows.size(), 2u);
    for (const SeriesRow& row : series.rows) EXPECT_NE(row.failure.find("failed to converge"), std::string::npos);
    EXPECT_NE(converge_page(study, "", {}).find("failed: stage"), std::string::npos);
    EXPECT_TRUE(nlohmann::json::parse(converge_json(study))["quantities"][0]["series"][0]["reference"].is_null());
}

}  // namespace
}  // namespace voussoir::app::studies::converge
