// Fourier transforms of sampled motions.
#pragma once

#include <complex>
#include <vector>

#include "records/record.h"

namespace voussoir::records::measures
{

/// Fourier amplitudes of an acceleration.
struct FourierSpectrum {
    std::vector<double> frequencies;  // Hz, from 0 to half the sampling rate
    std::vector<double> amplitudes;   // m/s of an acceleration: |integral of a(t) exp(-2 pi i f t) dt|
};

/// Amplitudes by a transform of the samples times the time step, padded with zeros to a power of two that makes
/// the frequencies at most `frequency_step` apart.
/// @throws InputError when the channel is not an acceleration with a unit, or the step is not > 0
FourierSpectrum fourier_amplitude(const Channel& channel, double frequency_step = 0.05);

/// X_k = sum x_j exp(-2 pi i j k / length), k = 0 .. length / 2, of the samples and zeros after them.
std::vector<std::complex<double>> transform(const std::vector<double>& samples, std::size_t length);

/// The real sequence of `length` values whose transform this is.
/// @param spectrum (length / 2 + 1)
std::vector<double> inverse_transform(const std::vector<std::complex<double>>& spectrum, std::size_t length);

}  // namespace voussoir::records::measures
