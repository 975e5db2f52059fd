// A case whose two supports have records of their own, through the program: how a user moves the abutments of a
// bridge differently.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "tests/temporary_folder.h"
#include "tests/verification/program_run.h"
#include "tests/verification/three_hinged_arch.h"

namespace voussoir::verification
{

namespace
{

// The arch of three_hinged_arch.h. The records are displacements, in mm, as a levelling would give them.
const std::string case_text = R"(title: An arch whose supports move differently
kinematics: planar_rigid
materials: {stone: {density: 2500 kg/m3, young: 10 GPa, poisson: 0.2}}
joints: {dry: {friction: 60 deg}}
blocks:
  - polygon: {name: support_left, corners: [[-3.5, -0.5], [-1.2, -0.5], [-1.2, 0], [-3.5, 0]]}
    group: left
  - polygon: {name: support_right, corners: [[1.2, -0.5], [3.5, -0.5], [3.5, 0], [1.2, 0]]}
    group: right
  - polygon: {name: half_left, corners: [[-2.6, 0], [-2, 0], [0, 1.6], [0, 2.3]]}
  - polygon: {name: half_right, corners: [[2, 0], [2.6, 0], [0, 2.3], [0, 1.6]]}
foundation:
  - {blocks: left, motion: {x: {record: left.txt, unit: mm}}}
  - {blocks: right, motion: {x: {record: right.txt, unit: mm}}}
stages:
  - {name: self-weight, type: static}
  - {name: settlement, type: dynamic, duration: 5 s, time_step: 2 ms, damping: {rate: 5 1/s}}
output:
  histories:
    left: {block: half_left, point: [0, HINGE]}
    right: {block: half_right, point: [0, HINGE]}
)";

/// Time [s] and displacement [mm], two columns.
void write_record(const std::filesystem::path& file, double end)
{
    std::ofstream stream(file);
    int i = 0;
    for (const double sample : slow_ramp(end)) {
        char line[64];
        std::snprintf(line, sizeof line, "%.2f %.12g\n", ramp_step * i++, 1e3 * sample);
        stream << line;
    }
}

/// Runs the case with supports that end up moved by `left` and `right` [m].
ProgramRun run_with_supports(double left, double right)
{
    const TemporaryFolder folder;
    write_record(folder / "left.txt", left);
    write_record(folder / "right.txt", right);
    std::string text = case_text;
    const std::string hinge = std::to_string(ThreeHingedArch{}.hinge_height(right > left));
    for (std::size_t at; (at = text.find("HINGE")) != std::string::npos;) text.replace(at, 5, hinge);
    return run_case(folder.write("arch.yaml", text), {});
}

}  // namespace

TEST(MovedSupportsCase, TwoFoundationsWithRecordsOfTheirOwnOpenAndCloseAnArch)
{
    const ThreeHingedArch arch;
    const double ends[][2] = {{-0.06, 0.14}, {0.02, -0.1}};
    for (const auto& [left, right] : ends) {
        const ProgramRun ran = run_with_supports(left, right);
        ASSERT_EQ(ran.status, 0);
        const double up = (ran.last("left uz [m]") + ran.last("right uz [m]")) / 2,
                     sideways = (ran.last("left ux [m]") + ran.last("right ux [m]")) / 2;
        const ThreeHingedArch::Moved exact = arch.crown(left, right);
        std::printf("supports %+.0f and %+.0f mm: crown %+.3f mm (%+.3f) and %+.3f mm sideways (%+.3f)\n",
                    1e3 * left, 1e3 * right, 1e3 * up, 1e3 * exact.up, 1e3 * sideways, 1e3 * exact.sideways);
        const double penetration = ran.figure("max_penetration_m");
        EXPECT_NEAR(up, exact.up, arch.give(penetration, right > left));
        EXPECT_NEAR(sideways, exact.sideways, 0.2 * penetration);
        EXPECT_LT(penetration, 1e-4);
    }
}

}  // namespace voussoir::verification
