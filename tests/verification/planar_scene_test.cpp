// The same case files as spatial and as planar scenes, through the program: same answer, nothing of what lies
// across.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/temporary_folder.h"
#include "tests/verification/program_run.h"

namespace voussoir::verification
{

namespace
{

const std::filesystem::path cases = VOUSSOIR_CASES;

/// Rows from the end that both runs have: a static stage may take a step more in one of them.
std::size_t common_rows(const ProgramRun& plane, const ProgramRun& space)
{
    return std::min(plane.rows.size(), space.rows.size());
}

std::size_t column_of(const ProgramRun& ran, const std::string& name)
{
    return std::find(ran.columns.begin(), ran.columns.end(), name) - ran.columns.begin();
}

/// Largest difference of the columns of the planar run, relative to the spatial run's largest displacement or
/// velocity.
double largest_difference(const ProgramRun& plane, const ProgramRun& space)
{
    double apart[2] = {0, 0}, size[2] = {0, 0};  // displacements, velocities
    for (std::size_t i = 1; i < plane.columns.size(); ++i) {
        const std::size_t k = column_of(space, plane.columns[i]);
        const int kind = plane.columns[i].find("[m/s]") != std::string::npos ? 1 : 0;
        for (std::size_t row = 1; row <= common_rows(plane, space); ++row) {
            const auto& here = plane.rows[plane.rows.size() - row];
            const auto& there = space.rows[space.rows.size() - row];
            EXPECT_EQ(here[0], there[0]) << "times";
            apart[kind] = std::max(apart[kind], std::abs(here[i] - there.at(k)));
            size[kind] = std::max(size[kind], std::abs(there[k]));
        }
    }
    return std::max(apart[0] / size[0], apart[1] / size[1]);
}

}  // namespace

TEST(PlanarScene, InclineGivesTheSameAnswerWithSixAndThreeUnknownsAndLessMemory)
{
    const double angle = std::numbers::pi / 4, friction = std::tan(20 * std::numbers::pi / 180);
    const double exact = 0.5 * 9.80665 * (std::sin(angle) - std::cos(angle) * friction);
    const auto run = [](const char* kinematics) {
        // Far below the default, lest iterations that stop at other residuals hide the arithmetic.
        return run_case(cases / "incline.yaml",
                        {std::string("kinematics=") + kinematics, "stages[0].force_tolerance=5e-10"});
    };
    const ProgramRun space = run("spatial_rigid"), rigid = run("planar_rigid"),
                     deformable = run("planar_deformable");
    for (const ProgramRun* ran : {&space, &deformable, &rigid}) {
        ASSERT_EQ(ran->status, 0);
        const double slid = std::hypot(ran->last("block ux [m]"), ran->last("block uz [m]"));
        std::printf(
            "incline, %s: relative error %.1e, %.0f state bytes a block, %.0f factor entries, %zu bytes of "
            "results\n",
            ran->word("kinematics").c_str(), std::abs(slid / exact - 1), ran->figure("state_bytes_per_block"),
            ran->figure("factor_entries"), ran->bytes.size());
        EXPECT_NEAR(slid / exact, 1, 1e-5);
    }
    const double apart = largest_difference(rigid, space);
    std::printf("incline, rigid, planar against spatial: histories differ by %.1e\n", apart);
    EXPECT_LT(apart, 1e-9);
    EXPECT_EQ(rigid.figure("state_bytes_per_block"), 48);
    EXPECT_EQ(deformable.figure("state_bytes_per_block"), 96);
    EXPECT_EQ(rigid.columns.size(), 7);
    EXPECT_EQ(4 * rigid.figure("factor_entries"), space.figure("factor_entries"));
    EXPECT_LT(rigid.bytes.size(), space.bytes.size());
    EXPECT_TRUE(deformable.has_dataset("stress"));
    EXPECT_FALSE(rigid.has_dataset("stress"));
}

// Four hinges form at 0.3736 g by virtual work over all sets of four hinges of this arch.
// Source: [Oppenheim1992] (0.37 g).
TEST(PlanarScene, ArchStandsBelowItsLimitAndFallsAboveIt)
{
    const std::vector<std::string> still = {"output=null", "foundation.motion=null"};
    const auto tilted = [&](const char* direction) {
        std::vector<std::string> settings = still;
        settings.push_back(std::string("gravity.direction=") + direction);
        return run_case(cases / "arch_planar.yaml", settings);
    };
    const ProgramRun stands = tilted("[0.37, -1]"), falls = tilted("[0.38, -1]");
    EXPECT_EQ(stands.word("outcome"), "completed");
    EXPECT_EQ(falls.word("outcome"), "collapsed");
    EXPECT_NE(falls.word("message").find("finds no equilibrium"), std::string::npos) << falls.word("message");
}

TEST(PlanarScene, ACaseWithoutMeshesAndPicturesStartsNoHelper)
{
    const TemporaryFolder alone;
    copy_file(VOUSSOIR_PROGRAM, alone / "voussoir");  // its helpers would stand beside it
    const ProgramRun ran = run_case(cases / "arch_planar.yaml",
                                    {"output.snapshots=null", "stages[1].duration=0.1 s"}, alone / "voussoir");
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.word("outcome"), "completed");
}

// Mosca's bridge, its stones being prisms along y, shaken along and up and down.
TEST(PlanarScene, BridgeMovesLikeTheSpatialOne)
{
    const auto run = [](const char* kinematics) {
        return run_case(cases / "mosca_bridge.yaml",
                        {std::string("kinematics=") + kinematics, "foundation.motion.y=null",
                         "joints.dry.face=corners", "output.snapshots=null", "stages[1].duration=0.5 s",
                         "stages[0].force_tolerance=1e-9", "stages[1].force_tolerance=1e-9"});
    };
    const ProgramRun plane = run("planar_rigid"), space = run("spatial_rigid");
    ASSERT_EQ(plane.status, 0);
    ASSERT_EQ(space.status, 0);
    ASSERT_GT(common_rows(plane, space), 250);  // 0.5 s at 2 ms
    const double apart = largest_difference(plane, space);
    std::printf(
        "bridge, rigid, planar and spatial: crown %.3f and %.3f mm down, histories differ by %.1e;\n"
        "  %.1f and %.1f s of processor, %.0f and %.0f factor entries, %zu and %zu bytes of results\n",
        -1e3 * plane.last("crown uz [m]"), -1e3 * space.last("crown uz [m]"), apart, plane.figure("cpu_time_s"),
        space.figure("cpu_time_s"), plane.figure("factor_entries"), space.figure("factor_entries"),
        plane.bytes.size(), space.bytes.size());
    EXPECT_LT(apart, 1e-7);
    EXPECT_EQ(4 * plane.figure("factor_entries"), space.figure("factor_entries"));
    EXPECT_LT(plane.bytes.size(), space.bytes.size());
}

}  // namespace voussoir::verification
