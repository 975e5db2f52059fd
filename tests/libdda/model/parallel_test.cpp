// Loops on several threads: every turn once, no turn lost, and threads that sleep.
#include "libdda/model/parallel.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{
namespace
{

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// CPU time of all threads of this process [s].
double cpu_time()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// A process that uses all of a core while this lives, beside this one on the same two cores at most.
class BusyNeighbour
{
 public:
    BusyNeighbour()
    {
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t two;
        CPU_ZERO(&two);
        for (std::size_t core = 0; core < CPU_SETSIZE && CPU_COUNT(&two) < 2; ++core)
            if (CPU_ISSET(core, &before_)) CPU_SET(core, &two);
        sched_setaffinity(0, sizeof two, &two);
        child_ = fork();
        if (child_ == 0)
            for (;;) sched_getcpu();  // some work that is not left out
    }
    BusyNeighbour(const BusyNeighbour&) = delete;
    BusyNeighbour& operator=(const BusyNeighbour&) = delete;
    ~BusyNeighbour()
    {
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
        sched_setaffinity(0, sizeof before_, &before_);
    }

 private:
    cpu_set_t before_{};
    pid_t child_ = 0;
};

/// Wall time of 0.024 s of shaking of a wall of 204 blocks [s].
double time_to_shake(const Model& model, int threads)
{
    Stage stage = shaking(0.024, 2e-3);
    stage.control.threads = threads;
    State state = initial_state(model);
    const Clock::time_point start = Clock::now();
    EXPECT_EQ(run_quietly(model, {stage}, state).outcome, Outcome::completed);
    return seconds_since(start);
}

}  // namespace

TEST(Parallel, DoesEveryTurnOnceOnAnyNumberOfThreads)
{
    for (const int threads : {1, 2, 3, 8})
        for (const std::size_t count : {0U, 1U, 256U, 257U, 10'007U}) {
            std::vector<int> turns(count, 0);
            in_parallel(count, threads, [&](std::size_t first, std::size_t end) {
                for (std::size_t i = first; i < end; ++i) ++turns[i];
            });
            EXPECT_EQ(std::count(turns.begin(), turns.end(), 1), static_cast<std::ptrdiff_t>(count))
                << threads << " threads, " << count << " turns";
        }
}

TEST(Parallel, ThreadsShareTheWork)
{
    std::atomic<int> at_once = 0, most = 0;
    in_parallel(400, 4, [&](std::size_t, std::size_t) {
        const int now = ++at_once;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        --at_once;
    });
    EXPECT_GE(most, 2);
    EXPECT_LE(most, 4);
}

TEST(Parallel, AnExceptionReachesTheCallerAndTheNextLoopRuns)
{
    const auto fail = [](std::size_t first, std::size_t end) {
        if (first <= 700 && 700 < end) throw std::runtime_error("turn 700");
    };
    for (int repeat = 0; repeat < 20; ++repeat) {
        EXPECT_THROW(in_parallel(1000, 3, fail), std::runtime_error);
        std::atomic<std::size_t> done = 0;
        in_parallel(1000, 3, [&](std::size_t first, std::size_t end) { done += end - first; });
        EXPECT_EQ(done, 1000U);
    }
}

TEST(Parallel, LoopsOfFewerThreadsAndOfMoreFollowOneAnother)
{
    for (int repeat = 0; repeat < 200; ++repeat)
        for (const int threads : {4, 2, 3, 1, 4}) {
            std::atomic<std::size_t> done = 0;
            each_in_parallel(5, threads, [&](std::size_t i) { done += i + 1; });
            EXPECT_EQ(done, 15U) << threads << " threads";
        }
}

TEST(Parallel, PartsAreAddedInTheirOrder)
{
    for (const int threads : {1, 2, 3}) {
        std::vector<std::size_t> added;
        add_in_order(
            1000, threads, [](std::size_t i) { return i * i; }, [&](std::size_t part) { added.push_back(part); });
        ASSERT_EQ(added.size(), 1000U);
        for (std::size_t i = 0; i < added.size(); ++i) EXPECT_EQ(added[i], i * i);
    }
}

// A thread that does not come back from its range for long has lost its core to another program.
TEST(Parallel, BesideAThreadThatLostItsCoreTheCallerWorksAloneForAWhile)
{
    const auto caller = std::this_thread::get_id();
    const auto helpers_at_work = [&] {
        std::atomic<bool> any = false;
        each_in_parallel(8, 2, [&](std::size_t) {
            if (std::this_thread::get_id() != caller) any = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        });
        return any.load();
    };
    std::atomic<bool> lost = false;
    each_in_parallel(8, 2, [&](std::size_t) {
        if (std::this_thread::get_id() != caller) {
            if (!lost.exchange(true)) std::this_thread::sleep_for(std::chrono::milliseconds(100));
            return;
        }
        const Clock::time_point start = Clock::now();
        while (!lost && seconds_since(start) < 0.5) std::this_thread::yield();
    });
    ASSERT_TRUE(lost);
    EXPECT_FALSE(helpers_at_work());
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_TRUE(helpers_at_work());
}

// Where threads wait in a loop for the last of them, each of these millisecond waits costs a core.
TEST(Parallel, ThreadsSleepWhileTheyWait)
{
    const double before = cpu_time();
    const Clock::time_point start = Clock::now();
    for (int repeat = 0; repeat < 100; ++repeat)
        in_parallel(300, 2, [](std::size_t first, std::size_t) {
            if (first == 0) std::this_thread::sleep_for(std::chrono::milliseconds(3));
        });
    EXPECT_LT(cpu_time() - before, 0.25 * seconds_since(start));
}

TEST(Parallel, FewBlocksAreWorthOneThread)
{
    EXPECT_EQ(worthwhile_threads(0), 1);
    EXPECT_EQ(worthwhile_threads(1023), 1);
    EXPECT_EQ(worthwhile_threads(1024), static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
}

// Pairs, one after the other, of which the second best counts: what else the machine does meets any of them.
TEST(Parallel, TwoThreadsBesideABusyProcessAreAtMostHalfSlowerThanOne)
{
    const Model model = running_bond(Kinematics::spatial_rigid, 14, 14);
    const BusyNeighbour busy;
    std::array<double, 5> ratios{};
    for (double& ratio : ratios) {
        const double one = time_to_shake(model, 1);
        ratio = time_to_shake(model, 2) / one;
    }
    std::sort(ratios.begin(), ratios.end());
    EXPECT_LT(ratios[1], 1.5) << ::testing::PrintToString(ratios);
}

}  // namespace voussoir::testing
