// What the benchmarks of vibration share.
#pragma once

#include <functional>
#include <vector>

#include "app/studies/verify/run_scene.h"

namespace voussoir::app::studies::verify
{

/// Runs a scene whose last stage begins with velocities that `push` gives; adds its cost to `result`.
RunReport run_moving(const scenes::StagedScene& scene, const std::function<void(State&)>& push,
                     const RunObserver& observer, VerifyResult& result);

/// Frequency of a record [Hz], from its first passage through zero upwards to its last; 0 with fewer than two.
double frequency_of(const std::vector<double>& times, const std::vector<double>& values);

/// Amplitude of the sine of a frequency in a record of whole cycles and even steps.
double amplitude_of(const std::vector<double>& times, const std::vector<double>& values, double frequency);

/// A compressed tower in free vibration.
std::vector<Benchmark> tower_vibration_rows();

}  // namespace voussoir::app::studies::verify
