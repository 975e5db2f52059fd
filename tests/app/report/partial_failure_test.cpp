// What is said of a structure of which a part fails while the rest moves and stays.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/app/command_test.h"

namespace voussoir::app::report
{
namespace
{

/// Two stones slide on a plinth: one off it, the other comes to rest v^2 / (2 mu g) from its place.
constexpr const char* two_that_slide = R"(title: Two stones on a plinth
kinematics: planar_rigid
thickness: 1 m
materials: {stone: {density: 2400 kg/m3, young: 5 GPa, poisson: 0.2}}
joints: {dry: {friction: 40 deg}}
blocks:
  - box: {name: plinth, lower: [-2, 0, -1], upper: [2, 1, 0]}
    group: foundation
  - box: {name: stays, lower: [-1.5, 0, 0], upper: [-1.1, 1, 0.4]}
  - box: {name: goes, lower: [1.4, 0, 0], upper: [1.8, 1, 0.4]}
foundation: {blocks: foundation}
initial_state: [{blocks: stays, velocity: [0.55 m/s, 0, 0]}, {blocks: goes, velocity: [4 m/s, 0, 0]}]
stages: [{name: push, type: dynamic, duration: 0.6 s, time_step: 1 ms}]
output: {every: 5 ms, trust: never}
)";

class PartialFailure : public CommandTest
{
 protected:
    nlohmann::json report()
    {
        folder_.write("case.yaml", two_that_slide);
        voussoir("run case.yaml -o results -q");
        EXPECT_EQ(voussoir("report results --no-film -q"), 0) << output_;
        return nlohmann::json::parse(contents("results/report.json"));
    }
};

TEST_F(PartialFailure, NamesWhatMovedOffAndSaysThatTheRestStays)
{
    const nlohmann::json told = report();
    EXPECT_EQ(told.at("mechanism"), "slides");
    const std::string line = told.at("mechanism_line");
    EXPECT_EQ(
        line.rfind("Part of the structure fails by sliding at one place: one body of stones moves (goes).", 0), 0U)
        << line;
    const double slid = 1e3 * 0.55 * 0.55 / (2 * std::tan(40 * std::numbers::pi / 180) * 9.80665);  // mm
    const std::string stays = "What else moved stays, up to ";
    ASSERT_NE(line.find(stays), std::string::npos) << line;
    EXPECT_NEAR(std::stod(line.substr(line.find(stays) + stays.size())), slid, 0.05 * slid) << line;
}

}  // namespace
}  // namespace voussoir::app::report
