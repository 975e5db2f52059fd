// Motions that run along the ground: each support moves as the first one, but later.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

/// Three piers 10 m apart, in two entries, far from the origin of coordinates. @param top a key of the piers
/// @param stage of the dynamic stage
std::string piers(const std::string& top, const std::string& stage)
{
    return "materials: {stone: {density: 2000 kg/m3, young: 3 GPa, poisson: 0.2}}\n"
           "joints: {dry: {friction: 30 deg}}\n"
           "blocks:\n"
           "  - {box: {name: a, lower: [1000, 0, 0], upper: [1001, 1, 1]}, group: near}\n"
           "  - {box: {name: b, lower: [1010, 0, 0], upper: [1011, 1, 1]}, group: far}\n"
           "  - {box: {name: c, lower: [1020, 0, 0], upper: [1021, 1, 1]}, group: far}\n"
           "  - {box: {name: stone, lower: [1010, 0, 1], upper: [1011, 1, 2]}}\n"
           "foundation: [{blocks: near}, {blocks: far" +
           top + "}]\nstages: [{name: quake, type: dynamic" + stage + "}]\n";
}

const std::string pulse = "x: {ricker: {acceleration: 1 m/s2, frequency: 2 Hz}}";

/// How much later than the first support each moves, by the peak of the velocity [s].
std::vector<double> delays_of(const Stage& stage)
{
    std::vector<double> delays;
    const GroundMotion& first = *stage.motions.at(0).motion;
    for (const FoundationMotion& motion : stage.motions) {
        const double delay = motion.motion->duration() - first.duration();
        for (const double time : {0.1, 0.6, 0.75, 1.1, 2.0})
            EXPECT_NEAR(motion.motion->displacement(time + delay), first.displacement(time), 1e-9);
        delays.push_back(delay);
    }
    return delays;
}

}  // namespace

TEST(Passage, ReachesSupportsOneAfterTheOther)
{
    const Case the_case =
        read(piers("", ", motion: {" + pulse + ", passes: {speed: 500 m/s, direction: [1, 0, 0]}}"));
    const std::vector<double> delays = delays_of(the_case.stages[0]);
    ASSERT_EQ(delays.size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(delays[static_cast<std::size_t>(i)], 0.02 * i, 1e-12);
    EXPECT_TRUE(has_default(the_case, "[1000.5, 0.5, 0.5], where it comes first"));
    // The last one moves to the end of the motion.
    EXPECT_NEAR(the_case.stages[0].duration, the_case.stages[0].motions[2].motion->duration(), 1e-12);
}

// Against x it comes to the last one first; askew it runs faster along the row of piers.
TEST(Passage, RunsAsItIsTold)
{
    const Stage back =
        read(piers("", ", motion: {" + pulse + ", passes: {speed: 500 m/s, direction: [-1, 0, 0]}}")).stages[0];
    EXPECT_NEAR(delays_of(back)[2], -0.04, 1e-12);
    EXPECT_NEAR(back.motions[0].motion->displacement(0.04), 0, 1e-15);
    const Stage askew =
        read(piers("", ", motion: {" + pulse +
                           ", passes: {speed: 500 m/s, direction: [1, 1, 0], from: [990, 0.5, 0]}}"))
            .stages[0];
    EXPECT_NEAR(delays_of(askew)[2], 0.04 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(askew.motions[0].motion->displacement(10.5 / 500 / std::sqrt(2.0)), 0, 1e-15);
}

// A foundation's own motion passes its own blocks; supports that are as far away share a motion.
TEST(Passage, IsPartOfAMotionOfOneGroup)
{
    const Stage stage =
        read(piers(", motion: {" + pulse + ", passes: {speed: 500 m/s, direction: [1, 0, 0]}}", "")).stages[0];
    ASSERT_EQ(stage.motions.size(), 2u);
    EXPECT_NEAR(delays_of(stage)[1], 0.02, 1e-12);
    const Stage across =
        read(piers("", ", motion: {" + pulse + ", passes: {speed: 500 m/s, direction: [0, 1, 0]}}")).stages[0];
    EXPECT_EQ(across.motions[0].motion, across.motions[2].motion);
}

TEST(Passage, SaysWhatIsWrong)
{
    const auto says = [](const std::string& passes, const std::string& part) {
        const std::string faults = faults_of(piers("", ", motion: {" + pulse + ", passes: " + passes + "}"));
        EXPECT_NE(faults.find(part), std::string::npos) << faults;
    };
    says("{speed: 500 m/s, direction: [1, 0, 0], from: [1010.5, 0, 0]}", "0.02 s before its motion begins");
    says("{direction: [1, 0, 0]}", "speed");
    says("{speed: 500 m/s}", "direction");
    says("{speed: 500 m/s, direction: [0, 0, 0]}", "length 0");
    says("{speed: 0.1 m/s, direction: [1, 0, 0]}", "speed");
    says("{speed: 500 m/s, direction: [1, 0, 0], to: [0, 0, 0]}", "to");
    EXPECT_NE(faults_of(piers("", ", motion: {passes: {speed: 500 m/s, direction: [1, 0, 0]}}")).find("no motion"),
              std::string::npos);
}

}  // namespace voussoir::app::reader
