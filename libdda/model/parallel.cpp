#include "libdda/model/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
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
constexpr std::size_t ranges_per_thread = 4;    // so that a thread that comes late leaves its share to the others

using Turn = std::function<void(std::size_t, std::size_t)>;

/// One loop at a time, its ranges taken under a lock.
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
        for (std::thread& helper : helpers_) helper.join();
    }

    void run(std::size_t count, int threads, const Turn& turn)
    {
        engage(static_cast<std::size_t>(threads) - 1);
        std::unique_lock lock(mutex_);
        turn_ = &turn;
        count_ = count;
        next_ = 0;
        range_ = std::max<std::size_t>(1, count / (static_cast<std::size_t>(threads) * ranges_per_thread));
        places_ = static_cast<std::size_t>(threads) - 1;
        begun_.fetch_add(1, std::memory_order_release);
        wake_.notify_all();
        take_ranges(lock);
        if (at_work_ > 0) {
            lock.unlock();
            spin([this] { return idle_.load(std::memory_order_acquire); });
            lock.lock();
        }
        done_.wait(lock, [this] { return at_work_ == 0; });
        turn_ = nullptr;
        if (const std::exception_ptr failure = std::exchange(failure_, nullptr)) std::rethrow_exception(failure);
    }

 private:
    /// So many helpers, or as many as the system gives.
    void engage(std::size_t wanted)
    {
        helpers_.reserve(wanted);
        try {
            while (helpers_.size() < wanted) helpers_.emplace_back([this] { serve(); });
        } catch (const std::system_error&) {  // no more threads: those that are there, or the caller alone, do all
        }
    }

    /// Waits awake for what is about to come: to wake a thread takes as long as the loops of a linear solve.
    template <class Until>
    static void spin(const Until& until)
    {
        const auto end = std::chrono::steady_clock::now() + awake;
        while (!until() && std::chrono::steady_clock::now() < end) {
        }
    }

    bool has_work() const { return turn_ != nullptr && next_ < count_ && places_ > 0; }

    void serve()
    {
        std::unique_lock lock(mutex_);
        for (;;) {
            if (!leaves_ && !has_work()) {
                const std::size_t seen = begun_.load(std::memory_order_acquire);
                lock.unlock();
                spin([&] { return begun_.load(std::memory_order_acquire) != seen; });
                lock.lock();
            }
            wake_.wait(lock, [this] { return leaves_ || has_work(); });
            if (leaves_) return;
            --places_;
            ++at_work_;
            idle_.store(false, std::memory_order_relaxed);
            take_ranges(lock);
            if (--at_work_ == 0) {
                idle_.store(true, std::memory_order_release);
                done_.notify_one();
            }
        }
    }

    /// Takes ranges until none is left. @param lock held on entry and on return, not while a range is done
    void take_ranges(std::unique_lock<std::mutex>& lock)
    {
        while (next_ < count_) {
            const std::size_t first = next_, end = std::min(first + range_, count_);
            next_ = end;
            const Turn& turn = *turn_;
            lock.unlock();
            std::exception_ptr failure;
            try {
                turn(first, end);
            } catch (...) {
                failure = std::current_exception();
            }
            lock.lock();
            if (failure) failure_ = failure;
        }
    }

    std::mutex mutex_;
    std::condition_variable wake_, done_;
    const Turn* turn_ = nullptr;  // absent: no loop
    std::size_t count_ = 0, next_ = 0, range_ = 1;
    std::size_t places_ = 0;              // helpers that may still join this loop
    std::size_t at_work_ = 0;             // helpers in it
    std::atomic<std::size_t> begun_ = 0;  // loops
    std::atomic<bool> idle_ = true;       // no helper is at work
    std::exception_ptr failure_;
    bool leaves_ = false;
    std::vector<std::thread> helpers_;
};

}  // namespace

namespace
{

int cores()
{
    static const int count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return count;
}

}  // namespace

int worthwhile_threads(std::size_t blocks)
{
    return blocks < static_cast<std::size_t>(blocks_worth_threads) ? 1 : cores();
}

void parallel::divide(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& turn)
{
    thread_local Crew crew;
    crew.run(count, std::min(threads, std::max(2, cores())), turn);  // more would stand in one another's way
}

}  // namespace voussoir
