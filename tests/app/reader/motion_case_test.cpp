// Motions of cases: waves, what is done to them, and what is said about faults.
#include <cmath>
#include <numbers>

#include "tests/app/reader/motion_case.h"

namespace voussoir::app::reader
{
namespace
{

// ---- waves

TEST_F(MotionCase, ARampedSineReachesItsPeakBetweenItsRamps)
{
    const Case the_case =
        read(moved_by("{x: {ramped_sine: {acceleration: 0.2 g, frequency: 5 Hz, ramp: 0.4 s, duration: 2 s}}}"));
    const GroundMotion& motion = only_motion(the_case);
    EXPECT_NEAR(motion.duration(), 2, 1e-12);
    EXPECT_NEAR(motion.peak_acceleration(), 0.2 * gravity, 1e-12);
    EXPECT_NEAR(motion.acceleration(0.25), 0.25 / 0.4 * 0.2 * gravity, 1e-12);  // a crest in the ramp
    EXPECT_NEAR(motion.acceleration(1.05), 0.2 * gravity, 1e-12);
    EXPECT_NEAR(the_case.stages[1].duration, 2, 1e-12);
    EXPECT_NE(the_case.motions.at(0).description.find("foundation x: ramped sine"), std::string::npos)
        << the_case.motions[0].description;
}

TEST_F(MotionCase, ASweepRunsFromOneFrequencyToTheOther)
{
    const Case linear =
        read(moved_by("{x: {sweep: {acceleration: 1 m/s2, from: 1 Hz, to: 9 Hz, duration: 4 s}}}"));
    const GroundMotion& motion = only_motion(linear);
    EXPECT_NEAR(motion.duration(), 4, 1e-12);
    EXPECT_NEAR(motion.peak_acceleration(), 1, 1e-3);
    // t (1 + t) cycles have passed at t: a whole number of them at 1 s, half an odd one at 1.5811 s.
    EXPECT_NEAR(motion.acceleration(1), 0, 1e-9);
    EXPECT_NEAR(motion.acceleration((std::sqrt(1 + 4 * 2.25) - 1) / 2), 1, 1e-3);
    const Case logarithmic = read(moved_by(
        "{x: {sweep: {acceleration: 1 m/s2, from: 1 Hz, to: 9 Hz, duration: 4 s, spacing: logarithmic}}}"));
    const double cycles = 4 / std::log(9) * (std::sqrt(9) - 1);  // at half time, where it is 3 Hz
    EXPECT_NEAR(only_motion(logarithmic).acceleration(2), std::sin(2 * std::numbers::pi * cycles), 1e-6);
}

TEST_F(MotionCase, ARickerPulseBringsTheGroundBack)
{
    const Case the_case = read(moved_by("{x: {ricker: {acceleration: -3 m/s2, frequency: 2 Hz}}}"));
    const GroundMotion& motion = only_motion(the_case);
    EXPECT_TRUE(has_default(the_case, "delay = 0.75 s"));
    EXPECT_NEAR(motion.duration(), 1.5, 1e-12);
    EXPECT_NEAR(motion.acceleration(0.75), -3, 1e-9);
    EXPECT_NEAR(motion.residual_velocity(), 0, 1e-6);
    EXPECT_NEAR(motion.residual_displacement(), 0, 1e-6);
    const Case later = read(moved_by("{x: {ricker: {acceleration: 3 m/s2, frequency: 2 Hz, delay: 1 s}}}"));
    EXPECT_NEAR(only_motion(later).duration(), 2, 1e-12);
    EXPECT_NEAR(only_motion(later).acceleration(1), 3, 1e-9);
}

TEST_F(MotionCase, APulseMovesTheGroundForwardOrForwardAndBack)
{
    const double amplitude = 2, period = 0.5;
    const Case forward = read(moved_by("{x: {pulse: {acceleration: 2 m/s2, period: 0.5 s}}}"));
    EXPECT_NEAR(only_motion(forward).duration(), period, 1e-12);
    EXPECT_NEAR(only_motion(forward).peak_acceleration(), amplitude, 1e-9);
    EXPECT_NEAR(only_motion(forward).residual_velocity(), 0, 1e-9);
    EXPECT_NEAR(only_motion(forward).residual_displacement(), amplitude * period * period / (2 * std::numbers::pi),
                1e-4);
    const Case back = read(moved_by("{x: {pulse: {acceleration: 2 m/s2, period: 0.5 s, shape: cosine}}}"));
    EXPECT_NEAR(only_motion(back).acceleration(0), amplitude, 1e-9);
    EXPECT_NEAR(only_motion(back).residual_velocity(), 0, 1e-9);
    EXPECT_NEAR(only_motion(back).residual_displacement(), 0, 1e-9);
    EXPECT_NEAR(only_motion(back).displacement(period / 2),
                2 * amplitude * period * period / std::pow(2 * std::numbers::pi, 2), 1e-4);
}

TEST_F(MotionCase, NoiseHasItsPeakEndsAtRestAndDependsOnItsSeedAlone)
{
    const auto noise = [&](int seed) {
        return read(
            moved_by("{x: {noise: {acceleration: 0.3 g, duration: 6 s, seed: " + std::to_string(seed) + "}}}"));
    };
    const Case first = noise(7), again = noise(7), other = noise(8);
    const GroundMotion& motion = only_motion(first);
    EXPECT_NEAR(motion.duration(), 6, 1e-9);
    EXPECT_NEAR(motion.peak_acceleration(), 0.3 * gravity, 1e-9);
    EXPECT_NEAR(motion.residual_velocity(), 0, 1e-9);
    EXPECT_NEAR(motion.residual_displacement(), 0, 1e-9);
    EXPECT_EQ(motion.acceleration(2.345), only_motion(again).acceleration(2.345));
    EXPECT_NE(motion.acceleration(2.345), only_motion(other).acceleration(2.345));
}

TEST_F(MotionCase, AWaveIsProcessedAndThenScaled)
{
    const Case the_case =
        read(moved_by("{x: {ricker: {acceleration: 3 m/s2, frequency: 2 Hz}, scale: 0.5, "
                      "processing: [{window: {from: 0.25 s, to: 1.25 s}}, {scale: 4}]}}"));
    EXPECT_NEAR(only_motion(the_case).duration(), 1, 1e-9);
    EXPECT_NEAR(only_motion(the_case).acceleration(0.5), 6, 1e-9);
    const std::string& said = the_case.motions.at(0).description;
    const std::size_t window = said.find("window 0.25 to 1.25 s"), scaled = said.find("scaled by 4");
    EXPECT_LT(window, scaled) << said;
    EXPECT_LT(scaled, said.find("x 0.5")) << said;
}

TEST_F(MotionCase, FiguresOfWavesThatCannotBeAreRefused)
{
    EXPECT_EQ(faults_of(moved_by(
                  "{x: {ramped_sine: {acceleration: 1 m/s2, frequency: 5 Hz, ramp: 2 s, duration: 3 s}}}")),
              "case.yaml:9: foundation.motion.x.ramped_sine: wave: ramp [s] = 2; must be > 0 and at most half the "
              "duration");
    EXPECT_EQ(faults_of(moved_by("{x: {pulse: {acceleration: 1 m/s2, period: 1 s, shape: cosin}}}")),
              "case.yaml:9: foundation.motion.x.pulse.shape: \"cosin\"; expected one of sine, cosine; did you "
              "mean cosine?");
    EXPECT_EQ(faults_of(moved_by("{x: {noise: {acceleration: 1 m/s2, duration: 6 s, seed: -1}}}")),
              "case.yaml:9: foundation.motion.x.noise.seed: \"-1\"; expected a whole number from 0 to 1000000000");
    EXPECT_NE(faults_of(moved_by("{x: {ricker: {acceleration: 1 m/s2, frequency: 1e308 Hz}}}")).find("so large"),
              std::string::npos)
        << "the ground stood still, without a word";
    EXPECT_EQ(faults_of(moved_by("{x: {sine: {acceleration: 1 m/s2, frequency: 5 Hz, duration: 1 s}, scale: 2}}")),
              "case.yaml:9: foundation.motion.x.scale: has no meaning here; a sine is defined by its parameters: "
              "change these, or use a ramped_sine");
}

// ---- warnings

/// A record of one strong wave after 1 s, 6 s long, that leaves the ground where it was.
std::vector<double> late_wave()
{
    std::vector<double> values(601, 0);
    for (int i = 0; i <= 200; ++i) {
        const double b = std::pow(std::numbers::pi * 2 * 0.01 * (i - 100), 2);
        values[static_cast<std::size_t>(100 + i)] = (1 - 2 * b) * std::exp(-b);
    }
    return values;
}

/// One push: the ground goes on moving.
std::vector<double> push()
{
    std::vector<double> values(201, 0);
    for (std::size_t i = 1; i < 50; ++i) values[i] = 0.5;
    return values;
}

class MotionWarnings : public MotionCase
{
 protected:
    MotionWarnings()
    {
        write_record("wave.txt", late_wave());
        write_record("push.txt", push());
    }
    std::string warnings_of(const std::string& motion) const
    {
        std::string all;
        for (const std::string& warning : read(moved_by("{" + motion + "}")).warnings)
            all += warning.substr((folder_ / "").string().size()) + "\n";
        return all;
    }
};

TEST_F(MotionWarnings, ARecordScaledByMoreThanTenIsToldWithTheFactor)
{
    EXPECT_EQ(
        warnings_of("x: {record: wave.txt, unit: m/s2, scale: 12}"),
        "case.yaml:9: foundation.motion.x.record: the record is scaled by 12, more than 10: check its unit and "
        "its channel, or take a stronger record\n");
    EXPECT_NE(warnings_of("x: {record: wave.txt, unit: mm/s2, scale_to_pga: 0.35 g}").find("scaled by 3432"),
              std::string::npos);
    EXPECT_NE(warnings_of("x: {record: wave.txt, unit: m/s2, scale: -3, processing: [{scale: 4}]}")
                  .find("scaled by -12"),
              std::string::npos);
    EXPECT_NE(warnings_of("records: wave.txt, unit: m/s2, axes: [x], processing: [{scale_to_pga: 20 m/s2}]")
                  .find("scaled by 20"),
              std::string::npos);
    EXPECT_EQ(warnings_of("x: {record: wave.txt, unit: m/s2, scale: 10}"), "");
    EXPECT_EQ(warnings_of("x: {ricker: {acceleration: 1 m/s2, frequency: 2 Hz}, scale: 20}"), "") << "no record";
}

TEST_F(MotionWarnings, AWindowThatCutsTheStrongPartIsTold)
{
    const auto said = [&](const std::string& step) {
        return warnings_of("x: {record: wave.txt, unit: m/s2, processing: [" + step + "], end_correction: true}");
    };
    EXPECT_NE(said("{window: {from: 2.05 s}}").find("% of the record's Arias intensity, less than 70 %"),
              std::string::npos);
    EXPECT_NE(said("{window: {arias: [0.1 %, 99 %], longest: 0.2 s}}").find("Arias intensity"), std::string::npos);
    EXPECT_EQ(said("{window: {from: 1 s, to: 3 s}}"), "");
    EXPECT_EQ(said("{window: {arias: [5 %, 75 %]}}"), "") << "70 % to the last bits";
}

TEST_F(MotionWarnings, AGroundThatEndsElsewhereIsToldUnlessItWasGivenAsDisplacement)
{
    const std::string told = warnings_of("x: {record: push.txt, unit: m/s2}");
    EXPECT_NE(told.find("the ground ends 429 mm from where it began, 100 % of its largest displacement"),
              std::string::npos)
        << told;
    EXPECT_NE(warnings_of("records: push.txt, unit: m/s2, axes: [x]").find("the ground along x ends"),
              std::string::npos);
    EXPECT_EQ(warnings_of("x: {record: push.txt, unit: m/s2, end_correction: true}"), "");
    EXPECT_EQ(warnings_of("x: {record: push.txt, unit: cm/s2}"), "") << "less than a centimetre";
    write_record("slip.txt", {0, 0.1, 0.3, 0.5, 0.5});
    EXPECT_EQ(warnings_of("x: {record: slip.txt, unit: m}"), "") << "the fault has slipped";
    EXPECT_EQ(warnings_of("x: {pulse: {acceleration: 1 m/s2, period: 1 s}}"), "") << "what was asked for";
}

// ---- processing and faults

TEST_F(JointRecords, FaultsOfProcessingNameTheStepAndItsLine)
{
    const auto fault = [&](const std::string& steps) {
        return faults_of(moved_by("{x: {record: a.txt, unit: m/s2, processing: " + steps + "}}"));
    };
    const std::string place = "case.yaml:9: foundation.motion.x.processing";
    EXPECT_EQ(fault("[mean, {window: {from: 1 s, to: 2 s}}]"),
              place + "[1]: end [s] = 2; at most the record's 0.04 s");
    EXPECT_EQ(fault("[mean,\n    {baseline: 9}]"),
              "case.yaml:10: foundation.motion.x.processing[1]: order = 9; must be 0 to 6");
    EXPECT_EQ(fault("[{low_pass: {high: 60 Hz}}]"),
              place + "[0]: a corner at 60 Hz; below half the sampling rate, 50 Hz");
    EXPECT_EQ(fault("[{taper: 1 m}]"),
              place + "[0].taper: \"1 m\" has the wrong dimension; expected a time such as 2 ms");
    EXPECT_EQ(fault("[{window: {arias: [5 %]}}]"),
              place + "[0].window.arias: 1 entries; write two fractions, [0.1 %, 99 %]");
    EXPECT_EQ(fault("mean"), place + ": \"mean\"; expected a list of steps, [mean, {taper: 1 s}]");
    EXPECT_EQ(fault("[{mean: 1, taper: 1 ms}]"),
              place + "[0].mean: has no meaning here; write it as a single word, without parameters");
    EXPECT_EQ(fault("[{scale: 2, taper: 1 ms}]"),
              place + "[0]: two steps in one entry; write each as a separate entry: the order matters");
    EXPECT_EQ(fault("[window]"), place + "[0]: step window without figures; write {window: ...}");
    EXPECT_EQ(fault("[{rotate: {x_azimuth: 1 deg}}]").find(place + "[0]: rotation of components"), 0);
    EXPECT_EQ(
        fault("[{match: {target: {table: [[0.1 s, 1 m/s2], [4 s, 1 g]]}}}]").find(place + "[0]: a seed of 0.04 s"),
        0);
}

TEST_F(JointRecords, UnknownKeysNameTheNearest)
{
    const std::string place = "case.yaml:9: foundation.motion.";
    EXPECT_EQ(faults_of(moved_by("{x: {recrd: a.txt, unit: g}}")),
              place + "x.recrd: unknown key; did you mean record?");
    EXPECT_EQ(faults_of(moved_by("{x: {record: a.txt, unit: g, procesing: [mean]}}")),
              place + "x.procesing: unknown key; did you mean processing?");
    EXPECT_EQ(faults_of(moved_by("{" + three_records + ", x_azimut: 1 deg}")),
              place + "x_azimut: unknown key; did you mean x_azimuth?");
    EXPECT_EQ(faults_of(moved_by("{x: {ricker: {acceleration: 1 g, frequency: 1 Hz, dellay: 3 s}}}")),
              place + "x.ricker.dellay: unknown key; did you mean delay?");
    EXPECT_EQ(faults_of(moved_by("{x: {record: a.txt, unit: g, processing: [meen]}}")),
              place + "x.processing[0]: step \"meen\"; did you mean mean?");
    EXPECT_EQ(faults_of(moved_by("{x: {record: a.txt, unit: g, processing: [{hi_pass: {low: 1 Hz}}]}}")),
              place + "x.processing[0].hi_pass: unknown key; did you mean high_pass?");
    EXPECT_EQ(
        faults_of(moved_by("{x: {record: a.txt, unit: g, sine: {acceleration: 1 g, frequency: 1 Hz}}}")),
        place + "x: both a record and a sine; give one of record, sine, ramped_sine, sweep, ricker, pulse, noise");
}

TEST_F(MotionCase, MatchedToASpectrumEndsAtRest)
{
    const Case the_case = read(
        moved_by("{x: {noise: {acceleration: 0.3 g, duration: 5 s}, processing: [{match: {target: {eurocode_8: "
                 "{type: 1, ground: B, acceleration: 0.25 g}}, shortest: 0.1 s, longest: 1 s}}]}}"));
    const GroundMotion& motion = only_motion(the_case);
    EXPECT_GT(motion.peak_acceleration(), 0.2 * gravity);
    EXPECT_NEAR(motion.residual_velocity(), 0, 1e-9);
    EXPECT_NEAR(motion.residual_displacement(), 0, 1e-9);
    EXPECT_NE(
        the_case.motions.at(0).description.find("matched to Eurocode 8 type 1, ground B, 0.25 g from 0.1 to 1 s"),
        std::string::npos)
        << the_case.motions[0].description;
}

}  // namespace
}  // namespace voussoir::app::reader
