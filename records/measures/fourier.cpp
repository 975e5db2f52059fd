#include "records/measures/fourier.h"

#include <fftw3.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <type_traits>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"
#include "records/measures/acceleration.h"

namespace voussoir::records::measures
{

namespace
{

struct DestroyPlan {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
// Estimated, not measured, so that a transform is the same bit for bit at every run.
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;

fftw_complex* as_fftw(std::complex<double>* values)
{
    return reinterpret_cast<fftw_complex*>(values);  // the layouts are the same: [FftwManual], 4.1.1
}

}  // namespace

std::vector<std::complex<double>> transform(const std::vector<double>& samples, std::size_t length)
{
    std::vector<double> padded(length, 0.0);
    std::copy_n(samples.begin(), std::min(samples.size(), length), padded.begin());
    std::vector<std::complex<double>> spectrum(length / 2 + 1);
    const Plan plan(
        fftw_plan_dft_r2c_1d(static_cast<int>(length), padded.data(), as_fftw(spectrum.data()), FFTW_ESTIMATE));
    fftw_execute(plan.get());
    return spectrum;
}

std::vector<double> inverse_transform(const std::vector<std::complex<double>>& spectrum, std::size_t length)
{
    std::vector<std::complex<double>> scratch = spectrum;  // FFTW overwrites its input here
    std::vector<double> samples(length);
    const Plan plan(
        fftw_plan_dft_c2r_1d(static_cast<int>(length), as_fftw(scratch.data()), samples.data(), FFTW_ESTIMATE));
    fftw_execute(plan.get());
    for (double& sample : samples) sample /= static_cast<double>(length);
    return samples;
}

FourierSpectrum fourier_amplitude(const Channel& channel, double frequency_step)
{
    const Channel even = even_acceleration(channel, "Fourier spectrum");
    const double needed = 1 / (even.time_step * frequency_step);  // samples
    if (!(frequency_step > 0) || !(needed < 1e8))
        throw InputError("Fourier spectrum: frequency step", text::to_text(frequency_step) + " Hz",
                         "must be > 0 and ask for less than 1e8 samples");
    const std::size_t count = std::max(even.samples.size(), static_cast<std::size_t>(std::ceil(needed)));
    const std::size_t length = std::bit_ceil(count);
    FourierSpectrum result;
    for (const std::complex<double>& value : transform(even.samples, length)) {
        result.frequencies.push_back(static_cast<double>(result.frequencies.size()) /
                                     (static_cast<double>(length) * even.time_step));
        result.amplitudes.push_back(even.time_step * std::abs(value));
    }
    return result;
}

}  // namespace voussoir::records::measures
