#include "tests/app/results/killed_runs.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>
#include <thread>

#include "app/results/restart_file.h"
#include "app/results/results_reader.h"
#include "tests/app/program_start.h"
#include "tests/app/results/every_dataset.h"

namespace voussoir::killed_runs
{

namespace fs = std::filesystem;

const std::string shaken_tower = R"(title: A shaken tower
materials: {stone: {density: 2400 kg/m3, young: 1 GPa, poisson: 0.2}}
joints: {dry: {friction: 25 deg}}
blocks:
  - {box: {name: floor, lower: [-1, -1, -1], upper: [1, 1, 0]}, group: foundation}
  - {box: {name: first, lower: [-0.3, -0.3, 0], upper: [0.3, 0.3, 0.5]}}
  - {box: {name: second, lower: [-0.25, -0.3, 0.5], upper: [0.35, 0.3, 1]}}
  - {box: {name: third, lower: [-0.3, -0.25, 1], upper: [0.3, 0.35, 1.6]}}
foundation: {blocks: foundation, motion: {x: {sine: {acceleration: 0.6 g, frequency: 4 Hz, duration: 0.25 s}}}}
stages:
  - {name: self-weight, type: static, gravity_increments: 4, time_step: 10 ms}
  - {name: earthquake, type: dynamic, duration: 0.3 s, time_step: 1 ms}
  - {name: afterwards, type: static, time_step: 20 ms, max_static_steps: 4000}
output: {every: 6 ms, histories: {top: {block: third}}}
)";

const std::string shaken_frame = R"(title: Two columns and a beam
kinematics: planar_rigid
thickness: 1 m
materials: {stone: {density: 2400 kg/m3, young: 5 GPa, poisson: 0.2}}
joints: {dry: {friction: 30 deg}}
blocks:
  - {box: {name: floor, lower: [-3, 0, -1], upper: [3, 1, 0]}, group: foundation}
  - {box: {name: left, lower: [-1.5, 0, 0], upper: [-1, 1, 2]}}
  - {box: {name: right, lower: [1, 0, 0], upper: [1.5, 1, 2]}}
  - {box: {name: beam, lower: [-1.6, 0, 2], upper: [1.6, 1, 2.4]}}
foundation: {blocks: foundation, motion: {x: {sine: {acceleration: 0.7 g, frequency: 2 Hz, duration: 0.5 s}}}}
stages:
  - {name: self-weight, type: static}
  - {name: earthquake, type: dynamic, duration: 0.6 s, time_step: 2 ms}
output: {every: 6 ms, histories: {beam: {block: beam}}}
)";

namespace
{

std::vector<std::string> arguments_of(const Reference& reference, const fs::path& folder, bool resume)
{
    std::vector<std::string> arguments = {
        "run", reference.case_file.string(), "-q", "-o", folder.string(), "--save-every", reference.save_every};
    if (resume) arguments.emplace_back("--resume");
    return arguments;
}

/// The rows of the frames that a killed run left are those of the reference.
void expect_beginning_of(const Reference& reference, const fs::path& results, std::int64_t frames)
{
    const app::results::ResultsReader killed(results), whole(reference.folder / "results.h5");
    ASSERT_LE(frames, static_cast<std::int64_t>(killed.times.size())) << "more than was promised was lost";
    if (reference.save_every == "0") {
        ASSERT_LE(static_cast<std::int64_t>(killed.times.size()), frames + 1) << "frames without a restart file";
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
        const app::results::RecordedFrame found = killed.frame(i), right = whole.frame(i);
        ASSERT_EQ(found.time, right.time) << i;
        ASSERT_EQ(found.state.coordinates, right.state.coordinates) << i;
        ASSERT_EQ(found.state.velocities, right.state.velocities) << i;
        ASSERT_EQ(found.contacts.size(), right.contacts.size()) << i;
        ASSERT_EQ(found.joints.size(), right.joints.size()) << i;
        for (std::size_t j = 0; j < found.joints.size(); ++j)
            ASSERT_EQ(found.joints[j].motion.opening, right.joints[j].motion.opening) << i;
    }
}

/// Everything can be read, whatever the moment of the kill. Whether there is something to go on from is counted.
/// @param frames that the life which was killed went on from; 0 if it began anew. What there was is still there.
/// @returns the frames to go on from
std::int64_t check_what_is_left(const Reference& reference, const fs::path& folder, std::int64_t frames,
                                Kills& kills)
{
    const fs::path results = folder / "results.h5", restart_file = app::results::restart_file_in(folder);
    if (!fs::exists(restart_file)) {
        EXPECT_EQ(frames, 0) << "a run that went on lost what it went on from";
        ++kills.before_a_frame;
        return 0;
    }
    const app::results::Restart restart = app::results::load_restart(restart_file);
    if (restart.ended) {  // of the run before, which this one had no time to replace, or killed at its very end
        ++kills.before_a_frame;
        EXPECT_EQ(app::results::every_dataset(results),
                  app::results::every_dataset(reference.folder / "results.h5"));
        return 0;
    }
    EXPECT_GE(restart.position.frames, frames) << "a run that went on fell back";
    EXPECT_NO_THROW(app::results::every_dataset(results));
    expect_beginning_of(reference, results, restart.position.frames);
    const bool more =
        app::results::ResultsReader(results).times.size() > static_cast<std::size_t>(restart.position.frames);
    if (more || fs::exists(folder / "restart.bin.part") || fs::exists(folder / "results.h5.last"))
        ++kills.during_output;
    return restart.position.frames;
}

nlohmann::json summary_without_times(const fs::path& folder)
{
    nlohmann::json summary = nlohmann::json::parse(app::contents(folder / "summary.json"));
    for (const char* key : {"wall_time_s", "cpu_time_s", "time_by_part"}) summary.erase(key);
    return summary;
}

}  // namespace

void expect_equal_results(const fs::path& folder, const fs::path& reference)
{
    EXPECT_EQ(app::results::every_dataset(folder / "results.h5"),
              app::results::every_dataset(reference / "results.h5"));
    EXPECT_EQ(app::contents(folder / "histories.csv"), app::contents(reference / "histories.csv"));
    // Where in results.h5 the values lie may differ.
    const std::regex address("Seek=\"[0-9]+\"");
    EXPECT_EQ(std::regex_replace(app::contents(folder / "results.xdmf"), address, ""),
              std::regex_replace(app::contents(reference / "results.xdmf"), address, ""));
    EXPECT_EQ(summary_without_times(folder), summary_without_times(reference));
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename();
        EXPECT_TRUE(fs::exists(reference / name)) << name << " was left over";
    }
}

Reference run_through(const fs::path& work, const std::string& case_text)
{
    Reference reference{work / "case.yaml", work / "reference", 0, "0"};
    std::ofstream(reference.case_file) << case_text;
    const TemporaryFolder output;
    const auto start = std::chrono::steady_clock::now();
    const app::Ended ended = app::voussoir(output, arguments_of(reference, reference.folder, false));
    reference.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    return reference;
}

Kills kill_and_resume(const Reference& reference, const fs::path& folder, int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> moment(0, 0.5 * reference.wall_time);
    std::bernoulli_distribution politely(0.2);
    const TemporaryFolder output;
    Kills kills;
    std::int64_t frames = 0;  // to go on from
    for (int life = 0; kills.kills < count && life < 10 * count && !testing::Test::HasFailure(); ++life) {
        const pid_t child = app::start(output, arguments_of(reference, folder, frames > 0));
        std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
        const int sent = politely(random) ? SIGINT : SIGKILL;
        kill(child, sent);
        const app::Ended ended = app::finish(output, child);
        // Of SIGINT it may also die, before it listens.
        EXPECT_TRUE(ended.signal == sent || (ended.signal == 0 && (ended.exit_code == 4 || ended.exit_code == 0)))
            << "signal " << ended.signal << ", exit code " << ended.exit_code << ": " << ended.errors;
        if (ended.exit_code == 0) {
            expect_equal_results(folder, reference.folder);
            kills.resumed_to_the_end += frames > 0;
            frames = 0;  // the next one begins anew, in the same folder
            continue;
        }
        frames = check_what_is_left(reference, folder, frames, kills);
        if (ended.exit_code == 4) ++kills.interrupts;
        if (ended.signal != 0 && frames > 0) ++kills.kills;  // one that left nothing to go on from proves nothing
    }
    const app::Ended ended = app::voussoir(output, arguments_of(reference, folder, frames > 0));
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    expect_equal_results(folder, reference.folder);
    kills.resumed_to_the_end += frames > 0;
    return kills;
}

void kill_many(const std::string& case_text, int count, unsigned seed, const std::string& save_every)
{
    const TemporaryFolder folder;
    Reference reference = run_through(folder.path(), case_text);
    reference.save_every = save_every;
    const Kills kills = kill_and_resume(reference, folder / "killed", count, seed);
    std::printf(
        "%d kills and %d interrupts, %d of them while something was written, %d before the first frame; %d "
        "runs came to their end and equal the uninterrupted one of %.2f s\n",
        kills.kills, kills.interrupts, kills.during_output, kills.before_a_frame, kills.resumed_to_the_end,
        reference.wall_time);
    EXPECT_EQ(kills.kills, count);
    EXPECT_GT(kills.resumed_to_the_end, 0);
}

}  // namespace voussoir::killed_runs
