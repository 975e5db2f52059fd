// Gravity of a stage: tilted, growing, turning; and what is said about faults.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double g = 9.80665, degree = std::numbers::pi / 180;

/// @param gravity of the dynamic stage @param at_rest of the static one
std::string with_gravity(const std::string& gravity, const std::string& at_rest = "")
{
    return "materials: {stone: {density: 2000 kg/m3, young: 3 GPa, poisson: 0.2}}\n"
           "joints: {dry: {friction: 30 deg}}\n"
           "blocks:\n"
           "  - {box: {name: floor, lower: [-1, -1, -1], upper: [1, 1, 0]}, group: foundation}\n"
           "  - box: {name: block, lower: [-0.1, -0.1, 0], upper: [0.1, 0.1, 0.4]}\n"
           "foundation: {blocks: foundation}\n"
           "stages:\n"
           "  - {name: rest, type: static" +
           at_rest +
           "}\n"
           "  - {name: motion, type: dynamic, duration: 3 s" +
           gravity + "}\n";
}

}  // namespace

// Squares of these lengths are no numbers: gravity was zero then, and 9.80665 was printed.
TEST(Gravity, ItsDirectionMayHaveAnyLength)
{
    for (const std::string length : {"1e160", "1e308", "1e-160", "1e-300", "7"}) {
        const Case the_case =
            read("gravity: {direction: [" + length + ", 0, -" + length + "]}\n" +
                 with_gravity(", gravity: {tilt: 90 deg, towards: [-" + length + ", 0, -" + length + "]}"));
        const double part = g / std::numbers::sqrt2;
        EXPECT_TRUE(the_case.stages[0].gravity.isApprox(Eigen::Vector3d(part, 0, -part), 1e-14)) << length;
        EXPECT_TRUE(the_case.stages[1].gravity.isApprox(Eigen::Vector3d(-part, 0, -part), 1e-14)) << length;
    }
    EXPECT_NE(faults_of("gravity: {direction: [0, 0, 0]}\n" + with_gravity("")).find("a direction of length 0"),
              std::string::npos);
    EXPECT_NE(faults_of("gravity: {magnitude: 1e200 m/s2}\n" + with_gravity("")).find("must be >= 0 and <= 1e+09"),
              std::string::npos);
}

TEST(StageGravity, GrowsFromNothing)
{
    const Stage stage = read(with_gravity(", gravity: {ramp: 2 s}")).stages[1];
    EXPECT_EQ(stage.gravity_ramp.duration, 2);
    EXPECT_EQ(stage.gravity_ramp.from, Eigen::Vector3d::Zero());
    EXPECT_FALSE(stage.gravity_ramp.turns);
    EXPECT_TRUE(stage.gravity.isApprox(Eigen::Vector3d(0, 0, -g)));
}

TEST(StageGravity, TurnsFromOneTiltToAnother)
{
    const auto leaning = [](double angle) {
        return Eigen::Vector3d(g * Eigen::Vector3d(std::sin(angle * degree), 0, -std::cos(angle * degree)));
    };
    const Case the_case =
        read(with_gravity(", gravity: {ramp: 2 s, tilt: 20 deg, from: 5 deg, towards: [3, 0, -1]}",
                          ", gravity: {tilt: 5 deg, towards: [1, 0, 0]}"));
    EXPECT_TRUE(the_case.stages[0].gravity.isApprox(leaning(5), 1e-14));
    EXPECT_EQ(the_case.stages[0].gravity_ramp.duration, 0);
    EXPECT_TRUE(the_case.stages[1].gravity.isApprox(leaning(20), 1e-14));
    EXPECT_TRUE(the_case.stages[1].gravity_ramp.from.isApprox(leaning(5), 1e-14));
    EXPECT_TRUE(the_case.stages[1].gravity_ramp.turns);
    const Stage steady = read(with_gravity(", gravity: {tilt: 20 deg, towards: [1, 0, 0]}")).stages[1];
    EXPECT_TRUE(steady.gravity.isApprox(leaning(20), 1e-14));
    EXPECT_EQ(steady.gravity_ramp.duration, 0);
}

TEST(StageGravity, IsThatOfTheSceneWhereNothingIsSaid)
{
    const Stage stage = read(with_gravity("")).stages[1];
    EXPECT_EQ(stage.gravity_ramp.duration, 0);
    EXPECT_TRUE(stage.gravity.isApprox(Eigen::Vector3d(0, 0, -g)));
}

TEST(StageGravity, FaultsSayWhatIsWrong)
{
    const std::string place = "case.yaml:9: stages[1].gravity";
    EXPECT_EQ(faults_of(with_gravity(", gravity: {}")),
              place + ": neither ramp nor tilt; give {ramp: 2 s} or {tilt: 10 deg, towards: [1, 0, 0]}");
    EXPECT_EQ(faults_of(with_gravity(", gravity: {ramp: 2 s, tilt: 10 deg, towards: [0, 0, 2]}")),
              place + ".towards: along gravity, or of length 0; give a direction across it, such as [1, 0, 0]");
    EXPECT_EQ(faults_of(with_gravity(", gravity: {ramp: 2 s, towards: [1, 0, 0]}")),
              place + ".towards: has no meaning here; there is no tilt");
    EXPECT_EQ(faults_of(with_gravity(", gravity: {tilt: 9 deg, from: 2 deg, towards: [1, 0, 0]}")),
              place + ".from: has no meaning here; there is no ramp");
    for (const char* wrong :
         {"ramp: 0 s", "ramp: -1 s", "ramp: 3 m", "ramp: 1 s, tilt: 180 deg, towards: [1, 0, 0]",
          "ramp: 1 s, tilt: -1 deg, towards: [1, 0, 0]", "tilt: 10 deg", "rampe: 1 s"})
        EXPECT_NE(faults_of(with_gravity(std::string(", gravity: {") + wrong + "}")), "no fault") << wrong;
    EXPECT_EQ(faults_of(with_gravity("", ", gravity: {ramp: 1 s, tilt: 5 deg, towards: [1, 0, 0]}")),
              "case.yaml:8: stages[0].gravity.ramp: has no meaning here; time does not pass in a static stage");
}

}  // namespace voussoir::app::reader
