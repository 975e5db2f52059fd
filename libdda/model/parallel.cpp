#include "libdda/model/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace voussoir
{
namespace
{

constexpr std::chrono::microseconds awake(50);  // that a thread waits before it sleeps
constexpr int glances_per_look = 32;            // at what is awaited, for each look at the clock
constexpr std::size_t ranges_per_thread = 4;    // so that a thread that comes late leaves its share to the others

// What the caller waits for a helper that has lost its core: beyond its own share of the loop, and not in loops of
// few turns, or the loop is uneven.
constexpr std::chrono::microseconds stall(500);
constexpr int stalled_shares = 3;
constexpr std::chrono::milliseconds first_pause(5), longest_pause(320);

using Clock = std::chrono::steady_clock;
using Turn = std::function<void(std::size_t, std::size_t)>;

int cores()
{
    static const int count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return count;
}

/// More would stand in one another's way.
int most_threads()
{
    return std::max(2, cores());
}

/// Tells the core that its thread only waits.
void pause_briefly()
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

/// Waits awake for what is about to come: to wake a thread takes as long as the loops of a linear solve.
/// @returns whether it came
template <class Until>
bool wait_awake(const Until& until)
{
    const auto end = Clock::now() + awake;
    do {
        for (int glance = 0; glance < glances_per_look; ++glance) {
            if (until()) return true;
            pause_briefly();
        }
    } while (Clock::now() < end);
    return until();
}

/// One loop at a time. Each thread has a share of it, always the same part, so that what its core remembers of the
/// loop before is of use; who has done its own share takes from the others'. Threads that are awake take no lock:
/// the lock is for those that sleep and those that wake them.
class Crew
{
 public:
    Crew() = default;
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    ~Crew()
    {
        {
            const std::lock_guard lock(mutex_);
            leaves_ = true;
        }
        wake_.notify_all();
        dismissed_.notify_all();
        for (std::thread& helper : helpers_) helper.join();
    }

    void run(std::size_t count, int threads, const Turn& turn)
    {
        if (is_alone()) {
            turn(0, count);
            return;
        }
        engage(static_cast<std::size_t>(threads) - 1);
        const std::uint64_t loop = loop_.load(std::memory_order_relaxed) + 1;
        turn_.store(&turn, std::memory_order_release);
        count_.store(count, std::memory_order_release);
        const bool call_back = static_cast<std::size_t>(threads) > shares_in_use_.load(std::memory_order_relaxed);
        shares_in_use_.store(static_cast<std::size_t>(threads), std::memory_order_release);
        done_.store(0, std::memory_order_release);
        for (int share = 0; share < threads; ++share) shares_[share].next.store(loop << range_bits);
        loop_.store(loop);
        if (call_back) wake(dismissed_);
        if (asleep_.load() > 0) wake(wake_);
        const Clock::time_point begun = Clock::now();
        take_ranges(0, loop);
        wait_for(count, begun);
        // Closed to late takers before the next loop is written down.
        for (int share = 0; share < threads; ++share) shares_[share].next.store(loop << range_bits | no_range);
        if (const std::exception_ptr failure = std::exchange(failure_, nullptr)) std::rethrow_exception(failure);
    }

 private:
    static constexpr std::size_t line = 64;  // bytes of a cache: what one thread writes keeps apart from others
    static constexpr int range_bits = 8;
    static constexpr std::uint64_t no_range = (std::uint64_t{1} << range_bits) - 1;

    struct alignas(line) Share {
        std::atomic<std::uint64_t> next = no_range;  // the loop's number, in the last bits the next range
    };

    /// So many helpers, or as many as the system gives.
    void engage(std::size_t wanted)
    {
        if (shares_.empty()) shares_ = std::vector<Share>(most_threads());
        helpers_.reserve(wanted);
        try {
            while (helpers_.size() < wanted)
                helpers_.emplace_back(
                    [this, share = helpers_.size() + 1, loop = loop_.load()] { serve(share, loop); });
        } catch (const std::system_error&) {  // no more threads: those that are there, or the caller alone, do all
        }
    }

    /// Who falls asleep tells so before it looks for the last time at what it waits for: either it sees that, or
    /// it is seen by who looks after having changed it.
    void wake(std::condition_variable& sleepers)
    {
        {
            const std::lock_guard lock(mutex_);
        }
        sleepers.notify_all();
    }

    /// @param share of the helper; @param loop the last one that began before it was there
    void serve(std::size_t share, std::uint64_t loop)
    {
        const auto is_called = [&] { return loop_.load() != loop || leaves_.load(); };
        for (;;) {
            if (!wait_awake(is_called)) {
                std::unique_lock lock(mutex_);
                ++asleep_;
                wake_.wait(lock, is_called);
                --asleep_;
            }
            if (share >= shares_in_use_.load()) {  // loops of fewer threads
                std::unique_lock lock(mutex_);
                dismissed_.wait(lock, [&] { return share < shares_in_use_.load() || leaves_.load(); });
            }
            if (leaves_.load()) return;
            loop = loop_.load();
            take_ranges(share, loop);
        }
    }

    /// Does ranges of a loop until none is left, those of its own share first.
    void take_ranges(std::size_t own, std::uint64_t loop)
    {
        const std::size_t shares = shares_in_use_.load();
        if (own >= shares) return;
        std::size_t done = 0;
        for (std::size_t i = 0; i < shares; ++i) done += take_share((own + i) % shares, shares, loop);
        // The caller may have fallen asleep like a helper.
        if (done > 0 && done_.fetch_add(done) + done == count_.load() && caller_sleeps_.load()) wake(finished_);
    }

    /// What is written down changes only after all shares of the loop have been closed: whoever gets a range of it
    /// has read what belongs to it. @returns how many turns it did
    std::size_t take_share(std::size_t share, std::size_t shares, std::uint64_t loop)
    {
        std::size_t done = 0;
        std::atomic<std::uint64_t>& next = shares_[share].next;
        std::uint64_t seen = next.load();
        for (;;) {
            const std::size_t count = count_.load(), range = seen & no_range;
            const Turn* turn = turn_.load();
            if (seen >> range_bits != loop || range >= ranges_per_thread) return done;
            if (!next.compare_exchange_weak(seen, seen + 1)) continue;
            const std::size_t ranges = shares * ranges_per_thread, at = share * ranges_per_thread + range;
            const std::size_t first = count * at / ranges, end = count * (at + 1) / ranges;
            if (first < end) do_range(first, end, *turn);
            done += end - first;
            seen = next.load();
        }
    }

    void do_range(std::size_t first, std::size_t end, const Turn& turn)
    {
        try {
            turn(first, end);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failure_ = std::current_exception();
        }
    }

    void wait_for(std::size_t count, Clock::time_point begun)
    {
        const auto are_done = [&] { return done_.load() == count; };
        if (are_done()) return;
        const Clock::time_point finished = Clock::now();
        if (wait_awake(are_done)) return;
        {
            std::unique_lock lock(mutex_);
            caller_sleeps_ = true;
            finished_.wait(lock, are_done);
            caller_sleeps_ = false;
        }
        const Clock::duration waited = Clock::now() - finished;
        const bool is_even = count >= shares_in_use_.load(std::memory_order_relaxed) * ranges_per_thread;
        if (is_even && waited > stall && waited > stalled_shares * (finished - begun)) go_alone();
    }

    /// A helper lost its core to another program in the middle of a range. For a while the caller does all by
    /// itself, for longer if that happens again soon.
    void go_alone()
    {
        const Clock::time_point now = Clock::now();
        pause_ =
            now < alone_until_ + 4 * pause_ ? std::min<Clock::duration>(2 * pause_, longest_pause) : first_pause;
        alone_until_ = now + pause_;
    }

    bool is_alone() const { return pause_.count() > 0 && Clock::now() < alone_until_; }

    std::mutex mutex_;
    std::condition_variable wake_, finished_, dismissed_;
    std::vector<Share> shares_;                          // of the caller, then of the helpers
    alignas(line) std::atomic<std::uint64_t> loop_ = 0;  // how many have begun
    std::atomic<const Turn*> turn_ = nullptr;
    std::atomic<std::size_t> count_ = 0, shares_in_use_ = 0;
    std::atomic<std::size_t> asleep_ = 0;  // helpers
    std::atomic<bool> caller_sleeps_ = false, leaves_ = false;
    alignas(line) std::atomic<std::size_t> done_ = 0;  // turns
    Clock::time_point alone_until_;
    Clock::duration pause_{0};
    std::exception_ptr failure_;
    std::vector<std::thread> helpers_;
};

}  // namespace

int worthwhile_threads(std::size_t blocks)
{
    return blocks < static_cast<std::size_t>(blocks_worth_threads) ? 1 : cores();
}

void parallel::divide(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& turn)
{
    thread_local Crew crew;
    crew.run(count, std::min(threads, most_threads()), turn);
}

}  // namespace voussoir
