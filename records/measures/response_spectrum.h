// Elastic response spectra of a recorded acceleration.
#pragma once

#include <functional>
#include <vector>

#include "records/record.h"

namespace voussoir::records::measures
{

/// Peaks of the response of damped oscillators, one per period.
struct ResponseSpectrum {
    double damping = 0.05;                      // ratio to critical
    std::vector<double> periods;                // s
    std::vector<double> displacement;           // m, relative to the ground
    std::vector<double> pseudo_velocity;        // m/s, displacement times 2 pi / period
    std::vector<double> pseudo_acceleration;    // m/s2, displacement times (2 pi / period)^2
    std::vector<double> absolute_acceleration;  // m/s2
};

/// Pseudo-acceleration over all orientations of two horizontal components, 0 to 179 deg in steps of 1 deg.
struct RotatedSpectrum {
    double damping = 0.05;              // ratio
    std::vector<double> periods;        // s
    std::vector<double> rotd50;         // m/s2, median over the orientations
    std::vector<double> rotd100;        // m/s2, the largest
    std::vector<double> rotd100_angle;  // deg, from the first component towards the second, of that
};

/// The spectrum of an acceleration that is linear between its samples (uneven ones: as resampled_evenly gives
/// them). The recurrence is exact; a sampling interval is divided so that a stretch is a quarter of a period at
/// most, and peaks are those of the continuous response, found within stretches at the roots of its rate to about
/// 1e-12, over the record and four periods of free vibration after it.
/// @param periods [s], > 0, each at least a thousandth of the time step; @param damping ratio, >= 0
/// @param tell is told the share of the work that is done, now and then; may be empty
/// @throws InputError when the channel is not an acceleration with a unit, or a period or the damping out of range
/// Source: [NigamJennings1969]
ResponseSpectrum response_spectrum(const Channel& channel, const std::vector<double>& periods,
                                   double damping = 0.05, const std::function<void(double)>& tell = {});

/// RotD50 and RotD100 of two components at right angles, of equal time step and count.
/// @throws InputError as response_spectrum, or when the two do not go together
/// Source: [Boore2010]
RotatedSpectrum rotd(const Channel& first, const Channel& second, const std::vector<double>& periods,
                     double damping = 0.05);

/// `count` periods from `shortest` to `longest` [s] in equal ratios.
std::vector<double> logarithmic_periods(double shortest, double longest, std::size_t count);

}  // namespace voussoir::records::measures
