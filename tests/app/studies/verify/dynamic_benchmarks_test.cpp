// Runs the rocking, knocking and waving benchmarks at their defaults and prints what they give.
#include <gtest/gtest.h>

#include "app/studies/verify/families.h"

namespace voussoir::app::studies::verify
{

namespace
{

void run_and_judge(const std::vector<Benchmark>& family)
{
    for (const Benchmark& benchmark : family) {
        const VerifyResult result = benchmark.run(benchmark.setting);
        std::printf(
            "%-28s error %.3e (tolerance %.0e) h %g s, %.2f s CPU, %lld steps, %lld cuts, %lld iterations\n    "
            "%s%s\n",
            benchmark.name.c_str(), result.error, benchmark.tolerance, benchmark.setting.time_step,
            result.cpu_time, static_cast<long long>(result.steps), static_cast<long long>(result.step_cuts),
            static_cast<long long>(result.iterations), result.failure.c_str(), result.note.c_str());
        EXPECT_TRUE(result.failure.empty()) << benchmark.name << ": " << result.failure;
        EXPECT_LE(result.error, benchmark.tolerance) << benchmark.name;
    }
}

}  // namespace

TEST(DynamicBenchmarks, Impact)
{
    run_and_judge(impact_benchmarks());
}
TEST(DynamicBenchmarks, Rocking)
{
    run_and_judge(rocking_benchmarks());
}
TEST(DynamicBenchmarks, RockingAtDefaults)
{
    run_and_judge(rocking_default_benchmarks());
}
TEST(DynamicBenchmarks, ManyBlocksErrAndCostAsOne)
{
    run_and_judge(many_blocks_benchmarks());
}
TEST(DynamicBenchmarks, Vibration)
{
    run_and_judge(vibration_benchmarks());
}
TEST(DynamicBenchmarks, Ground)
{
    run_and_judge(ground_benchmarks());
}
TEST(DynamicBenchmarks, ModeChart)
{
    run_and_judge(mode_chart_benchmarks(1));
}
// No point of the charts of ten seeds disagrees.
TEST(DynamicBenchmarks, ModeChartOfOtherSeeds)
{
    for (std::uint64_t seed = 2; seed < 12; ++seed)
        for (const Benchmark& chart : mode_chart_benchmarks(seed)) {
            const VerifyResult result = chart.run(chart.setting);
            EXPECT_EQ(result.error, 0) << chart.name << ", seed " << seed << ": " << result.note;
        }
}

TEST(DynamicBenchmarks, Waves)
{
    run_and_judge(wave_benchmarks());
}
TEST(DynamicBenchmarks, Tower)
{
    run_and_judge(tower_benchmarks());
}
TEST(DynamicBenchmarks, Vaults)
{
    run_and_judge(vault_benchmarks());
    run_and_judge(cross_vault_benchmarks());
}
TEST(DynamicBenchmarks, Openings)
{
    run_and_judge(opening_benchmarks());
}
TEST(DynamicBenchmarks, LimitStates)
{
    run_and_judge(limit_state_benchmarks());
}
TEST(DynamicBenchmarks, KineticDamping)
{
    run_and_judge(kinetic_damping_benchmarks());
}

}  // namespace voussoir::app::studies::verify
