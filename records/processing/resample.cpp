// Another time step: band-limited when coarser, on the engine's own motion when finer.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "records/measures/fourier.h"
#include "records/processing/butterworth.h"
#include "records/processing/steps.h"

namespace voussoir::records::processing
{

namespace
{

constexpr double largest_count = 2e7;  // samples

struct Fraction {
    std::size_t top = 1, bottom = 1;
};

/// The simplest fraction within `tolerance` of `value`, by its continued fraction.
Fraction fraction_near(double value, double tolerance)
{
    double rest = value;
    Fraction before{1, 0}, current{static_cast<std::size_t>(value), 1};
    for (int i = 0; i < 40; ++i) {
        const double found = static_cast<double>(current.top) / static_cast<double>(current.bottom);
        const double share = rest - std::floor(rest);
        if (std::abs(found - value) <= tolerance || share == 0) break;
        rest = 1 / share;
        const auto whole = static_cast<std::size_t>(rest);
        const Fraction next{whole * current.top + before.top, whole * current.bottom + before.bottom};
        before = current;
        current = next;
    }
    return current;
}

std::size_t count_at(const Channel& channel, double time_step)
{
    return static_cast<std::size_t>(std::floor(duration_of(channel) / time_step + 1e-6)) + 1;
}

std::vector<double> finer(const Channel& channel, double time_step, const std::string& place)
{
    std::vector<double> samples(count_at(channel, time_step));
    const bool is_cubic = channel.quantity == Quantity::displacement;
    const GroundMotion motion = to_ground_motion(channel, place);
    const std::size_t last = channel.samples.size() - 1;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double time = std::min(static_cast<double>(i) * time_step, duration_of(channel));
        const double steps = time / channel.time_step;
        const auto before = std::min(static_cast<std::size_t>(steps), last - 1);
        samples[i] = is_cubic ? motion.displacement(time)
                              : std::lerp(channel.samples[before], channel.samples[before + 1],
                                          steps - static_cast<double>(before));
    }
    return samples;
}

/// 1 below 0.8 of half the new sampling rate, 0 above it, a cosine wave between. @param share of that half
double passed(double share)
{
    if (share <= 0.8) return 1;
    return share >= 1 ? 0 : (1 + std::cos(std::numbers::pi * (share - 0.8) / 0.2)) / 2;
}

/// The samples as one period of a periodic motion: the last one fades to zero and out of it grows the first.
std::vector<double> closed(const std::vector<double>& samples, std::size_t length)
{
    std::vector<double> loop = samples;
    const std::size_t half = (length - samples.size()) / 2;
    const std::vector<double> after = fade_to_zero(samples.back(), half);
    std::vector<double> before = fade_to_zero(samples.front(), length - samples.size() - half);
    std::reverse(before.begin(), before.end());
    loop.insert(loop.end(), after.begin(), after.end());
    loop.insert(loop.end(), before.begin(), before.end());
    return loop;
}

/// The period is a whole number of both time steps, so that the transform of the one, cut short, is that of the
/// other.
std::vector<double> coarser(const Channel& channel, double time_step)
{
    const std::size_t count = count_at(channel, time_step);
    const double ratio = time_step / channel.time_step;
    // The last sample is a hundred-thousandth of a step away from where it should be, at most.
    const Fraction steps = fraction_near(ratio, 1e-5 / static_cast<double>(count));
    const double margin = 100 * ratio;  // for the fading; the filter's own memory is some 10 new steps
    const double needed = static_cast<double>(channel.samples.size()) + margin;
    const auto repeats = static_cast<std::size_t>(std::ceil(needed / static_cast<double>(steps.top)));
    const std::size_t length = repeats * steps.top, new_length = repeats * steps.bottom;
    std::vector<std::complex<double>> spectrum = measures::transform(closed(channel.samples, length), length);
    spectrum.resize(new_length / 2 + 1);
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
        const double share = 2 * static_cast<double>(k) / static_cast<double>(new_length);
        spectrum[k] *= passed(share) * static_cast<double>(new_length) / static_cast<double>(length);
    }
    std::vector<double> samples = measures::inverse_transform(spectrum, new_length);
    samples.resize(count);
    return samples;
}

}  // namespace

void apply(const Resample& step, const std::string& place, ProcessedRecord& record)
{
    std::string sentence;
    for (Channel& channel : record.channels) {
        const double old_step = channel.time_step, old_peak = peak(channel);
        const bool is_coarser = step.time_step > old_step;
        if (duration_of(channel) / step.time_step > largest_count || duration_of(channel) < step.time_step)
            throw InputError(place, "time step [s] = " + figure(step.time_step),
                             "1 to 2e7 steps in the record's " + figure(duration_of(channel)) + " s");
        const bool is_same = std::abs(step.time_step - old_step) <= 1e-12 * old_step;
        if (!is_same) {
            channel.samples =
                is_coarser ? coarser(channel, step.time_step) : finer(channel, step.time_step, place);
            channel.time_step = step.time_step;
        }
        sentence += (sentence.empty() ? "" : "; ") + channel.component + (channel.component.empty() ? "" : " ") +
                    "resampled from " + figure(old_step) + " s to " + figure(step.time_step) + " s, " +
                    (is_same      ? "which it had"
                     : is_coarser ? "band-limited to " + figure(0.4 / step.time_step) + " Hz"
                                  : "along the motion between its samples") +
                    ", largest sample from " + figure(old_peak) + " to " + figure(peak(channel)) + " " +
                    si_unit(channel.quantity);
    }
    record.sentences.push_back(sentence);
}

}  // namespace voussoir::records::processing
