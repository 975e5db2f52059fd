// The same case file as a deformable and as a rigid scene, through the program: same answer, less of everything.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/verification/program_run.h"

namespace voussoir::verification
{

TEST(RigidScene, incline_gives_the_same_answer_with_six_unknowns_and_less_memory)
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
            "incline, %d unknowns a block: relative error %.1e, %.0f state bytes a block, %d factor entries\n",
            ran->summary["unknowns_per_block"].get<int>(), std::abs(slid / exact - 1),
            ran->summary["state_bytes_per_block"].get<double>(), ran->summary["factor_entries"].get<int>());
        EXPECT_NEAR(slid / exact, 1, 1e-5);
    }
    EXPECT_EQ(deformable.summary["unknowns_per_block"], 12);
    EXPECT_EQ(rigid.summary["unknowns_per_block"], 6);
    EXPECT_LT(rigid.summary["factor_entries"], deformable.summary["factor_entries"]);
    EXPECT_LT(rigid.summary["state_bytes_per_block"], deformable.summary["state_bytes_per_block"]);
    EXPECT_NE(deformable.bytes.find("stress"), std::string::npos);
    for (const char* name : {"stress", "strain"})
        EXPECT_EQ(rigid.bytes.find(std::string("/frames/") + name), std::string::npos);
    EXPECT_EQ(rigid.bytes.find("face_least_stress"), std::string::npos);
    EXPECT_LT(rigid.bytes.size(), deformable.bytes.size());
}

}  // namespace voussoir::verification
