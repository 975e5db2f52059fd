// The ground motions that a results file holds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voussoir::app::results
{

struct RecordedMotion {
    std::string source;                                        // "records/aqv_we.at2 (PEER AT2 ...)"
    std::string stage;                                         // its name
    double start = 0;                                          // s of the run, when that stage begins
    std::vector<std::string> followers;                        // "abutment_left x"
    double peak_acceleration = 0;                              // m/s2
    double residual_velocity = 0;                              // m/s
    double residual_displacement = 0;                          // m
    std::vector<double> times;                                 // s since the stage began
    std::vector<double> acceleration, velocity, displacement;  // m/s2, m/s, m
};

/// @throws InputError when it is no results file, or damaged there
std::vector<RecordedMotion> recorded_motions(const std::filesystem::path& results_file);

}  // namespace voussoir::app::results
