// All 200 random walls and arches beside limit analysis.
#include "tests/app/studies/verify/limit_verdicts.h"

namespace voussoir::app::studies::verify
{

TEST(ManyLimitMasonry, StandsBelowItsLimitsAndFallsAboveThem)
{
    LimitCounts counts;
    for (int n = 0; n < 200; ++n) judge_verdicts(limit_masonry_seed, n, counts);
    std::printf("%d with one limit (0.3 %%), %d with an interval of them; %.1f times the iterations to fall\n",
                counts.sharp, counts.wide,
                static_cast<double>(counts.falling) / static_cast<double>(counts.standing));
    EXPECT_LE(counts.falling, 20 * counts.standing);
    EXPECT_GE(counts.sharp, 60);
    EXPECT_GE(counts.wide, 60);
}

}  // namespace voussoir::app::studies::verify
