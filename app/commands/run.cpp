#include "libdda/analysis/run.h"

#include <fmt/core.h>

#include <cstdio>

#include "app/case/case_file.h"
#include "app/commands/commands.h"
#include "app/commands/describe_case.h"
#include "app/commands/interrupt.h"
#include "app/commands/progress.h"
#include "app/commands/stopwatch.h"
#include "app/render/snapshots.h"
#include "app/results/results_writer.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

RunReport run_and_write(const Case& the_case, State& state, ResultsWriter& writer, bool quiet)
{
    Progress progress(the_case.stages, quiet);
    RunObserver observer;
    observer.every = the_case.output.every;
    observer.frame = [&](const State& now, const RunReport& report) { writer.frame(now, report); };
    observer.step = [&](const State& now, const StepReport& step, const RunReport& report) {
        writer.history(now, step, report);
        progress.step(now, step, report);
    };
    observer.stop = interrupted;
    RunReport report = run(the_case.model, the_case.stages, state, observer);
    progress.done();
    return report;
}

void print_report(const RunReport& report, double wall_time)
{
    fmt::print("{}: {} steps for {:g} s of motion in {:.1f} s of wall time\n", name_of(report.outcome),
               report.steps, report.simulated_time, wall_time);
    fmt::print("  {} steps cut, {} not converged, {} open-close iterations, {} factorisations\n", report.step_cuts,
               report.unconverged_steps, report.open_close_iterations, report.factorisations);
    const EnergyLedger& e = report.energy;
    fmt::print("  largest penetration {:.2e} m; energy unaccounted for {:.1e} of what went in or was lost\n",
               report.max_penetration, e.relative_residual());
    fmt::print(
        "  energy: {:.4g} kJ in; {:.4g} stored, {:.4g} taken out while settling, {:.4g} friction, {:.4g} damping, "
        "{:.4g} lost by the integrator\n",
        e.input() / 1e3, e.stored_change() / 1e3, e.damping_static / 1e3, e.friction / 1e3,
        (e.damping_kinetic + e.damping_contact + e.fracture) / 1e3,
        (e.algorithmic + e.algorithmic_rotation + e.redetection) / 1e3);
    for (const std::string& warning : report.warnings) fmt::print("  warning: {}\n", warning);
}

void print_files(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& pictures)
{
    fmt::print("written:\n");
    for (const char* name : {"results.h5", "results.xdmf", "histories.csv", "summary.json"})
        if (std::filesystem::exists(folder / name)) fmt::print("  {}\n", (folder / name).string());
    for (const std::filesystem::path& picture : pictures) fmt::print("  {}\n", picture.string());
}

/// The results stand whatever becomes of the pictures, so their failure is told and is no fault of the input.
bool draw(const Case& the_case, const std::filesystem::path& results, const std::filesystem::path& folder,
          std::vector<std::filesystem::path>& pictures)
{
    if (!the_case.output.snapshots) return true;
    try {
        pictures = render_snapshots(results, folder / "snapshots", *the_case.output.snapshots);
    } catch (const InputError& error) {
        fmt::print(stderr, "the results are complete, but there are no pictures: {}\n", error.what());
        return false;
    }
    return true;
}

int exit_code_of(Outcome outcome)
{
    if (outcome == Outcome::gave_up) return exit_gave_up;
    return outcome == Outcome::interrupted ? exit_interrupted : exit_done;
}

}  // namespace

int run_command(const RunArguments& arguments)
{
    const Stopwatch stopwatch;
    catch_interrupts();
    Case the_case = read_case(arguments.case_file, arguments.overrides);
    for (Stage& stage : the_case.stages) stage.control.threads = arguments.threads;
    const std::filesystem::path folder = arguments.folder.empty()
                                             ? std::filesystem::path("results") / arguments.case_file.stem()
                                             : arguments.folder;
    if (!arguments.quiet) print_case(the_case);
    if (interrupted()) return exit_interrupted;

    State state = initial_state(the_case.model);
    ResultsWriter writer(the_case, folder);
    const RunReport report = run_and_write(the_case, state, writer, arguments.quiet);
    writer.finish(state, report, stopwatch.wall_time(), Stopwatch::cpu_time());

    std::vector<std::filesystem::path> pictures;
    const bool drawn =
        report.outcome == Outcome::interrupted || draw(the_case, writer.results_file(), folder, pictures);
    if (!arguments.quiet) {
        print_report(report, stopwatch.wall_time());
        print_files(folder, pictures);
    }
    if (!report.message.empty()) fmt::print(stderr, "{}: {}\n", name_of(report.outcome), report.message);
    const int code = exit_code_of(report.outcome);
    return code == exit_done && !drawn ? exit_failure : code;
}

}  // namespace voussoir
