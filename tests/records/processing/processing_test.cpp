// The steps of processing, by what physics says of them.

#include "records/processing/processing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdda/errors.h"
#include "records/measures/measures.h"
#include "records/measures/response_spectrum.h"
#include "tests/records/channels.h"
#include "tests/records/expected.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

constexpr double pi = std::numbers::pi;

Channel processed(const Channel& channel, const processing::Processing& steps)
{
    const processing::ProcessedRecord record = processing::process({channel}, steps);
    EXPECT_GE(record.sentences.size(), steps.size());
    return record.channels.front();
}

std::string faults_of(const std::vector<Channel>& channels, const processing::Processing& steps)
{
    try {
        processing::process(channels, steps);
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "accepted";
    return "";
}

Channel horizontal(Channel channel, const std::string& component, double azimuth)
{
    channel.component = component;
    channel.azimuth = azimuth;
    return channel;
}

// ---- windows

TEST(Window, ByTimeKeepsTheSamplesAndSaysWhen)
{
    const Channel channel = noise(1001, 0.01, 1);
    const processing::ProcessedRecord record =
        processing::process({channel}, {processing::TimeWindow{2, 5}, processing::TimeWindow{0.5, 1}});
    ASSERT_EQ(record.channels[0].samples.size(), 51);
    EXPECT_EQ(record.channels[0].samples.front(), channel.samples[250]);
    EXPECT_EQ(record.channels[0].samples.back(), channel.samples[300]);
    EXPECT_DOUBLE_EQ(record.start, 2.5);
    expect_in(record.sentences[0], "window 2 to 5 s: of 10 s");
    EXPECT_EQ(processed(channel, {processing::TimeWindow{4}}).samples.size(), 601);
    expect_in(faults_of({channel}, {processing::TimeWindow{2, 11}}), "processing[0]");
}

TEST(Window, ByAriasHoldsItsShareOfTheJointIntensity)
{
    const std::vector<Channel> channels{noise(4001, 0.005, 1, "x"), noise(4001, 0.005, 2, "y"),
                                        noise(4001, 0.005, 3, "z")};
    const processing::ProcessedRecord record =
        processing::process(channels, {processing::AriasWindow{0.05, 0.95}});
    double whole = 0, held = 0;
    for (const Channel& channel : channels) whole += measures::measures_of(channel).arias_intensity;
    for (const Channel& channel : record.channels) {
        EXPECT_EQ(channel.samples.size(), record.channels[0].samples.size());
        held += measures::measures_of(channel).arias_intensity;
    }
    EXPECT_NEAR(held / whole, 0.9, 2e-3);  // whole samples only
    EXPECT_NEAR(record.arias_share, 0.9, 1e-9);
    expect_in(record.sentences[0], "5 % to 95 %");

    // One channel alone: the times of its own significant duration.
    const measures::Measures measures = measures::measures_of(channels[0]);
    const processing::ProcessedRecord alone =
        processing::process({channels[0]}, {processing::AriasWindow{0.05, 0.95, 1.5}});
    EXPECT_NEAR(alone.start, measures.time_5 - 1.5, 0.0026);
    const processing::ProcessedRecord brief =
        processing::process({channels[0]}, {processing::AriasWindow{0.05, 0.95, 0, 2}});
    EXPECT_NEAR(static_cast<double>(brief.channels[0].samples.size() - 1) * 0.005, 2, 0.006);
    expect_in(brief.sentences[0], "longest");
}

TEST(Window, AriasIsAdditiveOverWindows)
{
    const Channel channel = noise(2001, 0.005, 5);
    const double first = measures::measures_of(processed(channel, {processing::TimeWindow{0, 4}})).arias_intensity;
    const double second = measures::measures_of(processed(channel, {processing::TimeWindow{4}})).arias_intensity;
    const double whole = measures::measures_of(channel).arias_intensity;
    EXPECT_NEAR(first + second, whole, 1e-12);
    const processing::ProcessedRecord twice =
        processing::process({channel}, {processing::TimeWindow{4}, processing::TimeWindow{0, 2}});
    EXPECT_NEAR(twice.arias_share, measures::measures_of(twice.channels[0]).arias_intensity / whole, 1e-9)
        << "of the whole record, after both windows";
    EXPECT_EQ(processing::process({channel}, {processing::RemoveMean{}}).arias_share, 1);
}

// ---- baselines, taper, end

TEST(Baseline, OfAnyOrderRemovesAPolynomialOfThatOrderExactly)
{
    for (int order = 0; order <= 6; ++order) {
        const auto polynomial = [&](double t) {
            double sum = 0;
            for (int k = order; k >= 0; --k) sum = sum * (t / 50 - 1) + (k % 2 == 0 ? 1.5 : -2);
            return sum;
        };
        const Channel channel = sampled(polynomial, 0.005, 20001);
        EXPECT_LT(peak(processed(channel, {processing::RemoveBaseline{order}})), 1e-11) << order;
        if (order > 0) {
            EXPECT_GT(peak(processed(channel, {processing::RemoveBaseline{order - 1}})), 0.01) << order;
        }
    }
}

TEST(Baseline, LeavesNothingOfItselfAndSaysWhatItTook)
{
    const Channel channel = noise(3000, 0.01, 6);
    for (const int order : {0, 1, 3, 6}) {
        const Channel once = processed(channel, {processing::RemoveBaseline{order}});
        const Channel twice = processed(once, {processing::RemoveBaseline{order}});
        for (std::size_t i = 0; i < once.samples.size(); ++i)
            ASSERT_NEAR(once.samples[i], twice.samples[i], 1e-12);
    }
    const Channel line = sampled([](double t) { return 0.25 - 0.5 * t; }, 0.01, 101);
    expect_in(processing::process({line}, {processing::RemoveBaseline{1}}).sentences[0],
              "linear baseline removed: x 0.25 m/s2 - 0.5 m/s3 t");
    expect_in(processing::process({of_samples({1, 2, 6}, 1)}, {processing::RemoveMean{}}).sentences[0],
              "mean removed: x 3 m/s2");
    EXPECT_LT(peak(processed(of_samples({3, 3, 3}, 1), {processing::RemoveMean{}})), 1e-15);
}

TEST(TaperStep, IsZeroAtTheEndsAndOneInside)
{
    const Channel constant = of_samples(std::vector<double>(1001, 2.0), 0.01);
    for (const processing::Taper& taper :
         {processing::Taper{.seconds = 1.0}, processing::Taper{.fraction = 0.1}}) {
        const Channel tapered = processed(constant, {taper});
        EXPECT_EQ(tapered.samples.front(), 0);
        EXPECT_EQ(tapered.samples.back(), 0);
        EXPECT_NEAR(tapered.samples[50], 1, 1e-12);  // half way up
        EXPECT_NEAR(tapered.samples[950], 1, 1e-12);
        for (std::size_t i = 100; i <= 900; ++i) ASSERT_EQ(tapered.samples[i], 2);
    }
    expect_in(faults_of({constant}, {processing::Taper{.seconds = 6.0}}), "at most half");
}

TEST(EndCorrection, BringsTheGroundToRestWhereItStarted)
{
    const Channel channel = noise(2000, 0.01, 12);
    EXPECT_GT(std::abs(measures::measures_of(channel).residual_velocity), 1e-3);
    const Channel corrected = processed(channel, {processing::CorrectEnd{}});
    const measures::Measures measures = measures::measures_of(corrected);
    EXPECT_NEAR(measures.residual_velocity, 0, 1e-12);
    EXPECT_NEAR(measures.residual_displacement, 0, 1e-12);
    // The same as the engine's own.
    const GroundMotion expected = to_ground_motion(channel, "").with_end_correction();
    for (std::size_t i = 0; i + 1 < channel.samples.size(); ++i)
        ASSERT_NEAR(corrected.samples[i], expected.acceleration(static_cast<double>(i) * 0.01 + 1e-9), 1e-5);
}

// ---- filter

TEST(Filter, SaysWhatItDidAndRefusesWhatItCannot)
{
    const Channel channel = noise(4000, 0.01, 3);
    expect_in(processing::process({channel}, {processing::Butterworth{4, 0.1, 25.0}}).sentences[0],
              "Butterworth band pass, 0.1 to 25 Hz, order 4, zero-phase");
    expect_in(processing::process({channel}, {processing::Butterworth{2, 0.1, std::nullopt, false}}).sentences[0],
              "causal");
    expect_in(faults_of({channel}, {processing::RemoveMean{}, processing::Butterworth{4, 0.1, 50.0}}),
              "processing[1]");
    expect_in(faults_of({channel}, {processing::Butterworth{4, 1e-9}}), "for 39.99 s of record");
    const Channel filtered = processed(channel, {processing::Butterworth{4, 0.1, 25.0}});
    EXPECT_LT(std::abs(measures::measures_of(filtered).residual_velocity),
              std::abs(measures::measures_of(channel).residual_velocity));
}

// ---- resampling

TEST(Resampling, ToAFinerStepIsTheSameMotion)
{
    const Channel channel = noise(501, 0.02, 3);
    const Channel fine = processed(channel, {processing::Resample{0.004}});
    ASSERT_EQ(fine.samples.size(), 2501);
    const measures::Measures before = measures::measures_of(channel), after = measures::measures_of(fine);
    EXPECT_NEAR(after.peak_acceleration, before.peak_acceleration, 1e-12);
    EXPECT_NEAR(after.peak_displacement, before.peak_displacement, 1e-10);
    EXPECT_NEAR(after.arias_intensity, before.arias_intensity, 1e-12);
}

TEST(Resampling, ToACoarserStepKeepsSlowWavesWhereTheyAreAndDropsFastOnes)
{
    const auto pulse = [](double frequency, double time_step, std::size_t count) {
        return sampled(
            [=](double t) {
                return std::exp(-std::pow((t - 10) / 2, 2)) * std::cos(2 * pi * frequency * (t - 10));
            },
            time_step, count);
    };
    for (const double step : {0.02, 0.0123, 0.01 * std::numbers::sqrt2, 0.0125}) {
        const Channel slow = processed(pulse(3, 0.01, 2001), {processing::Resample{step}});
        EXPECT_EQ(slow.time_step, step);
        EXPECT_EQ(slow.samples.size(), static_cast<std::size_t>(20 / step + 1e-6) + 1);
        const Channel expected = pulse(3, step, slow.samples.size());
        for (std::size_t i = 0; i < slow.samples.size(); ++i)
            ASSERT_NEAR(slow.samples[i], expected.samples[i], 1e-6) << step << " " << i;
        EXPECT_LT(peak(processed(pulse(45, 0.01, 2001), {processing::Resample{step}})), 1e-6);  // not folded back
    }
}

TEST(Resampling, KeepsAConstantAndItsEnds)
{
    const Channel constant = of_samples(std::vector<double>(1001, 4.0), 0.01);
    const Channel coarse = processed(constant, {processing::Resample{0.03}});
    EXPECT_EQ(coarse.samples.size(), 334);
    for (const double sample : coarse.samples) ASSERT_NEAR(sample, 4, 2e-3);
    expect_in(faults_of({constant}, {processing::Resample{20}}), "time step");
    expect_in(faults_of({constant}, {processing::Resample{1e-12}}), "time step");
}

TEST(Resampling, OfUnevenSamplesComesFirstAndIsSaid)
{
    Channel uneven = of_samples({0, 1, 0, -1, 0}, 0);
    uneven.times = {0, 0.1, 0.3, 0.4, 0.5};
    const processing::ProcessedRecord record = processing::process({uneven}, {processing::RemoveMean{}});
    EXPECT_NEAR(record.channels[0].time_step, 0.1, 1e-12);
    ASSERT_EQ(record.sentences.size(), 2);
    expect_in(record.sentences[0], "uneven samples interpolated linearly to 6 at 0.1 s");
}

// ---- scaling

TEST(Scaling, BringsThePeakOfOneComponentToAValueAndKeepsTheOthersInProportion)
{
    const std::vector<Channel> channels{noise(1000, 0.01, 1, "NS"), noise(1000, 0.01, 2, "EW")};
    const double ratio = peak(channels[0]) / peak(channels[1]);
    const processing::ProcessedRecord by_ns =
        processing::process(channels, {processing::ScaleToPeak{Quantity::acceleration, 3.5, "NS"}});
    EXPECT_NEAR(peak(by_ns.channels[0]), 3.5, 1e-12);
    EXPECT_NEAR(peak(by_ns.channels[0]) / peak(by_ns.channels[1]), ratio, 1e-12);
    expect_in(by_ns.sentences[0], "peak acceleration [m/s2] of NS");

    const processing::ProcessedRecord by_largest =
        processing::process(channels, {processing::ScaleToPeak{Quantity::acceleration, 3.5}});
    EXPECT_NEAR(std::max(peak(by_largest.channels[0]), peak(by_largest.channels[1])), 3.5, 1e-12);

    const processing::ProcessedRecord by_velocity =
        processing::process(channels, {processing::ScaleToPeak{Quantity::velocity, 0.4, "EW"}});
    EXPECT_NEAR(measures::measures_of(by_velocity.channels[1]).peak_velocity, 0.4, 1e-12);

    const processing::ProcessedRecord by_spectrum =
        processing::process(channels, {processing::ScaleToSpectrum{0.7, 6, 0.05, "EW"}});
    EXPECT_NEAR(measures::response_spectrum(by_spectrum.channels[1], {0.7}).pseudo_acceleration[0], 6, 1e-9);
    expect_in(by_spectrum.sentences[0], "5 % pseudo-acceleration at 0.7 s");

    const processing::ProcessedRecord twice = processing::process(
        channels, {processing::Scale{-2}, processing::ScaleToPeak{Quantity::acceleration, 3.5, "NS"}});
    EXPECT_NEAR(twice.factor, -3.5 / peak(channels[0]), 1e-12) << "of all steps together";
    EXPECT_NEAR(peak(processing::process(channels, {processing::Scale{-2}}).channels[0]), 2 * peak(channels[0]),
                1e-12);
    expect_in(faults_of(channels, {processing::ScaleToPeak{Quantity::acceleration, 1, "UP"}}), "NS, EW");
    expect_in(faults_of({of_samples({0, 0, 0}, 1)}, {processing::ScaleToPeak{}}), "without motion");
}

// ---- rotation

TEST(Rotation, PutsAKnownMotionOnTheMonumentsAxes)
{
    const Channel motion = noise(500, 0.01, 4);
    Channel still = motion;
    std::fill(still.samples.begin(), still.samples.end(), 0.0);
    // The ground moves north only: x to the north has it all, x to the east has it on y (north is left of east).
    const std::vector<Channel> channels{horizontal(motion, "N", 0), horizontal(still, "E", 90)};
    const processing::ProcessedRecord north = processing::process(channels, {processing::Rotate{0}}),
                                      east = processing::process(channels, {processing::Rotate{90}});
    for (std::size_t i = 0; i < 500; ++i) {
        EXPECT_NEAR(north.channels[0].samples[i], motion.samples[i], 1e-12);
        EXPECT_NEAR(north.channels[1].samples[i], 0, 1e-12);
        EXPECT_NEAR(east.channels[0].samples[i], 0, 1e-12);
        EXPECT_NEAR(east.channels[1].samples[i], motion.samples[i], 1e-12);
    }
    EXPECT_EQ(north.channels[0].component, "x");
    EXPECT_EQ(*north.channels[1].azimuth, 270);
    // Moving east only, seen from x to the north: y points west, so it is negative.
    const processing::ProcessedRecord west =
        processing::process({horizontal(still, "N", 0), horizontal(motion, "E", 90)}, {processing::Rotate{0}});
    EXPECT_NEAR(west.channels[1].samples[250], -motion.samples[250], 1e-12);
}

TEST(Rotation, KeepsLengthsAndRotD100AndComesBack)
{
    Channel up = noise(800, 0.01, 3, "UP");
    up.is_vertical = true;
    const std::vector<Channel> channels{horizontal(noise(800, 0.01, 1), "N", 20), up,
                                        horizontal(noise(800, 0.01, 2), "E", 110)};
    const processing::ProcessedRecord turned = processing::process(channels, {processing::Rotate{73}});
    const std::vector<double>&x = turned.channels[0].samples, &y = turned.channels[2].samples;
    for (std::size_t i = 0; i < 800; ++i)
        ASSERT_NEAR(std::hypot(x[i], y[i]), std::hypot(channels[0].samples[i], channels[2].samples[i]), 1e-12);
    EXPECT_EQ(turned.channels[1].samples, up.samples);
    EXPECT_EQ(turned.channels[1].component, "z");
    const std::vector<double> periods{0.1, 0.5, 2};
    const measures::RotatedSpectrum before = measures::rotd(channels[0], channels[2], periods);
    const measures::RotatedSpectrum after = measures::rotd(turned.channels[0], turned.channels[2], periods);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after.rotd100[k], before.rotd100[k], 1e-9 * before.rotd100[k]);
    const processing::ProcessedRecord back = processing::process(turned.channels, {processing::Rotate{20}});
    EXPECT_NEAR(back.channels[0].samples[300], channels[0].samples[300], 1e-12);
    EXPECT_NEAR(back.channels[2].samples[300], -channels[2].samples[300], 1e-12);  // y is west of x = 20 deg
}

TEST(Rotation, AllowsForSkewSensors)
{
    const Channel east = noise(300, 0.01, 1), north = noise(300, 0.01, 2);
    const auto sensor = [&](double azimuth) {
        Channel channel = horizontal(east, "H" + std::to_string(azimuth), azimuth);
        for (std::size_t i = 0; i < 300; ++i)
            channel.samples[i] =
                east.samples[i] * std::sin(azimuth * pi / 180) + north.samples[i] * std::cos(azimuth * pi / 180);
        return channel;
    };
    const processing::ProcessedRecord record =
        processing::process({sensor(310), sensor(25)}, {processing::Rotate{90}});
    for (std::size_t i = 0; i < 300; ++i) {
        ASSERT_NEAR(record.channels[0].samples[i], east.samples[i], 1e-12);
        ASSERT_NEAR(record.channels[1].samples[i], north.samples[i], 1e-12);
    }
    expect_in(record.sentences[0], "15 deg off a right angle");
    expect_in(faults_of({sensor(20), sensor(203)}, {processing::Rotate{0}}), "nearly parallel");
    expect_in(faults_of({sensor(20), east}, {processing::Rotate{0}}), "unknown azimuth");
    Channel shorter = sensor(110);
    shorter.samples.pop_back();
    expect_in(faults_of({sensor(20), shorter}, {processing::Rotate{0}}), "300 and 299 samples");
}

// ---- integration

TEST(Integration, IsTheExactIntegralAtTheSamples)
{
    const Channel channel = noise(1000, 0.01, 9);
    const GroundMotion motion = to_ground_motion(channel, "");
    const Channel velocity = processed(channel, {processing::Integrate{}});
    const Channel displacement = processed(channel, {processing::Integrate{Quantity::displacement}});
    EXPECT_EQ(velocity.quantity, Quantity::velocity);
    EXPECT_NEAR(velocity.samples.back(), motion.residual_velocity(), 1e-15);
    EXPECT_NEAR(displacement.samples.back(), motion.residual_displacement(), 1e-15);
    EXPECT_NEAR(velocity.samples[1], 0.005 * (channel.samples[0] + channel.samples[1]), 1e-15);
    expect_in(faults_of({velocity}, {processing::Integrate{}}), "something to integrate");
    expect_in(faults_of({channel}, {processing::Integrate{}, processing::CorrectEnd{}}), "processing[1]");
}

TEST(Integration, IsUndoneByDifferentiationWhereTheMotionIsSlow)
{
    const Channel wave = sampled([](double t) { return std::sin(2 * pi * t); }, 0.002, 5001);
    const Channel back =
        processed(wave, {processing::Integrate{Quantity::displacement}, processing::Differentiate{}});
    EXPECT_EQ(back.quantity, Quantity::acceleration);
    for (std::size_t i = 2; i + 2 < wave.samples.size(); ++i) ASSERT_NEAR(back.samples[i], wave.samples[i], 2e-4);
    expect_in(faults_of({wave}, {processing::Differentiate{}}), "something to differentiate");
}

// ---- faults

TEST(ProcessingSteps, ListsAllWrongParametersAtOnceAndBeforeAnythingRuns)
{
    const Channel channel = noise(100, 0.01, 1);
    const std::string faults = faults_of(
        {channel}, {processing::TimeWindow{3, 2}, processing::RemoveMean{}, processing::RemoveBaseline{7},
                    processing::Taper{}, processing::Butterworth{0}, processing::Resample{-1},
                    processing::Scale{0}, processing::ScaleToPeak{Quantity::displacement, -1},
                    processing::ScaleToSpectrum{0, 1, -1}, processing::Rotate{NAN},
                    processing::Integrate{Quantity::acceleration}, processing::AriasWindow{0.5, 0.2}});
    for (const int step : {0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})
        expect_in(faults, "processing[" + std::to_string(step));
    EXPECT_EQ(faults.find("processing[1]"), std::string::npos);
}

TEST(ProcessingSteps, NeedsUnitsAndSamples)
{
    Channel channel = noise(100, 0.01, 1);
    channel.unit_in_file.clear();
    expect_in(faults_of({channel}, {processing::RemoveMean{}}), "unknown unit");
    expect_in(faults_of({}, {processing::RemoveMean{}}), "no channel");
    expect_in(faults_of({of_samples({1}, 0.01)}, {}), "1 samples");
    expect_in(faults_of({noise(100, 0.01, 1)}, {processing::Scale{1e308}, processing::Scale{1e308}}),
              "not finite");
}

TEST_F(RealRecords, LAquilaGoesThroughAUsualProcessing)
{
    std::vector<Channel> channels;
    for (const char* axis : {"H1", "H2", "V"}) {
        const std::string file = std::string("motions/laquila2009/AQV_16837_") + axis + ".cor.acc";
        channels.push_back(read_record(data_folder() / file, {}).channels[0]);
    }
    const processing::ProcessedRecord record =
        processing::process(channels, {processing::AriasWindow{0.001, 0.99, 2, 40}, processing::RemoveBaseline{1},
                                       processing::Taper{.fraction = 0.05}, processing::Butterworth{4, 0.05, 30.0},
                                       processing::Resample{0.01}, processing::CorrectEnd{}});
    EXPECT_EQ(record.sentences.size(), 6);
    EXPECT_GT(record.start, 20);
    EXPECT_LT(record.start, 34);  // the peak is at 34 s
    for (const Channel& channel : record.channels) {
        EXPECT_NEAR(measures::measures_of(channel).residual_displacement, 0, 1e-10);
        EXPECT_GT(measures::measures_of(channel).peak_velocity, 0.03);
    }
    EXPECT_NEAR(peak(record.channels[1]), 6.507, 0.5);
}

}  // namespace

}  // namespace voussoir::records
