#include "records/measures/response_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"
#include "records/measures/acceleration.h"
#include "records/measures/oscillator.h"
#include "records/measures/response_peaks.h"

namespace voussoir::records::measures
{

namespace
{

void require_oscillators(const std::vector<double>& periods, double damping, double time_step)
{
    std::vector<Fault> faults;
    if (!(damping >= 0) || !std::isfinite(damping))
        faults.push_back(
            {"response spectrum: damping ratio", text::to_text(damping), "must be finite and at least 0"});
    for (const double period : periods) {
        if (period >= time_step / 1000 && std::isfinite(period)) continue;
        faults.push_back({"response spectrum: period", text::to_text(period) + " s",
                          "must be finite and at least a thousandth of the time step, " +
                              text::to_text(time_step / 1000) + " s"});
    }
    if (!faults.empty()) throw InputError(std::move(faults));
}

Oscillator oscillator_of(double period, double damping)
{
    return {2 * std::numbers::pi / period, damping};
}

constexpr std::size_t orientations = 180;

struct Directions {
    std::array<double, orientations> cosines, sines;
};

Directions directions_by_degrees()
{
    Directions directions{};
    for (std::size_t i = 0; i < orientations; ++i) {
        const double angle = static_cast<double>(i) * std::numbers::pi / 180;
        directions.cosines[i] = std::cos(angle);
        directions.sines[i] = std::sin(angle);
    }
    return directions;
}

/// The response is linear in the ground's motion: that of a rotated component is the rotated response.
Stretch rotated(const Stretch& x, const Stretch& y, double c, double s)
{
    const auto turn = [&](const OscillatorState& a, const OscillatorState& b) {
        return OscillatorState{c * a.displacement + s * b.displacement, c * a.velocity + s * b.velocity};
    };
    return {turn(x.start, y.start), turn(x.end, y.end), c * x.acceleration + s * y.acceleration,
            c * x.jerk + s * y.jerk, x.length};
}

using Peaks = std::array<double, orientations>;

double smallest(const Peaks& peaks)
{
    return *std::min_element(peaks.begin(), peaks.end());
}

/// Largest relative displacement in each direction at the ends of the stretches.
Peaks peaks_at_ends(const Directions& directions, ResponseWalk walk, ResponseWalk other_walk)
{
    Peaks peaks{};
    double floor = 0;
    int taken = 0;
    for (Stretch x{}, y{}; walk.next(x) && other_walk.next(y);) {
        const double u = x.end.displacement, v = y.end.displacement;
        if (u * u + v * v <= floor * floor) continue;
        for (std::size_t i = 0; i < orientations; ++i)
            peaks[i] = std::max(peaks[i], std::abs(directions.cosines[i] * u + directions.sines[i] * v));
        if (++taken % 16 == 0) floor = smallest(peaks);  // only ever too low
    }
    return peaks;
}

/// Largest relative displacement in each direction. Of most stretches only the ends are looked at: their inside
/// counts where it may leave the chord by more than what is missing to the peak.
Peaks peaks_by_direction(const Oscillator& oscillator, const Channel& first, const Channel& second)
{
    static const Directions directions = directions_by_degrees();
    const Watched watched = watched_displacement();
    ResponseWalk walk(oscillator, first.samples, first.time_step);
    ResponseWalk other_walk(oscillator, second.samples, second.time_step);
    Peaks peaks = peaks_at_ends(directions, walk, other_walk);
    const double smallest_peak = smallest(peaks);
    for (Stretch x{}, y{}; walk.next(x) && other_walk.next(y);) {
        const double sag = largest_sag(oscillator, x) + largest_sag(oscillator, y);
        const double u = x.end.displacement, v = y.end.displacement;
        const double start = std::hypot(x.start.displacement, y.start.displacement);
        if (std::max(start, std::hypot(u, v)) + sag <= smallest_peak) continue;
        for (std::size_t i = 0; i < orientations; ++i) {
            const double c = directions.cosines[i], s = directions.sines[i];
            const double at_end = std::abs(c * u + s * v);
            const double at_start = std::abs(c * x.start.displacement + s * y.start.displacement);
            if (std::max(at_start, at_end) + sag > peaks[i])
                peaks[i] = std::max(peaks[i], peak_within(oscillator, rotated(x, y, c, s), watched));
        }
    }
    return peaks;
}

double median(Peaks values)
{
    std::sort(values.begin(), values.end());
    return (values[orientations / 2 - 1] + values[orientations / 2]) / 2;
}

void require_pair(const Channel& first, const Channel& second)
{
    if (first.samples.size() == second.samples.size() && first.time_step == second.time_step) return;
    throw InputError("rotated spectrum of components " + first.component + " and " + second.component,
                     std::to_string(first.samples.size()) + " samples of " + text::to_text(first.time_step) +
                         " s and " + std::to_string(second.samples.size()) + " of " +
                         text::to_text(second.time_step) + " s",
                     "resample and window them alike first");
}

}  // namespace

ResponseSpectrum response_spectrum(const Channel& channel, const std::vector<double>& periods, double damping,
                                   const std::function<void(double)>& tell)
{
    const Channel even = even_acceleration(channel, "response spectrum");
    require_oscillators(periods, damping, even.time_step);
    ResponseSpectrum spectrum{damping, periods, {}, {}, {}, {}};
    std::vector<Oscillator> oscillators;
    oscillators.reserve(periods.size());
    for (const double period : periods) oscillators.push_back(oscillator_of(period, damping));
    const std::vector<ResponsePeaks> peaks = peaks_of_responses(oscillators, even.samples, even.time_step, tell);
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        const double w = oscillators[i].frequency;
        spectrum.displacement.push_back(peaks[i].displacement);
        spectrum.pseudo_velocity.push_back(peaks[i].displacement * w);
        spectrum.pseudo_acceleration.push_back(peaks[i].displacement * w * w);
        spectrum.absolute_acceleration.push_back(peaks[i].absolute_acceleration);
    }
    return spectrum;
}

RotatedSpectrum rotd(const Channel& first, const Channel& second, const std::vector<double>& periods,
                     double damping)
{
    const Channel even_first = even_acceleration(first, "rotated spectrum");
    const Channel even_second = even_acceleration(second, "rotated spectrum");
    require_pair(even_first, even_second);
    require_oscillators(periods, damping, even_first.time_step);
    RotatedSpectrum spectrum{damping, periods, {}, {}, {}};
    for (const double period : periods) {
        const Oscillator oscillator = oscillator_of(period, damping);
        const Peaks peaks = peaks_by_direction(oscillator, even_first, even_second);
        const auto largest = std::max_element(peaks.begin(), peaks.end());
        const double stiffness = oscillator.frequency * oscillator.frequency;
        spectrum.rotd50.push_back(stiffness * median(peaks));
        spectrum.rotd100.push_back(stiffness * *largest);
        spectrum.rotd100_angle.push_back(static_cast<double>(largest - peaks.begin()));
    }
    return spectrum;
}

std::vector<double> logarithmic_periods(double shortest, double longest, std::size_t count)
{
    std::vector<double> periods(count, shortest);
    for (std::size_t i = 1; i < count; ++i)
        periods[i] =
            shortest * std::pow(longest / shortest, static_cast<double>(i) / static_cast<double>(count - 1));
    return periods;
}

}  // namespace voussoir::records::measures
