// The program where others have prepared its surroundings: closed descriptors, pipes, links, full devices, names
// that command a terminal or a spreadsheet.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/results/hdf5_file.h"
#include "app/results/own_folder.h"
#include "app/results/restart_file.h"
#include "app/results/results_reader.h"
#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app
{
namespace
{

namespace fs = std::filesystem;

class Surroundings : public CommandTest
{
 protected:
    void SetUp() override { folder_.write("case.yaml", two_boxes); }

    fs::path at(const std::string& name) const { return folder_.path() / name; }

    /// A whole line of the shell in the folder, $V being the program. @returns the exit code, -1 for a signal
    int shell(const std::string& line)
    {
        const std::string caught = folder_.path().string() + ".out";
        const std::string command = "cd '" + folder_.path().string() + "' && V='" VOUSSOIR_PROGRAM "' && { " +
                                    line + "; } > '" + caught + "' 2>&1";
        const int status = std::system(command.c_str());
        output_ = contents(caught);
        fs::remove(caught);
        return WIFEXITED(status) && WEXITSTATUS(status) < 128 ? WEXITSTATUS(status) : -1;
    }

    bool says(const std::string& text) const { return output_.find(text) != std::string::npos; }

    /// The results of the case are there and are whole.
    void expect_whole(const std::string& folder) const
    {
        EXPECT_EQ(results::ResultsReader(at(folder) / "results.h5").times.size(), 12U);
        EXPECT_TRUE(results::load_restart(at(folder) / "restart.bin").ended);
        EXPECT_EQ(nlohmann::json::parse(contents(at(folder) / "summary.json"))["outcome"], "completed");
    }
};

TEST_F(Surroundings, ClosedDescriptorsAreNotWrittenInto)
{
    int number = 0;
    for (const char* closed : {"<&- >&-", "<&- >&- 2>&-", ">&-", "<&-", ">&- 2>&-"}) {
        const std::string results = "closed_" + std::to_string(number++);
        EXPECT_EQ(shell("$V run case.yaml -o " + results + " " + closed), 0) << closed << "\n" << output_;
        expect_whole(results);
    }
    EXPECT_EQ(shell("$V check case.yaml --json - >&-"), 2) << "what was asked for goes nowhere";
    EXPECT_TRUE(says("standard output is closed")) << output_;
}

TEST_F(Surroundings, APipeInTheFolderIsNotWaitedFor)
{
    fs::create_directory(at("out"));
    ASSERT_EQ(mkfifo((at("out") / "restart.bin").c_str(), 0600), 0);
    EXPECT_EQ(shell("timeout -s KILL 20 $V run case.yaml -q -o out"), 0) << output_;
    EXPECT_TRUE(says("a restart.bin that this version cannot read")) << output_;
    expect_whole("out");
    for (const char* name : {"restart.bin", "results.h5"}) {
        fs::remove(at("out") / name);
        ASSERT_EQ(mkfifo((at("out") / name).c_str(), 0600), 0);
        EXPECT_EQ(shell("timeout -s KILL 20 $V run case.yaml -q -o out --resume"), 2) << output_;
    }
}

TEST_F(Surroundings, WhatIsReplacedIsNotReadIntoMemory)
{
    fs::create_directory(at("link"));
    fs::create_symlink("/dev/zero", at("link") / "restart.bin");
    fs::create_directory(at("sparse"));
    std::ofstream(at("sparse") / "restart.bin") << "voussoir restart 18\n";
    fs::resize_file(at("sparse") / "restart.bin", std::uintmax_t{1} << 40);
    for (const char* results : {"link", "sparse"}) {
        const std::string run = std::string("ulimit -t 20; $V run case.yaml -q -o ") + results;
        EXPECT_EQ(shell(run + " --resume"), 2) << output_;
        EXPECT_EQ(shell(run), 0) << output_;
        EXPECT_TRUE(says("a restart.bin that this version cannot read")) << output_;
        expect_whole(results);
    }
}

TEST_F(Surroundings, AFolderNamedAsAFile)
{
    fs::create_directories(at("out") / "restart.bin" / "inside");
    EXPECT_EQ(shell("$V run case.yaml -q -o out"), 2);
    EXPECT_TRUE(says("out/restart.bin: cannot be written: Directory not empty")) << output_;
    EXPECT_EQ(shell("$V run case.yaml -q -o out --resume"), 2);
    EXPECT_TRUE(says("not a file")) << output_;
    EXPECT_TRUE(fs::exists(at("out") / "restart.bin" / "inside"));
}

TEST_F(Surroundings, LinksThatGoRoundAreTold)
{
    fs::create_symlink("loop", at("loop"));
    for (const char* line :
         {"run case.yaml -q -o loop", "run loop -q", "check loop", "check case.yaml --json loop/x",
          "check case.yaml -o loop", "check case.yaml --json loop", "render loop", "report loop", "import loop",
          "record loop", "converge loop", "ensemble loop --vary a=1,2", "generate wall -o loop.obj/x.obj",
          "generate loop -o x.obj"}) {
        EXPECT_EQ(shell(std::string("$V ") + line + " > /dev/null"), 2) << line << "\n" << output_;
        EXPECT_FALSE(says("filesystem error") || says("basic_")) << output_;
        EXPECT_NE(output_, "") << line;
    }
}

#ifdef VOUSSOIR_HAS_PICTURES
TEST_F(Surroundings, FolderLinksAreReplacedNotFollowed)
{
    fs::create_directories(at("out"));
    fs::create_directories(at("elsewhere"));
    std::ofstream(at("elsewhere") / "snapshot_0001_t=0.000s.png") << "of another";
    fs::create_directory_symlink("../elsewhere", at("out") / "snapshots");
    EXPECT_EQ(shell("$V run case.yaml -q -o out --set 'output.snapshots={count: 1, size: [200, 200]}'"), 0)
        << output_;
    EXPECT_FALSE(fs::is_symlink(at("out") / "snapshots"));
    EXPECT_FALSE(fs::is_empty(at("out") / "snapshots"));
    fs::remove_all(at("out") / "snapshots");
    fs::create_directory_symlink("../elsewhere", at("out") / "snapshots");
    EXPECT_EQ(shell("$V render out/results.h5 --count 1 --size 200 200"), 0) << output_;
    fs::create_directory_symlink("../elsewhere", at("out") / "report");
    EXPECT_EQ(shell("$V report out --no-film -q"), 0) << output_;
    fs::create_directory_symlink("../elsewhere", at("out") / "converge");
    EXPECT_EQ(shell("$V converge case.yaml -q -o out --time-steps '4 ms,2 ms' --stiffness-factors 1"), 0)
        << output_;
    fs::create_directory_symlink("../elsewhere", at("out") / "ensemble");
    EXPECT_EQ(shell("$V ensemble case.yaml -q -o out --vary 'joints.dry.friction=29 deg,31 deg'"), 0) << output_;
    for (const char* name : {"snapshots", "report", "converge", "ensemble"})
        EXPECT_TRUE(results::is_own_folder(at("out") / name)) << name;
    EXPECT_EQ(contents(at("elsewhere") / "snapshot_0001_t=0.000s.png"), "of another");
    EXPECT_EQ(std::distance(fs::directory_iterator(at("elsewhere")), {}), 1) << "nothing was written there";
}

TEST_F(Surroundings, APictureThatIsMissingIsAFailure)
{
    fs::create_directories(at("out") / "assembly.png" / "in the way");
    EXPECT_EQ(shell("$V check case.yaml -o out"), 1);
    EXPECT_TRUE(says("voussoir-defects drew no pictures")) << output_;
    EXPECT_EQ(shell("$V check case.yaml -o free"), 0) << output_;
}

#ifdef VOUSSOIR_HAS_GEOMETRY
TEST_F(Surroundings, AnImportWhoseReaderHasHadEnoughDrawsAllTheSame)
{
    folder_.write("stones.obj",
                  "o stone\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                  "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    ASSERT_EQ(shell("$V import stones.obj -o whole"), 0) << output_;
    shell("{ $V import stones.obj -o piped; echo $? > code; } | true");
    EXPECT_EQ(contents("code"), "0\n");
    const auto count = [&](const char* folder) {
        return std::distance(fs::recursive_directory_iterator(at(folder)), {});
    };
    EXPECT_EQ(count("piped"), count("whole"));
    EXPECT_GT(count("whole"), 2);
}
#endif
#endif

// They are started by the program, but a user sees them beside it.
TEST_F(Surroundings, HelpersTellWhoStartsThem)
{
    int helpers = 0;
    for (const std::string name : {"cell", "defects", "geometry", "plot", "render", "report"}) {
        const fs::path helper = fs::path(VOUSSOIR_PROGRAM).parent_path() / ("voussoir-" + name);
        if (!fs::exists(helper)) continue;
        ++helpers;
        const int code = shell("'" + helper.string() + "' --help < /dev/null");
        EXPECT_TRUE(code == 0 || code == 2) << name << " " << code;
        EXPECT_TRUE(says("is started by voussoir") || says("Usage: ")) << name << output_;
        EXPECT_FALSE(says("exception") || says("parse_error")) << name << output_;
    }
    EXPECT_GE(helpers, 2);
}

TEST_F(Surroundings, WordsThatCannotBeWrittenAreAFailure)
{
    for (const char* line : {"check case.yaml --json -", "check case.yaml", "run case.yaml -o full", "--help",
                             "--version", "import --formats"}) {
        EXPECT_EQ(shell(std::string("$V ") + line + " > /dev/full"), 1) << line;
        EXPECT_TRUE(says("standard output: cannot be written: No space left on device")) << line << output_;
    }
    expect_whole("full");
    EXPECT_EQ(shell("$V check no.yaml > /dev/full"), 2) << "the first reason counts";
    EXPECT_EQ(shell("$V check case.yaml --json /dev/full"), 2);
    shell("{ $V run case.yaml -o piped; echo $? > code; } | true");
    EXPECT_EQ(contents("code"), "0\n") << "a reader that has had enough loses nothing";
    expect_whole("piped");
}

TEST_F(Surroundings, NamesDoNotCommandTheTerminal)
{
    const std::string clipboard = "\\e]52;c;aGk=\\a", turned = "\\u202E";
    std::string evil = with(two_boxes, "Two boxes", "\"" + clipboard + turned + "\\nthe case can be run\"");
    evil = with(evil, "name: stone,", "name: \"" + clipboard + "\",");
    folder_.write("evil.yaml", with(evil, "{block: stone}", "{block: \"" + clipboard + "\"}"));
    shell(
        "$V check evil.yaml; $V check evil.yaml --json -; $V run evil.yaml -o evil; $V check \"$(printf "
        "'a\\033[2J.yaml')\"; "
        "$V check evil.yaml --set \"$(printf 'a\\033[2J=1')\"; $V \"$(printf 'no\\033[2J')\"; "
        "$V run evil.yaml -q --\"$(printf 'no\\033[2J')\"; $V import \"$(printf 'a\\033[2J.obj')\"");
    EXPECT_TRUE(says("\\x1B]52;c;aGk=\\x07\\xE2\\x80\\xAE\\x0Athe case can be run\n")) << output_;
    EXPECT_TRUE(says("a\\x1B[2J.yaml: no such file")) << output_;
    for (const char* never : {"\x1B", "\x07", "\xE2\x80\xAE"}) EXPECT_FALSE(says(never)) << output_;
}

TEST_F(Surroundings, NamesAreNoFormulas)
{
    folder_.write("evil.yaml", with(with(two_boxes, "histories: {top:", "histories: {\"=cmd|'/c calc'!A1\":"),
                                    "name: stone,", "name: \"@SUM(A1)\","));
    folder_.write("evil.yaml", with(contents("evil.yaml"), "block: stone", "block: \"@SUM(A1)\""));
    ASSERT_EQ(shell("$V run evil.yaml -q -o out && $V check evil.yaml -o checked"), 0) << output_;
    EXPECT_EQ(contents("out/histories.csv").find("time [s],'=cmd|'/c calc'!A1 ux [m],"), 0U);
    EXPECT_NE(contents("checked/contact_graph.csv").find("'@SUM(A1)"), std::string::npos);
    const auto columns =
        results::Hdf5File::open(at("out") / "results.h5").texts_attribute("/histories/values", "columns");
    EXPECT_EQ(columns.at(1), "=cmd|'/c calc'!A1 ux [m]") << "no spreadsheet reads it";
}

TEST_F(Surroundings, AsManyHistoriesAndAsLongATitleAsOneLikes)
{
    std::string histories;
    for (int i = 0; i < 1000; ++i)
        histories += (i > 0 ? ", " : "") + ("a_history_" + std::to_string(i)) + ": {block: stone}";
    folder_.write("many.yaml",
                  with(with(two_boxes, "top: {block: stone}", histories), "Two boxes", std::string(70000, 'x')));
    ASSERT_EQ(shell("$V run many.yaml -q -o out"), 0) << output_;
    expect_whole("out");
    const results::Hdf5File file = results::Hdf5File::open(at("out") / "results.h5");
    const std::vector<std::string> columns = file.texts_attribute("/histories/values", "columns");
    ASSERT_EQ(columns.size(), 1U + 6 * 1000 + 3);
    EXPECT_EQ(columns.at(6000), "a_history_999 vz [m/s]");
    EXPECT_EQ(results::ResultsReader(at("out") / "results.h5").model.title, std::string(70000, 'x'));
    fs::remove(at("out") / "restart.bin");
    EXPECT_EQ(shell("$V report out --no-film -q"), 0) << output_;
}

TEST_F(Surroundings, AFolderOfTwoLinesIsRefusedBeforeTheRun)
{
    EXPECT_EQ(shell("$V run case.yaml -q -o \"$(printf 'one\\ntwo')\""), 2);
    EXPECT_TRUE(says("one\\x0Atwo: a folder whose name")) << output_;
    EXPECT_FALSE(fs::exists(at("one\ntwo")));
    EXPECT_EQ(
        shell("mkdir \"$(printf 'up\\nper')\" && cd \"$(printf 'up\\nper')\" && $V run ../case.yaml -q -o out"), 2)
        << output_;
}

TEST_F(Surroundings, ATooSmallStackIsToldAndDoesNotCrash)
{
    for (const char* line :
         {"run case.yaml -q -o out", "--help", "check case.yaml", "generate wall -o wall.obj"}) {
        EXPECT_EQ(shell(std::string("ulimit -s 64; $V ") + line), 1) << line << output_;
        EXPECT_TRUE(says("the stack is limited to 64 KiB")) << output_;
    }
    EXPECT_EQ(shell("ulimit -s 1024; $V run case.yaml -q -o out"), 0) << output_;
}

}  // namespace
}  // namespace voussoir::app
