// Fourier amplitudes of a motion, scaled frequency by frequency.
#pragma once

#include <vector>

namespace voussoir::records::synthetic
{

/// Multiplies the Fourier amplitudes of `samples` by factors given at ascending frequencies [Hz], linear in the
/// logarithm of the frequency between them. Above the last they keep its factor; below the first they fall off
/// with the square of the frequency. Phases stay. The samples are padded with as many zeros for the transform.
/// @param step [s] between samples
void scale_fourier_amplitudes(const std::vector<double>& frequencies, const std::vector<double>& factors,
                              double step, std::vector<double>& samples);

}  // namespace voussoir::records::synthetic
