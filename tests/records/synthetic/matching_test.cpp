// Target spectra, closed-form waves and matching.
#include "records/synthetic/matching.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "libdda/errors.h"
#include "records/synthetic/noise.h"

namespace voussoir::records
{

namespace
{

using std::numbers::pi;

/// Largest pseudo-acceleration of an oscillator by Duhamel's integral in small steps of the straight lines between
/// samples: no recurrence.
double pseudo_acceleration(const Channel& channel, double period, double damping, int parts)
{
    const double w = 2 * pi / period, wd = w * std::sqrt(1 - damping * damping);
    const double step = channel.time_step / parts;
    double cosines = 0, sines = 0, largest = 0;  // decayed integrals of a cos(wd t) and a sin(wd t)
    const double fall = std::exp(-damping * w * step);
    std::size_t k = 0;
    for (std::size_t i = 0; i + 1 < channel.samples.size(); ++i)
        for (int part = 0; part < parts; ++part, ++k) {
            const double a = std::lerp(channel.samples[i], channel.samples[i + 1], (part + 0.5) / parts);
            const double middle = (static_cast<double>(k) + 0.5) * step, end = middle + 0.5 * step;
            cosines = cosines * fall + a * std::cos(wd * middle) * std::sqrt(fall) * step;
            sines = sines * fall + a * std::sin(wd * middle) * std::sqrt(fall) * step;
            const double u = (std::sin(wd * end) * cosines - std::cos(wd * end) * sines) / wd;
            largest = std::max(largest, std::abs(u));
        }
    return largest * w * w;
}

Channel noise(double duration, std::uint64_t seed)
{
    synthetic::SyntheticMotion motion;
    motion.duration = duration;
    motion.seed = seed;
    Channel channel;
    channel.time_step = motion.time_step;
    channel.samples = synthetic::synthetic_acceleration(motion);
    channel.unit_in_file = "m/s2";
    return channel;
}

void expect_match(const Channel& seed, const synthetic::TargetSpectrum& target)
{
    synthetic::MatchReport report;
    const Channel matched = synthetic::match_spectrum(seed, target, {}, report);
    double worst = 0, at = 0;
    for (int i = 0; i <= 300; ++i) {  // between the periods that were matched too
        const double period = 0.05 * std::pow(80.0, i / 300.0);
        const double found = pseudo_acceleration(matched, period, target.damping, 4);
        const double apart = std::abs(found / target.at(period) - 1);
        if (apart > worst) worst = apart, at = period;
    }
    std::printf("%s: within %.1f %% at 301 periods (worst at %.3f s), %.1f %% at the %zu matched, %d passes\n",
                target.name.c_str(), 100 * worst, at, 100 * report.worst, report.periods.size(), report.passes);
    EXPECT_LT(worst, 0.1);
    const GroundMotion motion = to_ground_motion(matched, "matched");
    double furthest = 0, fastest = 0;
    for (int i = 0; i <= 1000; ++i) {
        furthest = std::max(furthest, std::abs(motion.displacement(motion.duration() * i / 1000)));
        fastest = std::max(fastest, std::abs(motion.velocity(motion.duration() * i / 1000)));
    }
    EXPECT_LT(std::abs(motion.residual_displacement()), 1e-9 * furthest);
    EXPECT_LT(std::abs(motion.residual_velocity()), 1e-9 * fastest);
    EXPECT_LT(furthest, 1.0) << "no drift";
}

TEST(Matching, NoiseToEurocode8)
{
    expect_match(noise(24, 1), synthetic::eurocode_8({.type = 1, .ground = 'B', .acceleration = 0.25 * 9.80665}));
    expect_match(noise(20, 4), synthetic::eurocode_8({.type = 2, .acceleration = 2, .vertical = true}));
}

}  // namespace

}  // namespace voussoir::records
