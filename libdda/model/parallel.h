// Loops whose turns are independent, divided among threads that sleep when there is nothing to do.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace voussoir
{

namespace parallel
{

constexpr std::size_t least_count = 257;  // below it waking threads takes longer than a loop over small turns

/// The loop itself, on more than one thread.
void divide(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& turn);

}  // namespace parallel

constexpr int blocks_worth_threads =
    1024;  // that move; below, a step is done in one piece and threads gain little

/// How many threads a scene is worth on this machine: one for each core, or one. @param blocks that move
int worthwhile_threads(std::size_t blocks);

/// Calls `turn(first, end)` for consecutive ranges that together make up 0 ... count, on at most `threads`
/// threads, the caller's among them. Which thread does which range is left open, so a turn may depend on its own
/// index only, and begin no such loop itself. Helpers belong to the calling thread; after a loop they stay awake
/// for 50 microseconds, then sleep, and the caller does what none of them has begun: beside a busy process a loop
/// waits for no thread that has not been given a core.
/// @throws what a turn throws, one of them, when all threads have left the loop
template <class Turn>
void in_parallel(std::size_t count, int threads, const Turn& turn)
{
    if (threads > 1 && count >= parallel::least_count)
        parallel::divide(count, threads, std::cref(turn));
    else if (count > 0)
        turn(std::size_t{0}, count);
}

/// The same for few turns of which each is worth a thread: calls `turn(i)` for every i of 0 ... count.
template <class Turn>
void each_in_parallel(std::size_t count, int threads, const Turn& turn)
{
    const auto range = [&turn](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) turn(i);
    };
    if (threads > 1 && count > 1)
        parallel::divide(count, threads, range);
    else
        range(0, count);
}

/// Calls `add(part(i))` for every i of 0 ... count in ascending order, so that sums come out the same on any
/// number of threads; `part` is called on all of them.
template <class PartOf, class Add>
void add_in_order(std::size_t count, int threads, const PartOf& part, const Add& add)
{
    if (threads <= 1 || count < parallel::least_count) {
        for (std::size_t i = 0; i < count; ++i) add(part(i));
        return;
    }
    std::vector<decltype(part(count))> parts(count);
    in_parallel(count, threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) parts[i] = part(i);
    });
    for (const auto& each : parts) add(each);
}

}  // namespace voussoir
