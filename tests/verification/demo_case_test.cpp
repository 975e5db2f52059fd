// The case of scripts/demo, Mosca's bridge under its earthquake: it runs, and contacts give no energy.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "tests/verification/program_run.h"

namespace voussoir::verification
{

// Faces that slide in part and open in part all along the arch, of stones that bend and twist.
TEST(DemoCase, RunsAndItsContactsGiveNoEnergy)
{
    const ProgramRun ran = run_case(std::filesystem::path(VOUSSOIR_CASES) / "mosca_bridge.yaml",
                                    {"stages[1].duration=2 s", "output.snapshots=null"});
    ASSERT_EQ(ran.status, 0);
    const auto summary = nlohmann::json::parse(ran.summary);
    EXPECT_EQ(summary.at("outcome"), "completed");
    const double given = summary.at("energy").at("foundation_work_J");
    const double by_contacts = summary.at("energy").at("redetection_J");
    EXPECT_GT(given, 0);
    EXPECT_LT(std::abs(by_contacts), 0.01 * given);
}

}  // namespace voussoir::verification
