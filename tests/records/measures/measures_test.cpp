// Measures of motions whose integrals are known in closed form.

#include "records/measures/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdda/errors.h"
#include "records/measures/fourier.h"
#include "tests/records/channels.h"
#include "tests/records/expected.h"

namespace voussoir::records
{

namespace
{

constexpr double pi = std::numbers::pi;

TEST(Measures, OfASine)
{
    const double amplitude = 3, frequency = 2, duration = 5;
    const Channel sine =
        sampled([&](double t) { return amplitude * std::sin(2 * pi * frequency * t); }, 1e-3, 5001);
    const measures::Measures found = measures::measures_of(sine);
    const double w = 2 * pi * frequency;
    EXPECT_NEAR(found.peak_acceleration, amplitude, 1e-12);
    EXPECT_NEAR(found.peak_velocity, 2 * amplitude / w, 1e-4 * amplitude / w);  // v = A/w (1 - cos wt)
    EXPECT_NEAR(found.peak_displacement, amplitude / w * duration, 1e-4);
    EXPECT_NEAR(found.arias_intensity, pi / (2 * standard_gravity) * amplitude * amplitude * duration / 2, 1e-3);
    EXPECT_NEAR(found.cumulative_velocity, 2 / pi * amplitude * duration, 1e-3);
    EXPECT_NEAR(found.duration_5_95, 0.9 * duration, 0.02);
    EXPECT_NEAR(found.duration_5_75, 0.7 * duration, 0.02);
    EXPECT_NEAR(found.time_5, 0.05 * duration, 0.02);
    EXPECT_NEAR(found.predominant_period, 1 / frequency, 0.03 / frequency);
    EXPECT_NEAR(found.residual_velocity, 0, 1e-12);
    EXPECT_NEAR(found.residual_displacement, amplitude / w * duration, 1e-4);
}

TEST(Measures, MeanPeriodOfALongWaveIsItsPeriod)
{
    const Channel wave = sampled(
        [](double t) { return std::exp(-std::pow((t - 20) / 5, 2)) * std::sin(2 * pi * 1.6 * t); }, 0.01, 4001);
    EXPECT_NEAR(measures::measures_of(wave).mean_period, 1 / 1.6, 1e-3);
}

// Samples 0, 4, -4, 0 at 1 s: every figure by hand from triangles and parabolas.
TEST(Measures, OfThreeTrianglesAreExact)
{
    const Channel channel = of_samples({0, 4, -4, 0}, 1);
    const measures::Measures found = measures::measures_of(channel);
    EXPECT_DOUBLE_EQ(found.peak_acceleration, 4);
    EXPECT_DOUBLE_EQ(found.peak_velocity, 3);  // at 1.5 s, between samples: at 1 s it is 2
    // v = 2, then 2 + 4s - 4s^2, then 2 - 4s + 2s^2: never negative, so the end is farthest
    EXPECT_NEAR(found.peak_displacement, 2.0 / 3 + (2 + 2 - 4.0 / 3) + 2.0 / 3, 1e-14);
    EXPECT_NEAR(found.arias_intensity, pi / (2 * standard_gravity) * 16, 1e-13);  // 16/3 each second
    EXPECT_DOUBLE_EQ(found.cumulative_velocity, 6);                               // 2, two triangles of 1, 2
    EXPECT_NEAR(found.residual_velocity, 0, 1e-15);
    // a = 4t: 16 t^3 / 3 = 0.05 * 16; the end is its mirror image
    EXPECT_NEAR(found.time_5, std::cbrt(0.15), 1e-14);
    EXPECT_NEAR(found.time_95, 3 - std::cbrt(0.15), 1e-14);
    EXPECT_NEAR(found.duration_5_95, 3 - 2 * std::cbrt(0.15), 1e-14);
}

TEST(Measures, DisplacementPeaksBetweenSamplesCount)
{
    // a = 2 then -2 (samples 2, -2 at 2 s, ...): v = 2t - t^2 peaks at 1 s and is zero at 2 s; then it falls.
    const measures::Measures found = measures::measures_of(of_samples({2, -2, -6}, 2));
    // d(2) = 4/3 is an extreme at a sample; v(4) = -8
    EXPECT_DOUBLE_EQ(found.peak_velocity, 8);
    const measures::Measures inside =
        measures::measures_of(of_samples({2, -4, 0.5}, 2));  // v = 2t - 3/2 t^2: zero at 4/3 s
    // d(4/3) = 16/9 - 32/27; later d is farther in the other direction
    const GroundMotion motion = to_ground_motion(of_samples({2, -4, 0.5}, 2), "");
    double largest = 0;
    for (int i = 0; i <= 400000; ++i) largest = std::max(largest, std::abs(motion.displacement(i * 1e-5)));
    EXPECT_NEAR(inside.peak_displacement, largest, 1e-9);
    const measures::Measures short_one = measures::measures_of(of_samples({2, -4}, 2));
    EXPECT_NEAR(short_one.peak_displacement, std::max(16.0 / 9 - 32.0 / 27, std::abs(4 - 8.0 / 2)), 1e-14);
}

TEST(Measures, BracketedDurationIsBetweenCrossingsOfTheThreshold)
{
    const Channel channel = of_samples({0, 1, 0.2, -2, 0}, 1);
    EXPECT_DOUBLE_EQ(measures::measures_of(channel, {.bracket_threshold = 0.5}).bracketed_duration, 3.75 - 0.5);
    EXPECT_EQ(measures::measures_of(channel, {.bracket_threshold = 2.5}).bracketed_duration, 0);
    EXPECT_DOUBLE_EQ(measures::measures_of(channel, {.bracket_threshold = 2}).bracketed_duration,
                     0);  // touched once
}

TEST(Measures, FollowTheirScalingLaws)
{
    const Channel channel = noise(4000, 0.005, 7);
    Channel twice = channel;
    for (double& sample : twice.samples) sample *= 2;
    const measures::Measures one = measures::measures_of(channel), two = measures::measures_of(twice);
    EXPECT_DOUBLE_EQ(two.peak_velocity, 2 * one.peak_velocity);
    EXPECT_DOUBLE_EQ(two.peak_displacement, 2 * one.peak_displacement);
    EXPECT_NEAR(two.arias_intensity, 4 * one.arias_intensity, 1e-12 * two.arias_intensity);
    EXPECT_NEAR(two.cumulative_velocity, 2 * one.cumulative_velocity, 1e-12 * two.cumulative_velocity);
    EXPECT_NEAR(two.duration_5_95, one.duration_5_95, 1e-9);
    EXPECT_NEAR(two.mean_period, one.mean_period, 1e-12);
    EXPECT_EQ(two.predominant_period, one.predominant_period);
    // Twice as slow: the same accelerations, periods and durations doubled.
    Channel slow = channel;
    slow.time_step *= 2;
    const measures::Measures slower = measures::measures_of(slow);
    EXPECT_NEAR(slower.arias_intensity, 2 * one.arias_intensity, 1e-12 * slower.arias_intensity);
    EXPECT_NEAR(slower.duration_5_75, 2 * one.duration_5_75, 1e-9);
    EXPECT_NEAR(slower.peak_displacement, 4 * one.peak_displacement, 1e-9 * slower.peak_displacement);
}

TEST(Measures, ArriveInOrderAndCoverTheWholeIntensity)
{
    const Channel channel = noise(1000, 0.01, 3);
    const std::vector<double> arias = measures::arias_up_to(channel.samples, channel.time_step);
    const std::vector<double> head(channel.samples.begin(), channel.samples.begin() + 401);
    const std::vector<double> tail(channel.samples.begin() + 400, channel.samples.end());
    EXPECT_NEAR(measures::arias_up_to(head, 0.01).back() + measures::arias_up_to(tail, 0.01).back(), arias.back(),
                1e-12 * arias.back());
    EXPECT_EQ(measures::time_of_arias(channel.samples, 0.01, arias, 0), 0);
    EXPECT_NEAR(measures::time_of_arias(channel.samples, 0.01, arias, arias[400]), 4, 1e-9);
}

TEST(Measures, OfNothingAreZero)
{
    const measures::Measures found = measures::measures_of(of_samples({0, 0, 0, 0}, 0.01));
    EXPECT_EQ(found.peak_displacement, 0);
    EXPECT_EQ(found.arias_intensity, 0);
    EXPECT_EQ(found.mean_period, 0);
    EXPECT_EQ(found.duration_5_95, 0);
}

TEST(Measures, NeedAnAccelerationWithAUnit)
{
    Channel channel = of_samples({0, 1, 0}, 0.01);
    channel.quantity = Quantity::velocity;
    EXPECT_THROW(measures::measures_of(channel), InputError);
    channel.quantity = Quantity::acceleration;
    channel.unit_in_file.clear();
    EXPECT_THROW(measures::measures_of(channel), InputError);
}

TEST(Fourier, AmplitudeOfATriangleIsItsClosedForm)
{
    // A triangle of height 1 and half width 0.5 s: |A(f)| = 0.5 sinc^2(pi f 0.5), but for sampling at 1 ms.
    const Channel triangle =
        sampled([](double t) { return std::max(0.0, 1 - std::abs(t - 0.5) / 0.5); }, 1e-3, 1001);
    const measures::FourierSpectrum spectrum = measures::fourier_amplitude(triangle, 0.05);
    ASSERT_GT(spectrum.frequencies.size(), 100);
    EXPECT_LE(spectrum.frequencies[1], 0.05);
    for (std::size_t i = 1; i < 100; ++i) {
        const double x = pi * spectrum.frequencies[i] * 0.5;
        EXPECT_NEAR(spectrum.amplitudes[i], 0.5 * std::pow(std::sin(x) / x, 2), 1e-6) << spectrum.frequencies[i];
    }
}

TEST(Fourier, InverseReturnsTheSamples)
{
    const std::vector<double> samples = noise(1000, 0.01, 5).samples;
    for (const std::size_t length : {1000, 1023, 2048}) {
        const std::vector<double> back = measures::inverse_transform(measures::transform(samples, length), length);
        for (std::size_t i = 0; i < samples.size(); ++i) ASSERT_NEAR(back[i], samples[i], 1e-12);
    }
}

// Parseval: the energy of the samples is that of their spectrum.
TEST(Fourier, KeepsTheEnergy)
{
    const Channel channel = noise(1024, 0.01, 9);
    const measures::FourierSpectrum spectrum = measures::fourier_amplitude(channel, 1);
    double in_time = 0, in_frequency = 0;
    for (const double a : channel.samples) in_time += a * a * 0.01;
    const double step = spectrum.frequencies[1];
    for (std::size_t i = 0; i < spectrum.amplitudes.size(); ++i) {
        const bool alone = i == 0 || i + 1 == spectrum.amplitudes.size();
        in_frequency += (alone ? 1 : 2) * spectrum.amplitudes[i] * spectrum.amplitudes[i] * step;
    }
    EXPECT_NEAR(in_frequency, in_time, 1e-10 * in_time);
}

TEST_F(RealRecords, PeaksOfTheLAquilaMainShock)
{
    const Channel aqv = read_record(data_folder() / "motions/laquila2009/AQV_16837_H2.cor.acc", {}).channels[0];
    EXPECT_NEAR(measures::measures_of(aqv).peak_acceleration, 6.507, 5e-4);
}

}  // namespace

}  // namespace voussoir::records
