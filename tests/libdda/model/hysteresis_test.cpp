// Branches whose damping ratio is the same within a band of frequencies.
#include "libdda/model/hysteresis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace voussoir::testing
{

using std::numbers::pi;

// Narrow and wide bands, little and much damping: within half a per cent between the points of the fit too.
TEST(Hysteresis, HasTheRatioThatIsAskedForThroughoutTheBand)
{
    for (const double ratio : {0.001, 0.01, 0.05, 0.1, 0.2})
        for (const double band : {1.01, 2.0, 10.0, 50.0, 1e3, 1e4}) {
            const std::vector<MaxwellBranch> branches = hysteretic_branches(ratio, 0.5, 0.5 * band);
            ASSERT_FALSE(branches.empty()) << ratio << " over " << band;
            for (int i = 0; i <= 400; ++i) {
                const double frequency = 0.5 * std::pow(band, i / 400.0);
                EXPECT_NEAR(damping_ratio_of(branches, 2 * pi * frequency) / ratio, 1, 0.006)
                    << ratio << " at " << frequency << " Hz of " << band;
            }
        }
}

// What is damped alike at all frequencies is stiffer at higher ones: |M| grows with omega^(2 delta / pi),
// tan(delta) twice the ratio. Within the band the fit follows that law.
TEST(Hysteresis, GrowsStifferAsCausalityAsks)
{
    for (const double ratio : {0.02, 0.05, 0.1}) {
        const std::vector<MaxwellBranch> branches = hysteretic_branches(ratio, 0.1, 100);
        const double grown =
            std::abs(modulus_over_rest(branches, 2 * pi * 10)) / std::abs(modulus_over_rest(branches, 2 * pi * 1));
        EXPECT_NEAR(std::log(grown), 2 * std::atan(2 * ratio) / pi * std::log(10.0), 0.01 * std::log(grown));
    }
}

// Frequencies are in Hz: the same band elsewhere has the same shares and other times.
TEST(Hysteresis, DependsOnTheBandByItsTimesAlone)
{
    const auto low = hysteretic_branches(0.05, 1, 10), high = hysteretic_branches(0.05, 100, 1000);
    ASSERT_EQ(low.size(), high.size());
    for (std::size_t i = 0; i < low.size(); ++i) {
        EXPECT_NEAR(high[i].share, low[i].share, 1e-9);
        EXPECT_NEAR(high[i].time, 0.01 * low[i].time, 1e-9 * low[i].time);
    }
}

TEST(Hysteresis, RefusesWhatItCannotFit)
{
    EXPECT_TRUE(hysteretic_branches(0, 1, 10).empty());
    EXPECT_TRUE(hysteretic_branches(2 * most_hysteretic_ratio, 1, 10).empty());
    EXPECT_TRUE(hysteretic_branches(0.05, 10, 1).empty());
    EXPECT_TRUE(hysteretic_branches(0.05, 0, 1).empty());
    EXPECT_TRUE(hysteretic_branches(0.05, 1, 2 * widest_band).empty());
}

}  // namespace voussoir::testing
