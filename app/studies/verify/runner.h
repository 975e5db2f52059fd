// Runs benchmarks: at their default setting, and over time steps, methods and stiffnesses.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/verify/benchmark.h"

namespace voussoir::app::studies::verify
{

/// One setting and what it gave; a run that gave up is a row with its `failure`.
struct VerifyRow {
    scenes::SceneSetting setting;
    VerifyResult result;
};

/// How fast the error of a method falls with the time step.
struct ObservedOrder {
    std::string method;
    double order =
        0;  // slope of log error over log time step, least squares over its rows (3 or more) above rounding
};

/// The same scene in other unknowns, at the default setting otherwise.
struct Companion {
    VerifyRow row;
    std::optional<double>
        distance;  // of its answer from that of the first row with the same kind of block, relative
};

struct VerifyOutcome {
    Benchmark benchmark;
    VerifyRow row;  // at the default setting
    std::vector<Companion> companions;
    std::vector<VerifyRow> rows;  // of the sweep; only `row` without one
    std::vector<ObservedOrder> orders;
    bool pass = false;  // default row and companions ran, their errors are within the tolerance, and they agree
};

/// @param sweep also run the benchmark's sweep, CPU times then being the median of three runs
VerifyOutcome run_benchmark(const Benchmark& benchmark, bool sweep);

/// CPU seconds per simulated second.
double cpu_share(const VerifyResult& result);

}  // namespace voussoir::app::studies::verify
