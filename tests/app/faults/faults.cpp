#include "tests/app/faults/faults.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/results/restart_file.h"
#include "app/results/results_reader.h"
#include "tests/app/program_start.h"
#include "tests/app/results/killed_runs.h"

namespace voussoir::faults
{

namespace fs = std::filesystem;

namespace
{

const std::string smallest_case = R"(title: A stone slides
materials: {stone: {density: 2400 kg/m3, young: 1 GPa, poisson: 0.2}}
joints: {dry: {friction: 25 deg}}
blocks:
  - {box: {name: floor, lower: [-1, -1, -1], upper: [1, 1, 0]}, group: foundation}
  - {box: {name: stone, lower: [-0.3, -0.3, 0], upper: [0.3, 0.3, 0.5]}}
foundation: {blocks: foundation, motion: {x: {sine: {acceleration: 0.6 g, frequency: 4 Hz, duration: 20 ms}}}}
stages:
  - {name: self-weight, type: static}
  - {name: earthquake, type: dynamic, duration: 20 ms, time_step: 1 ms}
output: {every: 4 ms, histories: {top: {block: stone}}}
)";

const std::string one_stone =
    "o stone\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

std::vector<CallSite> read_sites(const fs::path& list)
{
    std::vector<CallSite> sites;
    std::ifstream lines(list);
    CallSite site;
    for (std::string owner; lines >> site.number >> site.kind >> owner >> site.program;) {
        site.ours = owner == "ours";
        sites.push_back(site);
    }
    return sites;
}

/// Of a file that is there under its own name, the last of it is there.
void expect_whole(const fs::path& file)
{
    const std::string bytes = app::contents(file), kind = file.extension();
    const auto ends_with = [&](const std::string& end, std::size_t behind = 0) {
        return bytes.size() >= end.size() + behind &&
               bytes.compare(bytes.size() - end.size() - behind, end.size(), end) == 0;
    };
    const bool grows = file.filename() == "histories.csv";  // its last line may be half
    EXPECT_TRUE(kind != ".png" || ends_with("IEND", 4)) << file;
    EXPECT_TRUE(kind != ".json" || nlohmann::json::accept(bytes)) << file;
    EXPECT_TRUE(kind != ".xdmf" || ends_with("</Xdmf>\n")) << file;
    EXPECT_TRUE(kind != ".csv" || grows || ends_with("\n")) << file;
    if (kind == ".h5") {
        EXPECT_NO_THROW(app::results::ResultsReader{file}) << file;
    }
    if (kind == ".bin") {
        EXPECT_NO_THROW(app::results::load_restart(file)) << file;
    }
}

std::vector<std::string> names_in(const fs::path& folder)
{
    std::vector<std::string> names;
    std::error_code none;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, none))
        if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder));
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

struct Scenario::Outcome {
    int exit_code = -1, signal = 0;
    std::string errors;

    std::string in_words(bool reached) const
    {
        if (!reached) return "not reached";
        return signal != 0 ? "signal " + std::to_string(signal) : "exit " + std::to_string(exit_code);
    }
};

Scenario::Scenario(std::string name, const fs::path& home) : name_(std::move(name)), home_(home)
{
    std::ofstream(home_ / "case.yaml") << smallest_case;
    std::ofstream(home_ / "stone.obj") << one_stone;
    if (name_ == "picture" || name_ == "resume") {
        Scenario run("run", home_);
        if (name_ == "resume") {
            // Stopped where the disk is full for the third frame.
            const auto is_sync = [](const CallSite& site) { return site.kind == "fdatasync"; };
            for (const CallSite& site : run.sites_) {
                if (!is_sync(site)) continue;
                fs::remove_all(home_ / "begun");
                run.prepare(home_ / "begun");
                run.start(home_ / "begun",
                          {"VOUSSOIR_FAULT_SITE=" + std::to_string(site.number), "VOUSSOIR_FAULT_TIME=3",
                           "VOUSSOIR_FAULT_FIRED=" + (home_ / "begun/fired").string()});
                if (fs::exists(home_ / "begun/fired")) break;
            }
            fs::remove(home_ / "begun/fired");
        }
        fs::rename(home_ / "right", home_ / "uninterrupted");
    }
    const fs::path list = home_ / "sites";
    prepare(home_ / "right");
    const Outcome right = start(home_ / "right", {"VOUSSOIR_FAULT_LIST=" + list.string()});
    EXPECT_EQ(right.exit_code, 0) << name_ << ": " << right.errors;
    sites_ = read_sites(list);
    fs::remove(list);
}

void Scenario::prepare(const fs::path& work) const
{
    if (name_ == "resume" && work.filename() != "begun")
        fs::copy(home_ / "begun", work, fs::copy_options::recursive);
    else
        fs::create_directory(work);
}

Scenario::Outcome Scenario::start(const fs::path& work, const std::vector<std::string>& environment) const
{
    const std::string place = work.string(), given = home_.string();
    std::map<std::string, std::vector<std::string>> commands = {
        {"run", {"run", given + "/case.yaml", "-q", "-o", place + "/out", "--save-every", "0"}},
        {"resume", {"run", given + "/case.yaml", "-q", "-o", place + "/out", "--save-every", "0", "--resume"}},
        {"import", {"import", given + "/stone.obj", "--json", place + "/stone.json", "-o", place + "/out"}},
        {"picture",
         {"render", given + "/uninterrupted/out/results.h5", "-o", place + "/out", "--count", "1", "--size", "200",
          "200"}}};
    std::vector<std::string> words = commands.at(name_);
    words.insert(words.begin(), VOUSSOIR_PROGRAM);
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    const std::string errors = place + ".errors";
    const pid_t child = fork();
    if (child == 0) {
        for (const std::string& setting : environment)
            setenv(setting.substr(0, setting.find('=')).c_str(), setting.substr(setting.find('=') + 1).c_str(), 1);
        setenv("LD_PRELOAD", VOUSSOIR_FAIL_ONCE, 1);
        const int to = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        dup2(to, STDERR_FILENO);
        alarm(120);
        execv(pointers[0], pointers.data());
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
                    app::contents(errors)};
    fs::remove(errors);
    return outcome;
}

/// What a run that failed left: the same as if it had never been disturbed, once it is resumed or begun anew.
void Scenario::check_run(const fs::path& work, const Outcome& outcome) const
{
    const fs::path whole = (name_ == "resume" ? home_ / "uninterrupted" : home_ / "right") / "out";
    const bool resumable = fs::exists(work / "out/restart.bin");
    EXPECT_TRUE(resumable || name_ != "resume") << "what was to be resumed is lost: " << outcome.errors;
    EXPECT_TRUE(resumable || outcome.errors.find("--resume continues") == std::string::npos) << outcome.errors;
    if (outcome.exit_code != 0 && resumable) {
        std::vector<std::string> words = {"run", (home_ / "case.yaml").string(), "-q",
                                          "-o",  (work / "out").string(),        "--resume"};
        const TemporaryFolder outputs;
        const app::Ended ended = app::voussoir(outputs, words);
        EXPECT_EQ(ended.exit_code, 0) << outcome.errors << ended.errors;
    }
    if (outcome.exit_code == 0 || resumable) killed_runs::expect_equal_results(work / "out", whole);
}

Scenario::Outcome Scenario::fail(const fs::path& work, const CallSite& site, int time, bool& reached) const
{
    const fs::path fired = home_ / "fired";
    prepare(work);
    Outcome outcome =
        start(work, {"VOUSSOIR_FAULT_SITE=" + std::to_string(site.number),
                     "VOUSSOIR_FAULT_TIME=" + std::to_string(time), "VOUSSOIR_FAULT_FIRED=" + fired.string()});
    reached = fs::remove(fired);
    return outcome;
}

std::string Scenario::watch_fault(const CallSite& site) const
{
    bool reached = false;
    const Outcome outcome = fail(home_ / "work", site, 1, reached);
    fs::remove_all(home_ / "work");
    return outcome.in_words(reached);
}

std::string Scenario::try_fault(const CallSite& site, int time) const
{
    const fs::path work = home_ / "work";
    bool reached = false;
    const Outcome outcome = fail(work, site, time, reached);
    EXPECT_EQ(outcome.signal, 0) << outcome.errors;
    EXPECT_TRUE(outcome.signal != 0 || (outcome.exit_code >= 0 && outcome.exit_code <= 2)) << outcome.exit_code;
    EXPECT_TRUE(outcome.exit_code <= 0 || !outcome.errors.empty()) << "a failure without a word";
    EXPECT_EQ(outcome.errors.find("terminate called"), std::string::npos) << outcome.errors;
    EXPECT_TRUE(reached || outcome.exit_code == 0) << outcome.errors;
    // As after a kill: the next run removes it.
    const bool at_once = outcome.errors.find("it ended at once") != std::string::npos;
    for (const std::string& name : names_in(work)) {
        expect_whole(work / name);
        const bool temporary = name.ends_with(".part") || name.ends_with(".next") || name.ends_with(".last");
        EXPECT_TRUE(!temporary || at_once) << name << " was left: " << outcome.errors;
    }
    EXPECT_TRUE(outcome.exit_code != 0 || names_in(work) == names_in(home_ / "right")) << outcome.errors;
    if (name_ == "run" || name_ == "resume") check_run(work, outcome);
    fs::remove_all(work);
    return outcome.in_words(reached);
}

int try_all(const Scenario& scenario, const std::vector<CallSite>& sites, int time)
{
    std::map<std::string, std::map<std::string, int>> ends;
    int lost = 0;
    for (const CallSite& site : sites) {
        const testing::TestResult& result = *testing::UnitTest::GetInstance()->current_test_info()->result();
        const int before = result.total_part_count();
        const std::string program = site.program + (site.ours ? "" : ", libraries");
        SCOPED_TRACE(scenario.name() + ": " + site.kind + " of " + program + ", site " +
                     std::to_string(site.number) + " at its call " + std::to_string(time));
        ++ends[program + ": " + site.kind][time > 0 ? scenario.try_fault(site, time) : scenario.watch_fault(site)];
        lost += result.total_part_count() > before;
    }
    for (const auto& [kind, counts] : ends) {
        std::string line;
        for (const auto& [end, count] : counts) line += "  " + end + ": " + std::to_string(count);
        std::cout << scenario.name() << ": " << kind << line << std::endl;
    }
    return lost;
}

}  // namespace voussoir::faults
