// One call site of each kind of each program. every_fault_test.cpp has them all.
#include <gtest/gtest.h>

#include <map>

#include "tests/app/faults/faults.h"
#include "tests/temporary_folder.h"

// AddressSanitizer has the allocations for itself.
#ifndef __SANITIZE_ADDRESS__
namespace voussoir::faults
{
namespace
{

class FaultInjection : public ::testing::TestWithParam<const char*>
{
};

/// A few sites of each kind and program, evenly spread over those in the order of their first calls.
std::vector<CallSite> sample_of(const std::vector<CallSite>& sites, std::size_t of_each)
{
    std::map<std::string, std::vector<CallSite>> kinds;
    for (const CallSite& site : sites)
        if (site.ours) kinds[site.program + site.kind].push_back(site);
    std::vector<CallSite> sample;
    for (const auto& [name, of_kind] : kinds)
        for (std::size_t i = 0; i < std::min(of_each, of_kind.size()); ++i)
            sample.push_back(of_kind[(2 * i + 1) * of_kind.size() / (2 * std::min(of_each, of_kind.size()))]);
    return sample;
}

TEST_P(FaultInjection, ASiteOfEachKind)
{
    const TemporaryFolder folder;
    const Scenario scenario(GetParam(), folder.path());
    EXPECT_GT(scenario.sites().size(), 500U);
    EXPECT_EQ(try_all(scenario, sample_of(scenario.sites(), 1), 1), 0);
}

INSTANTIATE_TEST_SUITE_P(Commands, FaultInjection, ::testing::Values("run", "resume", "import", "picture"));

}  // namespace
}  // namespace voussoir::faults
#endif
