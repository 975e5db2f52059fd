#include "records/synthetic/waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdda/errors.h"
#include "records/synthetic/target_spectrum.h"

namespace voussoir::records
{

namespace
{

using std::numbers::pi;

GroundMotion motion_of(const synthetic::Wave& wave)
{
    return to_ground_motion(synthetic::sampled(wave, synthetic::default_time_step(wave)), "wave");
}

/// Straight lines between 200 samples a period take (w h)^2 / 12 from the integrals of a sine.
constexpr double chords = (2 * pi / 200) * (2 * pi / 200) / 12;

TEST(Waves, OneCycleOfSineMovesTheGroundForward)
{
    const double a = 2, period = 0.7, w = 2 * pi / period;
    const GroundMotion motion = motion_of(synthetic::OneCycle{a, period, synthetic::OneCycle::Shape::sine});
    EXPECT_NEAR(motion.residual_velocity(), 0, 1e-12);
    EXPECT_NEAR(motion.residual_displacement(), a * period / w, 1.1 * chords * a * period / w);
    EXPECT_NEAR(motion.velocity(period / 2) / (2 * a / w), 1 - chords, 1e-7);
}

TEST(Waves, OneCycleOfCosineComesBack)
{
    const double a = 2, period = 0.7, w = 2 * pi / period;
    const GroundMotion motion = motion_of(synthetic::OneCycle{a, period, synthetic::OneCycle::Shape::cosine});
    EXPECT_NEAR(motion.displacement(period / 2) / (2 * a / (w * w)), 1 - chords, 1e-7);
    EXPECT_NEAR(motion.residual_velocity(), 0, 1e-12);
    EXPECT_NEAR(motion.residual_displacement(), 0, 1e-12);
}

TEST(Waves, RickerEndsWhereItBeganAndMovesByItsClosedForm)
{
    const double a = 3, f = 2, delay = 1.5 / f;
    const synthetic::Wave wave = synthetic::Ricker{a, f, delay};
    const GroundMotion motion = motion_of(wave);
    const double farthest = a / (2 * pi * pi * f * f);  // displacement -farthest exp(-b) + rest far away
    EXPECT_NEAR(motion.displacement(delay), -farthest, 2e-4 * farthest);
    EXPECT_NEAR(motion.residual_displacement(), 0, 1e-6 * farthest);
    EXPECT_DOUBLE_EQ(synthetic::acceleration_of(wave, delay), a);
    EXPECT_LT(std::abs(synthetic::acceleration_of(wave, 0)), 1e-7 * a);
}

/// Zero crossings of the samples between two times.
int crossings(const Channel& channel, double from, double to)
{
    int count = 0;
    for (std::size_t i = 1; i < channel.samples.size(); ++i) {
        const double t = static_cast<double>(i) * channel.time_step;
        count += t > from && t <= to && (channel.samples[i] > 0) != (channel.samples[i - 1] > 0);
    }
    return count;
}

TEST(Waves, SweepsRunThroughTheirFrequencies)
{
    // Half cycles in a stretch: twice the integral of the frequency over it.
    const Channel linear = synthetic::sampled(synthetic::Sweep{1, 1, 11, 10, false}, 1e-3);
    EXPECT_NEAR(crossings(linear, 0, 5), 2 * (1 * 5 + 0.5 * 5 * 5), 1);
    EXPECT_NEAR(crossings(linear, 5, 10), 2 * (6 * 5 + 0.5 * 5 * 5), 1);
    const Channel logarithmic = synthetic::sampled(synthetic::Sweep{1, 1, 16, 8, true}, 1e-3);
    const double growth = std::log(16.0) / 8;
    EXPECT_NEAR(crossings(logarithmic, 0, 4), 2 * (std::exp(4 * growth) - 1) / growth, 1);
    EXPECT_NEAR(crossings(logarithmic, 4, 8), 2 * (16 - std::exp(4 * growth)) / growth, 1);
}

TEST(Waves, RampedSineStaysUnderItsEnvelope)
{
    const Channel channel = synthetic::sampled(synthetic::RampedSine{2, 2.66, 0, 1.5, 5}, 1e-3);
    double early = 0, middle = 0;
    for (std::size_t i = 0; i < channel.samples.size(); ++i) {
        const double t = static_cast<double>(i) * channel.time_step, a = std::abs(channel.samples[i]);
        EXPECT_LE(a, 2 * std::min({t / 1.5, (5 - t) / 1.5, 1.0}) + 1e-12);
        if (t < 0.75) early = std::max(early, a);
        if (t > 1.5 && t < 3.5) middle = std::max(middle, a);
    }
    EXPECT_NEAR(middle, 2, 1e-3);
    EXPECT_NEAR(early, 1, 0.15);
}

TEST(Waves, BadFiguresAreRefused)
{
    EXPECT_THROW(synthetic::sampled(synthetic::SineWave{1, 2, 0, 0}, 1e-3), InputError);
    EXPECT_THROW(synthetic::sampled(synthetic::SineWave{1, 2, 0, 1}, 0.2), InputError) << "ten steps in a period";
    EXPECT_THROW(synthetic::sampled(synthetic::SineWave{1, 2, 0, 1e9}, 1e-3), InputError)
        << "no room for 1e12 samples";
    EXPECT_THROW(synthetic::sampled(synthetic::RampedSine{1, 2, 0, 3, 5}, 1e-3), InputError);
    EXPECT_THROW(synthetic::sampled(synthetic::Sweep{1, 0, 3, 5, true}, 1e-3), InputError);
}

// [EN1998-1-2004], table 3.2: ground C, type 1: S = 1.15, TB = 0.20, TC = 0.6, TD = 2.0 s.
TEST(TargetSpectrum, Eurocode8AtItsCorners)
{
    const double ag = 2.5;
    const synthetic::TargetSpectrum target = synthetic::eurocode_8({.type = 1, .ground = 'C', .acceleration = ag});
    EXPECT_DOUBLE_EQ(target.at(0), 1.15 * ag);
    EXPECT_DOUBLE_EQ(target.at(0.4), 2.5 * 1.15 * ag);
    EXPECT_DOUBLE_EQ(target.at(1.2), 2.5 * 1.15 * ag / 2);
    EXPECT_DOUBLE_EQ(target.at(4), 2.5 * 1.15 * ag * 0.6 * 2 / 16);
    for (const double corner : {0.2, 0.6, 2.0})
        EXPECT_NEAR(target.at(corner * (1 - 1e-9)), target.at(corner * (1 + 1e-9)), 1e-7 * ag);
    const synthetic::TargetSpectrum soft =
        synthetic::eurocode_8({.type = 1, .ground = 'C', .acceleration = ag, .damping = 0.2});
    EXPECT_NEAR(soft.at(0.4) / target.at(0.4), std::sqrt(10.0 / 25), 1e-12);
    EXPECT_THROW(synthetic::eurocode_8({.type = 3, .acceleration = 1}), InputError);
    EXPECT_THROW(synthetic::eurocode_8({.ground = 'F', .acceleration = 1}), InputError);
}

TEST(TargetSpectrum, ATableIsLinearBetweenItsPoints)
{
    const synthetic::TargetSpectrum target = synthetic::tabulated_spectrum("site", {0.1, 0.5, 4}, {2, 4, 1}, 0.05);
    EXPECT_DOUBLE_EQ(target.at(0.3), 3);
    EXPECT_DOUBLE_EQ(target.at(0.1), 2);
    EXPECT_DOUBLE_EQ(target.at(4), 1);
    EXPECT_THROW(synthetic::tabulated_spectrum("site", {0.5, 0.1}, {1, 1}, 0.05), InputError);
    EXPECT_THROW(synthetic::tabulated_spectrum("site", {0.1, 0.5}, {1, 0}, 0.05), InputError);
}

}  // namespace

}  // namespace voussoir::records
