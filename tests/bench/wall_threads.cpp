// How much faster threads make a wall in motion, by parts.
//
//     libdda_wall_threads [seconds [courses blocks]...]
//
// Self-weight, then so many seconds (0.25) of 0.3 g at 2 Hz in the plane of running-bond walls in which nothing
// may move (32 courses of 62 and 50 of 100) at 8 ms, on 1, 2, 4, ... threads up to the cores of the machine.
// Prints the quicker of two runs of each as a Markdown table, and says if any number of threads leads to other
// bits.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "libdda/model/parallel.h"
#include "libdda/model/standard_gravity.h"
#include "libdda/run/run.h"
#include "tests/running_bond_wall.h"

namespace voussoir
{
namespace
{

struct Timed {
    double wall = 0, cpu = 0;  // s
    RunReport report;
    State end;
};

double cpu_time()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

State at_rest(const Model& model)
{
    Stage rest;
    rest.type = StageType::static_equilibrium;
    rest.control.time_step = 0.1;
    rest.control.threads = worthwhile_threads(model.blocks.size());
    State state = initial_state(model);
    std::thread([&] { run(model, {rest}, state, {}); }).join();
    state.stage = 0;
    state.stage_time = state.time = 0;
    return state;
}

Stage shaken(const Model& model, double duration)
{
    Stage stage;
    stage.duration = duration;
    stage.control.time_step = 8e-3;
    const auto push = std::make_shared<const GroundMotion>(
        GroundMotion::sine_acceleration(0.3 * standard_gravity, 2, 0, duration));
    for (int block = 1; block < static_cast<int>(model.blocks.size()); ++block)
        stage.body_accelerations.push_back({block, 0, push});
    return stage;
}

Timed time_run(const Model& model, Stage stage, const State& rest, int threads)
{
    stage.control.threads = threads;
    Timed timed;
    timed.end = rest;
    const double cpu = cpu_time();
    const auto start = std::chrono::steady_clock::now();
    // With helpers of its own, which leave with it.
    std::thread([&] { timed.report = run(model, {stage}, timed.end, {}); }).join();
    timed.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    timed.cpu = cpu_time() - cpu;
    return timed;
}

void print_row(const Timed& timed, const Timed& one, int threads, double duration)
{
    const auto of = [&](Part part) { return timed.report.seconds[static_cast<std::size_t>(part)]; };
    const double solve = of(Part::linear_solve), search = of(Part::contact_search), update = of(Part::update);
    // What is left beside them is assembly, evaluation, relaxation and landings.
    const double rest = timed.wall - solve - search - update;
    std::printf("| %d | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |%s\n", threads, timed.wall / duration,
                one.wall / timed.wall, timed.cpu / one.cpu, solve / duration, rest / duration, search / duration,
                update / duration, timed.end.velocities == one.end.velocities ? "" : " OTHER BITS");
    std::fflush(stdout);
}

void measure(int courses, int blocks, double duration)
{
    const Model model = running_bond_wall(Kinematics::spatial_rigid, courses, blocks);
    const State rest = at_rest(model);
    const Stage stage = shaken(model, duration);
    std::printf("\n%zu blocks; s of wall time per simulated s\n\n", model.blocks.size());
    std::printf("| threads | s | times faster | CPU time, times | linear solve | iteration | search | update |\n");
    std::printf("|---|---|---|---|---|---|---|---|\n");
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    Timed one;
    for (int threads = 1; threads <= cores; threads *= 2) {
        Timed timed = time_run(model, stage, rest, threads);
        Timed again = time_run(model, stage, rest, threads);
        if (again.wall < timed.wall) std::swap(timed, again);
        if (threads == 1) one = timed;
        print_row(timed, one, threads, duration);
    }
}

}  // namespace
}  // namespace voussoir

int main(int count, char** arguments)
{
    const double duration = count > 1 ? std::strtod(arguments[1], nullptr) : 0.25;
    std::vector<int> sizes;
    for (int i = 2; i < count; ++i) sizes.push_back(std::atoi(arguments[i]));
    if (sizes.empty()) sizes = {32, 62, 50, 100};
    for (std::size_t i = 0; i + 1 < sizes.size(); i += 2) voussoir::measure(sizes[i], sizes[i + 1], duration);
}
