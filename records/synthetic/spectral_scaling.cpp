#include "records/synthetic/spectral_scaling.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>

namespace voussoir::records::synthetic
{

namespace
{

using Plan = std::unique_ptr<fftw_plan_s, decltype(&fftw_destroy_plan)>;

double factor_at(double frequency, const std::vector<double>& frequencies, const std::vector<double>& factors)
{
    if (frequency >= frequencies.back()) return factors.back();
    if (frequency <= frequencies.front()) return factors.front() * std::pow(frequency / frequencies.front(), 2);
    const auto after = std::upper_bound(frequencies.begin(), frequencies.end(), frequency) - frequencies.begin();
    const double share =
        std::log(frequency / frequencies[after - 1]) / std::log(frequencies[after] / frequencies[after - 1]);
    return std::lerp(factors[after - 1], factors[after], share);
}

}  // namespace

void scale_fourier_amplitudes(const std::vector<double>& frequencies, const std::vector<double>& factors,
                              double step, std::vector<double>& samples)
{
    std::size_t count = 1;  // a power of two, at least twice the samples
    while (count < 2 * samples.size()) count *= 2;
    std::vector<double> padded(count);
    std::vector<std::complex<double>> amplitudes(count / 2 + 1);
    auto* const spectrum = reinterpret_cast<fftw_complex*>(amplitudes.data());
    const auto size = static_cast<int>(count);
    const Plan there(fftw_plan_dft_r2c_1d(size, padded.data(), spectrum, FFTW_ESTIMATE), fftw_destroy_plan);
    const Plan back(fftw_plan_dft_c2r_1d(size, spectrum, padded.data(), FFTW_ESTIMATE), fftw_destroy_plan);
    std::copy(samples.begin(), samples.end(), padded.begin());
    fftw_execute(there.get());
    for (std::size_t k = 0; k < amplitudes.size(); ++k) {
        const double frequency = static_cast<double>(k) / (static_cast<double>(count) * step);
        amplitudes[k] *= factor_at(frequency, frequencies, factors) / static_cast<double>(count);
    }
    fftw_execute(back.get());
    std::copy_n(padded.begin(), samples.size(), samples.begin());
}

}  // namespace voussoir::records::synthetic
