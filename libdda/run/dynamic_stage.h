// A stage in which time passes.
#pragma once

#include <cstdint>

#include "libdda/run/progress.h"

namespace voussoir::driver
{

/// How many multiples of `every` lie in [0, time], 0 excluded; 0 when every step has its frame.
std::int64_t multiples_until(double time, double every);

/// Steps on the nominal grid: a cut step is followed by growing ones that end on the next grid time, so that
/// output and ground motion are sampled at the same times whatever was cut.
/// @returns false when the run ends in this stage
bool run_dynamic(const Stage& stage, RunProgress& progress);

}  // namespace voussoir::driver
