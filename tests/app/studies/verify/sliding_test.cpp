// The fast part of the sliding benchmarks: a fraction of the papers' errors, at the default setting.
#include <gtest/gtest.h>

#include <cstdio>

#include "app/studies/verify/runner.h"
#include "app/studies/verify/table.h"

namespace voussoir::app::studies::verify
{
namespace
{

class SlidingBenchmark : public ::testing::TestWithParam<const char*>
{
};
INSTANTIATE_TEST_SUITE_P(Papers, SlidingBenchmark,
                         ::testing::Values("incline-gravity-2d", "incline-gravity-3d", "incline-start-velocity",
                                           "incline-sine-2d", "incline-sine-3d", "incline-two-directions",
                                           "wedge-gravity", "wedge-sine", "foundation-1d", "foundation-2d",
                                           "foundation-3d", "three-sines", "incline-li", "incline-khan",
                                           "incline-khan-soft", "two-sliding-blocks"),
                         [](const auto& info) {
                             std::string name = info.param;
                             for (char& letter : name)
                                 if (letter == '-') letter = '_';
                             return name;
                         });

TEST_P(SlidingBenchmark, IsWithinItsToleranceAndFarBelowThePapersError)
{
    for (const Benchmark& benchmark : all_benchmarks(1)) {
        if (benchmark.name != GetParam()) continue;
        const VerifyOutcome outcome = run_benchmark(benchmark, false);
        std::printf("%s", table_line(outcome).c_str());
        EXPECT_EQ(outcome.row.result.failure, "");
        EXPECT_LE(outcome.row.result.error, benchmark.tolerance);
        EXPECT_LE(outcome.row.result.error, 0.5 * benchmark.paper_level.value_or(1));
        return;
    }
    FAIL() << "no such benchmark";
}

}  // namespace
}  // namespace voussoir::app::studies::verify
