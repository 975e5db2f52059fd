// What the built program does with stones that move when the run begins.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::commands
{
namespace
{

class InitialStateProgram : public CommandTest
{
 protected:
    double energy(const char* term) const
    {
        return nlohmann::json::parse(contents("out/summary.json")).at("energy").at(term).get<double>();
    }
};

TEST_F(InitialStateProgram, StaticStageLeavesTheBlocksAtRest)
{
    folder_.write("case.yaml", with(two_boxes, "stages:\n",
                                    "initial_state: [{blocks: stone, velocity: [0.5 m/s, 0, 0]}]\nstages:\n"));
    const double start = 0.5 * 2400 * 0.25;  // J
    for (const char* friction : {"5", "10", "20", "30"}) {
        ASSERT_EQ(
            voussoir(std::string("run case.yaml -o out -q --set 'joints.dry.friction=") + friction + " deg'"), 0)
            << output_;
        EXPECT_NEAR(energy("start_kinetic_J"), start, 1e-9 * start);
        EXPECT_LT(energy("damping_static_J"), 1e-3 * start) << "the motion waits for the dynamic stage";
    }
}

}  // namespace
}  // namespace voussoir::app::commands
