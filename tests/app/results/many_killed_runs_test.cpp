// 300 runs killed at random moments: all results readable, all resumed runs identical to the uninterrupted one.
#include "tests/app/results/killed_runs.h"

#include <gtest/gtest.h>

namespace voussoir::killed_runs
{
namespace
{

TEST(ManyKilledRuns, AHundredOfATower)
{
    kill_many(shaken_tower, 100, 20251);
}

TEST(ManyKilledRuns, AHundredOfATowerThatIsSavedNowAndThen)
{
    kill_many(shaken_tower, 100, 20253, "0.03");
}

TEST(ManyKilledRuns, AHundredOfAPlanarFrame)
{
    kill_many(shaken_frame, 100, 20252);
}

}  // namespace
}  // namespace voussoir::killed_runs
