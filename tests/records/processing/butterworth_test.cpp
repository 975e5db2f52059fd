// Filters against Butterworth's formula.

#include "records/processing/butterworth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/records/channels.h"

namespace voussoir::records
{

namespace
{

constexpr double pi = std::numbers::pi;

/// Gain of the filter at a frequency by the response to a single sample, summed to its end.
std::complex<double> gain(std::vector<double> response, std::size_t origin, double frequency, double time_step)
{
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < response.size(); ++i) {
        const double time = (static_cast<double>(i) - static_cast<double>(origin)) * time_step;
        sum += response[i] * std::polar(1.0, -2 * pi * frequency * time);
    }
    return sum;
}

double butterworth_gain(const processing::Butterworth& filter, double frequency, double time_step)
{
    const auto warped = [&](double f) { return std::tan(pi * f * time_step); };
    const double w = warped(frequency);
    double q = 0;
    if (filter.low_corner && filter.high_corner) {
        const double low = warped(*filter.low_corner), high = warped(*filter.high_corner);
        q = (w * w - low * high) / (w * (high - low));
    } else {
        q = filter.low_corner ? warped(*filter.low_corner) / w : w / warped(*filter.high_corner);
    }
    return 1 / std::sqrt(1 + std::pow(q, 2 * filter.order));
}

void expect_butterworth(const processing::Butterworth& filter, double time_step)
{
    std::vector<double> pulse(60001, 0.0);
    const std::size_t origin = filter.zero_phase ? 30000 : 0;
    pulse[origin] = 1;
    const std::vector<double> response = processing::filtered(filter, time_step, pulse);
    ASSERT_EQ(response.size(), pulse.size());
    for (const double frequency : {0.1, 0.2, 0.5, 1.0, 5.0, 17.0, 25.0, 40.0, 49.0}) {
        SCOPED_TRACE(std::to_string(frequency) + " Hz, order " + std::to_string(filter.order));
        const std::complex<double> found = gain(response, origin, frequency, time_step);
        const double expected = butterworth_gain(filter, frequency, time_step);
        if (filter.zero_phase) {
            EXPECT_NEAR(found.real(), expected * expected, 1e-7);
            EXPECT_NEAR(found.imag(), 0, 1e-7);
        } else {
            EXPECT_NEAR(std::abs(found), expected, 1e-7);
        }
    }
}

TEST(ButterworthFilter, HasTheGainOfTheFormulaAtEveryOrder)
{
    for (const bool zero_phase : {false, true}) {
        for (int order = 1; order <= 10; ++order) {
            expect_butterworth({order, 0.5, std::nullopt, zero_phase}, 0.01);
            expect_butterworth({order, std::nullopt, 25, zero_phase}, 0.01);
            expect_butterworth({order, 0.5, 25, zero_phase}, 0.01);
        }
    }
}

TEST(ButterworthFilter, IsThreeDecibelsDownAtACornerAndSixBothWays)
{
    EXPECT_NEAR(20 * std::log10(butterworth_gain({4, 0.5, 25}, 0.5, 0.01)), -3.0103, 1e-4);
    std::vector<double> pulse(60001, 0.0);
    pulse[30000] = 1;
    const std::vector<double> twice = processing::filtered({4, 0.5, 25, true}, 0.01, pulse);
    EXPECT_NEAR(20 * std::log10(std::abs(gain(twice, 30000, 0.5, 0.01))), -6.0206, 1e-4);
    EXPECT_NEAR(20 * std::log10(std::abs(gain(twice, 30000, 25, 0.01))), -6.0206, 1e-4);
}

TEST(ButterworthFilter, ZeroPhaseKeepsASymmetricPulseSymmetricAboutItsCentre)
{
    const auto shape = [](double t) { return std::exp(-std::pow((t - 20) / 0.1, 2)); };
    const Channel pulse = sampled(shape, 0.01, 4001);
    const std::vector<double> out = processing::filtered({4, 0.2, 10, true}, 0.01, pulse.samples);
    EXPECT_EQ(std::max_element(out.begin(), out.end()) - out.begin(), 2000);
    for (std::size_t k = 1; k <= 1000; ++k) EXPECT_NEAR(out[2000 - k], out[2000 + k], 1e-9) << k;
    // The causal one is late.
    const std::vector<double> late = processing::filtered({4, 0.2, 10, false}, 0.01, pulse.samples);
    EXPECT_GT(std::max_element(late.begin(), late.end()) - late.begin(), 2001);
    for (std::size_t i = 0; i < 1900; ++i) ASSERT_NEAR(late[i], 0, 1e-15);  // and never early
}

TEST(ButterworthFilter, EndsDoNotRing)
{
    const std::vector<double> constant(2000, 5.0);
    for (const double sample : processing::filtered({4, std::nullopt, 10, true}, 0.01, constant))
        ASSERT_NEAR(sample, 5, 0.01);
    for (const double sample : processing::filtered({4, 0.2, std::nullopt, true}, 0.01, constant))
        ASSERT_NEAR(sample, 0, 0.05);
    // A filter that starts in the middle of a step rings with all of it.
    std::vector<double> bare = constant;
    processing::run_forward(processing::butterworth_sections({4, 0.2, std::nullopt, false}, 0.01), bare);
    EXPECT_NEAR(bare.front(), 5, 0.1);
}

// Low corners and fine steps put all poles beside z = 1.
TEST(ButterworthFilter, IsSoundAtVeryLowCorners)
{
    const Channel wave = sampled([](double t) { return std::sin(2 * pi * t); }, 0.001, 100001);
    const std::vector<double> out = processing::filtered({8, 0.02, 50, true}, 0.001, wave.samples);
    for (std::size_t i = 30000; i < 70000; ++i) ASSERT_NEAR(out[i], wave.samples[i], 2e-3);
}

}  // namespace

}  // namespace voussoir::records
