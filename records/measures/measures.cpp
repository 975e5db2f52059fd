#include "records/measures/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "records/measures/acceleration.h"
#include "records/measures/fourier.h"
#include "records/measures/response_spectrum.h"

namespace voussoir::records::measures
{

namespace
{

constexpr double arias_factor = std::numbers::pi / (2 * standard_gravity);  // s2/m

/// Integral of (a + jerk t)^2 from 0 to `time`.
double squared_integral(double a, double jerk, double time)
{
    return time * (a * a + time * (a * jerk + time * jerk * jerk / 3));
}

/// Integral of |a| over an interval of `length` in which it goes from a to b along a straight line.
double absolute_integral(double a, double b, double length)
{
    const double sum = std::abs(a) + std::abs(b);
    if (a * b >= 0) return length * sum / 2;
    return length * (a * a + b * b) / (2 * sum);  // two triangles that meet at the zero
}

double cumulative_absolute_velocity(const Channel& channel)
{
    double sum = 0;
    for (std::size_t i = 0; i + 1 < channel.samples.size(); ++i)
        sum += absolute_integral(channel.samples[i], channel.samples[i + 1], channel.time_step);
    return sum;
}

/// Velocity has its extremes where the acceleration is zero.
double largest_velocity(const GroundMotion& motion, const Channel& channel)
{
    double peak = std::abs(motion.residual_velocity());
    for (std::size_t i = 0; i + 1 < channel.samples.size(); ++i) {
        const double a = channel.samples[i], b = channel.samples[i + 1];
        const double start = static_cast<double>(i) * channel.time_step;
        peak = std::max(peak, std::abs(motion.velocity(start)));
        if (a * b < 0) peak = std::max(peak, std::abs(motion.velocity(start + channel.time_step * a / (a - b))));
    }
    return peak;
}

/// Displacement has its extremes where the velocity v + a t + jerk t^2 / 2 is zero.
double largest_displacement(const GroundMotion& motion, const Channel& channel)
{
    double peak = std::abs(motion.residual_displacement());
    const double step = channel.time_step;
    for (std::size_t i = 0; i + 1 < channel.samples.size(); ++i) {
        const double start = static_cast<double>(i) * step;
        const auto take = [&](double since) {
            if (since >= 0 && since <= step) peak = std::max(peak, std::abs(motion.displacement(start + since)));
        };
        take(0);
        const double v = motion.velocity(start), a = channel.samples[i];
        const double jerk = (channel.samples[i + 1] - a) / step;
        const double discriminant = a * a - 2 * jerk * v;
        if (discriminant < 0) continue;
        // Both roots without cancellation: their product is 2 v / jerk.
        const double far = -(a + std::copysign(std::sqrt(discriminant), a));
        if (jerk != 0) take(far / jerk);
        if (far != 0) take(2 * v / far);
    }
    return peak;
}

/// From the first to the last time at which |a| is at the threshold.
double bracketed_duration(const Channel& channel, double threshold)
{
    const std::vector<double>& a = channel.samples;
    const auto reaches = [&](double sample) { return std::abs(sample) >= threshold; };
    const auto first = std::find_if(a.begin(), a.end(), reaches);
    if (first == a.end()) return 0;
    const auto last = std::find_if(a.rbegin(), a.rend(), reaches).base() - 1;
    // How much earlier the threshold is reached than at `sample`, on the line from `outside`; shares of a step.
    const auto share = [&](double sample, double outside) {
        const double sign = std::copysign(1.0, sample);
        return (std::abs(sample) - threshold) / (std::abs(sample) - sign * outside);
    };
    double steps = static_cast<double>(last - first);
    if (first != a.begin()) steps += share(*first, *(first - 1));
    if (last + 1 != a.end()) steps += share(*last, *(last + 1));
    return steps * channel.time_step;
}

double predominant_period(const Channel& channel, const std::function<void(double)>& tell)
{
    const std::vector<double> periods = logarithmic_periods(0.02, 10, 312);  // 2 % apart
    const std::vector<double> spectrum = response_spectrum(channel, periods, 0.05, tell).pseudo_acceleration;
    return periods[static_cast<std::size_t>(std::max_element(spectrum.begin(), spectrum.end()) -
                                            spectrum.begin())];
}

double mean_period(const Channel& channel)
{
    const FourierSpectrum spectrum = fourier_amplitude(channel, 0.05);
    double weighted = 0, weights = 0;
    for (std::size_t i = 0; i < spectrum.frequencies.size(); ++i) {
        const double frequency = spectrum.frequencies[i];
        if (frequency < 0.25 || frequency > 20) continue;
        const double weight = spectrum.amplitudes[i] * spectrum.amplitudes[i];
        weighted += weight / frequency;
        weights += weight;
    }
    return weights > 0 ? weighted / weights : 0;
}

}  // namespace

double peak_velocity(const Channel& channel)
{
    const Channel even = even_acceleration(channel, "peak velocity");
    return largest_velocity(to_ground_motion(even, even.component), even);
}

std::vector<double> arias_up_to(const std::vector<double>& samples, double time_step)
{
    std::vector<double> cumulated(samples.size(), 0.0);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double jerk = (samples[i + 1] - samples[i]) / time_step;
        cumulated[i + 1] = cumulated[i] + arias_factor * squared_integral(samples[i], jerk, time_step);
    }
    return cumulated;
}

double time_of_arias(const std::vector<double>& samples, double time_step, const std::vector<double>& cumulated,
                     double value)
{
    const auto after = std::lower_bound(cumulated.begin(), cumulated.end(), value);
    if (after == cumulated.begin()) return 0;
    if (after == cumulated.end()) return static_cast<double>(cumulated.size() - 1) * time_step;
    const auto i = static_cast<std::size_t>(after - cumulated.begin()) - 1;
    const double jerk = (samples[i + 1] - samples[i]) / time_step;
    const double missing = (value - cumulated[i]) / arias_factor;
    double early = 0, late = time_step;  // the integral grows with time: bisection to the last digit
    for (int k = 0; k < 60; ++k) {
        const double middle = (early + late) / 2;
        (squared_integral(samples[i], jerk, middle) < missing ? early : late) = middle;
    }
    return static_cast<double>(i) * time_step + late;
}

Measures measures_of(const Channel& channel, const MeasureOptions& options)
{
    const Channel even = even_acceleration(channel, "measures");
    const GroundMotion motion = to_ground_motion(even, even.component);
    const std::vector<double> arias = arias_up_to(even.samples, even.time_step);
    const auto time_of = [&](double share) {
        return time_of_arias(even.samples, even.time_step, arias, share * arias.back());
    };
    Measures measures;
    measures.peak_acceleration = peak(channel);
    measures.peak_velocity = largest_velocity(motion, even);
    measures.peak_displacement = largest_displacement(motion, even);
    measures.arias_intensity = arias.back();
    measures.cumulative_velocity = cumulative_absolute_velocity(even);
    measures.time_5 = time_of(0.05);
    measures.time_75 = time_of(0.75);
    measures.time_95 = time_of(0.95);
    measures.duration_5_75 = measures.time_75 - measures.time_5;
    measures.duration_5_95 = measures.time_95 - measures.time_5;
    measures.bracketed_duration = bracketed_duration(even, options.bracket_threshold);
    measures.predominant_period = predominant_period(even, options.tell);
    measures.mean_period = mean_period(even);
    measures.residual_velocity = motion.residual_velocity();
    measures.residual_displacement = motion.residual_displacement();
    return measures;
}

}  // namespace voussoir::records::measures
