// What --resume refuses, in one sentence, and what a run into a folder in use or in second hand says.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "app/results/restart_file.h"
#include "app/results/run_lock.h"
#include "libdda/errors.h"
#include "tests/app/program_start.h"
#include "tests/app/results/killed_runs.h"

namespace voussoir::app::results
{
namespace
{

namespace fs = std::filesystem;

/// Two cubes of a mesh file, the ground moved by a record.
const std::string of_files = R"(title: Of files
materials: {stone: {density: 2400 kg/m3, young: 1 GPa, poisson: 0.2}}
joints: {dry: {friction: 25 deg}}
blocks:
  - {mesh: stones.obj, groups: {foundation: floor}}
foundation: {blocks: foundation, motion: {x: {record: record.txt, unit: m/s2}}}
stages: [{name: earthquake, type: dynamic, duration: 10 s, time_step: 1 ms}]
output: {every: 5 ms}
)";

std::string cube(const std::string& name, double lower, double upper, int first)
{
    std::string text = "o " + name + "\n";
    for (int k = 0; k < 8; ++k)
        text += "v " + std::to_string(k & 1) + " " + std::to_string((k >> 1) & 1) + " " +
                std::to_string(k < 4 ? lower : upper) + "\n";
    const int loops[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& loop : loops) {
        text += "f";
        for (const int v : loop) text += " " + std::to_string(v + first);
        text += "\n";
    }
    return text;
}

void write_files(const TemporaryFolder& folder)
{
    folder.write("case.yaml", of_files);
    folder.write("stones.obj", cube("floor", 0, 1, 1) + cube("stone", 1, 2, 9));
    folder.write("record.txt", "0.00 0.0\n0.01 1.0\n0.02 -1.0\n0.03 0.0\n");
}

std::vector<std::string> run_of(const TemporaryFolder& folder, std::vector<std::string> more = {})
{
    std::vector<std::string> arguments = {"run", (folder / "case.yaml").string(), "-q", "-o",
                                          (folder / "results").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

/// A run that has saved a frame. @returns its process, still running
pid_t running(const TemporaryFolder& folder)
{
    const pid_t child = start(folder, run_of(folder));
    for (int i = 0; i < 2000 && !fs::exists(restart_file_in(folder / "results")); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return child;
}

void kill_and_wait(pid_t child)
{
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
}

void expect_refusal(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                    const std::string& sentence)
{
    const Ended ended = voussoir(folder, arguments);
    EXPECT_EQ(ended.exit_code, 2) << ended.errors;
    EXPECT_NE(ended.errors.find(sentence), std::string::npos) << ended.errors;
    EXPECT_EQ(std::count(ended.errors.begin(), ended.errors.end(), '\n'), 1) << ended.errors;
}

TEST(ResumeRefusal, WhateverHasChanged)
{
    const TemporaryFolder folder;
    write_files(folder);
    kill_and_wait(running(folder));
    const auto resume = run_of(folder, {"--resume"});
    folder.write("record.txt", "0.00 0.0\n0.01 1.0\n0.02 -1.1\n0.03 0.0\n");
    expect_refusal(folder, resume, "changed since: a record");
    write_files(folder);
    folder.write("stones.obj", cube("floor", 0, 1, 1) + cube("stone", 1, 2.001, 9));
    expect_refusal(folder, resume, "changed since: a mesh file");
    write_files(folder);
    folder.write("case.yaml", of_files + "# a remark\n");
    expect_refusal(folder, resume, "changed since: the case file");
    write_files(folder);
    expect_refusal(folder, run_of(folder, {"--resume", "--set", "joints.dry.friction=26 deg"}),
                   "changed since: --set");
}

/// The restart file says that another engine wrote it.
void make_of_other_engine(const TemporaryFolder& folder,
                          const std::function<void(version::EngineVersion&)>& change)
{
    const fs::path file = restart_file_in(folder / "results");
    Restart restart = load_restart(file);
    change(restart.computed_from.engine);
    save_restart(restart, file);
}

// Whatever of it is another: version, commit, changes to the commit, the sources or how they were compiled.
TEST(ResumeRefusal, AnotherEngine)
{
    const TemporaryFolder folder;
    write_files(folder);
    kill_and_wait(running(folder));
    const std::string good = contents(restart_file_in(folder / "results"));
    for (const std::function<void(version::EngineVersion&)>& change :
         std::vector<std::function<void(version::EngineVersion&)>>{
             [](version::EngineVersion& engine) { engine.version = "0.1.0"; },
             [](version::EngineVersion& engine) { engine.commit = "8951b6b97059"; },
             [](version::EngineVersion& engine) {
                 engine.dirty = engine.dirty == version::Dirty::yes ? version::Dirty::no : version::Dirty::yes;
             },
             [](version::EngineVersion& engine) { engine.sources = "eb0b81037a65"; },
             [](version::EngineVersion& engine) { engine.compilation.instruction_set = "x86-65"; },
             [](version::EngineVersion& engine) { engine.compilation.compiler = "g++ 1"; }}) {
        folder.write("results/restart.bin", good);
        make_of_other_engine(folder, change);
        version::EngineVersion before = version::engine_version();
        change(before);
        expect_refusal(folder, run_of(folder, {"--resume"}),
                       "begun by another engine (" + version::in_words(before) + "; this is " +
                           version::in_words(version::engine_version()) + ")");
    }
    // What another engine would make of other files nobody knows: that they have changed comes first.
    folder.write("case.yaml", of_files + "# a remark\n");
    expect_refusal(folder, run_of(folder, {"--resume", "--other-engine"}), "changed since: the case file");
    expect_refusal(folder, run_of(folder, {"--resume"}), "changed since: the case file");
    EXPECT_EQ(voussoir(folder, run_of(folder, {"--other-engine"})).exit_code, 2)
        << "it says nothing without --resume";
}

TEST(ResumeRefusal, WhereThereIsNothing)
{
    const TemporaryFolder folder;
    write_files(folder);
    expect_refusal(folder, run_of(folder, {"--resume"}), "nothing to resume");
    EXPECT_FALSE(fs::exists(folder / "results"));
}

TEST(ResumeRefusal, DamagedFiles)
{
    const TemporaryFolder folder;
    write_files(folder);
    kill_and_wait(running(folder));
    const fs::path restart = restart_file_in(folder / "results");
    const std::string good = contents(restart);
    for (const std::size_t place : {good.size() / 2, good.size() - 1}) {
        std::string bad = good;
        bad[place] = static_cast<char>(bad[place] ^ 1);
        folder.write("results/restart.bin", bad);
        expect_refusal(folder, run_of(folder, {"--resume"}), "damaged");
    }
    folder.write("results/restart.bin", good);
    fs::rename(folder / "results/results.h5", folder / "results/elsewhere.h5");
    expect_refusal(folder, run_of(folder, {"--resume"}), "results.h5");
    fs::rename(folder / "results/elsewhere.h5", folder / "results/results.h5");
    EXPECT_EQ(voussoir(folder, run_of(folder, {"--resume", "--set", "x=1"})).exit_code, 2);
}

TEST(RunLock, ASecondRunIsRefusedAndAKilledOneLeavesNone)
{
    const TemporaryFolder folder;
    write_files(folder);
    const pid_t first = running(folder);
    const TemporaryFolder other;  // for the messages
    const Ended second = voussoir(other, run_of(folder));
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_NE(second.errors.find("another run is writing there"), std::string::npos) << second.errors;
    EXPECT_EQ(kill(first, 0), 0) << "the first one was disturbed";
    kill_and_wait(first);
    EXPECT_TRUE(fs::exists(folder / "results" / "run.lock"));
    EXPECT_NO_THROW(RunLock(folder / "results"));
    EXPECT_FALSE(fs::exists(folder / "results" / "run.lock"));
}

TEST(RunLock, ALinkLeadsNowhere)
{
    const TemporaryFolder folder;
    fs::create_directory(folder / "results");
    fs::create_symlink(folder / "elsewhere", folder / "results/run.lock");
    EXPECT_THROW(RunLock(folder / "results"), InputError);
    EXPECT_FALSE(fs::exists(folder / "elsewhere"));
}

TEST(RunLock, AnInterruptedRunIsNotReplacedSilently)
{
    const TemporaryFolder folder;
    write_files(folder);
    kill_and_wait(running(folder));
    const Ended ended = voussoir(folder, run_of(folder, {"--set", "stages[0].duration=2 ms"}));
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    EXPECT_NE(ended.errors.find("replacing an interrupted run"), std::string::npos) << ended.errors;
}

}  // namespace
}  // namespace voussoir::app::results
