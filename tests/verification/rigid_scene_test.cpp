// The same case file as a deformable and as a rigid scene, through the program: same answer, less of everything.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/program_run.h"

namespace voussoir::verification
{

TEST(RigidScene, InclineGivesTheSameAnswerWithSixUnknownsAndLessMemory)
{
    const std::filesystem::path incline = VOUSSOIR_CASES "/incline.yaml";
    const ProgramRun deformable = run_case(incline, {"kinematics=spatial_deformable"}),
                     rigid = run_case(incline, {"kinematics=spatial_rigid"});
    const double angle = std::numbers::pi / 4, friction = std::tan(20 * std::numbers::pi / 180);
    const double exact = 0.5 * 9.80665 * (std::sin(angle) - std::cos(angle) * friction);
    for (const ProgramRun* ran : {&deformable, &rigid}) {
        ASSERT_EQ(ran->status, 0);
        const double slid =
            std::hypot(ran->last("block ux [m]"), ran->last("block uy [m]"), ran->last("block uz [m]"));
        std::printf(
            "incline, %.0f unknowns a block: relative error %.1e, %.0f state bytes a block, %.0f factor entries\n",
            ran->figure("unknowns_per_block"), std::abs(slid / exact - 1), ran->figure("state_bytes_per_block"),
            ran->figure("factor_entries"));
        EXPECT_NEAR(slid / exact, 1, 1e-5);
    }
    EXPECT_EQ(deformable.figure("unknowns_per_block"), 12);
    EXPECT_EQ(rigid.figure("unknowns_per_block"), 6);
    EXPECT_LT(rigid.figure("factor_entries"), deformable.figure("factor_entries"));
    EXPECT_LT(rigid.figure("state_bytes_per_block"), deformable.figure("state_bytes_per_block"));
    for (const char* dataset : {"stress", "face_least_stress", "face_greatest_stress"}) {
        EXPECT_TRUE(deformable.has_dataset(dataset)) << dataset;
        EXPECT_FALSE(rigid.has_dataset(dataset)) << dataset;
    }
    EXPECT_LT(rigid.bytes.size(), deformable.bytes.size());
}

}  // namespace voussoir::verification
