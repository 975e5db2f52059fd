// --resume goes on bit for bit: from every kind of moment at which a run can be asked to stop.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/reader/case_file.h"
#include "app/results/restart_file.h"
#include "app/results/results_writer.h"
#include "tests/app/program_start.h"
#include "tests/app/results/killed_runs.h"

namespace voussoir::app::results
{
namespace
{

namespace fs = std::filesystem;

/// Runs the case in this process into a folder, stopping after so many steps of this life; from a restart if
/// given.
Outcome run_steps(const Case& the_case, const fs::path& folder, int steps, const Restart* restart)
{
    State state = restart ? restart->state : initial_state(the_case.model);
    const std::unique_ptr<ResultsWriter> writer = restart
                                                      ? std::make_unique<ResultsWriter>(the_case, folder, *restart)
                                                      : std::make_unique<ResultsWriter>(the_case, folder);
    RunObserver observer;
    observer.every = the_case.output.every;
    int done = 0;
    observer.frame = [&](const State& now, const RunReport& report) { writer->frame(now, report); };
    observer.save = [&](const State& now, const RunPosition& at) { writer->save(now, at, {}); };
    observer.step = [&](const State& now, const StepReport& step, const RunReport& report) {
        writer->history(now, step, report);
        ++done;
    };
    observer.stop = [&] { return done == steps; };
    const RunReport report = restart ? run(the_case.model, the_case.stages, state, observer, restart->position)
                                     : run(the_case.model, the_case.stages, state, observer);
    writer->finish(state, report, {});
    if (report.outcome != Outcome::interrupted) writer->end(report);
    return report.outcome;
}

/// Stopped after every `steps` steps, in static and dynamic stages, on the grid of frames and off it.
void stop_again_and_again(const std::string& case_text, int steps)
{
    const TemporaryFolder folder;
    const fs::path file = folder.write("case.yaml", case_text);
    const Case the_case = reader::read_case(file, {});
    ASSERT_EQ(run_steps(the_case, folder / "reference", -1, nullptr), Outcome::completed);
    int lives = 1;
    Outcome outcome = run_steps(the_case, folder / "stopped", steps, nullptr);
    for (; outcome == Outcome::interrupted; ++lives) {
        const Restart restart = load_restart(restart_file_in(folder / "stopped"));
        outcome = run_steps(the_case, folder / "stopped", steps, &restart);
    }
    EXPECT_EQ(outcome, Outcome::completed);
    EXPECT_GT(lives, 5);
    killed_runs::expect_equal_results(folder / "stopped", folder / "reference");
}

TEST(Resume, ATowerStoppedAfterEveryElevenSteps)
{
    stop_again_and_again(killed_runs::shaken_tower, 11);
}

TEST(Resume, AFrameStoppedAfterEveryThirteenSteps)
{
    stop_again_and_again(killed_runs::shaken_frame, 13);
}

// How often the steps have been halved, and what had been lost when the motion began, are in the place to go on
// from.
TEST(Resume, StepsThatBecameShorterStoppedAfterEveryElevenSteps)
{
    const std::string text =
        "kinematics: planar_rigid\n"
        "thickness: 1 m\n"
        "materials: {stone: {density: 2000 kg/m3, young: 3 GPa, poisson: 0.2}}\n"
        "joints: {dry: {friction: 40 deg}}\n"
        "blocks:\n"
        "  - {box: {name: base, lower: [-3, -1], upper: [3, 0]}, group: foundation}\n"
        "  - {wall: {name: column, length: 1 m, height: 3 m, thickness: 1 m, block: [1 m, 0.5 m]}}\n"
        "foundation: {blocks: foundation, motion: {x: {sine: {acceleration: 0.7 g, frequency: 1.5 Hz, duration: 2 "
        "s}}}}\n"
        "stages:\n"
        "  - {name: self-weight, type: static}\n"
        "  - {name: earthquake, type: dynamic, time_step: auto, duration: 2 s, divide_up_to_blocks: 0}\n"
        "output: {every: 20 ms}\n";
    const TemporaryFolder folder;
    const Case the_case = reader::read_case(folder.write("case.yaml", text), {});
    ASSERT_TRUE(the_case.stages[1].control.automatic);
    run_steps(the_case, folder / "whole", -1, nullptr);
    EXPECT_NE(contents(folder / "whole" / "summary.json").find("\"shorter_steps\""), std::string::npos);
    stop_again_and_again(text, 11);
}

// The reactions of the boundary are in the state, and what the soil remembers of its strain: without the ones it
// would sink after the first interruption, without the other it would be softer.
TEST(Resume, SoilOnAViscousBaseStoppedAfterEverySevenSteps)
{
    stop_again_and_again(
        "kinematics: planar_deformable\n"
        "materials: {stone: {density: 2000 kg/m3, young: 3 GPa, poisson: 0.2}}\n"
        "joints: {bond: {friction: 30 deg, cohesion: 100 MPa, tensile_strength: 100 MPa}}\n"
        "blocks:\n"
        "  - soil: {width: 4 m, columns: 1, highest_frequency: 5 Hz, layers: [{thickness: 20 m, shear_wave: 200 "
        "m/s,\n"
        "      density: 1900 kg/m3, poisson: 0.3, rayleigh: {ratio: 5 %, at: [1 Hz, 5 Hz]},\n"
        "      hysteretic: {ratio: 5 %, band: [1 Hz, 10 Hz]}}]}\n"
        "boundaries: [{name: base, blocks: soil, side: bottom}]\n"
        "tied_sides: soil\n"
        "stages:\n"
        "  - {name: self-weight, type: static}\n"
        "  - {name: earthquake, type: dynamic, time_step: 5 ms, duration: 0.4 s, incoming_wave: {motion_is: "
        "outcrop,\n"
        "      x: {ricker: {acceleration: 1 m/s2, frequency: 4 Hz}}}}\n"
        "output: {every: 20 ms}\n",
        7);
}

// What bars have yielded is in the state: without it they would be as long again as they were drawn.
TEST(Resume, ABlockWhoseBarsYieldStoppedAfterEverySevenSteps)
{
    stop_again_and_again(
        "kinematics: spatial_rigid\n"
        "materials: {stone: {density: 2000 kg/m3, young: 3 GPa, poisson: 0.2}}\n"
        "joints: {dry: {friction: 20 deg}}\n"
        "blocks:\n"
        "  - {box: {name: base, lower: [-3, -1, -1], upper: [3, 1, 0]}, group: foundation}\n"
        "  - {box: {name: block, lower: [-0.5, -0.5, 0], upper: [0.5, 0.5, 0.5]}, group: block}\n"
        "bars:\n"
        "  - {name: dowel, between: [foundation, block], diameter: 5 mm, length: 10 cm, yield_strength: 200 MPa}\n"
        "  - {name: tie, from: {block: base, at: [-3, 0, 0]}, to: {block: block, at: [-0.5, 0, 0.25]}, diameter: "
        "5 "
        "mm,\n"
        "     yield_strength: 200 MPa, prestress: 20 MPa}\n"
        "foundation:\n"
        "  blocks: foundation\n"
        "  motion: {x: {sine: {acceleration: 9 m/s2, frequency: 4 Hz, duration: 0.4 s}}}\n"
        "stages:\n"
        "  - {name: self-weight, type: static}\n"
        "  - {name: earthquake, type: dynamic, time_step: 2 ms, duration: 0.4 s}\n"
        "output: {every: 20 ms, histories: {tie: {bar: tie}, block: {block: block}}}\n",
        7);
}

// The engine is the same after all, so the numbers are those of the run that was never stopped.
TEST(Resume, AnotherEngineGoesOnIfAskedAndTheResultsSayWhich)
{
    const TemporaryFolder folder;
    const killed_runs::Reference reference = killed_runs::run_through(folder.path(), killed_runs::shaken_tower);
    const fs::path results = folder / "results";
    const Case the_case = reader::read_case(reference.case_file, {});
    ASSERT_EQ(run_steps(the_case, results, 40, nullptr), Outcome::interrupted);
    Restart restart = load_restart(restart_file_in(results));
    restart.computed_from.engine.commit = "8951b6b97059";
    restart.computed_from.engine.dirty = version::Dirty::no;
    const std::string before = version::in_words(restart.computed_from.engine);
    save_restart(restart, restart_file_in(results));
    std::vector<std::string> arguments = {"run",     reference.case_file.string(), "-q", "-o", results.string(),
                                          "--resume"};
    EXPECT_EQ(voussoir(folder, arguments).exit_code, 2);
    arguments.emplace_back("--other-engine");
    const Ended ended = voussoir(folder, arguments);
    ASSERT_EQ(ended.exit_code, 0) << ended.errors;
    EXPECT_EQ(contents(results / "histories.csv"), contents(reference.folder / "histories.csv"));

    const auto warnings_in = [](const fs::path& folder_of_run) {
        const nlohmann::json summary = nlohmann::json::parse(contents(folder_of_run / "summary.json"));
        EXPECT_EQ(summary["engine"], nlohmann::json::parse(version::engine_json()));
        return summary["warnings"].dump();
    };
    EXPECT_EQ(warnings_in(reference.folder).find("two engines"), std::string::npos);
    EXPECT_NE(warnings_in(results).find("two engines made this run: " + before + ", up to t = "),
              std::string::npos)
        << warnings_in(results);
    // From here on the run is this engine's, and the warning stays with it however often it is stopped again.
    const Restart last = load_restart(restart_file_in(results));
    EXPECT_EQ(last.computed_from.engine, version::engine_version());
    EXPECT_EQ(last.remarks.size(), 1);
}

TEST(Resume, TimesAddUpAndTheEndedRunSaysSo)
{
    const TemporaryFolder folder;
    const killed_runs::Reference reference = killed_runs::run_through(folder.path(), killed_runs::shaken_tower);
    const fs::path results = folder / "results";
    const std::vector<std::string> arguments = {
        "run", reference.case_file.string(), "-o", results.string(), "--save-every", "0"};
    std::vector<std::string> resume = arguments;
    resume.emplace_back("--resume");
    const pid_t child = start(folder, arguments);
    while (!fs::exists(restart_file_in(results))) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::duration<double>(0.3 * reference.wall_time));
    kill(child, SIGINT);
    const Ended interrupted = finish(folder, child);
    ASSERT_EQ(interrupted.exit_code, 4) << interrupted.errors;
    EXPECT_NE(interrupted.errors.find("--resume to continue"), std::string::npos) << interrupted.errors;
    const double before = load_restart(restart_file_in(results)).wall_time;
    EXPECT_GT(before, 0.2 * reference.wall_time);

    const Ended resumed = voussoir(folder, resume);
    ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
    EXPECT_NE(resumed.output.find("continues from stage '"), std::string::npos) << resumed.output;
    const auto summary = nlohmann::json::parse(contents(results / "summary.json"));
    EXPECT_GT(summary["wall_time_s"].get<double>(), before);
    EXPECT_GT(summary["cpu_time_s"].get<double>(), 0);
    killed_runs::expect_equal_results(results, reference.folder);

    const std::string histories = contents(results / "histories.csv");
    const Ended again = voussoir(folder, resume);
    EXPECT_EQ(again.exit_code, 0) << again.errors;
    EXPECT_NE(again.output.find("nothing to resume, the run has ended: completed"), std::string::npos);
    EXPECT_EQ(contents(results / "histories.csv"), histories);
}

}  // namespace
}  // namespace voussoir::app::results
