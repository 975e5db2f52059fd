// The built program as its user meets it: bad input gives exit code 2, one sentence with its place, and no folder.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <thread>

#include "tests/app/program_start.h"
#include "tests/app/test_files.h"

namespace voussoir::app::commands
{
namespace
{

/// A case whose only block entry is a mesh.
std::string mesh_case(const std::string& mesh)
{
    const std::size_t first = two_boxes.find("  - {box"), last = two_boxes.find("foundation: {");
    std::string text = two_boxes;
    text.replace(first, last - first, "  - {mesh: " + mesh + ", groups: {foundation: floor}}\n");
    return text;
}

/// An OBJ cube of side 1 at z, with some faces left out and one corner moved.
std::string obj_cube(const std::string& name, double z, int first_vertex, int faces = 6, double corner = 0)
{
    std::ostringstream text;
    text << "o " << name << "\n";
    for (int k = 0; k < 8; ++k)
        text << "v " << (k & 1) - (k == 7 ? corner : 0) << " " << ((k >> 1) & 1) - (k == 7 ? corner : 0) << " "
             << z + (k >> 2) - (k == 7 ? corner : 0) << "\n";
    const int loops[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int i = 0; i < faces; ++i) {  // triangles, for a moved corner bends its quadrilaterals
        const int* v = loops[i];
        const int n = first_vertex;
        // the diagonal through corner 7 keeps the dent a dent
        const int turn = v[0] == 7 || v[2] == 7 ? 0 : 1;
        text << "f " << v[turn] + n << " " << v[turn + 1] + n << " " << v[turn + 2] + n << "\n";
        text << "f " << v[turn] + n << " " << v[turn + 2] + n << " " << v[(turn + 3) % 4] + n << "\n";
    }
    return text.str();
}

/// Runs a bad case: it must end with 2, say each of `parts` in stderr, and leave no folder.
void expect_refusal(const TemporaryFolder& folder, const std::string& text, const std::vector<std::string>& parts)
{
    const std::filesystem::path file = folder.write("case.yaml", text);
    const Ended ended = voussoir(folder, {"run", file.string(), "-o", (folder / "results").string()});
    EXPECT_EQ(ended.exit_code, 2) << ended.errors;
    for (const std::string& part : parts)
        EXPECT_NE(ended.errors.find(part), std::string::npos) << part << " is not in:\n" << ended.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "results"));
}

TEST(BadInput, MissingMesh)
{
    const TemporaryFolder folder;
    expect_refusal(folder, mesh_case("nowhere.obj"), {"case.yaml:7: blocks[0].mesh: no mesh file", "nowhere.obj"});
}

TEST(BadInput, OpenMesh)
{
    const TemporaryFolder folder;
    folder.write("open.obj", obj_cube("floor", 0, 1) + obj_cube("stone", 1, 9, 5));
    expect_refusal(folder, mesh_case("open.obj"), {"case.yaml:7: blocks[0].mesh: open.obj", "stone"});
}

TEST(BadInput, StoneWithTwistedWalls)
{
    const TemporaryFolder folder;
    // A prism whose top is turned by half a turn: its walls meet in the middle.
    const std::string twisted =
        "o stone\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 1 1 2\nv 0 1 2\nv 0 0 2\nv 1 0 2\n"
        "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n";
    folder.write("crossed.obj", obj_cube("floor", 0, 1) + twisted);
    expect_refusal(folder, mesh_case("crossed.obj"),
                   {"case.yaml:7: blocks[0].mesh: crossed.obj", "stone", "cannot be cut into triangles"});
}

TEST(Run, AConcaveStoneRunsAsOneBlockOfGluedParts)
{
    const TemporaryFolder folder;
    folder.write("dented.obj", obj_cube("floor", 0, 1) + obj_cube("stone", 1, 9, 6, 0.8));
    const std::filesystem::path file = folder.write("case.yaml", mesh_case("dented.obj"));
    const Ended ended = voussoir(folder, {"run", file.string(), "-o", (folder / "results").string()});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    std::ifstream stream(folder / "results" / "summary.json");
    EXPECT_EQ(nlohmann::json::parse(stream).at("blocks"), 2);
}

TEST(BadInput, MeshOptionsNameTheirKeyAndNothingElse)
{
    const TemporaryFolder folder;
    folder.write("good.obj", obj_cube("floor", 0, 1));
    for (const std::string option :
         {"planarity: 0", "volume_error: 50 %", "close_joints: 3 kg", "stones: heap", "skip: []", "repair: mend",
          "simplify: cube", "simplify: {}", "simplify: {parts: 0}", "simplify: {volume_error: 200 %}",
          "simplify: {parts: 3, points: 7}", "hull: {a: b}"}) {
        const std::filesystem::path file = folder.write("case.yaml", mesh_case("good.obj, " + option));
        const Ended ended = voussoir(folder, {"check", file.string()});
        EXPECT_EQ(ended.exit_code, 2) << option;
        EXPECT_NE(ended.errors.find("case.yaml:7"), std::string::npos) << ended.errors;
        EXPECT_EQ(ended.errors.find("helper"), std::string::npos) << ended.errors;
    }
}

/// What a program wrote as JSON.
nlohmann::json json_in(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    return nlohmann::json::parse(stream);
}

// Three cubes of 1 m that overlap by 2 mm and gape by 1 mm: no load, and no word of compression.
TEST(DrawnFit, OfAMeshIsMeasuredAndToldByCheckAndRun)
{
    const TemporaryFolder folder;
    folder.write("loose.obj", obj_cube("floor", 0, 1) + obj_cube("stone", 0.998, 9) + obj_cube("top", 1.999, 17));
    const std::string file = folder.write("case.yaml", mesh_case("loose.obj")).string();
    const Ended check = voussoir(folder, {"check", file, "--json", (folder / "c.json").string()});
    EXPECT_EQ(check.exit_code, 0) << check.errors;
    EXPECT_NE(check.output.find("fit_tolerance = 2.1 mm"), std::string::npos) << check.output;
    EXPECT_NE(check.output.find("(floor and stone)"), std::string::npos) << check.output;
    EXPECT_EQ(check.output.find("compression"), std::string::npos) << check.output;
    EXPECT_NEAR(json_in(folder / "c.json")["fit_tolerance_m"].get<double>(), 2.1e-3, 1e-9);
    const Ended run = voussoir(folder, {"run", file, "-o", (folder / "results").string()});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_NE(run.output.find("fit_tolerance = 2.1 mm"), std::string::npos) << run.output;
    const nlohmann::json summary = json_in(folder / "results" / "summary.json");
    EXPECT_NEAR(summary["fit_tolerance_m"].get<double>(), 2.1e-3, 1e-9);
    EXPECT_EQ(summary["energy"]["start_contact_J"], 0);
    EXPECT_LT(summary["max_penetration_m"].get<double>(), 1e-4);
}

// A share of the volume beyond 1 % is a mistake, unless the user says that the survey is as bad as that.
TEST(DrawnFit, OfAMeshMayBeGivenLarger)
{
    const TemporaryFolder folder;
    folder.write("rough.obj", obj_cube("floor", 0, 1) + obj_cube("stone", 0.98, 9));
    expect_refusal(folder, mesh_case("rough.obj"), {"floor and stone", "overlap by 0.02 m3, 2 % of the smaller"});
    const std::string file = folder.write("case.yaml", mesh_case("rough.obj")).string();
    const std::vector<std::string> given = {"run", file, "-o", (folder / "results").string(), "--set"};
    for (const auto& [tolerance, exit_code] : {std::pair("fit_tolerance=19 mm", 2), {"fit_tolerance=21 mm", 0}}) {
        std::vector<std::string> arguments = given;
        arguments.emplace_back(tolerance);
        const Ended run = voussoir(folder, arguments);
        EXPECT_EQ(run.exit_code, exit_code) << tolerance << run.errors;
    }
}

TEST(MeshChoice, OneBadStoneDoesNotRefuseTheFile)
{
    const TemporaryFolder folder;
    folder.write("open.obj", obj_cube("floor", 0, 1) + obj_cube("stone", 1, 9, 5));
    const auto check = [&](const std::string& option) {
        const std::filesystem::path file = folder.write("case.yaml", mesh_case("open.obj" + option));
        return voussoir(folder, {"check", file.string(), "--set", "output.histories=null", "--json",
                                 (folder / "c.json").string()});
    };
    const Ended refused = check("");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.errors.find("give hull: \"stone\" or skip: \"stone\""), std::string::npos) << refused.errors;
    for (const std::string option :
         {", hull: stone", ", skip: [\"st?ne\"]", ", only: floor", ", repair: hull", ", repair: skip"}) {
        const Ended cured = check(option);
        EXPECT_EQ(cured.exit_code, 0) << option << cured.errors;
        std::ifstream stream(folder / "c.json");
        const nlohmann::json json = nlohmann::json::parse(stream);
        const bool hull = option.find("hull") != std::string::npos;
        EXPECT_EQ(json.at("blocks").size(), hull ? 2U : 1U) << option;
        EXPECT_EQ(json.at("files")[0].at("skipped").size(), hull ? 0U : 1U) << option;
        ASSERT_EQ(json.at("warnings").size(), 1U) << option << ": each use is told in one line";
        EXPECT_NE(json.at("warnings")[0].get<std::string>().find("stone"), std::string::npos);
    }
    const Ended mistyped = check(", repair: hull, skip: flor");
    EXPECT_EQ(mistyped.exit_code, 2);
    EXPECT_NE(mistyped.errors.find("\"flor\" matches no stone; did you mean floor?"), std::string::npos)
        << mistyped.errors;
}

TEST(BadInput, OverlappingStones)
{
    const TemporaryFolder folder;
    folder.write("overlap.obj", obj_cube("floor", 0, 1) + obj_cube("stone", 0.5, 9));
    expect_refusal(folder, mesh_case("overlap.obj"), {"case.yaml:7", "floor", "stone", "overlap by 0.5 m3"});
}

TEST(BadInput, APlanarSceneOfAStoneThatIsNoPrism)
{
    const TemporaryFolder folder;
    const std::string tetrahedron =
        "o stone\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\nf 9 11 10\nf 9 10 12\nf 10 11 12\nf 11 9 12\n";
    folder.write("mixed.obj", obj_cube("floor", 0, 1) + tetrahedron);
    expect_refusal(folder, with(mesh_case("mixed.obj"), "title: Two boxes", "kinematics: planar_rigid"),
                   {"case.yaml:7: blocks[0].mesh: mixed.obj: stone", "not a prism along y"});
}

TEST(BadInput, NegativeTimeStep)
{
    const TemporaryFolder folder;
    expect_refusal(folder, with(two_boxes, "time_step: 2 ms", "time_step: -2 ms"),
                   {"case.yaml:12: stages[1].time_step: -2 ms; must be > 0"});
}

TEST(BadInput, UnknownKey)
{
    const TemporaryFolder folder;
    expect_refusal(folder, with(two_boxes, "time_step: 2 ms", "timestep: 2 ms"),
                   {"case.yaml:12: stages[1].timestep: unknown key; did you mean time_step?"});
}

std::string case_with_record(const std::string& record)
{
    return with(two_boxes, "{blocks: foundation}", "{blocks: foundation, motion: {x: {record: " + record + "}}}");
}

TEST(BadInput, RecordWithoutUnits)
{
    const TemporaryFolder folder;
    folder.write("record.txt", "0.00 0.0\n0.01 1.0\n0.02 0.0\n");
    expect_refusal(folder, case_with_record("record.txt"),
                   {"case.yaml:9: foundation.motion.x.record: ", "record.txt", "unit"});
}

TEST(BadInput, RecordWithNan)
{
    const TemporaryFolder folder;
    folder.write("record.txt", "0.00 0.0\n0.01 nan\n0.02 0.0\n");
    expect_refusal(folder, case_with_record("record.txt, unit: g"),
                   {"case.yaml:9: foundation.motion.x.record: ", "record.txt:2", "nan"});
}

TEST(BadInput, EmptyFile)
{
    const TemporaryFolder folder;
    expect_refusal(folder, "", {"case.yaml: the file is empty"});
}

TEST(BadInput, RandomBytes)
{
    const TemporaryFolder folder;
    std::mt19937 random(7);
    for (int i = 0; i < 20; ++i) {
        std::string noise(1 + random() % 3000, ' ');
        for (char& byte : noise) byte = static_cast<char>(random());
        expect_refusal(folder, noise, {"case.yaml"});
    }
}

TEST(BadInput, DamagedCasesNeverCrash)
{
    const TemporaryFolder folder;
    std::mt19937 random(11);
    for (int i = 0; i < 60; ++i) {
        std::string text = two_boxes;
        for (int k = 0; k < 3; ++k) text[random() % text.size()] = "{}[]:,- \n\"'#&*?x0"[random() % 17];
        const Ended ended = voussoir(folder, {"check", folder.write("case.yaml", text).string()});
        EXPECT_TRUE(ended.exit_code == 0 || ended.exit_code == 2) << ended.exit_code << "\n" << text;
        EXPECT_EQ(ended.exit_code == 2, !ended.errors.empty()) << text;
    }
}

TEST(Program, BadCommandLinesAreBadInput)
{
    const TemporaryFolder folder;
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                      {"rnu"},
                                                      {"run"},
                                                      {"run", "--threads", "0", "x.yaml"},
                                                      {"run", "--threads", "some", "x.yaml"},
                                                      {"run", "x.yaml", "--set"},
                                                      {"import", "--up", "w", "x.obj"},
                                                      {"record"}})
        EXPECT_EQ(voussoir(folder, arguments).exit_code, 2);
}

// With --help, too, which was that of the whole program, with exit code 0.
TEST(Program, AnUnknownCommandIsAFaultThatNamesTheNearest)
{
    const TemporaryFolder folder;
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"rnu"},
                                                      {"rnu", "--help"},
                                                      {"--help", "rnu"},
                                                      {"rnu", "x.yaml", "-o", "made"}}) {
        const Ended ended = voussoir(folder, arguments);
        EXPECT_EQ(ended.exit_code, 2);
        EXPECT_EQ(ended.output, "");
        EXPECT_NE(ended.errors.find("voussoir: no command \"rnu\"; did you mean run?"), std::string::npos)
            << ended.errors;
    }
    const Ended ended = voussoir(folder, {"fos", "--help"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_NE(ended.errors.find("no command \"fos\"; known here: run, check, "), std::string::npos)
        << ended.errors;
}

TEST(Program, HelpsAndTellsItsVersion)
{
    const TemporaryFolder folder;
    EXPECT_NE(voussoir(folder, {"--version"}).output.find("voussoir 0."), std::string::npos);
    for (const char* command : {"run", "check", "import", "record", "render"}) {
        const Ended ended = voussoir(folder, {command, "--help"});
        EXPECT_EQ(ended.exit_code, 0);
        EXPECT_NE(ended.output.find("--help"), std::string::npos) << command;
    }
}

TEST(Program, CheckListsBlocksAndContactsAndWritesNothing)
{
    const TemporaryFolder folder;
    const Ended ended = voussoir(folder, {"check", folder.write("case.yaml", two_boxes).string()});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    EXPECT_NE(ended.output.find("1 pair of blocks, 12 points, 1 m2"), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find("left out: "), std::string::npos);
}

TEST(Program, EveryShippedCaseCanBeRun)
{
    const TemporaryFolder folder;
    int cases = 0;
    for (const auto& entry : std::filesystem::directory_iterator(VOUSSOIR_CASES)) {
        if (entry.path().extension() != ".yaml") continue;
        const Ended ended = voussoir(folder, {"check", entry.path().string()});
        EXPECT_EQ(ended.exit_code, 0) << ended.errors;
        // Only the survey has joints to be fitted. What is said of a run's trust is another matter.
        const bool surveyed = entry.path().stem() == "surveyed_dome";
        EXPECT_EQ(ended.output.find("\nwarnings:") != std::string::npos, surveyed) << ended.output;
        EXPECT_NE(ended.output.find("as drawn, all joints closed: first modes"), std::string::npos)
            << ended.output;
        ++cases;
    }
    EXPECT_GE(cases, 5);
}

TEST(Program, RunsAndKeepsItsFigures)
{
    const TemporaryFolder folder;
    const Ended ended = voussoir(folder, {"run", folder.write("case.yaml", two_boxes).string(), "-o",
                                          (folder / "results").string(), "--set", "stages[1].duration=0.1 s"});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    const auto summary = nlohmann::json::parse(contents(folder / "results" / "summary.json"));
    EXPECT_EQ(summary["outcome"].get<std::string>(), "completed");
    EXPECT_EQ(summary["blocks"], 2);
    EXPECT_EQ(summary["unconverged_steps"], 0);
    EXPECT_NEAR(summary["simulated_time_s"].get<double>(), 0.1, 1e-12);
    EXPECT_NE(ended.output.find("results.h5"), std::string::npos);
}

// A block that leans beyond its base: named, with its joint and its direction; nothing is shaken, and no picture
// drawn that nobody asked for.
TEST(Program, AMechanismIsNamedAndNotShaken)
{
    const TemporaryFolder folder;
    const Ended ended = voussoir(
        folder, {"run", folder.write("case.yaml", two_boxes).string(), "-o", (folder / "results").string(),
                 "--set", "gravity.direction=[0.9, 0, -0.1]", "--set", "joints.dry.friction=80 deg"});
    EXPECT_EQ(ended.exit_code, 5) << ended.errors;
    const auto summary = nlohmann::json::parse(contents(folder / "results" / "summary.json"));
    EXPECT_EQ(summary["outcome"].get<std::string>(), "collapsed");
    EXPECT_EQ(summary["simulated_time_s"].get<double>(), 0);
    const auto message = summary["message"].get<std::string>();
    for (const char* part :
         {"finds no equilibrium: 1 of 2 blocks is falling: '", " m towards [", "joints opened: '"})
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
    EXPECT_FALSE(std::filesystem::exists(folder / "results" / "snapshots")) << ended.output;
}

TEST(Program, AnInterruptEndsTheStepAndKeepsTheResults)
{
    const TemporaryFolder folder;
    const std::string text = with(two_boxes, "duration: 0.2 s", "duration: 100000 s");
    const std::filesystem::path histories = folder / "results" / "histories.csv";
    const pid_t child =
        start(folder, {"run", folder.write("case.yaml", text).string(), "-o", (folder / "results").string()});
    for (int i = 0; i < 600 && !std::filesystem::exists(histories); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    kill(child, SIGINT);
    const Ended ended = finish(folder, child);
    EXPECT_EQ(ended.exit_code, 4) << ended.errors;
    EXPECT_EQ(nlohmann::json::parse(contents(folder / "results" / "summary.json"))["outcome"].get<std::string>(),
              "interrupted");
}

TEST(Program, RecordTellsWhatAFileHolds)
{
    const TemporaryFolder folder;
    const std::string good = folder.write("good.txt", "0.00 0.0\n0.01 1.0\n0.02 -2.0\n0.03 0.0\n");
    const Ended ended = voussoir(folder, {"record", good, folder.write("bad.txt", "").string(), "--unit", "cm/s2",
                                          "--json", (folder / "record.json").string()});
    EXPECT_EQ(ended.exit_code, 2);  // for the second one; the first is listed all the same
    const auto files = nlohmann::json::parse(contents(folder / "record.json"));
    ASSERT_EQ(files.size(), 2);
    EXPECT_EQ(files[0]["channels"][0]["npts"], 4);
    EXPECT_NEAR(files[0]["channels"][0]["pga_m_s2"].get<double>(), 0.02, 1e-15);
    EXPECT_FALSE(files[1]["reason"].get<std::string>().empty());
}

// It might lead out of the folder, into a file that somebody else gave us to overwrite.
TEST(Program, ALinkInTheOutputFolderIsReplacedAndNotWrittenThrough)
{
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const std::string record = folder.write("record.txt", "0.00 0.0\n0.01 1.0\n0.02 -2.0\n0.03 0.0\n");
    const std::string boxes = folder.write("case.yaml", two_boxes);
    const fs::path made = folder / "made", precious = folder.write("precious", "precious");
    const std::vector<std::vector<std::string>> commands = {{"check", boxes},
                                                            {"record", record, "--unit", "cm/s2"},
                                                            {"verify", "incline-gravity-3d"},
                                                            {"stability", "sliding/k=1e+06/h=0.005"},
                                                            {"run", boxes}};
    for (std::vector<std::string> command : commands) {
        command.insert(command.end(), {"-o", made.string()});
        ASSERT_EQ(voussoir(folder, command).exit_code, 0) << command[0];
        std::vector<fs::path> files;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(made))
            if (entry.is_regular_file()) files.push_back(entry.path());
        ASSERT_FALSE(files.empty()) << command[0];
        for (const fs::path& file : files) {
            fs::remove(file);
            fs::create_symlink(precious, file);
        }
        voussoir(folder, command);  // or it refuses, which is as good
        EXPECT_EQ(contents(precious), "precious") << command[0];
        fs::remove_all(made);
    }
}

TEST(Program, ImportCertifiesEachFileByItself)
{
    const TemporaryFolder folder;
    const std::string good = folder.write("good.obj", obj_cube("stone", 0, 1));
    const std::string open = folder.write("open.obj", obj_cube("stone", 0, 1, 5));
    const Ended ended = voussoir(
        folder, {"import", good, open, "nowhere.obj", "--unit", "cm", "--json", (folder / "i.json").string()});
    EXPECT_EQ(ended.exit_code, 2);
    const auto files = nlohmann::json::parse(contents(folder / "i.json"));
    ASSERT_EQ(files.size(), 3);
    EXPECT_TRUE(files[0]["accepted"].get<bool>()) << files[0];
    EXPECT_NEAR(files[0]["stones"][0]["volume_m3"].get<double>(), 1e-6, 1e-18);
    EXPECT_NEAR(files[0]["stones"][0]["volume_file_units"].get<double>(), 1, 1e-12);
    EXPECT_EQ(files[0]["unit"]["from"].get<std::string>(), "option");
    EXPECT_FALSE(files[1]["accepted"].get<bool>());
    EXPECT_EQ(files[2]["reason"].get<std::string>(), "no such file");
}

}  // namespace
}  // namespace voussoir::app::commands
