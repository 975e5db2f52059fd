// The damped oscillator under a ground acceleration that is linear in time, solved exactly.
#pragma once

#include <cmath>
#include <vector>

namespace voussoir::records::measures
{

struct Oscillator {
    double frequency;  // rad/s, undamped
    double damping;    // ratio to critical, >= 0; 1 and above do not oscillate
};

struct OscillatorState {
    double displacement = 0, velocity = 0;  // m, m/s, relative to the ground
};

/// What the oscillator does within a time s, from rest: S under an impulse, S' its rate, and the integrals I1 of S
/// (a unit step) and I2 of I1 (a unit ramp).
struct Influence {
    double impulse, impulse_rate, step, ramp;
};
Influence influence(const Oscillator& oscillator, double time);

/// A stretch of time in which the acceleration of the ground is linear, with the response at both ends.
struct Stretch {
    OscillatorState start, end;
    double acceleration;  // m/s2, of the ground, at the start
    double jerk;          // m/s3, of the ground
    double length;        // s; at most half a damped period, so that no second derivative vanishes twice in it
};

/// The state after the time of `over`: u = u0 (S' + 2 z w S) + v0 S - a I1 - j I2.
/// Source: [NigamJennings1969], eq. 2-7, in other letters
OscillatorState advanced(const Oscillator& oscillator, const Influence& over, const OscillatorState& start,
                         double acceleration, double jerk);

/// How many stretches, of at most a sixteenth of a period, a sampling interval is divided into.
int stretches_of(const Oscillator& oscillator, double time_step);

/// Walks along the response from rest to an acceleration that is linear between samples, in stretches of at most a
/// sixteenth of a period, and on for four periods after the last sample, when the ground moves on unaccelerated.
class ResponseWalk
{
 public:
    /// @param samples (n >= 2) [m/s2], which must outlive the walk; @param time_step [s]
    ResponseWalk(const Oscillator& oscillator, const std::vector<double>& samples, double time_step);
    /// The same from sample `first` on, where the response is known.
    ResponseWalk(const Oscillator& oscillator, const std::vector<double>& samples, double time_step,
                 std::size_t first, const OscillatorState& state);
    /// The next stretch. @returns false when there is none
    bool next(Stretch& stretch);
    /// The sample at or before the beginning of the next stretch.
    std::size_t sample() const { return sample_; }

 private:
    Oscillator oscillator_;
    const std::vector<double>& samples_;
    double sampling_rate_;  // 1/s
    int division_;          // stretches between two samples
    double length_;         // s, of one
    Influence over_sampled_, over_free_;
    OscillatorState state_;
    std::size_t sample_ = 0;
    int part_ = 0, free_ = 0;
};

/// A response watched: `of_displacement` u + `of_velocity` u'. (1, 0) is the relative displacement,
/// (w^2, 2 z w) the absolute acceleration but for its sign.
struct Watched {
    double of_displacement, of_velocity;
    double swing;  // its amplitude in free vibration, for one of the displacement
};
inline double value(const Watched& watched, const OscillatorState& state)
{
    return watched.of_displacement * state.displacement + watched.of_velocity * state.velocity;
}
Watched watched_displacement();
Watched watched_absolute_acceleration(const Oscillator& oscillator);

/// How far the displacement can leave its chord within the stretch: length^2 / 8 times the largest relative
/// acceleration. That vibrates freely under a linear load, so that its energy, which falls, bounds it. [m]
inline double largest_sag(const Oscillator& oscillator, const Stretch& stretch)
{
    const double w = oscillator.frequency, twice_damping = 2 * oscillator.damping * w;
    const double u = stretch.start.displacement, v = stretch.start.velocity;
    const double second = -stretch.acceleration - twice_damping * v - w * w * u;
    const double third_over_w = -(stretch.jerk + twice_damping * second) / w - w * v;
    return stretch.length * stretch.length / 8 * std::sqrt(second * second + third_over_w * third_over_w);
}

/// The largest |value| within the stretch, ends included: of the continuous response, at the roots of its rate.
double peak_within(const Oscillator& oscillator, const Stretch& stretch, const Watched& watched);

}  // namespace voussoir::records::measures
