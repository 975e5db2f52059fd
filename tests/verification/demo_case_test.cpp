// The case of scripts/demo, Mosca's bridge under its earthquake: it runs, and contacts give no energy.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "tests/verification/program_run.h"

namespace voussoir::verification
{

// Faces that slide in part and open in part all along the arch, of stones that bend and twist.
TEST(DemoCase, RunsAndItsContactsGiveNoEnergy)
{
    for (const auto& [step, duration] : {std::pair{"2 ms", "2 s"}, std::pair{"0.5 ms", "1.8 s"}}) {
        const ProgramRun ran = run_case(std::filesystem::path(VOUSSOIR_CASES) / "mosca_bridge.yaml",
                                        {std::string("stages[1].duration=") + duration,
                                         std::string("stages[1].time_step=") + step, "output.snapshots=null"});
        ASSERT_EQ(ran.status, 0);
        const auto summary = nlohmann::json::parse(ran.summary);
        EXPECT_EQ(summary.at("outcome"), "completed");
        const auto& energy = summary.at("energy");
        const double given = energy.at("foundation_work_J");
        EXPECT_GT(given, 0);
        EXPECT_LT(std::abs(energy.at("redetection_J").get<double>()), 0.002 * given) << step;
        EXPECT_GT(energy.at("friction_J").get<double>(), 0) << step;
    }
}

}  // namespace voussoir::verification
