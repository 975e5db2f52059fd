#include "records/synthetic/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"
#include "records/synthetic/rest.h"

namespace voussoir::records::synthetic
{

std::uint64_t SplitMix64::next()
{
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

double SplitMix64::uniform()
{
    return static_cast<double>(next() >> 11U) * 0x1p-53;
}

double SplitMix64::normal()
{
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
}

namespace
{

constexpr double largest_count = 1e7;  // samples; 14 hours at 5 ms

void check(const SyntheticMotion& p)
{
    std::vector<Fault> faults;
    const auto require = [&](bool good, const char* name, double value, const std::string& expected) {
        if (!good) faults.push_back({std::string("synthetic record: ") + name, text::to_text(value), expected});
    };
    const double nyquist = 0.5 / p.time_step;
    require(p.time_step > 0 && std::isfinite(p.time_step), "time step [s]", p.time_step, "must be > 0");
    require(p.fade > 0 && std::isfinite(p.fade), "fade [s]", p.fade, "must be > 0");
    require(p.duration > 4 * p.fade && p.duration / p.time_step <= largest_count, "duration [s]", p.duration,
            "must be more than 4 fades and at most 1e7 time steps");
    require(p.duration >= 100 * p.time_step, "duration [s]", p.duration, "must be at least 100 time steps");
    require(p.peak_acceleration > 0 && std::isfinite(p.peak_acceleration), "peak acceleration [m/s2]",
            p.peak_acceleration, "must be > 0");
    require(p.ground_frequency > 0 && p.ground_frequency < nyquist / 2, "ground frequency [Hz]",
            p.ground_frequency, "must be > 0 and below a quarter of the sampling rate");
    require(p.ground_damping > 0 && p.ground_damping <= 1, "ground damping ratio", p.ground_damping,
            "must be > 0 and at most 1");
    require(p.high_pass_frequency > 0 && p.high_pass_frequency < p.ground_frequency, "high-pass frequency [Hz]",
            p.high_pass_frequency, "must be > 0 and below the ground frequency");
    if (!faults.empty()) throw InputError(std::move(faults));
}

/// 3 x^2 - 2 x^3 between 0 and 1: rises with zero slope at both ends.
double smooth_step(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * (3 - 2 * x);
}

/// Strength of the noise over the time from 0 to 1: a quick rise, a strong part, a slow fall.
double envelope(double x)
{
    return smooth_step(x / 0.15) * (1 - smooth_step((x - 0.4) / 0.5));
}

/// x'' + 2 z w x' + w^2 x = -a(t), by the trapezoidal rule (no damping of its own, no libm).
class Oscillator
{
 public:
    Oscillator(double frequency, double damping_ratio, double time_step)
        : stiffness_(4 * std::numbers::pi * std::numbers::pi * frequency * frequency),
          damping_(4 * damping_ratio * std::numbers::pi * frequency),
          h_(time_step)
    {
    }
    /// Moves on by one step under the base acceleration at its end.
    void advance(double base_acceleration)
    {
        const double x = displacement_ + h_ * velocity_ + h_ * h_ / 4 * acceleration_;
        const double v = velocity_ + h_ / 2 * acceleration_;
        acceleration_ = (-base_acceleration - damping_ * v - stiffness_ * x) /
                        (1 + damping_ * h_ / 2 + stiffness_ * h_ * h_ / 4);
        displacement_ = x + h_ * h_ / 4 * acceleration_;
        velocity_ = v + h_ / 2 * acceleration_;
    }
    double relative_acceleration() const { return acceleration_; }
    /// Of the mass in space: x'' + a.
    double absolute_acceleration() const { return -damping_ * velocity_ - stiffness_ * displacement_; }

 private:
    double stiffness_, damping_, h_;
    double displacement_ = 0, velocity_ = 0, acceleration_ = 0;
};

std::vector<double> filtered_noise(const SyntheticMotion& p, std::size_t count)
{
    SplitMix64 random(p.seed);
    Oscillator soil(p.ground_frequency, p.ground_damping, p.time_step);
    Oscillator high_pass(p.high_pass_frequency, 0.8, p.time_step);
    std::vector<double> samples(count);
    const auto last = static_cast<double>(count - 1);
    const double fade = p.fade / (last * p.time_step);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = static_cast<double>(i) / last;
        soil.advance(envelope(x) * random.normal());
        high_pass.advance(soil.absolute_acceleration());
        samples[i] = high_pass.relative_acceleration() * smooth_step(x / fade) * smooth_step((1 - x) / fade);
    }
    return samples;
}

}  // namespace

std::vector<double> synthetic_acceleration(const SyntheticMotion& parameters)
{
    check(parameters);
    const auto steps = static_cast<std::size_t>(std::round(parameters.duration / parameters.time_step));
    std::vector<double> samples = filtered_noise(parameters, steps + 1);
    bring_to_rest(samples);
    double largest = 0;
    for (const double sample : samples) largest = std::max(largest, std::abs(sample));
    for (double& sample : samples) sample *= parameters.peak_acceleration / largest;
    return samples;
}

}  // namespace voussoir::records::synthetic
