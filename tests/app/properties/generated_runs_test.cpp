// Generated cases through the program: `check` accepts what `run` starts, exit codes and summaries agree, and the
// printed figures are the summary's.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/app/program_start.h"
#include "tests/app/properties/generated_reading.h"

namespace voussoir::app::properties
{
namespace
{

namespace fs = std::filesystem;
using nlohmann::json;

/// The program with its output in the folder; a run of a damaged case that would take long is interrupted.
Ended started(const TemporaryFolder& folder, const std::vector<std::string>& arguments)
{
    const pid_t child = start(folder, arguments);
    const auto late = std::chrono::steady_clock::now() + std::chrono::seconds(3);
    siginfo_t info = {};
    while (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0) {
        if (std::chrono::steady_clock::now() > late) {
            kill(child, SIGINT);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return finish(folder, child);
}

std::string outcome_of(int exit_code)
{
    const std::map<int, std::string> outcomes{
        {0, "completed"}, {3, "gave_up"}, {4, "interrupted"}, {5, "collapsed undecided"}};
    const auto found = outcomes.find(exit_code);
    return found == outcomes.end() ? "" : found->second;
}

void expect_line(const std::string& output, const std::string& line)
{
    EXPECT_NE(output.find(line), std::string::npos) << "the summary has \"" << line << "\"\n" << output;
}

/// What `run` printed of how it went, and summary.json.
void expect_same_figures(const std::string& output, const json& summary)
{
    expect_line(output, fmt::format("{}: {} steps for {:g} s of motion in ", summary["outcome"].get<std::string>(),
                                    summary["steps"].get<long>(), summary["simulated_time_s"].get<double>()));
    expect_line(output,
                fmt::format("  {} steps cut, {} not converged, {} open-close iterations, {} factorisations\n",
                            summary["step_cuts"].get<long>(), summary["unconverged_steps"].get<long>(),
                            summary["open_close_iterations"].get<long>(), summary["factorisations"].get<long>()));
    const json& energy = summary["energy"];
    const auto of = [&](const char* name) { return energy[name].get<double>(); };
    expect_line(output, fmt::format("  largest penetration {:.2e} m; energy unaccounted for {:.1e} of the energy",
                                    summary["max_penetration_m"].get<double>(), of("residual")));
    expect_line(output, fmt::format("{:.4g} removed in static stages, {:.4g} friction, {:.4g} impacts, ",
                                    of("damping_static_J") / 1e3, of("friction_J") / 1e3, of("impact_J") / 1e3));
    for (const auto& warning : summary["warnings"]) expect_line(output, warning.get<std::string>());
    const json& joints = summary["joints"];
    if (joints["count"].get<int>() > 0)
        expect_line(output, fmt::format("  of {} joints {} opened and {} slid ", joints["count"].get<int>(),
                                        joints["opened"].get<int>(), joints["slid"].get<int>()));
}

/// Checks and runs a case. @returns how it ended
std::string check_and_run(const std::string& text, const std::map<std::string, std::string>& files)
{
    const TemporaryFolder folder;
    for (const auto& [name, content] : files) folder.write(name, content);
    const std::string file = folder.write("case.yaml", text);
    const fs::path results = folder / "results";
    const Ended check = started(folder, {"check", file});
    const Ended run = started(folder, {"run", file, "-o", results.string()});
    EXPECT_EQ(check.signal, 0) << check.errors;
    EXPECT_EQ(run.signal, 0) << run.errors;
    if (check.exit_code != 0) {
        EXPECT_EQ(check.exit_code, 2) << check.errors;
        EXPECT_EQ(run.exit_code, 2) << "check refused what run starts: " << check.errors;
        EXPECT_NE(run.errors, "");
        EXPECT_FALSE(fs::exists(results)) << "a case that is refused leaves no folder";
        return "refused";
    }
    const std::string summary_text = contents(results / "summary.json");
    if (!json::accept(summary_text)) {
        ADD_FAILURE() << "check accepted what run did not start: " << run.exit_code << " " << run.errors;
        return "not_started";
    }
    const json summary = json::parse(summary_text);
    const auto outcome = summary["outcome"].get<std::string>();
    EXPECT_NE(outcome_of(run.exit_code).find(outcome), std::string::npos)
        << "exit code " << run.exit_code << " of a run that is " << outcome;
    EXPECT_EQ(run.exit_code == 0 && outcome == "completed", run.errors.empty()) << run.errors;
    expect_same_figures(run.output, summary);
    return outcome;
}

constexpr std::uint64_t usual = 100;

TEST(GeneratedRuns, WholeOnesEndAsTheirSummarySays)
{
    const auto [first, end] = seeds(usual);
    std::map<std::string, int> ends;
    for (std::uint64_t seed = first; seed < end; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const GeneratedScene scene = generated(seed);
        ++ends[check_and_run(text_of(scene, {}), files_of(scene, {}))];
    }
    count(ends);
    EXPECT_EQ(ends["refused"] + ends["gave_up"] + ends["interrupted"], 0);
}

TEST(GeneratedRuns, DamagedOnesAreStartedIfAndOnlyIfCheckAcceptsThem)
{
    const auto [first, end] = seeds(usual);
    std::map<std::string, int> ends;
    for (std::uint64_t seed = first; seed < end; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const GeneratedScene scene = generated(seed);
        ++ends[check_and_run(mutated(text_of(scene, {}), seed), files_of(scene, {}))];
    }
    count(ends);
    EXPECT_GT(ends["refused"], 0);
}

}  // namespace
}  // namespace voussoir::app::properties
