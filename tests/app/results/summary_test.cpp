// summary.json and histories.csv say what was computed.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/results/hdf5_file.h"
#include "app/results/results_writer.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::results
{
namespace
{

nlohmann::json summary_in(const std::filesystem::path& folder)
{
    return nlohmann::json::parse(std::ifstream(folder / "summary.json"));
}

TEST(Summary, HasEveryKeyOfTheDesign)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_deformable);
    const State state = synthetic::swaying(the_case, 1);
    RunReport report;
    report.steps = 500;
    report.step_cuts = 2;
    report.energy.gravity_work = 100;
    report.energy.friction = 60;
    report.energy.kinetic = 39;
    report.seconds[static_cast<int>(Part::linear_solve)] = 1.5;
    ResultsWriter writer(the_case, folder.path());
    writer.frame(state, report);
    writer.finish(state, report, {2, 3});
    const nlohmann::json json = summary_in(folder.path());
    for (const char* key : {"case",
                            "outcome",
                            "blocks",
                            "unknowns_per_block",
                            "steps",
                            "step_cuts",
                            "unconverged_steps",
                            "open_close_iterations",
                            "iteration_acted",
                            "factorisations",
                            "cpu_time_s",
                            "wall_time_s",
                            "simulated_time_s",
                            "time_by_part",
                            "max_penetration_m",
                            "energy",
                            "left_out",
                            "warnings",
                            "factor_entries",
                            "fit_tolerance_m",
                            "state_bytes_per_block",
                            "motions",
                            "defaults",
                            "integrator",
                            "static_unbalanced",
                            "title",
                            "voussoir_version",
                            "message",
                            "kinematics",
                            "contacts",
                            "linear_iterations",
                            "deepest_overlap",
                            "fallen_blocks",
                            "overrides",
                            "files"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
    EXPECT_EQ(json["outcome"], "completed");
    EXPECT_EQ(json["blocks"], 17);
    EXPECT_EQ(json["unknowns_per_block"], 12);
    EXPECT_EQ(json["state_bytes_per_block"], (12 + 12) * 8);
    EXPECT_EQ(json["time_by_part"]["linear_solve"], 1.5);
    EXPECT_EQ(json["energy"]["residual_J"], 1);
    EXPECT_EQ(json["energy"]["residual"], 0.01);
    EXPECT_EQ(json["energy"]["friction_J"], 60);
    EXPECT_EQ(json["integrator"][1]["stage"], "earthquake");
    for (const auto& file : json["files"]) {
        EXPECT_TRUE(std::filesystem::exists(folder.path() / file.get<std::string>())) << file;
    }
}

// What a run prints is what its summary has: a run that ends before its first step has noted no joint.
TEST(Summary, HandsOverTheJointsThatItTellsOf)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid);
    ResultsWriter writer(the_case, folder.path());
    const std::vector<JointPeaks> joints = writer.finish(synthetic::swaying(the_case, 1), {}, {2, 3});
    int slid = 0;
    for (const JointPeaks& joint : joints) slid += joint.slid.has_value();
    EXPECT_GT(slid, 0);
    EXPECT_EQ(summary_in(folder.path()).at("joints").at("slid").get<int>(), slid);
}

TEST(Summary, TellsWhatFellWasCrushedAndOverlapped)
{
    const TemporaryFolder folder;
    Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    const std::string second = the_case.model.blocks[1].name, third = the_case.model.blocks[2].name;
    RunReport report;
    ResultsWriter(the_case, folder.path()).finish(synthetic::swaying(the_case, 0), report, {0, 0});
    EXPECT_EQ(summary_in(folder.path())["deepest_overlap"], nullptr);
    EXPECT_EQ(summary_in(folder.path())["fallen_blocks"], nlohmann::json::array());
    EXPECT_FALSE(summary_in(folder.path()).contains("crushed_joints")) << "no strength to judge by";
    the_case.model.materials[0].compressive_strength = 1e6;
    report.fallen = {{2, 0.5, true}, {1, 0.75, false}};
    report.crushed = {{1, 2, 1e6, 0.25, 0.3, 3e6, 0.08, 0.05, 0, false}};
    report.deepest = {0.02, 0.01, 0.006, 0.4, 1, 2, 0.003};
    ResultsWriter(the_case, folder.path()).finish(synthetic::swaying(the_case, 0), report, {0, 0});
    const nlohmann::json json = summary_in(folder.path());
    EXPECT_EQ(json["fallen_blocks"], (nlohmann::json{{{"block", third}, {"time_s", 0.5}, {"left", true}},
                                                     {{"block", second}, {"time_s", 0.75}, {"left", false}}}));
    EXPECT_EQ(json["crushed_joints"], (nlohmann::json{{{"blocks", {second, third}},
                                                       {"compressive_strength_Pa", 1e6},
                                                       {"first_time_s", 0.25},
                                                       {"worst_time_s", 0.3},
                                                       {"worst_edge_stress_Pa", 3e6},
                                                       {"duration_s", 0.08},
                                                       {"longest_s", 0.05},
                                                       {"at_rest", false},
                                                       {"lasting", true}}}));
    EXPECT_EQ(json["deepest_overlap"], (nlohmann::json{{"blocks", {second, third}},
                                                       {"depth_m", 0.01},
                                                       {"forgiven_m", 0.006},
                                                       {"drawn_m", 0.003},
                                                       {"fraction_of_width", 0.02},
                                                       {"share_of_width", 0.02},  // former name
                                                       {"time_s", 0.4}}));
}

TEST(Summary, TellsOfEveryJointWhatItDidAndDoes)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid, 3);
    State state = initial_state(the_case.model);
    state.step = 1;
    const std::size_t third = 3 * static_cast<std::size_t>(coordinates_per_block(the_case.model.kinematics));
    state.coordinates[third] += 3e-3;      // the uppermost drum slides along x
    state.coordinates[third + 2] += 5e-3;  // and is lifted
    RunReport report;
    report.joints = {{0, 1, 2e-4, 0, 0.25, {}}, {1, 2, 0, 0, {}, {}}, {2, 3, 8e-3, 4e-3, 0.5, 0.75}};
    ResultsWriter(the_case, folder.path()).finish(state, report, {0, 0});
    const nlohmann::json joints = summary_in(folder.path())["joints"];
    EXPECT_EQ(joints["count"], 3);
    EXPECT_EQ(joints["opened"], 2);
    EXPECT_EQ(joints["slid"], 1);
    EXPECT_EQ(joints["broken"], 0);
    EXPECT_EQ(joints["counts_from_m"], noteworthy_opening);
    ASSERT_EQ(joints["list"].size(), 3U);
    const nlohmann::json &still = joints["list"][1], &moved = joints["list"][2];
    EXPECT_EQ(still["blocks"], (nlohmann::json{"drum_1", "drum_2"}));
    EXPECT_NEAR(still["area_m2"].get<double>(), 2.25, 1e-12);
    EXPECT_NEAR(still["facing_area_m2"].get<double>(), 2.25, 1e-12);
    EXPECT_EQ(still["opened_time_s"], nullptr);
    EXPECT_NEAR(still["opening_m"].get<double>(), 0, 1e-12);
    EXPECT_NEAR(moved["opening_m"].get<double>(), 5e-3, 1e-12);
    EXPECT_NEAR(moved["mean_opening_m"].get<double>(), 5e-3, 1e-12);
    EXPECT_NEAR(moved["slip_m"].get<double>(), 3e-3, 1e-12);
    EXPECT_EQ(moved["largest_opening_m"], 8e-3);
    EXPECT_EQ(moved["largest_slip_m"], 4e-3);
    EXPECT_EQ(moved["opened_time_s"], 0.5);
    EXPECT_EQ(moved["slid_time_s"], 0.75);
    EXPECT_EQ(moved["normal_force_N"], 0);
    EXPECT_EQ(moved["broken"], false);
    const Hdf5File file = Hdf5File::open(folder.path() / "results.h5");
    EXPECT_EQ(file.read<double>("/joints/largest_opening"), (std::vector<double>{2e-4, 0, 8e-3}));
    EXPECT_EQ(file.read<double>("/joints/slid_time")[2], 0.75);
    EXPECT_TRUE(std::isnan(file.read<double>("/joints/opened_time")[1]));
}

TEST(Summary, ListsTheThousandJointsThatMovedMost)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::tower(Kinematics::planar_rigid, 1200);
    State state = initial_state(the_case.model);
    state.step = 1;
    RunReport report;
    report.joints = no_peaks(joints_at_start(the_case.model, state));
    ASSERT_EQ(report.joints.size(), 1200U);
    for (std::size_t i = 0; i < 1200; ++i)
        (i % 2 == 0 ? report.joints[i].opening : report.joints[i].slip) = 1e-6 * i;
    ResultsWriter(the_case, folder.path()).finish(state, report, {0, 0});
    const nlohmann::json joints = summary_in(folder.path())["joints"];
    EXPECT_EQ(joints["count"], 1200);
    EXPECT_EQ(joints["listed"], 1000);
    ASSERT_EQ(joints["list"].size(), 1000U);
    EXPECT_EQ(joints["list"][0]["blocks"][1], "drum_201");
    EXPECT_EQ(joints["list"][999]["blocks"][1], "drum_1200");
    EXPECT_EQ(Hdf5File::open(folder.path() / "results.h5").read<double>("/joints/largest_slip").size(), 1200U);
}

TEST(Summary, EveryKeyIsInTheDocument)
{
    const TemporaryFolder folder;
    Case the_case = synthetic::tower(Kinematics::planar_deformable);
    the_case.model.materials[0].compressive_strength = 1e6;
    ResultsWriter(the_case, folder.path()).finish(synthetic::swaying(the_case, 0), {}, {0, 0});
    std::ostringstream text;
    text << std::ifstream(VOUSSOIR_DOCS "/results_format.md").rdbuf();
    const nlohmann::json json = summary_in(folder.path());
    for (const nlohmann::json& map :
         {json, json.at("energy"), json.at("joints"), json.at("joints").at("list").at(0)})
        for (const auto& [key, value] : map.items())
            EXPECT_NE(text.str().find("`" + key + "`"), std::string::npos) << key;
}

TEST(Summary, ARigidStateTakesFewerBytes)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid);
    ResultsWriter writer(the_case, folder.path());
    writer.finish(synthetic::swaying(the_case, 0), {}, {0, 0});
    EXPECT_EQ(summary_in(folder.path())["state_bytes_per_block"], (7 + 6) * 8);
    EXPECT_EQ(summary_in(folder.path())["unknowns_per_block"], 6);
}

std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

TEST(Histories, APointOffTheCentroidMovesWithItsBlock)
{
    const TemporaryFolder folder;
    Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    the_case.model.origin = {1000, 2000, 0};
    the_case.output.histories = {{"corner", "drum_1", Eigen::Vector3d(1000.75, 2000, 1)}};
    State state = initial_state(the_case.model);
    state.time = 0.25;
    const double angle = 0.3, omega = 2;  // drum_1 turns about y through its centroid (0, 0, 0.5)
    double* x = state.coordinates.data() + 7;
    x[3] = std::cos(angle / 2);
    x[5] = std::sin(angle / 2);
    state.velocities[6 + 4] = omega;
    ResultsWriter writer(the_case, folder.path());
    writer.history(state, {}, {});
    std::ifstream unread(folder.path() / "histories.csv");
    writer.frame(state, {});  // a frame flushes the lines
    std::string header, line;
    std::ifstream stream(folder.path() / "histories.csv");
    std::getline(stream, header);
    std::getline(stream, line);
    EXPECT_EQ(header,
              "time [s],corner ux [m],corner uy [m],corner uz [m],corner vx [m/s],corner vy [m/s],corner vz [m/s],"
              "ground ux [m],ground uy [m],ground uz [m]");
    const std::vector<std::string> cells = split(line);
    ASSERT_EQ(cells.size(), 10U);
    const double c = std::cos(angle), s = std::sin(angle);
    const double rx = c * 0.75 + s * 0.5, rz = -s * 0.75 + c * 0.5;  // the lever (0.75, 0, 0.5), turned
    EXPECT_DOUBLE_EQ(std::stod(cells[0]), 0.25);
    EXPECT_NEAR(std::stod(cells[1]), rx - 0.75, 1e-12);
    EXPECT_NEAR(std::stod(cells[3]), rz - 0.5, 1e-12);
    EXPECT_NEAR(std::stod(cells[4]), omega * rz, 1e-12);
    EXPECT_NEAR(std::stod(cells[6]), -omega * rx, 1e-12);
    EXPECT_EQ(std::stod(cells[7]), 0);
}

TEST(Histories, NoPointNoFile)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    ResultsWriter writer(the_case, folder.path());
    writer.history(initial_state(the_case.model), {}, {});
    writer.finish(initial_state(the_case.model), {}, {0, 0});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "histories.csv"));
}

// The most important thing that an error estimate can say is no difference.
TEST(Summary, WarnsWhenARunOfTheErrorEstimateEndsOtherwise)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid);
    const State state = synthetic::swaying(the_case, 1);
    ResultsWriter writer(the_case, folder.path());
    writer.frame(state, {});
    writer.note(ErrorEstimate{{{"half the time step", "half_step", "collapsed: 3 of 9 blocks have fallen"},
                               {"twice the stiffness", "twice_stiffness", "completed"}},
                              {}});
    writer.finish(state, {}, {2, 3});
    const nlohmann::json warnings = summary_in(folder.path()).at("warnings");
    ASSERT_EQ(warnings.size(), 1U) << warnings;
    EXPECT_EQ(
        warnings.at(0).get<std::string>().rfind("with half the time step the run ends otherwise (collapsed: 3 of "
                                                "9 blocks have fallen; here completed)",
                                                0),
        0U)
        << warnings;
}

}  // namespace
}  // namespace voussoir::app::results
