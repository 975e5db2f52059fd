// An arch that one long sine of the ground brings down: computed to its end, whatever the step.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/verification/program_run.h"

namespace voussoir::verification
{

// The corners of the outer voussoirs pass the edges of the springers under all that the arch carries. Half of
// these runs gave up: what touched there was 1e-4 of a face, and grew.
TEST(FallingArch, IsFollowedToItsEnd)
{
    for (const char* peak : {"0.6 g", "0.65 g", "0.7 g"})
        for (const char* step : {"2 ms", "1 ms", "0.5 ms", "0.25 ms"}) {
            const ProgramRun ran =
                run_case(std::filesystem::path(VOUSSOIR_CASES) / "arch_planar.yaml",
                         {std::string("stages[1].time_step=") + step, "stages[1].duration=4 s",
                          std::string("foundation.motion.x.sine={frequency: 1 Hz, duration: 1 s, acceleration: ") +
                              peak + "}",
                          "output.snapshots=null"});
            EXPECT_EQ(ran.word("outcome"), "collapsed") << peak << ", " << step;
            const auto summary = nlohmann::json::parse(ran.summary);
            EXPECT_EQ(summary.at("verdict").at("standing"), "fallen") << peak << ", " << step;
            const auto& energy = summary.at("energy");
            EXPECT_LT(std::abs(energy.at("redetection_J").get<double>()),
                      0.01 * energy.at("gravity_work_J").get<double>())
                << peak << ", " << step;
        }
}

}  // namespace voussoir::verification
