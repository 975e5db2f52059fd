// Scenes with what is known of their answer.
#pragma once

#include <string>

#include "tests/peers/engines.h"

namespace voussoir::peers
{

struct Finding {
    double error = 0;      // as the trial defines it; of a failure what had come until then
    double cpu_time = 0;   // s, CLOCK_PROCESS_CPUTIME_ID: the scene built in the engine, rest and motion
    double step_time = 0;  // s, of the same for each step of the motion that was seen
    std::string failure;   // empty: none
};

/// @param name sliding, sliding_across, rocking, wall_100, wall_504 or arch
/// @throws InputError when there is no such trial or engine
Finding run_trial(const std::string& name, const Setting& setting);

}  // namespace voussoir::peers
