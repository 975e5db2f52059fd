#include "libdda/run/run.h"
#include "app/commands/say.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>

#include "app/commands/after_run.h"
#include "app/commands/commands.h"
#include "app/commands/describe_case.h"
#include "app/commands/error_estimate.h"
#include "app/commands/interrupt.h"
#include "app/commands/progress.h"
#include "app/commands/resume.h"
#include "app/commands/saver.h"
#include "app/commands/stopwatch.h"
#include "app/commands/trust_watch.h"
#include "app/reader/case_file.h"
#include "app/results/results_writer.h"
#include "app/results/run_lock.h"
#include "app/words/diagnosis_words.h"
#include "app/words/doubts.h"
#include "app/words/verdict_words.h"
#include "importers/process/program_start.h"
#include "libdda/analysis/joint_openings.h"
#include "libdda/errors.h"
#include "libdda/model/parallel.h"

namespace voussoir::app::commands
{
namespace
{

/// Where to go on from, or the beginning.
struct Start {
    State state;
    RunPosition position;
    results::CommandTimes times;  // of the commands before this one
    std::optional<TrustStart> trust;
    bool is_resumed = false;
};

/// What a run gave beside its files.
struct Ended {
    RunReport report;
    std::optional<TrustStart> trust;
    std::optional<results::ErrorEstimate> estimate;
    std::vector<JointPeaks> joints;  // as the summary has them
};

/// Runs to the end, or as far as it goes, and closes the files. @param start its state becomes the last one
Ended run_and_write(const Case& the_case, Start& start, results::ResultsWriter& writer, Saver& saver, bool quiet)
{
    Progress progress(the_case.stages, quiet);
    TrustWatch trust(the_case, start.trust);
    std::optional<HistoryRecorder> recorder;
    if (the_case.output.error_estimate) recorder.emplace(the_case);
    RunObserver observer;
    observer.every = the_case.output.every;
    observer.frame = [&](const State& now, const RunReport& report) {
        writer.add_frame(now, report);
        if (const TrustStart* noted = trust.frame(now, report)) writer.note(*noted);
    };
    observer.save = std::ref(saver);
    observer.step = [&](const State& now, const StepReport& step, const RunReport& report) {
        writer.history(now, step, report);
        progress.step(now, step, report);
        if (recorder) recorder->step(now);
    };
    observer.stop = interrupted;
    Ended ended;
    ended.report = run(the_case.model, the_case.stages, start.state, observer, start.position);
    ended.trust = trust.start();
    progress.done();
    if (recorder)
        ended.estimate =
            error_of(the_case, {std::move(*recorder), start.state, ended.report}, !start.is_resumed, quiet);
    if (ended.estimate) writer.note(*ended.estimate);
    const importers::process::EndsWithoutMemory while_the_summary_is_composed;
    ended.joints = writer.finish(start.state, ended.report, saver.times());
    return ended;
}

/// Neither the input's fault nor that of the numerics: the disk is full, or the memory.
struct RunBroken : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Ended run_unbroken(const Case& the_case, Start& start, results::ResultsWriter& writer, Saver& saver, bool quiet)
{
    try {
        return run_and_write(the_case, start, writer, saver, quiet);
    } catch (const InputError& error) {
        throw RunBroken(error.what());
    } catch (const std::bad_alloc&) {
        throw RunBroken("out of memory");
    }
}

/// "earthquake: time_step auto, 4 ms as drawn, 2 ms from its start, 1 ms from 3.1 s on": whose steps became
/// shorter.
void print_shorter_steps(const RunReport& report, const std::vector<Stage>& stages)
{
    for (int s = 0; s < static_cast<int>(stages.size()); ++s) {
        std::string told;
        for (const ShorterSteps& shorter : report.shorter_steps)
            if (shorter.stage == s)
                told += fmt::format(
                    ", {:.3g} ms {}", 1e3 * shorter.time_step,
                    shorter.at_start ? "from its start" : fmt::format("from {:.4g} s on", shorter.time));
        if (told.empty()) continue;
        say(fmt::format("  {}: time_step auto, {:.3g} ms as drawn{}", stages[s].name,
                        1e3 * stages[s].control.time_step, told));
    }
}

void print_joints(const std::vector<JointPeaks>& joints)
{
    if (joints.empty()) return;
    int opened = 0, slid = 0;
    double opening = 0, slip = 0;
    for (const JointPeaks& joint : joints) {
        opened += joint.opened.has_value();
        slid += joint.slid.has_value();
        opening = std::max(opening, joint.opening);
        slip = std::max(slip, joint.slip);
    }
    say(fmt::format(
        "  of {} joints {} opened and {} slid by more than {:g} mm; at most {:.3g} mm open, {:.3g} mm of slip",
        joints.size(), opened, slid, 1e3 * noteworthy_opening, 1e3 * opening, 1e3 * slip));
}

void print_bars(const RunReport& report)
{
    if (report.bars.empty()) return;
    std::size_t yielded = 0;
    double tension = 0, shear = 0;
    for (const BarPeaks& bar : report.bars) {
        yielded += bar.yielded.has_value();
        tension = std::max(tension, bar.tension);
        shear = std::max(shear, bar.shear);
    }
    say(fmt::format("  of {} bars {} yielded; at most {:.4g} kN of tension, {:.4g} kN of shear",
                    report.bars.size(), yielded, tension / 1e3, shear / 1e3));
}

void print_report(const Case& the_case, const Ended& ended, double wall_time)
{
    const RunReport& report = ended.report;
    if (report.verdict) say(words::in_words(*report.verdict, the_case.model));
    say(fmt::format("{}: {} steps for {:g} s of motion in {:.1f} s of wall time", name_of(report.outcome),
                    report.steps, report.simulated_time, wall_time));
    say(fmt::format("  {} steps cut, {} not converged, {} open-close iterations, {} factorisations",
                    report.step_cuts, report.unconverged_steps, report.open_close_iterations,
                    report.factorisations));
    print_shorter_steps(report, the_case.stages);
    const EnergyLedger& e = report.energy;
    say(fmt::format(
        "  largest penetration {:.2e} m; energy unaccounted for {:.1e} of the energy put in, stored or lost",
        report.max_penetration, e.relative_residual()));
    say(fmt::format(
        "  energy: {:.4g} kJ put in; {:.4g} stored, {:.4g} removed in static stages, {:.4g} friction, {:.4g} "
        "impacts, {:.4g} damping, {:.4g} joints that closed within steps, {:.4g} loss of the integrator",
        e.input() / 1e3, e.stored_change() / 1e3, e.damping_static / 1e3, e.friction / 1e3, e.impact / 1e3,
        (e.damping_kinetic + e.damping_contact + e.damping_material + e.fracture + e.yielding) / 1e3,
        e.closing / 1e3, (e.algorithmic + e.algorithmic_rotation + e.redetection) / 1e3));
    print_joints(ended.joints);
    print_bars(report);
    const std::optional<Trust> trust = print_trust(the_case, ended.trust, report);
    for (const std::string& doubt : words::doubts_of(report, trust, the_case.model, the_case.stages))
        say(fmt::format("  warning: {}", doubt));
    if (ended.estimate) print_estimate(*ended.estimate, report.outcome);
}

void print_files(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& pictures)
{
    say("written:");
    for (const char* name : {"results.h5", "results.xdmf", "histories.csv", "summary.json"})
        if (is_there(folder / name)) say(fmt::format("  {}", (folder / name).string()));
    for (const std::filesystem::path& picture : pictures) say(fmt::format("  {}", picture.string()));
}

int exit_code_of(Outcome outcome, bool accept_collapse)
{
    switch (outcome) {
        case Outcome::gave_up:
            return exit_gave_up;
        case Outcome::interrupted:
            return exit_interrupted;
        case Outcome::undecided:
            return exit_not_standing;
        case Outcome::collapsed:
            return accept_collapse ? exit_done : exit_not_standing;
        case Outcome::completed:
            break;
    }
    return exit_done;
}

/// "gave_up: stage 'earthquake' gave up at ..."
std::string outcome_in_words(const RunReport& report, const Case& the_case)
{
    const std::string message = words::message_of(report, the_case.model, the_case.stages);
    return std::string(name_of(report.outcome)) + (message.empty() ? "" : ": " + message);
}

/// Runs, writes and draws. @returns the exit code
int run_from(const Case& the_case, const std::filesystem::path& folder,
             const std::optional<results::Restart>& restart, const Stopwatch& stopwatch,
             const RunArguments& arguments)
{
    const bool quiet = arguments.quiet;
    Start start;
    if (restart) {
        start = {restart->state, restart->position, {restart->wall_time, restart->cpu_time}, restart->trust, true};
        if (!quiet) say(fmt::format("continues from {}", place_of(the_case, *restart)));
    } else {
        start.state = initial_state(the_case.model);
        start.position = start_position(the_case.model, the_case.stages, start.state);
    }
    std::unique_ptr<results::ResultsWriter> writer =
        restart ? std::make_unique<results::ResultsWriter>(the_case, folder, *restart)
                : std::make_unique<results::ResultsWriter>(the_case, folder);
    Saver saver(*writer, {start.position.frames, start.times, arguments.save_every}, stopwatch);
    const Ended ended = run_unbroken(the_case, start, *writer, saver, quiet);
    const RunReport& report = ended.report;

    AfterRun after;
    const bool goes_on = report.outcome == Outcome::interrupted;
    if (!goes_on) after = make_after_run(the_case, writer->results_file(), folder, quiet);
    if (!goes_on) writer->end(report);
    if (!quiet) {
        print_report(the_case, ended, saver.times().wall);
        print_files(folder, after.files);
    }
    if (report.diagnosis)
        complain(fmt::format("{}{}", outcome_in_words(report, the_case),
                             goes_on ? "; run the same command with --resume to continue" : ""));
    const int code = exit_code_of(report.outcome, arguments.accept_collapse);
    return code == exit_done && !after.complete ? exit_failure : code;
}

/// The helpers that draw are told of files a line each.
void expect_one_line(const std::filesystem::path& folder)
{
    std::error_code none;
    if (std::filesystem::absolute(folder, none).string().find('\n') != std::string::npos)
        throw InputError(folder.string(), "a folder whose name, or that of one above it, has two lines",
                         "give another folder");
}

}  // namespace

int run_command(const RunArguments& arguments)
{
    const Stopwatch stopwatch;
    catch_interrupts();
    const std::filesystem::path folder = arguments.folder.empty()
                                             ? std::filesystem::path("results") / arguments.case_file.stem()
                                             : arguments.folder;
    expect_one_line(folder);
    if (arguments.resume) refuse_without_restart(folder);
    reader::CaseStones stones;
    Case the_case = reader::read_case(arguments.case_file, arguments.overrides, &stones);
    const std::size_t moving = the_case.model.blocks.size() - the_case.model.foundations.size();
    const int threads = arguments.threads.value_or(worthwhile_threads(moving));
    for (Stage& stage : the_case.stages) stage.control.threads = threads;
    if (!arguments.quiet) print_case(the_case);
    if (arguments.verbose) print_repairs(stones.geometry);
    expect_tools(the_case);
    if (interrupted()) return exit_interrupted;

    const results::RunLock lock(folder);
    std::optional<results::Restart> restart;
    if (arguments.resume)
        restart = restart_of(the_case, folder, arguments.other_engine);
    else
        tell_what_is_replaced(folder, arguments.quiet);
    if (restart && restart->ended) {
        say(fmt::format("{}: there is nothing to resume, the run has ended: {}", folder.string(),
                        outcome_in_words(restart->position.report, the_case)));
        return exit_code_of(restart->position.report.outcome, arguments.accept_collapse);
    }
    if (restart)
        for (const std::string& remark : restart->remarks) {
            the_case.warnings.push_back(remark);
            complain(fmt::format("warning: {}", remark));
        }
    try {
        return run_from(the_case, folder, restart, stopwatch, arguments);
    } catch (const RunBroken& broken) {
        complain(broken.what());
        if (is_there(results::restart_file_in(folder)))
            complain(fmt::format("{}: the results written so far are complete; --resume continues from there",
                                 folder.string()));
        return exit_failure;
    }
}

}  // namespace voussoir::app::commands
