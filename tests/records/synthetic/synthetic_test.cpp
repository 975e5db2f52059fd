// Synthetic accelerograms: the same everywhere, at rest at both ends, and shaking where they were asked to.

#include "records/synthetic/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "libdda/errors.h"
#include "records/write_at2.h"
#include "tests/records/test_files.h"

namespace voussoir::records
{

namespace
{

constexpr double g = 9.80665;

/// Share of the energy of the samples between two frequencies, by a plain Fourier sum.
double energy_share(const std::vector<double>& samples, double time_step, double low, double high)
{
    const double duration = static_cast<double>(samples.size()) * time_step;
    double inside = 0, all = 0;
    for (int k = 1; k <= 25 * duration; ++k) {
        double real = 0, imaginary = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double angle =
                2 * std::numbers::pi * k * static_cast<double>(i) / static_cast<double>(samples.size());
            real += samples[i] * std::cos(angle);
            imaginary += samples[i] * std::sin(angle);
        }
        const double energy = real * real + imaginary * imaginary;
        const double frequency = k / duration;
        all += energy;
        if (frequency >= low && frequency < high) inside += energy;
    }
    return inside / all;
}

TEST(SplitMix64, GivesThePublishedSequence)
{
    synthetic::SplitMix64 random(1234567);  // first values of the reference implementation for this seed
    EXPECT_EQ(random.next(), 6457827717110365317U);
    EXPECT_EQ(random.next(), 3203168211198807973U);
    EXPECT_EQ(random.next(), 9817491932198370423U);
}

TEST(SplitMix64, NormalHasMeanZeroAndVarianceOne)
{
    synthetic::SplitMix64 random(42);
    double sum = 0, squares = 0;
    const int count = 100000;
    for (int i = 0; i < count; ++i) {
        const double value = random.normal();
        sum += value;
        squares += value * value;
    }
    EXPECT_NEAR(sum / count, 0, 0.015);  // 5 standard errors
    EXPECT_NEAR(squares / count, 1, 0.02);
}

TEST(Synthetic, HasItsPeakAndEndsAtRest)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        synthetic::SyntheticMotion parameters;
        parameters.seed = seed;
        parameters.peak_acceleration = 2.5;
        const std::vector<double> samples = synthetic::synthetic_acceleration(parameters);
        ASSERT_EQ(samples.size(), 2001);
        EXPECT_EQ(samples.front(), 0);
        EXPECT_EQ(samples.back(), 0);
        const GroundMotion motion = GroundMotion::from_acceleration(samples, parameters.time_step, "synthetic");
        EXPECT_NEAR(motion.peak_acceleration(), 2.5, 1e-12);
        EXPECT_NEAR(motion.residual_velocity(), 0, 1e-12);
        EXPECT_NEAR(motion.residual_displacement(), 0, 1e-11);
        for (const double early : {0.01, 0.05, 0.1}) {
            EXPECT_LT(std::abs(motion.acceleration(early)), 0.1);
            EXPECT_LT(std::abs(motion.acceleration(10 - early)), 0.1);
        }
    }
}

TEST(Synthetic, ShakesWhereTheGroundResonates)
{
    synthetic::SyntheticMotion parameters;
    parameters.ground_damping = 0.15;
    parameters.duration = 20;
    for (const double frequency : {2.0, 4.0, 8.0}) {
        parameters.ground_frequency = frequency;
        const std::vector<double> samples = synthetic::synthetic_acceleration(parameters);
        EXPECT_GT(energy_share(samples, parameters.time_step, 0.7 * frequency, 1.3 * frequency), 0.6) << frequency;
    }
}

TEST(Synthetic, ASeedIsOneRecordAndAnotherSeedAnother)
{
    synthetic::SyntheticMotion parameters;
    const std::vector<double> first = synthetic::synthetic_acceleration(parameters);
    EXPECT_EQ(first, synthetic::synthetic_acceleration(parameters));
    parameters.seed = 2;
    EXPECT_NE(first, synthetic::synthetic_acceleration(parameters));
}

TEST(Synthetic, BadParametersAreRefusedAllAtOnce)
{
    synthetic::SyntheticMotion parameters;
    parameters.peak_acceleration = -1;
    parameters.ground_damping = 0;
    parameters.duration = 1e9;
    try {
        synthetic::synthetic_acceleration(parameters);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.size(), 3);
    }
    parameters = {};
    parameters.time_step = 0;
    EXPECT_THROW(synthetic::synthetic_acceleration(parameters), InputError);
    parameters = {};
    parameters.ground_frequency = std::nan("");
    EXPECT_THROW(synthetic::synthetic_acceleration(parameters), InputError);
}

TEST(WriteAt2, IsReadBackAsItWas)
{
    Channel channel;
    channel.time_step = 0.005;
    channel.samples = {0, 1.25 * g, -0.333333333 * g, 1e-9 * g, 2, -3, 4};
    const TemporaryFile file(format_at2("first", "second, Z", channel), "written.at2");
    const Record record = read_record(file.path(), {});
    EXPECT_EQ(record.format, "PEER AT2");
    EXPECT_EQ(record.channels.front().component, "Z");
    EXPECT_DOUBLE_EQ(record.channels.front().time_step, 0.005);
    ASSERT_EQ(record.channels.front().samples.size(), channel.samples.size());
    for (std::size_t i = 0; i < channel.samples.size(); ++i) {
        EXPECT_NEAR(record.channels.front().samples[i], channel.samples[i], 1e-7 * std::abs(channel.samples[i]));
    }
}

TEST(ShippedRecords, AreWhatTheirDescriptionSays)
{
    const std::pair<const char*, double> records[] = {{"x", 0.35}, {"y", 0.28}, {"z", 0.20}};
    for (const auto& [component, peak_g] : records) {
        const std::string name = std::string("synthetic_") + component + ".at2";
        const Record record = read_record(repository() / "cases" / "records" / name, {});
        const Channel& channel = record.channels.front();
        EXPECT_EQ(channel.samples.size(), 2001);
        EXPECT_DOUBLE_EQ(channel.time_step, 0.005);
        EXPECT_NEAR(peak(channel), peak_g * g, 1e-9);
        EXPECT_GT(energy_share(channel.samples, 0.005, 1.5, 4.5), 0.6);
        const GroundMotion motion = to_ground_motion(channel, name);
        EXPECT_NEAR(motion.residual_velocity(), 0, 1e-7);
        EXPECT_NEAR(motion.residual_displacement(), 0, 1e-6);
    }
}

}  // namespace

}  // namespace voussoir::records
