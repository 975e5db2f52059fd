// Ground motions against closed forms, against an independent integration in higher precision, and as functions:
// displacement, velocity and acceleration must be derivatives of one another without a jump.

#include "libdda/model/ground_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "libdda/errors.h"

namespace voussoir
{

namespace
{

constexpr double pi = std::numbers::pi;

std::vector<double> noise(std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> samples(count);
    for (double& sample : samples) sample = uniform(random);
    return samples;
}

/// v(t) = integral of a and d(t) = integral of (t - s) a(s) ds by Gauss points and long doubles, interval by
/// interval: shares nothing with the code under test.
struct Integrated {
    long double velocity = 0, displacement = 0;
};

Integrated integrate(const std::vector<double>& samples, double h, double time)
{
    const long double gauss = 0.5L / std::sqrt(3.0L);
    Integrated result;
    const std::size_t last = samples.size() - 1;
    for (std::size_t i = 0; i < last && static_cast<long double>(i) * h < time; ++i) {
        const long double start = static_cast<long double>(i) * h;
        const long double length = std::min(static_cast<long double>(h), time - start);
        for (const long double point : {0.5L - gauss, 0.5L + gauss}) {
            const long double s = point * length;
            const long double a = samples[i] + (static_cast<long double>(samples[i + 1]) - samples[i]) * s / h;
            result.velocity += a * length / 2;
            result.displacement += (time - start - s) * a * length / 2;
        }
    }
    return result;
}

double peak_displacement(const GroundMotion& motion, double step)
{
    double peak = 0;
    for (int i = 0; i * step <= motion.duration(); ++i)
        peak = std::max(peak, std::abs(motion.displacement(i * step)));
    return peak;
}

/// Central differences of displacement and velocity agree with velocity and acceleration at `time`.
void expect_derivatives(const GroundMotion& motion, double time)
{
    const double e = 1e-5;
    const double velocity = (motion.displacement(time + e) - motion.displacement(time - e)) / (2 * e);
    const double acceleration = (motion.velocity(time + e) - motion.velocity(time - e)) / (2 * e);
    EXPECT_NEAR(motion.velocity(time), velocity, 1e-6 * (1 + std::abs(velocity))) << "at " << time;
    EXPECT_NEAR(motion.acceleration(time), acceleration, 1e-6 * (1 + std::abs(acceleration))) << "at " << time;
}

/// Displacement and velocity do not jump at the sample times nor at the start: between two neighbouring times they
/// change by no more than the largest slope allows.
void expect_no_jump(const GroundMotion& motion, double h, bool velocity_too)
{
    const double e = 1e-9;
    for (int i = 0; i * h <= motion.duration() + h / 2; ++i) {
        const double t = i * h;
        EXPECT_NEAR(motion.displacement(t - e), motion.displacement(t + e), 1e-7) << "at " << t;
        if (velocity_too) {
            EXPECT_NEAR(motion.velocity(t - e), motion.velocity(t + e),
                        2.1 * e * motion.peak_acceleration() + 1e-12)
                << "at " << t;
        }
    }
}

TEST(GroundMotion, LinearAccelerationIsIntegratedExactly)
{
    const double h = 0.25;
    std::vector<double> samples;
    for (int i = 0; i <= 40; ++i) samples.push_back(3.0 * i * h - 2.0);
    const GroundMotion motion = GroundMotion::from_acceleration(samples, h, "ramp");
    for (const double t : {0.0, 0.1, 0.25, 0.3, 4.99, 5.0, 9.87654321}) {
        EXPECT_NEAR(motion.acceleration(t), 3 * t - 2, 1e-13);
        EXPECT_NEAR(motion.velocity(t), 1.5 * t * t - 2 * t, 1e-12);
        EXPECT_NEAR(motion.displacement(t), 0.5 * t * t * t - t * t, 1e-11);
    }
    EXPECT_DOUBLE_EQ(motion.duration(), 10);
    EXPECT_DOUBLE_EQ(motion.peak_acceleration(), 28);
}

TEST(GroundMotion, LongRecordIsExactToTwelveDigitsOfItsPeak)
{
    const double h = 0.005;
    const std::vector<double> samples = noise(60001, 7);  // 300 s
    const GroundMotion motion = GroundMotion::from_acceleration(samples, h, "noise");
    const double peak = peak_displacement(motion, 0.1);
    for (const double t : {0.0012, 1.0, 33.3333, 149.9975, 271.8281828, 299.999, 300.0}) {
        const Integrated exact = integrate(samples, h, t);
        EXPECT_NEAR(motion.displacement(t), static_cast<double>(exact.displacement), 1e-12 * peak) << "at " << t;
        EXPECT_NEAR(motion.velocity(t), static_cast<double>(exact.velocity), 1e-12 * peak) << "at " << t;
    }
}

TEST(GroundMotion, DerivativesAgreeForEveryKindOfInput)
{
    const double h = 0.1;
    const std::vector<double> samples = noise(50, 3);
    const GroundMotion motions[] = {
        GroundMotion::from_acceleration(samples, h, "a"), GroundMotion::from_velocity(samples, h, "v"),
        GroundMotion::from_displacement(samples, h, "d"), GroundMotion::sine_acceleration(2, 1.5, 0.7, 5)};
    for (const GroundMotion& motion : motions) {
        for (int i = 0; i < 47; ++i) {
            expect_derivatives(motion, h * (i + 0.3));
            expect_derivatives(motion, h * (i + 0.85));
        }
        expect_derivatives(motion, 7.7);  // after the end
        expect_derivatives(motion, -1);   // before the start
    }
}

TEST(GroundMotion, NothingJumps)
{
    const double h = 0.1;
    std::vector<double> samples = noise(50, 4);
    expect_no_jump(GroundMotion::from_acceleration(samples, h, "a"), h, true);
    expect_no_jump(GroundMotion::from_displacement(samples, h, "d"), h, true);
    expect_no_jump(GroundMotion::sine_acceleration(2, 1.5, 0.7, 5), h, true);
    expect_no_jump(GroundMotion::from_velocity(samples, h, "v"), h, false);
    samples.front() = 0;  // a velocity that starts from rest does not jump either
    expect_no_jump(GroundMotion::from_velocity(samples, h, "v"), h, true);
}

TEST(GroundMotion, RestsBeforeAndDriftsAfter)
{
    const GroundMotion motion = GroundMotion::from_acceleration({1, 1, 1}, 0.5, "constant");
    EXPECT_EQ(motion.displacement(-0.1), 0);
    EXPECT_EQ(motion.velocity(-0.1), 0);
    EXPECT_EQ(motion.acceleration(-0.1), 0);
    EXPECT_DOUBLE_EQ(motion.residual_velocity(), 1);
    EXPECT_DOUBLE_EQ(motion.residual_displacement(), 0.5);
    EXPECT_EQ(motion.acceleration(1.5), 0);
    EXPECT_DOUBLE_EQ(motion.velocity(1.5), 1);
    EXPECT_DOUBLE_EQ(motion.displacement(3), 2.5);
}

TEST(GroundMotion, VelocityGivesItsTrapezoids)
{
    const GroundMotion motion = GroundMotion::from_velocity({0, 2, 1}, 0.5, "v");
    EXPECT_DOUBLE_EQ(motion.velocity(0.25), 1);
    EXPECT_DOUBLE_EQ(motion.displacement(0.25), 0.125);
    EXPECT_DOUBLE_EQ(motion.displacement(1), 0.5 + 0.75);
    EXPECT_DOUBLE_EQ(motion.acceleration(0.75), -2);
    EXPECT_DOUBLE_EQ(motion.peak_acceleration(), 4);
    EXPECT_DOUBLE_EQ(motion.residual_velocity(), 1);
    EXPECT_DOUBLE_EQ(motion.displacement(2), 2.25);
}

TEST(GroundMotion, DisplacementPassesThroughItsSamplesFromRest)
{
    const std::vector<double> samples = noise(30, 5);
    const GroundMotion motion = GroundMotion::from_displacement(samples, 0.02, "d");
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_NEAR(motion.displacement(0.02 * static_cast<double>(i)), samples[i] - samples[0], 1e-13);
    }
    EXPECT_EQ(motion.velocity(0), 0);
    EXPECT_EQ(motion.displacement(-1), 0);
}

// Printed to 0.1 mm: the last but one sample has the value of the last, the one before it has not.
TEST(GroundMotion, ADisplacementThatEndsFlatEndsAtRest)
{
    const GroundMotion motion = GroundMotion::from_displacement({0, 0.0199, 0.02, 0.02}, 0.01, "flat");
    EXPECT_EQ(motion.residual_velocity(), 0);
    EXPECT_EQ(motion.displacement(10), 0.02);
}

TEST(GroundMotion, SmoothDisplacementGivesItsVelocityToThirdOrder)
{
    const auto largest_error = [](double h) {
        std::vector<double> samples;
        for (int i = 0; i * h <= 2 + h / 2; ++i) samples.push_back(1 - std::cos(2 * pi * i * h));
        const GroundMotion motion = GroundMotion::from_displacement(samples, h, "cosine");
        double error = 0;
        for (int i = 0; i < 1500; ++i) {
            const double t = 0.0013 * i;
            error = std::max(error, std::abs(motion.displacement(t) - (1 - std::cos(2 * pi * t))));
        }
        return error;
    };
    EXPECT_LT(largest_error(0.01), 1e-5);
    EXPECT_GT(largest_error(0.02) / largest_error(0.01), 7);  // 8 for third order
}

TEST(GroundMotion, SineIsTheClosedForm)
{
    const double amplitude = 4.903, frequency = 2.5, duration = 0.4, w = 2 * pi * frequency;
    for (const double phase : {0.0, 0.7, pi / 2, -2.0}) {
        const GroundMotion motion = GroundMotion::sine_acceleration(amplitude, frequency, phase, duration);
        for (const double t : {1e-6, 0.01, 0.123, 0.3999}) {
            const double velocity = amplitude / w * (std::cos(phase) - std::cos(w * t + phase));
            const double displacement = amplitude / w * t * std::cos(phase) -
                                        amplitude / w / w * (std::sin(w * t + phase) - std::sin(phase));
            EXPECT_NEAR(motion.acceleration(t), amplitude * std::sin(w * t + phase), 1e-14);
            EXPECT_NEAR(motion.velocity(t), velocity, 1e-15);
            EXPECT_NEAR(motion.displacement(t), displacement, 1e-16);
        }
        EXPECT_EQ(motion.acceleration(0.41), 0);
        EXPECT_EQ(motion.velocity(9), motion.residual_velocity());
        const double drift = motion.residual_displacement() + 1.6 * motion.residual_velocity();
        EXPECT_NEAR(motion.displacement(2), drift, 1e-14);
    }
}

TEST(GroundMotion, SampledSineConvergesToTheClosedForm)
{
    const GroundMotion exact = GroundMotion::sine_acceleration(4.9, 2.5, 0, 0.4);
    const auto error = [&](double h) {
        std::vector<double> samples;
        for (int i = 0; i * h <= 0.4 + h / 2; ++i) samples.push_back(4.9 * std::sin(2 * pi * 2.5 * i * h));
        const GroundMotion motion = GroundMotion::from_acceleration(samples, h, "sine");
        return std::abs(motion.displacement(0.4) - exact.displacement(0.4));
    };
    EXPECT_LT(error(0.005), 1e-4);
    EXPECT_NEAR(error(0.01) / error(0.005), 4, 0.05);
}

TEST(GroundMotion, EndCorrectionIsLinearInTimeAndEndsAtRest)
{
    const double h = 0.005;
    const std::vector<double> samples = noise(4001, 9);
    const GroundMotion motion = GroundMotion::from_acceleration(samples, h, "noise");
    const GroundMotion corrected = motion.with_end_correction();
    ASSERT_GT(std::abs(motion.residual_displacement()), 1e-3);
    EXPECT_NEAR(corrected.residual_velocity(), 0, 1e-14);
    EXPECT_NEAR(corrected.residual_displacement(), 0, 1e-13);
    const auto added = [&](double t) { return corrected.acceleration(t) - motion.acceleration(t); };
    for (const double t : {1.234, 5.0, 13.3, 19.9}) {
        EXPECT_NEAR(added(t), added(0) + (added(10) - added(0)) * t / 10, 1e-13);
    }
    // Already at rest: nothing to add.
    const GroundMotion again = corrected.with_end_correction();
    EXPECT_NEAR(again.acceleration(7.77), corrected.acceleration(7.77), 1e-14);
}

TEST(GroundMotion, EndCorrectionIsRefusedWhereItHasNoMeaning)
{
    EXPECT_THROW(GroundMotion::from_velocity({0, 1}, 1, "v").with_end_correction(), InputError);
    EXPECT_THROW(GroundMotion::from_displacement({0, 1}, 1, "d").with_end_correction(), InputError);
    EXPECT_THROW(GroundMotion::sine_acceleration(1, 1, 0, 1).with_end_correction(), InputError);
}

TEST(GroundMotion, ScalingScalesEverything)
{
    const GroundMotion motions[] = {GroundMotion::from_acceleration(noise(20, 1), 0.1, "a"),
                                    GroundMotion::sine_acceleration(3, 2, 0.1, 2)};
    for (const GroundMotion& motion : motions) {
        const GroundMotion scaled = motion.scaled(-1.5);
        EXPECT_DOUBLE_EQ(scaled.peak_acceleration(), 1.5 * motion.peak_acceleration());
        for (const double t : {0.05, 1.23, 5.0}) {
            EXPECT_NEAR(scaled.acceleration(t), -1.5 * motion.acceleration(t), 1e-14);
            EXPECT_NEAR(scaled.velocity(t), -1.5 * motion.velocity(t), 1e-14);
            EXPECT_NEAR(scaled.displacement(t), -1.5 * motion.displacement(t), 1e-14);
        }
    }
    EXPECT_NEAR(motions[0].scaled(2).with_end_correction().residual_displacement(), 0, 1e-13);
}

// The ground is where it starts: a survey's own zero does not throw it there.
// The ground rests until then, and all that it does comes as much later; twice delayed is delayed by the sum.
TEST(GroundMotion, DelayMovesAllOfItInTime)
{
    const GroundMotion sampled = GroundMotion::from_acceleration({1, 3, -2, 0.5}, 0.1, "samples"),
                       sine = GroundMotion::sine_acceleration(2, 3, 0.7, 0.8);
    for (const GroundMotion& motion : {sampled, sine}) {
        const GroundMotion late = motion.delayed(0.2).delayed(0.05);
        for (const double time : {0.0, 0.1, 0.2499}) {
            EXPECT_EQ(late.displacement(time), 0);
            EXPECT_EQ(late.velocity(time), 0);
            EXPECT_EQ(late.acceleration(time), 0);
        }
        for (const double time : {0.0, 0.03, 0.17, 0.9, 2.0}) {
            EXPECT_NEAR(late.displacement(time + 0.25), motion.displacement(time), 1e-12);
            EXPECT_NEAR(late.velocity(time + 0.25), motion.velocity(time), 1e-12);
            EXPECT_NEAR(late.acceleration(time + 0.25 + 1e-9), motion.acceleration(time + 1e-9), 1e-6);
        }
        EXPECT_NEAR(late.duration(), motion.duration() + 0.25, 1e-12);
        EXPECT_NEAR(late.residual_velocity(), motion.residual_velocity(), 1e-12);
    }
    EXPECT_THROW(sampled.delayed(0.1).with_end_correction(), InputError);
}

TEST(GroundMotion, CountsDisplacementsFromTheFirstOne)
{
    const GroundMotion motion = GroundMotion::from_displacement({0.3, 0.3, 0.4, 0.5, 0.5}, 0.1, "survey");
    EXPECT_EQ(motion.displacement(0), 0);
    EXPECT_NEAR(motion.displacement(0.4), 0.2, 1e-15);
    EXPECT_EQ(motion.source(), "survey (counted from its first sample, 0.3 m)");
}

TEST(GroundMotion, BadSamplesAreRefusedWithEveryFault)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    try {
        GroundMotion::from_acceleration({nan}, 0, "bad.at2");
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.size(), 3);  // the step, the count, the NaN
        EXPECT_NE(std::string(error.what()).find("bad.at2"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("nan"), std::string::npos);
    }
    EXPECT_THROW(GroundMotion::from_acceleration({0, 1}, -0.1, ""), InputError);
    EXPECT_THROW(GroundMotion::from_acceleration({0, 1}, nan, ""), InputError);
    EXPECT_THROW(GroundMotion::from_velocity({0, INFINITY}, 1, ""), InputError);
    EXPECT_THROW(GroundMotion::from_displacement({}, 1, ""), InputError);
    EXPECT_THROW(GroundMotion::from_displacement({0, 1}, 1e-300, ""), InputError);  // overflows
    EXPECT_THROW(GroundMotion::from_acceleration({1e308, 1e308}, 1e3, ""), InputError);
    EXPECT_THROW(GroundMotion::from_velocity({1, 1, 1}, 1e308, ""), InputError);  // lasts for ever
    EXPECT_THROW(GroundMotion::sine_acceleration(nan, 0, nan, -1), InputError);
    EXPECT_THROW(GroundMotion::sine_acceleration(1, 1e-320, 0, 0.5), InputError);  // its displacement is none
    EXPECT_NO_THROW(GroundMotion::sine_acceleration(1, 1e-3, 0, 0.5));
}

}  // namespace

}  // namespace voussoir
