// All call sites. A part of them: VOUSSOIR_FAULTS=K/N tries every N-th site from the K-th on, so that several
// machines can share the work.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include "tests/app/faults/faults.h"
#include "tests/temporary_folder.h"

#ifndef __SANITIZE_ADDRESS__
namespace voussoir::faults
{
namespace
{

class EveryFault : public ::testing::TestWithParam<const char*>
{
 protected:
    std::vector<CallSite> part_of(const std::vector<CallSite>& sites) const
    {
        int first = 0, step = 1;
        if (const char* part = std::getenv("VOUSSOIR_FAULTS")) std::sscanf(part, "%d/%d", &first, &step);
        std::vector<CallSite> chosen;
        for (std::size_t i = static_cast<std::size_t>(first); i < sites.size();
             i += static_cast<std::size_t>(step))
            chosen.push_back(sites[i]);
        return chosen;
    }

    const TemporaryFolder folder_;
    const Scenario scenario_{GetParam(), folder_.path()};
};

TEST_P(EveryFault, CallsOfTheSystem)
{
    std::vector<CallSite> sites = scenario_.sites();
    std::erase_if(sites, [](const CallSite& site) { return site.kind == "memory"; });
    EXPECT_EQ(try_all(scenario_, part_of(sites), 1), 0);
    EXPECT_EQ(try_all(scenario_, part_of(sites), 2), 0);
}

TEST_P(EveryFault, MemoryOfOurs)
{
    std::vector<CallSite> sites = scenario_.sites();
    std::erase_if(sites, [](const CallSite& site) { return site.kind != "memory" || !site.ours; });
    EXPECT_EQ(try_all(scenario_, part_of(sites), 1), 0);
}

TEST_P(EveryFault, MemoryOfLibrariesBySeed)
{
    std::vector<CallSite> sites = scenario_.sites(), sample;
    std::erase_if(sites, [](const CallSite& site) { return site.ours; });
    std::sample(sites.begin(), sites.end(), std::back_inserter(sample), 200, std::mt19937(22));
    try_all(scenario_, part_of(sample), 0);  // what a library makes of it is its own
}

INSTANTIATE_TEST_SUITE_P(Commands, EveryFault, ::testing::Values("run", "resume", "import", "picture"));

}  // namespace
}  // namespace voussoir::faults
#endif
