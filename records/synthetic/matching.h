// Matching a record to a target spectrum.
#pragma once

#include <vector>

#include "records/record.h"
#include "records/synthetic/target_spectrum.h"

namespace voussoir::records::synthetic
{

/// How closely to match, and where.
struct MatchSettings {
    double shortest = 0.05, longest = 4;            // s, the periods to match
    int periods = 200;                              // spaced evenly in their logarithm
    double tolerance = 0.05;                        // largest |spectrum / target - 1| at which to stop
    int spectral_passes = 12, wavelet_passes = 40;  // at most
};

/// How well it matches.
struct MatchReport {
    std::vector<double> periods;                // s
    std::vector<double> target, before, after;  // m/s2, pseudo-acceleration; before: the seed as it came
    double worst = 0, worst_period = 0;         // |after / target - 1| and where [s]
    int passes = 0;                             // of both kinds
};

/// A motion with the seed's phases whose response spectrum follows the target, and whose velocity and displacement
/// end at zero. First the Fourier amplitudes are scaled by target / spectrum, again and again; then wavelets
/// cos(w (t - t0)) exp(-((t - t0) / g)^2), placed where each oscillator peaks, take away what is left.
/// Source: [GaspariniVanmarcke1976]; [LilhanandTseng1988]; [AlAtikAbrahamson2010], eq. 14 to 16.
/// @param seed acceleration, at least as long as four of the longest periods, sampled at a quarter of the shortest
/// or finer
/// @throws InputError when it is not, or the target does not cover the periods
Channel match_spectrum(const Channel& seed, const TargetSpectrum& target, const MatchSettings& settings,
                       MatchReport& report);

}  // namespace voussoir::records::synthetic
