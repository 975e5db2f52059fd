// Peaks of many oscillators' responses to one acceleration.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "records/measures/oscillator.h"

namespace voussoir::records::measures
{

struct ResponsePeaks {
    double displacement = 0;           // m, relative to the ground
    double absolute_acceleration = 0;  // m/s2
};

/// The peaks of each oscillator, as peak_within finds them on every stretch of its ResponseWalk, bit for bit.
/// Eight oscillators walk at a time; only where a bound says that a peak may be passed do they walk again, one by
/// one.
/// @param samples (n >= 2) [m/s2], linear between them; @param time_step [s]
/// @param tell is told the share of the work that is done, now and then; may be empty
std::vector<ResponsePeaks> peaks_of_responses(std::span<const Oscillator> oscillators,
                                              const std::vector<double>& samples, double time_step,
                                              const std::function<void(double)>& tell = {});

}  // namespace voussoir::records::measures
