// How short a step is to be, as a case file has it.
#include "app/words/shorter_step.h"

#include <gtest/gtest.h>

namespace voussoir::testing
{
namespace
{

using app::words::longest_step;
using app::words::rounded_down;
using app::words::shorter_step;

TEST(ShorterStep, IsOneDigitThatIsNoLarger)
{
    Stage stage;
    stage.control.time_step = 4e-3;
    EXPECT_EQ(shorter_step(stage, 0.5), "time_step: 2 ms");
    EXPECT_EQ(shorter_step(stage, 0.49), "time_step: 1 ms");
    EXPECT_EQ(shorter_step(stage, 0.02), "time_step: 0.08 ms");
    stage.control.step_error = 1e-4;
    EXPECT_EQ(shorter_step(stage, 0.5), "step_error: 0.01 mm");
    EXPECT_DOUBLE_EQ(rounded_down(0.7), 0.7);
    EXPECT_DOUBLE_EQ(rounded_down(123), 100);
}

TEST(LongestStep, IsOfADynamicStageWhereThereIsOne)
{
    std::vector<Stage> stages(3);
    stages[0].type = StageType::static_equilibrium;
    stages[0].control.time_step = 1;
    stages[1].type = stages[2].type = StageType::dynamic;
    stages[1].control.time_step = 1e-3;
    stages[2].control.time_step = 2e-3;
    EXPECT_EQ(longest_step(stages), &stages[2]);
    stages.resize(1);
    EXPECT_EQ(longest_step(stages), &stages[0]);
    EXPECT_EQ(longest_step({}), nullptr);
}

}  // namespace
}  // namespace voussoir::testing
