// Some dozen kills at random moments; 200 of them are in many_killed_runs_test.cpp.
#include "tests/app/results/killed_runs.h"

#include <gtest/gtest.h>

namespace voussoir::killed_runs
{
namespace
{

TEST(KilledRuns, ADozenOfATower)
{
    kill_many(shaken_tower, 12, 1);
}

// Several frames wait in memory, and the file gets them at once.
TEST(KilledRuns, ADozenOfATowerThatIsSavedNowAndThen)
{
    kill_many(shaken_tower, 12, 3, "0.03");
}

TEST(KilledRuns, ADozenOfAPlanarFrame)
{
    kill_many(shaken_frame, 12, 2);
}

}  // namespace
}  // namespace voussoir::killed_runs
