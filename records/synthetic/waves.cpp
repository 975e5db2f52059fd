#include "records/synthetic/waves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"

namespace voussoir::records::synthetic
{

namespace
{

using std::numbers::pi;

constexpr double largest_count = 1e7;  // samples

double value(const SineWave& wave, double t)
{
    return wave.amplitude * std::sin(2 * pi * wave.frequency * t + wave.phase);
}

double value(const RampedSine& wave, double t)
{
    const double envelope = std::min({t / wave.ramp, (wave.duration - t) / wave.ramp, 1.0});
    return envelope * wave.amplitude * std::sin(2 * pi * wave.frequency * t + wave.phase);
}

/// The phase is the integral of the frequency f0 + (f1 - f0) t / T, or f0 (f1 / f0)^(t / T).
double value(const Sweep& wave, double t)
{
    const double share = t / wave.duration;
    const double growth = std::log(wave.to / wave.from);
    const double cycles = wave.logarithmic && growth != 0
                              ? wave.from * wave.duration * std::expm1(growth * share) / growth
                              : wave.duration * share * (wave.from + 0.5 * (wave.to - wave.from) * share);
    return wave.amplitude * std::sin(2 * pi * cycles);
}

double value(const Ricker& wave, double t)
{
    const double root = pi * wave.frequency * (t - wave.delay);
    return wave.amplitude * (1 - 2 * root * root) * std::exp(-root * root);
}

double value(const OneCycle& wave, double t)
{
    const double angle = 2 * pi * t / wave.period;
    return wave.amplitude * (wave.shape == OneCycle::Shape::sine ? std::sin(angle) : std::cos(angle));
}

double duration(const Ricker& wave)
{
    return 2 * wave.delay;
}
double duration(const OneCycle& wave)
{
    return wave.period;
}
template <class Other>
double duration(const Other& wave)
{
    return wave.duration;
}

double highest(const Sweep& wave)
{
    return std::max(wave.from, wave.to);
}
/// Its Fourier spectrum has fallen to a hundredth at three times the peak's frequency.
double highest(const Ricker& wave)
{
    return 3 * wave.frequency;
}
double highest(const OneCycle& wave)
{
    return 1 / wave.period;
}
template <class Other>
double highest(const Other& wave)
{
    return wave.frequency;
}

std::string amplitude_in_words(const char* name, double amplitude)
{
    return std::string(name) + " " + text::to_text(amplitude) + " m/s2, ";
}

std::string words(const SineWave& wave)
{
    return amplitude_in_words("sine", wave.amplitude) + text::to_text(wave.frequency) + " Hz, " +
           text::to_text(wave.duration) + " s";
}
std::string words(const RampedSine& wave)
{
    return amplitude_in_words("ramped sine", wave.amplitude) + text::to_text(wave.frequency) + " Hz, " +
           text::to_text(wave.duration) + " s with ramps of " + text::to_text(wave.ramp) + " s";
}
std::string words(const Sweep& wave)
{
    return amplitude_in_words(wave.logarithmic ? "logarithmic sweep" : "sweep", wave.amplitude) +
           text::to_text(wave.from) + " to " + text::to_text(wave.to) + " Hz, " + text::to_text(wave.duration) +
           " s";
}
std::string words(const Ricker& wave)
{
    return amplitude_in_words("Ricker pulse", wave.amplitude) + text::to_text(wave.frequency) + " Hz, peak at " +
           text::to_text(wave.delay) + " s";
}
std::string words(const OneCycle& wave)
{
    return amplitude_in_words(wave.shape == OneCycle::Shape::sine ? "one-cycle sine" : "one-cycle cosine",
                              wave.amplitude) +
           text::to_text(wave.period) + " s";
}

void require(std::vector<Fault>& faults, bool good, const char* name, double found, const char* expected)
{
    if (!good) faults.push_back({std::string("wave: ") + name, text::to_text(found), expected});
}

void check(const SineWave&, std::vector<Fault>&) {}
void check(const RampedSine& wave, std::vector<Fault>& faults)
{
    require(faults, wave.ramp > 0 && 2 * wave.ramp <= wave.duration, "ramp [s]", wave.ramp,
            "must be > 0 and at most half the duration");
}
void check(const Sweep& wave, std::vector<Fault>& faults)
{
    require(faults, std::min(wave.from, wave.to) > 0, "lower frequency [Hz]", std::min(wave.from, wave.to),
            "must be > 0");
}
void check(const Ricker&, std::vector<Fault>&) {}
void check(const OneCycle&, std::vector<Fault>&) {}

}  // namespace

double duration_of(const Wave& wave)
{
    return std::visit([](const auto& w) { return duration(w); }, wave);
}

double highest_frequency_of(const Wave& wave)
{
    return std::visit([](const auto& w) { return highest(w); }, wave);
}

double acceleration_of(const Wave& wave, double time)
{
    if (time < 0 || time > duration_of(wave)) return 0;
    return std::visit([time](const auto& w) { return value(w, time); }, wave);
}

std::string in_words(const Wave& wave)
{
    return std::visit([](const auto& w) { return words(w); }, wave);
}

double default_time_step(const Wave& wave)
{
    return 1 / (200 * highest_frequency_of(wave));
}

Channel sampled(const Wave& wave, double time_step)
{
    const double end = duration_of(wave), frequency = highest_frequency_of(wave);
    std::vector<Fault> faults;
    require(faults, time_step > 0 && std::isfinite(time_step), "time step [s]", time_step, "must be > 0");
    require(faults, end > 0 && end / time_step <= largest_count, "duration [s]", end,
            "must be > 0 and at most 1e7 time steps");
    require(faults, frequency > 0 && frequency * time_step <= 0.1, "frequency [Hz]", frequency,
            "must be > 0, with at least ten time steps in its period");
    std::visit([&](const auto& w) { check(w, faults); }, wave);
    if (!faults.empty()) throw InputError(std::move(faults));

    const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(end / time_step - 1e-9)));
    Channel channel;
    channel.time_step = end / static_cast<double>(steps);
    channel.unit_in_file = "m/s2";
    channel.samples.resize(steps + 1);
    for (std::size_t i = 0; i <= steps; ++i)
        channel.samples[i] = acceleration_of(wave, i == steps ? end : static_cast<double>(i) * channel.time_step);
    return channel;
}

}  // namespace voussoir::records::synthetic
