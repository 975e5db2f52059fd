// The same case file as a deformable and as a rigid scene, through the program: same answer, less of everything.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>

namespace voussoir::verification
{

namespace
{

struct Ran {
    nlohmann::json summary;
    double slid = 0;       // m, along the slope at the end
    std::string datasets;  // the bytes of results.h5, in which dataset names stand as they are
};

Ran run_incline(const std::string& kinematics)
{
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("voussoir_incline_" + kinematics);
    std::filesystem::remove_all(folder);
    const std::string command = std::string(VOUSSOIR_PROGRAM) + " run " VOUSSOIR_CASES "/incline.yaml -q -o " +
                                folder.string() + " --set kinematics=" + kinematics;
    Ran ran;
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream(folder / "summary.json") >> ran.summary;
    std::ifstream histories(folder / "histories.csv");
    std::string line, last;
    while (std::getline(histories, line)) last = line;
    std::istringstream cells(last);
    double x[4] = {};
    char comma = 0;
    cells >> x[0] >> comma >> x[1] >> comma >> x[2] >> comma >> x[3];
    ran.slid = std::hypot(x[1], x[2], x[3]);
    std::ifstream results(folder / "results.h5", std::ios::binary);
    ran.datasets.assign(std::istreambuf_iterator<char>(results), {});
    std::filesystem::remove_all(folder);
    return ran;
}

}  // namespace

TEST(RigidScene, incline_gives_the_same_answer_with_six_unknowns_and_less_memory)
{
    const Ran deformable = run_incline("spatial_deformable"), rigid = run_incline("spatial_rigid");
    const double angle = std::numbers::pi / 4, friction = std::tan(20 * std::numbers::pi / 180);
    const double exact = 0.5 * 9.80665 * (std::sin(angle) - std::cos(angle) * friction);
    for (const Ran* ran : {&deformable, &rigid}) {
        std::printf(
            "incline, %d unknowns a block: relative error %.1e, %.0f state bytes a block, %d factor entries\n",
            ran->summary["unknowns_per_block"].get<int>(), std::abs(ran->slid / exact - 1),
            ran->summary["state_bytes_per_block"].get<double>(), ran->summary["factor_entries"].get<int>());
        EXPECT_NEAR(ran->slid / exact, 1, 1e-5);
    }
    EXPECT_EQ(deformable.summary["unknowns_per_block"], 12);
    EXPECT_EQ(rigid.summary["unknowns_per_block"], 6);
    EXPECT_LT(rigid.summary["factor_entries"], deformable.summary["factor_entries"]);
    EXPECT_LT(rigid.summary["state_bytes_per_block"], deformable.summary["state_bytes_per_block"]);
    EXPECT_NE(deformable.datasets.find("stress"), std::string::npos);
    for (const char* name : {"stress", "strain"})
        EXPECT_EQ(rigid.datasets.find(std::string("/frames/") + name), std::string::npos);
    EXPECT_EQ(rigid.datasets.find("face_least_stress"), std::string::npos);
    EXPECT_LT(rigid.datasets.size(), deformable.datasets.size());
}

}  // namespace voussoir::verification
