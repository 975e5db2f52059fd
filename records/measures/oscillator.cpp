#include "records/measures/oscillator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace voussoir::records::measures
{

namespace
{

/// S = s - z w s^2 + ..., from S'' = -2 z w S' - w^2 S: where the closed form would lose its digits.
Influence influence_by_series(const Oscillator& oscillator, double time)
{
    const double twice_damping = 2 * oscillator.damping * oscillator.frequency;
    const double stiffness = oscillator.frequency * oscillator.frequency;
    Influence sum{0, 0, 0, 0};
    double derivative = 0, next = 1;  // of S at 0, of order k and k + 1
    double power = 1;                 // time^k / k!
    for (int k = 0; k < 18; ++k) {
        sum.impulse += derivative * power;
        sum.impulse_rate += next * power;
        sum.step += derivative * power * time / (k + 1);
        sum.ramp += derivative * power * time * time / ((k + 1) * (k + 2));
        const double after = -twice_damping * next - stiffness * derivative;
        derivative = next;
        next = after;
        power *= time / (k + 1);
    }
    return sum;
}

/// I1 and I2 follow from the equation of motion integrated once and twice.
Influence influence_in_closed_form(const Oscillator& oscillator, double time)
{
    const double w = oscillator.frequency, decay = oscillator.damping * w;
    const double root = w * std::sqrt(std::abs(1 - oscillator.damping * oscillator.damping));
    double sine, cosine;  // exp(-decay t) sin(root t) / root and exp(-decay t) cos(root t), or hyperbolic
    if (root * time < 1e-8) {
        sine = time * std::exp(-decay * time);
        cosine = std::exp(-decay * time);
    } else if (oscillator.damping < 1) {
        sine = std::exp(-decay * time) * std::sin(root * time) / root;
        cosine = std::exp(-decay * time) * std::cos(root * time);
    } else {  // in one exponential each: cosh alone would overflow
        const double slow = std::exp((root - decay) * time);
        sine = -slow * std::expm1(-2 * root * time) / (2 * root);
        cosine = slow * (1 + std::exp(-2 * root * time)) / 2;
    }
    const double rate = cosine - decay * sine;
    const double step = (1 - rate - 2 * decay * sine) / (w * w);
    return {sine, rate, step, (time - sine - 2 * decay * step) / (w * w)};
}

/// A watched value with its first and second derivative in time.
struct Rates {
    double value, rate, second;
};

Rates rates(const Oscillator& oscillator, const Watched& watched, const OscillatorState& state,
            double acceleration, double jerk)
{
    const double w = oscillator.frequency, twice_damping = 2 * oscillator.damping * w;
    const double u = state.displacement, v = state.velocity;
    const double second = -acceleration - twice_damping * v - w * w * u;
    const double third = -jerk - twice_damping * second - w * w * v;
    return {watched.of_displacement * u + watched.of_velocity * v,
            watched.of_displacement * v + watched.of_velocity * second,
            watched.of_displacement * second + watched.of_velocity * third};
}

Rates rates_at(const Oscillator& oscillator, const Stretch& stretch, const Watched& watched, double time)
{
    const OscillatorState state =
        advanced(oscillator, influence(oscillator, time), stretch.start, stretch.acceleration, stretch.jerk);
    return rates(oscillator, watched, state, stretch.acceleration + stretch.jerk * time, stretch.jerk);
}

double end_acceleration(const Stretch& stretch)
{
    return stretch.acceleration + stretch.jerk * stretch.length;
}

/// Where `derivative` changes its sign between `left` and `right`, by regula falsi with halved ends (Illinois).
double root_between(const Oscillator& oscillator, const Stretch& stretch, const Watched& watched,
                    double Rates::*derivative, std::array<double, 2> times)
{
    auto [left, right] = times;
    double at_left = rates_at(oscillator, stretch, watched, left).*derivative;
    double at_right = rates_at(oscillator, stretch, watched, right).*derivative;
    const double small = 1e-6 * std::max(std::abs(at_left), std::abs(at_right));
    double time = left;
    for (int i = 0; i < 60 && right - left > 1e-12 * stretch.length; ++i) {
        time = at_right == at_left ? (left + right) / 2 : right - at_right * (right - left) / (at_right - at_left);
        const double here = rates_at(oscillator, stretch, watched, time).*derivative;
        if (std::abs(here) <= small) break;  // the value is off by the square of this
        if ((here > 0) == (at_right > 0)) {
            right = time;
            at_right = here;
            at_left /= 2;
        } else {
            left = time;
            at_left = here;
            at_right /= 2;
        }
    }
    return time;
}

double longest_stretch(const Oscillator& oscillator)
{
    return std::numbers::pi / (8 * oscillator.frequency);
}

}  // namespace

Influence influence(const Oscillator& oscillator, double time)
{
    const double angle = oscillator.frequency * time * std::max(1.0, 2 * oscillator.damping);
    return angle < 0.5 ? influence_by_series(oscillator, time) : influence_in_closed_form(oscillator, time);
}

OscillatorState advanced(const Oscillator& oscillator, const Influence& over, const OscillatorState& start,
                         double acceleration, double jerk)
{
    const double w = oscillator.frequency;
    const double u = start.displacement, v = start.velocity;
    return {u * (over.impulse_rate + 2 * oscillator.damping * w * over.impulse) + v * over.impulse -
                acceleration * over.step - jerk * over.ramp,
            -u * w * w * over.impulse + v * over.impulse_rate - acceleration * over.impulse - jerk * over.step};
}

int stretches_of(const Oscillator& oscillator, double time_step)
{
    return static_cast<int>(std::ceil(time_step / longest_stretch(oscillator)));
}

ResponseWalk::ResponseWalk(const Oscillator& oscillator, const std::vector<double>& samples, double time_step)
    : oscillator_(oscillator),
      samples_(samples),
      sampling_rate_(1 / time_step),
      division_(stretches_of(oscillator, time_step)),
      length_(time_step / division_),
      over_sampled_(influence(oscillator, length_)),
      over_free_(influence(oscillator, longest_stretch(oscillator)))
{
}

ResponseWalk::ResponseWalk(const Oscillator& oscillator, const std::vector<double>& samples, double time_step,
                           std::size_t first, const OscillatorState& state)
    : ResponseWalk(oscillator, samples, time_step)
{
    sample_ = first;
    state_ = state;
}

bool ResponseWalk::next(Stretch& stretch)
{
    constexpr int free_stretches = 64;  // four periods
    const OscillatorState start = state_;
    if (sample_ + 1 < samples_.size()) {
        const double jerk = (samples_[sample_ + 1] - samples_[sample_]) * sampling_rate_;
        const double acceleration = samples_[sample_] + jerk * part_ * length_;
        state_ = advanced(oscillator_, over_sampled_, start, acceleration, jerk);
        stretch = {start, state_, acceleration, jerk, length_};
        if (++part_ == division_) {
            part_ = 0;
            ++sample_;
        }
        return true;
    }
    if (free_ == free_stretches) return false;
    ++free_;
    state_ = advanced(oscillator_, over_free_, start, 0, 0);
    stretch = {start, state_, 0, 0, longest_stretch(oscillator_)};
    return true;
}

Watched watched_displacement()
{
    return {1, 0, 1};
}

Watched watched_absolute_acceleration(const Oscillator& oscillator)
{
    const double stiffness = oscillator.frequency * oscillator.frequency;
    return {stiffness, 2 * oscillator.damping * oscillator.frequency,
            stiffness * std::hypot(1.0, 2 * oscillator.damping)};
}

double peak_within(const Oscillator& oscillator, const Stretch& stretch, const Watched& watched)
{
    const Rates start = rates(oscillator, watched, stretch.start, stretch.acceleration, stretch.jerk);
    const Rates end = rates(oscillator, watched, stretch.end, end_acceleration(stretch), stretch.jerk);
    double peak = std::max(std::abs(start.value), std::abs(end.value));
    const auto take_extreme = [&](double left, double right) {
        const double time = root_between(oscillator, stretch, watched, &Rates::rate, {left, right});
        peak = std::max(peak, std::abs(rates_at(oscillator, stretch, watched, time).value));
    };
    if (start.rate * end.rate < 0) {
        take_extreme(0, stretch.length);
    } else if (start.second * end.second < 0) {
        // The rate turns once between: two extremes may hide, or one beside a start at rest.
        const double turn = root_between(oscillator, stretch, watched, &Rates::second, {0, stretch.length});
        const double rate = rates_at(oscillator, stretch, watched, turn).rate;
        if (start.rate * rate < 0) take_extreme(0, turn);
        if (rate * end.rate < 0) take_extreme(turn, stretch.length);
    }
    return peak;
}

}  // namespace voussoir::records::measures
