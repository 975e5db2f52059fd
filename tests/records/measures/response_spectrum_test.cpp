// Response spectra against closed forms and an integration that shares nothing with them.

#include "records/measures/response_spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "libdda/errors.h"
#include "records/measures/response_peaks.h"
#include "records/units.h"
#include "tests/records/channels.h"
#include "tests/records/expected.h"

namespace voussoir::records
{

namespace
{

constexpr double pi = std::numbers::pi;

struct Peaks {
    double displacement = 0, acceleration = 0;
};

/// Top of the parabola through three equally spaced values.
double top(double left, double middle, double right)
{
    const double bend = left - 2 * middle + right;
    return bend == 0 ? middle : middle - (right - left) * (right - left) / (8 * bend);
}

/// Classical fourth-order Runge-Kutta at `division` steps a sample and two periods of rest after them.
Peaks runge_kutta(const Channel& channel, double period, double damping, int division)
{
    const double w = 2 * pi / period, h = channel.time_step / division;
    const auto rate = [&](double u, double v, double ground) { return -ground - 2 * damping * w * v - w * w * u; };
    std::vector<double> displacement{0}, acceleration{0};
    double u = 0, v = 0;
    const std::size_t rest = static_cast<std::size_t>(std::ceil(2 * period / channel.time_step));
    for (std::size_t i = 0; i + 1 < channel.samples.size() + rest; ++i) {
        const bool inside = i + 1 < channel.samples.size();
        const double start = inside ? channel.samples[i] : 0;
        const double slope = inside ? (channel.samples[i + 1] - start) / division : 0;
        for (int k = 0; k < division; ++k) {
            const double a0 = start + slope * k, a1 = a0 + slope / 2, a2 = a0 + slope;
            const double v1 = v, f1 = rate(u, v, a0);
            const double v2 = v + h / 2 * f1, f2 = rate(u + h / 2 * v1, v2, a1);
            const double v3 = v + h / 2 * f2, f3 = rate(u + h / 2 * v2, v3, a1);
            const double v4 = v + h * f3, f4 = rate(u + h * v3, v4, a2);
            u += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
            v += h / 6 * (f1 + 2 * f2 + 2 * f3 + f4);
            displacement.push_back(u);
            acceleration.push_back(w * w * u + 2 * damping * w * v);
        }
    }
    const auto largest = [](const std::vector<double>& values) {
        double peak = 0;
        for (std::size_t i = 1; i + 1 < values.size(); ++i) {
            if (std::abs(values[i]) < std::abs(values[i - 1]) || std::abs(values[i]) < std::abs(values[i + 1]))
                continue;
            peak = std::max(peak, std::abs(top(values[i - 1], values[i], values[i + 1])));
        }
        return peak;
    };
    return {largest(displacement), largest(acceleration)};
}

void expect_as_runge_kutta(const Channel& channel, const std::vector<double>& periods, double damping)
{
    const measures::ResponseSpectrum spectrum = measures::response_spectrum(channel, periods, damping);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        SCOPED_TRACE("period " + std::to_string(periods[i]) + " damping " + std::to_string(damping));
        const double finest = std::min(channel.time_step, periods[i] / (10 * std::max(1.0, damping))) / 60;
        const int division = static_cast<int>(std::ceil(channel.time_step / finest));
        const Peaks expected = runge_kutta(channel, periods[i], damping, division);
        EXPECT_NEAR(spectrum.displacement[i], expected.displacement, 1e-6 * expected.displacement);
        EXPECT_NEAR(spectrum.absolute_acceleration[i], expected.acceleration, 1e-6 * expected.acceleration);
    }
}

TEST(ResponseSpectrum, AgreesWithRungeKuttaAtAnyPeriodAndDamping)
{
    const Channel channel = noise(300, 0.01, 11);
    for (const double damping : {0.0, 0.02, 0.05, 0.3, 0.999999, 1.0, 1.000001, 3.0})
        expect_as_runge_kutta(channel, {0.003, 0.0101, 0.02, 0.041, 0.1, 0.33, 1, 4, 20}, damping);
}

TEST_F(RealRecords, SpectraOfTheLAquilaMainShockAgreeWithRungeKutta)
{
    for (const char* name : {"AQV_16837_H2", "AQG_16833_H1"}) {
        const std::string file = std::string("motions/laquila2009/") + name + ".cor.acc";
        const Record record = read_record(data_folder() / file, {});
        ASSERT_EQ(record.channels.size(), 1);
        expect_as_runge_kutta(record.channels[0], {0.02, 0.1, 0.5, 2}, 0.05);
    }
}

// Undamped at resonance from rest: u = A/(2 w^2) (w t cos wt - sin wt), at rest in velocity after whole periods.
TEST(ResponseSpectrum, GrowsAtResonanceAsTheClosedForm)
{
    const double amplitude = 2, period = 0.5, w = 2 * pi / period;
    const Channel sine =
        sampled([&](double t) { return amplitude * std::sin(w * t); }, 1e-4, 50001);  // 10 periods
    const measures::ResponseSpectrum spectrum = measures::response_spectrum(sine, {period}, 0);
    EXPECT_NEAR(spectrum.displacement[0], amplitude * pi * 10 / (w * w), 2e-6 * spectrum.displacement[0]);
    EXPECT_NEAR(spectrum.pseudo_acceleration[0], amplitude * pi * 10, 2e-6 * amplitude * pi * 10);
    EXPECT_NEAR(spectrum.absolute_acceleration[0], spectrum.pseudo_acceleration[0], 1e-9 * amplitude * pi * 10);
    EXPECT_NEAR(spectrum.pseudo_velocity[0] * w, spectrum.pseudo_acceleration[0], 1e-9);
}

// A long harmonic motion with damping: the amplitude of the steady state.
TEST(ResponseSpectrum, OfALongHarmonicIsTheSteadyState)
{
    const double amplitude = 1, w = 2 * pi, damping = 0.1;
    const auto envelope = [](double t) { return std::pow(std::sin(pi * t / 100), 2); };
    const Channel sine =
        sampled([&](double t) { return amplitude * envelope(t) * std::sin(w * t); }, 1e-3, 100001);
    const std::vector<double> periods{0.3, 0.8, 1, 1.25, 3};
    const measures::ResponseSpectrum spectrum = measures::response_spectrum(sine, periods, damping);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        const double ratio = periods[i];  // of the motion's frequency (1 Hz) to the oscillator's
        const double dynamic = 1 / std::hypot(1 - ratio * ratio, 2 * damping * ratio);
        EXPECT_NEAR(spectrum.pseudo_acceleration[i], amplitude * dynamic, 3e-3 * dynamic) << periods[i];
    }
}

// A rectangular pulse much longer than the period doubles the static deflection.
TEST(ResponseSpectrum, OfASuddenLoadIsTwiceTheStaticOne)
{
    const Channel step = of_samples(std::vector<double>(2001, 3.0), 0.001);
    EXPECT_NEAR(measures::response_spectrum(step, {0.3}, 0).pseudo_acceleration[0], 6, 1e-12);
}

// Oscillators that walk together have the peaks that each has when every stretch of its walk is looked into.
TEST(ResponseSpectrum, ManyOscillatorsHaveThePeaksOfEachBitForBit)
{
    const Channel channel = noise(3000, 0.01, 5);
    std::vector<measures::Oscillator> oscillators;
    for (const double damping : {0.0, 0.05, 1.5})
        for (const double period : measures::logarithmic_periods(0.011, 9, 21))
            oscillators.push_back({2 * pi / period, damping});
    const auto together = measures::peaks_of_responses(oscillators, channel.samples, channel.time_step);
    ASSERT_EQ(together.size(), oscillators.size());
    for (std::size_t i = 0; i < oscillators.size(); ++i) {
        const measures::Oscillator& oscillator = oscillators[i];
        const measures::Watched acceleration = measures::watched_absolute_acceleration(oscillator);
        measures::ResponsePeaks alone;
        measures::ResponseWalk walk(oscillator, channel.samples, channel.time_step);
        for (measures::Stretch stretch{}; walk.next(stretch);) {
            alone.displacement = std::max(
                alone.displacement, measures::peak_within(oscillator, stretch, measures::watched_displacement()));
            alone.absolute_acceleration =
                std::max(alone.absolute_acceleration, measures::peak_within(oscillator, stretch, acceleration));
        }
        EXPECT_EQ(together[i].displacement, alone.displacement) << i;
        EXPECT_EQ(together[i].absolute_acceleration, alone.absolute_acceleration) << i;
    }
}

TEST(ResponseSpectrum, HasThePeaksOfTheGroundAtItsEnds)
{
    const Channel channel = noise(2000, 0.01, 4);
    const measures::ResponseSpectrum spectrum = measures::response_spectrum(channel, {1e-4, 1000}, 0.05);
    EXPECT_NEAR(spectrum.absolute_acceleration[0], peak(channel), 1e-3 * peak(channel));
    const GroundMotion motion = to_ground_motion(channel, "");
    double ground = 0;  // a very soft oscillator stays where it was
    for (int i = 0; i < 2000; ++i) ground = std::max(ground, std::abs(motion.displacement(i * 0.01)));
    EXPECT_GT(spectrum.displacement[1], 0.9 * ground);
}

// The same motion, sampled more finely along its straight lines, has the same spectrum.
TEST(ResponseSpectrum, DoesNotDependOnTheDivisionOfTheRecord)
{
    const Channel channel = noise(200, 0.02, 8);
    Channel fine = channel;
    fine.time_step = 0.002;
    fine.samples.clear();
    for (std::size_t i = 0; i + 1 < channel.samples.size(); ++i)
        for (int k = 0; k < 10; ++k)
            fine.samples.push_back(std::lerp(channel.samples[i], channel.samples[i + 1], k / 10.0));
    fine.samples.push_back(channel.samples.back());
    const std::vector<double> periods{0.01, 0.05, 0.2, 1, 5};
    const measures::ResponseSpectrum coarse_spectrum = measures::response_spectrum(channel, periods);
    const measures::ResponseSpectrum fine_spectrum = measures::response_spectrum(fine, periods);
    for (std::size_t i = 0; i < periods.size(); ++i) {
        EXPECT_NEAR(coarse_spectrum.displacement[i] / fine_spectrum.displacement[i], 1, 1e-10);
        EXPECT_NEAR(coarse_spectrum.absolute_acceleration[i] / fine_spectrum.absolute_acceleration[i], 1, 1e-10);
    }
}

TEST(RotatedSpectrum, OfOneDirectionFallsWithTheCosine)
{
    const Channel along = noise(500, 0.01, 2);
    Channel across = along;
    for (double& sample : across.samples) sample *= std::tan(30 * pi / 180);  // polarised at 30 deg
    const std::vector<double> periods{0.05, 0.3, 1};
    const measures::RotatedSpectrum found = measures::rotd(along, across, periods);
    const measures::ResponseSpectrum one = measures::response_spectrum(along, periods);
    std::vector<double> cosines;
    for (int angle = 0; angle < 180; ++angle) cosines.push_back(std::abs(std::cos(angle * pi / 180)));
    std::sort(cosines.begin(), cosines.end());
    const double middle = (cosines[89] + cosines[90]) / 2;
    for (std::size_t i = 0; i < periods.size(); ++i) {
        const double full = one.pseudo_acceleration[i] / std::cos(30 * pi / 180);
        EXPECT_NEAR(found.rotd100[i], full, 1e-9 * full);
        EXPECT_EQ(found.rotd100_angle[i], 30);
        EXPECT_NEAR(found.rotd50[i], middle * full, 1e-9 * full);
    }
}

// Every orientation for itself, by the spectrum of the rotated accelerations.
TEST(RotatedSpectrum, IsTheSpectrumOfEveryRotatedComponent)
{
    const Channel x = noise(400, 0.01, 21), y = noise(400, 0.01, 22);
    const std::vector<double> periods{0.02, 0.15, 0.9, 5};
    const measures::RotatedSpectrum found = measures::rotd(x, y, periods);
    std::array<std::vector<double>, 4> by_angle;
    for (int degrees = 0; degrees < 180; ++degrees) {
        Channel turned = x;
        for (std::size_t i = 0; i < x.samples.size(); ++i)
            turned.samples[i] =
                x.samples[i] * std::cos(degrees * pi / 180) + y.samples[i] * std::sin(degrees * pi / 180);
        const measures::ResponseSpectrum spectrum = measures::response_spectrum(turned, periods);
        for (std::size_t k = 0; k < periods.size(); ++k) by_angle[k].push_back(spectrum.pseudo_acceleration[k]);
    }
    for (std::size_t k = 0; k < periods.size(); ++k) {
        std::sort(by_angle[k].begin(), by_angle[k].end());
        EXPECT_NEAR(found.rotd100[k], by_angle[k].back(), 1e-9 * by_angle[k].back());
        EXPECT_NEAR(found.rotd50[k], (by_angle[k][89] + by_angle[k][90]) / 2, 1e-9 * by_angle[k].back());
    }
}

TEST(ResponseSpectrum, RefusesWhatHasNone)
{
    const Channel channel = noise(50, 0.01, 2);
    EXPECT_THROW(measures::response_spectrum(channel, {0}), InputError);
    EXPECT_THROW(measures::response_spectrum(channel, {-1}), InputError);
    EXPECT_THROW(measures::response_spectrum(channel, {1e-9}), InputError);
    EXPECT_THROW(measures::response_spectrum(channel, {1}, -0.1), InputError);
    EXPECT_THROW(measures::rotd(channel, noise(51, 0.01, 2), {1}), InputError);
    EXPECT_THROW(measures::rotd(channel, noise(50, 0.02, 2), {1}), InputError);
}

}  // namespace

}  // namespace voussoir::records
