// A full disk, a folder that may not be written, too little memory: told in a sentence, and nothing is lost.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cstdlib>

#include "app/results/restart_file.h"
#include "app/results/results_reader.h"
#include "app/results/run_lock.h"
#include "libdda/errors.h"
#include "tests/app/program_start.h"
#include "tests/app/results/killed_runs.h"

namespace voussoir::app::results
{
namespace
{

namespace fs = std::filesystem;

/// Starts the program under a limit of one resource, which this process has only while it forks.
Ended run_within(__rlimit_resource resource, rlim_t limit, const TemporaryFolder& folder,
                 const std::vector<std::string>& arguments)
{
    rlimit before{};
    getrlimit(resource, &before);
    const rlimit small{limit, before.rlim_max};
    setrlimit(resource, &small);
    const pid_t child = start(folder, arguments);
    setrlimit(resource, &before);
    return finish(folder, child);
}

/// After a failure: what was written can be read, and the run comes to the right end with --resume.
void expect_nothing_lost(const TemporaryFolder& folder, const killed_runs::Reference& reference,
                         const fs::path& results)
{
    const Restart restart = load_restart(restart_file_in(results));
    EXPECT_GE(ResultsReader(results / "results.h5").times.size(),
              static_cast<std::size_t>(restart.position.frames));
    const Ended resumed =
        voussoir(folder, {"run", reference.case_file.string(), "-q", "-o", results.string(), "--resume"});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
    killed_runs::expect_equal_results(results, reference.folder);
}

TEST(Scarcity, AFullDiskInTheMiddleOfARun)
{
    const TemporaryFolder folder;
    const killed_runs::Reference reference = killed_runs::run_through(folder.path(), killed_runs::shaken_tower);
    const auto whole = fs::file_size(reference.folder / "results.h5");
    int resumed = 0;
    for (const double share : {0.98, 0.9, 0.7, 0.4}) {
        const fs::path results = folder / ("full_" + std::to_string(share));
        const Ended ended =
            run_within(RLIMIT_FSIZE, static_cast<rlim_t>(share * static_cast<double>(whole)), folder,
                       {"run", reference.case_file.string(), "-q", "-o", results.string(), "--save-every", "0"});
        EXPECT_NE(ended.errors.find("cannot be written: File too large"), std::string::npos) << ended.errors;
        if (!fs::exists(restart_file_in(results))) continue;  // full before the first frame
        EXPECT_EQ(ended.exit_code, 1);
        EXPECT_NE(ended.errors.find("--resume continues from there"), std::string::npos) << ended.errors;
        EXPECT_FALSE(fs::exists(results / "results.h5.next")) << "takes room on the full disk";
        expect_nothing_lost(folder, reference, results);
        ++resumed;
    }
    EXPECT_GT(resumed, 0);
}

// AddressSanitizer reserves far more memory than any of these limits and does not survive them.
#ifndef __SANITIZE_ADDRESS__
TEST(Scarcity, TooLittleMemoryToBeginWith)
{
    const TemporaryFolder folder;
    const fs::path file = folder.write("case.yaml", killed_runs::shaken_tower);
    int without = 0;
    for (rlim_t megabytes = 120; megabytes >= 20; megabytes -= 10) {
        const Ended ended = run_within(RLIMIT_AS, megabytes << 20, folder,
                                       {"run", file.string(), "-q", "-o", (folder / "results").string()});
        if (ended.errors.find("loading shared libraries") != std::string::npos) break;  // not ours to say
        if (ended.exit_code == 0) continue;
        ++without;
        EXPECT_EQ(ended.exit_code, 1) << megabytes << " MiB: " << ended.errors;
        EXPECT_NE(ended.errors.find("out of memory"), std::string::npos) << megabytes << " MiB: " << ended.errors;
    }
    EXPECT_GT(without, 0);
}

TEST(Scarcity, MemoryThatRunsOutDuringTheRun)
{
    const TemporaryFolder folder;
    const killed_runs::Reference reference = killed_runs::run_through(folder.path(), killed_runs::shaken_tower);
    const fs::path results = folder / "results";
    setenv("LD_PRELOAD", VOUSSOIR_MEMORY_RUNS_OUT, 1);
    const pid_t child =
        start(folder, {"run", reference.case_file.string(), "-q", "-o", results.string(), "--save-every", "0"});
    unsetenv("LD_PRELOAD");
    const Ended ended = finish(folder, child);
    EXPECT_EQ(ended.exit_code, 1) << ended.errors;
    EXPECT_NE(ended.errors.find("out of memory"), std::string::npos) << ended.errors;
    EXPECT_NE(ended.errors.find("--resume continues from there"), std::string::npos) << ended.errors;
    expect_nothing_lost(folder, reference, results);
}

#endif

TEST(Scarcity, AFolderThatMayNotBeWritten)
{
    const TemporaryFolder folder;
    const fs::path results = folder / "locked";
    fs::create_directory(results);
    fs::permissions(folder.path(), fs::perms::owner_all | fs::perms::others_exec | fs::perms::group_exec);
    fs::permissions(
        results, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
    const bool is_root = geteuid() == 0;
    ASSERT_TRUE(!is_root || seteuid(65534) == 0);  // nothing is forbidden to root
    std::string sentence;
    try {
        const RunLock lock(results);
    } catch (const InputError& error) {
        sentence = error.what();
    }
    ASSERT_TRUE(!is_root || seteuid(0) == 0);
    EXPECT_NE(sentence.find("cannot be written: Permission denied"), std::string::npos) << sentence;
    EXPECT_TRUE(fs::is_empty(results));
}

}  // namespace
}  // namespace voussoir::app::results
