// Loops whose turns are independent, divided among threads that sleep when there is nothing to do.
#pragma once

#include <cstddef>
#include <functional>

namespace voussoir
{

/// Calls `turn(first, end)` for consecutive ranges that together make up 0 ... count, on at most `threads`
/// threads, the caller's among them. Which thread does which range is left open, so a turn may depend on its own
/// index only. Helpers belong to the calling thread; they wait on a condition variable, never in a loop, and the
/// caller does what none of them has begun: beside a busy process a loop waits for no thread that has not been
/// given a core.
/// @throws what a turn throws, one of them, when all threads have left the loop
void in_parallel(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& turn);

}  // namespace voussoir
