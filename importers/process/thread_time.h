// What one thread has cost.
#pragma once

#include <ctime>

namespace voussoir::importers::process
{

/// CPU time of the calling thread [s]. Unlike that of the process it is not mixed with what others do beside it,
/// and it stays exact under a limit on the process's CPU time, where the system counts whole ticks of 4 ms.
inline double thread_time()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace voussoir::importers::process
