// Takes step problems out of a run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/problems/problem.h"

namespace voussoir::app::problems
{

/// Which steps of which case. A step is taken if it is asked for in any way; all are if none is given.
struct TakeArguments {
    std::filesystem::path file;         // the case
    std::vector<std::string> settings;  // "stages[1].time_step=1 ms"
    std::string name;                   // of its problems; empty: the file's
    std::vector<double> at;             // s of the run's time: the first step that begins no earlier
    std::int64_t every = 0;             // steps: each so manieth; 0: none
    std::vector<std::string> of;        // of the steps that were asked for only those with one of these tags
    int most = 0;                       // problems; 0: all
};

/// Runs the case on one thread, no further than necessary. Not taken are the first steps of stages after the
/// first, and those of static stages in which stones fall: what they begin with is the driver's alone.
/// @throws InputError with the faults of the case, and for one that names other files
Corpus take(const TakeArguments& arguments);

}  // namespace voussoir::app::problems
