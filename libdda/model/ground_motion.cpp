#include "libdda/model/ground_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "libdda/errors.h"

namespace voussoir
{

namespace
{

/// A running sum whose rounding errors are carried along and added at the end, so that tens of thousands of
/// samples lose no more than one. Source: [Neumaier1974], "Kahan-Babuska".
struct CompensatedSum {
    double sum = 0, correction = 0;

    void add(double term)
    {
        const double next = sum + term;
        correction += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }
    double value() const { return sum + correction; }
};

std::vector<Fault> sample_faults(const std::vector<double>& samples, double time_step, const std::string& source)
{
    std::vector<Fault> faults;
    if (!(time_step > 0) || !std::isfinite(time_step)) {
        faults.push_back(
            {source, "time step = " + std::to_string(time_step) + " s", "must be finite and greater than 0"});
    }
    if (samples.size() < 2) {
        faults.push_back(
            {source, std::to_string(samples.size()) + " samples", "a ground motion needs at least 2 samples"});
    }
    const auto is_bad = [](double sample) { return !std::isfinite(sample); };
    const auto bad = std::find_if(samples.begin(), samples.end(), is_bad);
    if (bad != samples.end()) {
        const auto count = std::count_if(bad, samples.end(), is_bad);
        faults.push_back({source,
                          "sample " + std::to_string(bad - samples.begin() + 1) + " of " +
                              std::to_string(samples.size()) + " is " + std::to_string(*bad) + " (" +
                              std::to_string(count) + " such in all)",
                          "every sample must be a finite number"});
    }
    return faults;
}

/// Sound samples can still overflow when integrated or differenced.
void require_finite(double value, const std::string& source)
{
    if (std::isfinite(value)) return;
    throw InputError(source, "samples and time step so large or small that the motion overflows",
                     "check their units");
}

void require_samples(const std::vector<double>& samples, double time_step, const std::string& source)
{
    std::vector<Fault> faults = sample_faults(samples, time_step, source);
    if (!faults.empty()) throw InputError(std::move(faults));
    require_finite(static_cast<double>(samples.size()) * time_step, source);  // the duration
}

/// Slopes of a sampled displacement: zero at the start (from rest), central inside, second-order one-sided at the
/// end, and zero where its last two samples are equal: a record that ends flat leaves the ground at rest. @returns
/// (n) [m/s]
std::vector<double> hermite_slopes(const std::vector<double>& d, double h)
{
    const std::size_t last = d.size() - 1;
    std::vector<double> slopes(d.size(), 0.0);
    for (std::size_t i = 1; i < last; ++i) slopes[i] = (d[i + 1] - d[i - 1]) / (2 * h);
    if (d[last] == d[last - 1]) return slopes;
    slopes[last] = last == 1 ? (d[1] - d[0]) / h : (3 * d[last] - 4 * d[last - 1] + d[last - 2]) / (2 * h);
    return slopes;
}

}  // namespace

GroundMotion GroundMotion::from_acceleration(std::vector<double> samples, double time_step, std::string source)
{
    require_samples(samples, time_step, source);
    GroundMotion motion;
    motion.given_as_acceleration_ = true;
    motion.time_step_ = time_step;
    motion.intervals_.reserve(samples.size());
    CompensatedSum velocity, displacement;
    const double h = time_step;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double a0 = samples[i], a1 = samples[i + 1], jerk = (a1 - a0) / h;
        require_finite(jerk, source);
        motion.intervals_.push_back({displacement.value(), velocity.value(), a0, jerk});
        displacement.add(h * velocity.value());
        displacement.add(h * h * (2 * a0 + a1) / 6);
        velocity.add(h * (a0 + a1) / 2);
    }
    motion.intervals_.push_back({displacement.value(), velocity.value(), 0, 0});
    require_finite(displacement.value() + velocity.value(), source);
    for (const double a : samples) motion.peak_acceleration_ = std::max(motion.peak_acceleration_, std::abs(a));
    motion.source_ = std::move(source);
    return motion;
}

GroundMotion GroundMotion::from_velocity(std::vector<double> samples, double time_step, std::string source)
{
    require_samples(samples, time_step, source);
    GroundMotion motion;
    motion.time_step_ = time_step;
    motion.intervals_.reserve(samples.size());
    CompensatedSum displacement;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double slope = (samples[i + 1] - samples[i]) / time_step;
        require_finite(slope, source);
        motion.intervals_.push_back({displacement.value(), samples[i], slope, 0});
        motion.peak_acceleration_ = std::max(motion.peak_acceleration_, std::abs(slope));
        displacement.add(time_step * samples[i] / 2);
        displacement.add(time_step * samples[i + 1] / 2);
    }
    motion.intervals_.push_back({displacement.value(), samples.back(), 0, 0});
    require_finite(displacement.value(), source);
    motion.source_ = std::move(source);
    return motion;
}

GroundMotion GroundMotion::from_displacement(std::vector<double> samples, double time_step, std::string source)
{
    require_samples(samples, time_step, source);
    GroundMotion motion;
    if (const double first = samples[0]; first != 0) {  // the ground is where it starts
        for (double& sample : samples) sample -= first;
        std::ostringstream words;
        words << " (counted from its first sample, " << first << " m)";
        source += words.str();
    }
    motion.time_step_ = time_step;
    motion.intervals_.reserve(samples.size());
    const double h = time_step;
    const std::vector<double> slopes = hermite_slopes(samples, h);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double secant = (samples[i + 1] - samples[i]) / h;
        const double start_acceleration = 2 * (3 * secant - 2 * slopes[i] - slopes[i + 1]) / h;
        const double jerk = 6 * (slopes[i] + slopes[i + 1] - 2 * secant) / (h * h);
        const double end_acceleration = start_acceleration + jerk * h;
        require_finite(start_acceleration + end_acceleration, source);
        motion.intervals_.push_back({samples[i], slopes[i], start_acceleration, jerk});
        motion.peak_acceleration_ =
            std::max({motion.peak_acceleration_, std::abs(start_acceleration), std::abs(end_acceleration)});
    }
    motion.intervals_.push_back({samples.back(), slopes.back(), 0, 0});
    motion.source_ = std::move(source);
    return motion;
}

GroundMotion GroundMotion::sine_acceleration(double amplitude, double frequency, double phase, double duration)
{
    std::vector<Fault> faults;
    const auto require = [&faults](bool good, const char* name, double value, const char* expected) {
        if (!good) faults.push_back({std::string("sine: ") + name, std::to_string(value), expected});
    };
    require(std::isfinite(amplitude), "amplitude [m/s2]", amplitude, "must be finite");
    require(std::isfinite(frequency) && frequency > 0, "frequency [Hz]", frequency, "must be finite and > 0");
    require(std::isfinite(phase), "phase [rad]", phase, "must be finite");
    require(std::isfinite(duration) && duration > 0, "duration [s]", duration, "must be finite and > 0");
    // Of a shorter piece of a period the closed form is the difference of numbers that are nearly the same.
    constexpr double shortest = 1e-4;  // of a period
    if (faults.empty())
        require(frequency * duration >= shortest, "frequency [Hz]", frequency,
                "must be at least 1e-4 / duration: of a longer period there is no wave to see");
    if (!faults.empty()) throw InputError(std::move(faults));

    GroundMotion motion;
    motion.sine_.amplitude = amplitude;
    motion.sine_.rate = 2 * std::numbers::pi * frequency;
    motion.sine_.phase = phase;
    motion.sine_.duration = duration;
    motion.sine_.prepare();
    motion.peak_acceleration_ = std::abs(amplitude);
    motion.source_ = "sine";
    return motion;
}

/// With w = 2 pi f: v = A/w (cos p - cos(wt + p)), d = A/w^2 (wt cos p + sin p - sin(wt + p)).
void GroundMotion::Sine::prepare()
{
    velocity_factor = 2 * amplitude / rate;
    displacement_factor = amplitude / (rate * rate);
    cos_phase = std::cos(phase);
    sin_phase = std::sin(phase);
    last_velocity = velocity(duration);
    last_displacement = displacement(duration);
}

double GroundMotion::Sine::displacement(double time) const
{
    if (time < 0) return 0;
    if (time > duration) return last_displacement + (time - duration) * last_velocity;
    return displacement_factor * (rate * time * cos_phase + sin_phase - std::sin(rate * time + phase));
}

double GroundMotion::Sine::velocity(double time) const
{
    if (time < 0) return 0;
    if (time > duration) return last_velocity;
    // cos p - cos(wt + p) as a product: no cancellation at small times.
    return velocity_factor * std::sin(rate * time / 2) * std::sin(rate * time / 2 + phase);
}

double GroundMotion::Sine::acceleration(double time) const
{
    return time < 0 || time > duration ? 0 : amplitude * std::sin(rate * time + phase);
}

/// The cubic of a sampled motion that holds at `time`. @param[out] since time passed since the start of that cubic
/// [s]
GroundMotion::Cubic GroundMotion::at(double time, double& since) const
{
    DDA_ASSERT(!std::isnan(time));
    since = 0;
    if (delay_ != 0) time -= delay_;
    if (time < 0) return {intervals_.front().displacement, 0, 0, 0};
    const auto last = static_cast<double>(intervals_.size() - 1);
    const double index = std::min(std::floor(time / time_step_), last);
    since = time - index * time_step_;
    return intervals_[static_cast<std::size_t>(index)];
}

double GroundMotion::displacement(double time) const
{
    if (is_sine()) return sine_.displacement(time - delay_);
    double s = 0;
    const Cubic c = at(time, s);
    return c.displacement + s * (c.velocity + s * (c.acceleration / 2 + s * c.jerk / 6));
}

double GroundMotion::velocity(double time) const
{
    if (is_sine()) return sine_.velocity(time - delay_);
    double s = 0;
    const Cubic c = at(time, s);
    return c.velocity + s * (c.acceleration + s * c.jerk / 2);
}

double GroundMotion::acceleration(double time) const
{
    if (is_sine()) return sine_.acceleration(time - delay_);
    double s = 0;
    const Cubic c = at(time, s);
    return c.acceleration + s * c.jerk;
}

double GroundMotion::duration() const
{
    return delay_ + (is_sine() ? sine_.duration : static_cast<double>(intervals_.size() - 1) * time_step_);
}

double GroundMotion::residual_velocity() const
{
    return velocity(duration());
}

double GroundMotion::residual_displacement() const
{
    return displacement(duration());
}

double GroundMotion::peak_acceleration() const
{
    return peak_acceleration_;
}

GroundMotion GroundMotion::scaled(double factor) const
{
    DDA_ASSERT(std::isfinite(factor));
    GroundMotion motion = *this;
    for (Cubic& cubic : motion.intervals_) {
        cubic = {factor * cubic.displacement, factor * cubic.velocity, factor * cubic.acceleration,
                 factor * cubic.jerk};
    }
    motion.sine_.amplitude *= factor;
    motion.sine_.prepare();
    motion.peak_acceleration_ *= std::abs(factor);
    return motion;
}

GroundMotion GroundMotion::delayed(double seconds) const
{
    DDA_ASSERT(std::isfinite(seconds) && seconds >= 0);
    GroundMotion motion = *this;
    motion.delay_ += seconds;
    return motion;
}

/// The added acceleration p + q t solves p T + q T^2/2 = -v(T), p T^2/2 + q T^3/6 = -d(T).
GroundMotion GroundMotion::with_end_correction() const
{
    if (!given_as_acceleration_ || delay_ != 0) {
        throw InputError(source_, "an end correction of a motion that is not a sampled acceleration from 0 s",
                         "remove the correction or give the motion as samples of acceleration");
    }
    const double end = duration();
    const double v = residual_velocity(), d = residual_displacement();
    const double constant = (2 * v * end - 6 * d) / (end * end);
    const double slope = (12 * d - 6 * v * end) / (end * end * end);
    std::vector<double> samples;
    samples.reserve(intervals_.size());
    for (std::size_t i = 0; i + 1 < intervals_.size(); ++i) samples.push_back(intervals_[i].acceleration);
    // The last cubic is the rest after the record; the last sample is where the one before it ends.
    const Cubic& final_interval = intervals_[intervals_.size() - 2];
    samples.push_back(final_interval.acceleration + final_interval.jerk * time_step_);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] += constant + slope * (static_cast<double>(i) * time_step_);
    }
    return from_acceleration(std::move(samples), time_step_, source_);
}

}  // namespace voussoir
