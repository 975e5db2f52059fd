// A benchmark: small data, one reference that knows nothing of the engine, and a run of the engine beside it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/plots/diagram.h"
#include "app/studies/scenes/scene_setting.h"
#include "libdda/model/kinematics.h"
#include "libdda/model/step_control.h"

namespace voussoir::app::studies::verify
{

/// What one run gave.
struct VerifyResult {
    double error = 0;                     // -, the benchmark's measure against its reference
    std::optional<double> paper_measure;  // the same run by the paper's own measure
    double simulated_time = 0;            // s
    double cpu_time = 0;                  // s, process clock
    std::int64_t steps = 0, step_cuts = 0, iterations = 0;
    std::vector<double> answer;  // compared with the same scene in other unknowns, all on one scale; or empty
    plots::Diagram picture;      // of what was compared; without curves there is none
    std::string failure;         // why there is no error: the run gave up; empty when it did not
    std::string note;            // what else the run showed, one line
};

/// One line of the verification table.
struct Benchmark {
    std::string name;         // as typed: incline-gravity-3d
    std::string title;        // A block on an incline, from rest
    std::string source;       // yagoda-biran-hatzor, section 3.1.1.2 (a); short names: docs/bibliography.md
    std::string quantity;     // largest distance from the closed form / largest displacement
    std::string choices;      // what the paper leaves out, what we took, and how the run shows it does not matter
    std::string paper_error;  // as printed: "below 1 % after 0.2 s"; empty when the paper gives none
    std::optional<double> paper_level;        // the number in it, for the line in the diagram
    scenes::SceneSetting setting;             // the default one, on which `tolerance` is held
    double tolerance = 0;                     // of `error`
    std::vector<Kinematics> also = {};        // other unknowns for the same scene: they must pass too, and agree
    std::vector<scenes::SceneSetting> sweep;  // of the work-precision diagram; at least 4 time steps x methods
    std::function<VerifyResult(const scenes::SceneSetting&)> run;
};

/// All benchmarks, in the order of the papers. Each family is a function of its own in a file of its own.
/// @param seed of the benchmarks that draw their points (the mode chart)
std::vector<Benchmark> all_benchmarks(std::uint64_t seed);

}  // namespace voussoir::app::studies::verify
