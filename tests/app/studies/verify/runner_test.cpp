// The runner, the table and the JSON on benchmarks whose results are known.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "app/studies/scenes/materials.h"
#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/sliding_scenes.h"
#include "app/studies/verify/engine_run.h"
#include "app/studies/verify/page.h"
#include "app/studies/verify/plot.h"
#include "app/studies/verify/runner.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/table.h"
#include "app/studies/verify/verify_json.h"

namespace voussoir::app::studies::verify
{
namespace
{

/// The error is 100 h^2; a step of 5 ms throws, one of 10 ms gives up.
Benchmark second_order()
{
    Benchmark benchmark;
    benchmark.name = "second-order";
    benchmark.tolerance = 2e-4;
    benchmark.sweep = standard_sweep({1e-2, 5e-3, 2e-3, 1e-3, 5e-4});
    benchmark.run = [](const scenes::SceneSetting& setting) {
        if (setting.time_step == 5e-3) throw std::runtime_error("no such thing");
        VerifyResult result;
        result.error = 100 * setting.time_step * setting.time_step;
        result.simulated_time = 2;
        result.cpu_time = 0.5;
        if (setting.time_step == 1e-2) result.failure = "gave up";
        return result;
    };
    return benchmark;
}

TEST(Runner, FindsTheOrderAndKeepsFailuresAsRows)
{
    const VerifyOutcome outcome = run_benchmark(second_order(), true);
    EXPECT_TRUE(outcome.pass);
    EXPECT_EQ(outcome.rows.size(), 20u);
    ASSERT_EQ(outcome.orders.size(), 4u);
    for (const ObservedOrder& order : outcome.orders) EXPECT_NEAR(order.order, 2, 1e-12) << order.method;
    EXPECT_EQ(outcome.rows[0].result.failure, "gave up");
    EXPECT_EQ(outcome.rows[1].result.failure, "no such thing");
    EXPECT_NE(sweep_lines(outcome).find("failed"), std::string::npos);
    EXPECT_NE(verification_page({outcome}, "voussoir verify", {}, false).find("failed: no such thing"),
              std::string::npos);
    EXPECT_DOUBLE_EQ(cpu_share(outcome.row.result), 0.25);
}

TEST(Runner, AnErrorAboveTheToleranceOrNoneAtAllDoesNotPass)
{
    Benchmark benchmark = second_order();
    benchmark.tolerance = 0.99e-4;
    EXPECT_FALSE(run_benchmark(benchmark, false).pass);
    benchmark.setting.time_step = 5e-3;
    benchmark.tolerance = 1;
    EXPECT_FALSE(run_benchmark(benchmark, false).pass);
    benchmark.run = [](const scenes::SceneSetting&) {
        VerifyResult result;
        result.error = std::nan("");
        return result;
    };
    EXPECT_FALSE(run_benchmark(benchmark, false).pass);
}

TEST(Runner, JsonHasWhatDesignNamesAndNullForAnErrorThatIsNone)
{
    const VerifyOutcome outcome = run_benchmark(second_order(), true);
    const nlohmann::json list = nlohmann::json::parse(verify_json({outcome}));
    ASSERT_EQ(list.size(), 1u);
    for (const char* key :
         {"benchmark", "source", "quantity", "rows", "error", "tolerance", "paper_error", "pass"})
        EXPECT_TRUE(list[0].contains(key)) << key;
    for (const char* key : {"method", "time_step_s", "error", "cpu_time_s", "steps", "iterations"})
        EXPECT_TRUE(list[0]["rows"][0].contains(key)) << key;
    EXPECT_TRUE(list[0]["rows"][0]["error"].is_null());
    EXPECT_NEAR(list[0]["error"].get<double>(), 1e-4, 1e-15);
}

TEST(Runner, DrawsWhatWasSweptAndNothingWhereEveryErrorIsNone)
{
    Benchmark benchmark = second_order();
    const plots::Figure swept = work_precision(run_benchmark(benchmark, true));
    ASSERT_EQ(swept.diagrams.size(), 2u);  // no stiffness was varied
    EXPECT_EQ(swept.diagrams[0].curves.size(), 4u);
    EXPECT_EQ(swept.notes.size(), 8u) << "two steps of each method fail";
    EXPECT_TRUE(picture(run_benchmark(benchmark, false)).diagrams.empty());
    benchmark.tolerance = 0;
    benchmark.run = [](const scenes::SceneSetting&) { return VerifyResult{}; };
    const plots::Figure none = work_precision(run_benchmark(benchmark, true));
    EXPECT_TRUE(none.diagrams.empty());
    EXPECT_EQ(none.notes.size(), 20u) << "each row is one without error";
}

TEST(Runner, TheSameSceneInOtherUnknownsMustPassAndAgree)
{
    Benchmark benchmark = second_order();
    benchmark.also = {Kinematics::planar_rigid, Kinematics::planar_deformable, Kinematics::spatial_deformable};
    double apart = 1e-6;
    benchmark.run = [&](const scenes::SceneSetting& setting) {
        VerifyResult result;
        const double place = is_deformable(setting.kinematics) ? 2 : 1;
        result.answer = {place * (is_planar(setting.kinematics) ? 1 + apart : 1)};
        return result;
    };
    VerifyOutcome outcome = run_benchmark(benchmark, false);
    EXPECT_TRUE(outcome.pass);
    ASSERT_EQ(outcome.companions.size(), 3u);
    EXPECT_NEAR(outcome.companions[0].distance.value(), 1e-6, 1e-12);
    EXPECT_FALSE(outcome.companions[1].distance) << "the first deformable one has nothing to agree with";
    EXPECT_NEAR(outcome.companions[2].distance.value(), 1e-6, 1e-9);
    for (const double worse : {1e-3, std::nan("")}) {
        apart = worse;
        EXPECT_FALSE(run_benchmark(benchmark, false).pass);
    }
}

TEST(Runner, RunsAddUpAndTheWorstErrorCounts)
{
    VerifyResult total, one;
    one.error = 1e-3, one.steps = 5, one.cpu_time = 2, one.note = "a";
    add_run(total, one);
    one.error = 1e-4, one.failure = "why", one.note = "b";
    add_run(total, one);
    EXPECT_EQ(total.error, 1e-3);
    EXPECT_EQ(total.steps, 10);
    EXPECT_EQ(total.failure, "why");
    EXPECT_EQ(total.note, "a; b");
}

/// Rows that are held against what a paper computed with its own method.
bool is_of_a_papers_method(const std::string& name)
{
    return name.starts_with("rebound-") || name.starts_with("site-") || name == "open-close" ||
           name == "kinetic-damping-factor" || name == "slender-tower" || name == "mosca-bridge" ||
           name == "rocking-5-seconds-fine";
}

TEST(Benchmarks, RunAtDefaultsUnlessAPapersMethodIsTheReference)
{
    for (const Benchmark& benchmark : all_benchmarks(1)) {
        const scenes::SceneSetting& setting = benchmark.setting;
        const bool papers = is_of_a_papers_method(benchmark.name),
                   keeps = benchmark.name == "rebound-energy-keeping";
        EXPECT_EQ(setting.papers_joints, papers) << benchmark.name;
        EXPECT_EQ(setting.integrator, papers && !keeps ? Integrator::newmark : StepControl{}.integrator)
            << benchmark.name;
        EXPECT_FALSE(setting.stiffness_factor) << benchmark.name;
        if (papers) {
            EXPECT_NE(method_name(setting).find("joints as in the papers"), std::string::npos) << benchmark.name;
        }
    }
}

TEST(Settings, JointsAsInThePapersHaveTheirStiffnessAndNoLawOfImpacts)
{
    for (const Kinematics kinematics : {Kinematics::spatial_rigid, Kinematics::planar_deformable}) {
        scenes::SceneSetting setting;
        setting.kinematics = kinematics;
        const scenes::SceneSetting papers = as_in_papers(setting);
        EXPECT_TRUE(scenes::joint_in(setting, {}).restitution.has_value());
        EXPECT_FALSE(scenes::joint_in(papers, {}).restitution.has_value());
        const auto stiffness = [](const scenes::SceneSetting& with) {
            return scenes::start_contact(scenes::block_on_base(with, {.size = {1, 1, 0.5}}).model).stiffness;
        };
        // A block of 0.5 m and 10 GPa on a held base, dry: 2 k E / L.
        EXPECT_NEAR(stiffness(setting) / 4e10, is_deformable(kinematics) ? 30 : 10, 1e-9);
        EXPECT_NEAR(stiffness(papers) / 4e10, is_deformable(kinematics) ? 10 : 1, 1e-9);
        EXPECT_NEAR(scenes::default_stiffness(papers, 0.5e-10), stiffness(papers), 1);
        EXPECT_NEAR(scenes::default_stiffness(setting, 0.5e-10), stiffness(setting), 1);
    }
}

TEST(Benchmarks, HaveNamesOfTheirOwnTolerancesAndSweepsOfFourSettings)
{
    std::set<std::string> names;
    int swept = 0;
    for (const Benchmark& benchmark : all_benchmarks(1)) {
        EXPECT_TRUE(names.insert(benchmark.name).second) << benchmark.name;
        EXPECT_GE(benchmark.tolerance, 0) << benchmark.name;
        EXPECT_LE(benchmark.tolerance, 1) << benchmark.name;
        std::set<double> steps, factors;  // a static stage has no time step to vary
        for (const scenes::SceneSetting& setting : benchmark.sweep) {
            steps.insert(setting.time_step);
            factors.insert(setting.stiffness_factor.value_or(1));
        }
        EXPECT_TRUE(steps.empty() || steps.size() >= 4 || factors.size() >= 4) << benchmark.name;
        swept += !steps.empty();
    }
    EXPECT_GE(names.size(), 20U);
    EXPECT_GE(swept, 5);
}

}  // namespace
}  // namespace voussoir::app::studies::verify
