// A seeded synthetic accelerogram for the cases that ship with the program: reproducible, free, and honest about
// not being a recorded earthquake.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "records/record.h"

namespace voussoir::records::synthetic
{

/// What the noise shall be like.
struct SyntheticMotion {
    double duration = 10;              // s
    double time_step = 0.005;          // s
    double peak_acceleration = 3;      // m/s2
    double ground_frequency = 3;       // Hz, where the soil resonates
    double ground_damping = 0.4;       // ratio; smaller is more nearly one frequency
    double high_pass_frequency = 0.3;  // Hz, below which the motion falls off as f^2
    double fade = 0.2;                 // s, the first and last stretch, in which it grows from and falls to zero
    std::uint64_t seed = 1;            // of the generator
};

/// White noise under an envelope, through the Kanai-Tajimi soil filter and the Clough-Penzien high-pass, faded at
/// both ends, with a small smooth correction after which the velocity and displacement of the piecewise linear
/// acceleration both end at zero, scaled to the peak. Uses only + - * / of IEEE doubles and its own generator, so
/// that a seed gives the same record on every machine.
/// @returns samples (duration / time_step + 1) [m/s2]
/// @throws InputError with every parameter that is out of range
/// Source: [Kanai1957], [Tajimi1960], [CloughPenzien1975], eq. 28-27
std::vector<double> synthetic_acceleration(const SyntheticMotion& parameters);

/// splitmix64. Source: [SteeleLeaFlood2014]
class SplitMix64
{
 public:
    /// Equal seeds give equal numbers.
    explicit SplitMix64(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();  // 64 bits
    double uniform();      // in [0, 1), 53 bits
    double normal();  // mean 0, variance 1, within 6: the sum of twelve uniforms, so that no logarithm is needed

 private:
    std::uint64_t state_;
};

}  // namespace voussoir::records::synthetic
