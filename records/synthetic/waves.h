// Ground motions in closed form: sines, sweeps and pulses of acceleration.
#pragma once

#include <string>
#include <variant>

#include "records/record.h"

namespace voussoir::records::synthetic
{

/// a(t) = amplitude sin(2 pi frequency t + phase) until `duration`.
struct SineWave {
    double amplitude = 0;  // m/s2
    double frequency = 0;  // Hz
    double phase = 0;      // rad
    double duration = 0;   // s
};

/// The same under an envelope that grows linearly over `ramp`, stays, and falls linearly over `ramp`.
/// Source: [Tsesarsky2002], the input of the shaking table.
struct RampedSine {
    double amplitude = 0;  // m/s2
    double frequency = 0;  // Hz
    double phase = 0;      // rad
    double ramp = 0;       // s, at most half the duration
    double duration = 0;   // s
};

/// A sine whose frequency runs from one value to another, linearly in time or by equal shares in equal times.
struct Sweep {
    double amplitude = 0;      // m/s2
    double from = 0, to = 0;   // Hz
    double duration = 0;       // s
    bool logarithmic = false;  // equal shares of the frequency in equal times
};

/// a(t) = amplitude (1 - 2 b) exp(-b), b = (pi frequency (t - delay))^2, until 2 delay: velocity and displacement
/// end where they began. Source: [Ricker1953].
struct Ricker {
    double amplitude = 0;  // m/s2
    double frequency = 0;  // Hz, where its Fourier spectrum peaks
    double delay = 0;      // s, of the peak; 1.5 / frequency leaves 1e-8 of it at the ends
};

/// One cycle of acceleration, amplitude sin(2 pi t / period): the ground moves forward and stays there (type A of
/// [MakrisChang2000]); or amplitude cos(2 pi t / period): forward and back (their type B).
struct OneCycle {
    /// How it goes.
    enum class Shape {
        sine,    // forward
        cosine,  // forward and back
    };
    double amplitude = 0;       // m/s2
    double period = 0;          // s
    Shape shape = Shape::sine;  // which of the two
};

/// Any of them.
using Wave = std::variant<SineWave, RampedSine, Sweep, Ricker, OneCycle>;

/// Acceleration [m/s2] at `time` [s]; 0 outside 0 to the wave's duration.
double acceleration_of(const Wave& wave, double time);

double duration_of(const Wave& wave);           ///< When it ends [s].
double highest_frequency_of(const Wave& wave);  ///< The highest that occurs [Hz].

/// "Ricker 3 m/s2, 2 Hz", "sweep 1 m/s2, 0.5 to 20 Hz, 10 s".
std::string in_words(const Wave& wave);

/// Samples of the wave from 0 to its end. Between them the ground's acceleration is linear; 200 samples in the
/// shortest period keep the motion within some 1e-4 of the wave's.
/// @param time_step [s] the longest; the step taken divides the duration evenly
/// @throws InputError when a figure of the wave cannot be
Channel sampled(const Wave& wave, double time_step);

/// 1 / 200 of the shortest period [s].
double default_time_step(const Wave& wave);

}  // namespace voussoir::records::synthetic
