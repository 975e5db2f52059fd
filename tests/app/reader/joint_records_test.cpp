// Records that belong together, along the axes of a scene.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/app/reader/motion_case.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double degree = std::numbers::pi / 180;

TEST_F(JointRecords, TurnToTheAxesOfTheScene)
{
    const Case the_case = read(moved_by("{" + three_records + ", x_azimuth: 40 deg}"));
    ASSERT_EQ(the_case.stages[1].motions.size(), 3);
    EXPECT_NEAR(the_case.stages[1].duration, 0.04, 1e-12);
    for (std::size_t i = 0; i < at_10.size(); ++i) {
        const double time = 0.01 * static_cast<double>(i);
        const double x = motion_along(0, the_case).motion->acceleration(time);
        const double y = motion_along(1, the_case).motion->acceleration(time);
        const double z = motion_along(2, the_case).motion->acceleration(time);
        // x lies 30 deg clockwise of the first sensor, and 60 deg anticlockwise of the second.
        EXPECT_NEAR(x, at_10[i] * std::cos(30 * degree) + at_100[i] * std::cos(60 * degree), 1e-12);
        EXPECT_NEAR(y, at_10[i] * std::cos(60 * degree) + at_100[i] * std::cos(150 * degree), 1e-12);
        EXPECT_EQ(z, upwards[i]);
        EXPECT_NEAR(std::hypot(x, y, z), std::hypot(at_10[i], at_100[i], upwards[i]), 1e-12);
    }
    EXPECT_NE(the_case.motions.at(0).description.find("rotated to x at azimuth 40 deg"), std::string::npos);
}

TEST_F(JointRecords, ThatPointDownAreTurnedOver)
{
    const Case the_case = read(moved_by("{" + with(three_records, "up]", "down]") + "}"));
    EXPECT_EQ(motion_along(2, the_case).motion->acceleration(0.03), -upwards[3]);
}

TEST_F(JointRecords, LieWithXToTheEastUnlessToldOtherwise)
{
    const Case the_case = read(moved_by("{records: [a.txt, b.txt], unit: m/s2, azimuths: [0 deg, 90 deg]}"));
    EXPECT_TRUE(has_default(the_case, "x_azimuth = 1.5708 rad (90 deg)"));
    for (std::size_t i = 0; i < at_10.size(); ++i) {
        const double time = 0.01 * static_cast<double>(i);
        EXPECT_NEAR(motion_along(0, the_case).motion->acceleration(time), at_100[i], 1e-12);
        EXPECT_NEAR(motion_along(1, the_case).motion->acceleration(time), at_10[i], 1e-12);
    }
}

TEST_F(JointRecords, TakeTheAxesTheyAreGiven)
{
    const Case the_case = read(moved_by("{records: [a.txt, b.txt], unit: m/s2, axes: [z, x]}"));
    ASSERT_EQ(the_case.stages[1].motions.size(), 2);
    EXPECT_EQ(motion_along(2, the_case).motion->acceleration(0.02), -2);
    EXPECT_EQ(motion_along(0, the_case).motion->acceleration(0.03), -3);
}

TEST_F(JointRecords, AreScaledByOneFactorThatAnAxisDecides)
{
    const Case the_case = read(moved_by("{" + three_records +
                                        ", x_azimuth: 10 deg, processing: [{rotate: {x_azimuth: 10 "
                                        "deg}}, {scale_to_pga: {value: 6 m/s2, component: y}}]}"));
    EXPECT_NEAR(motion_along(1, the_case).motion->peak_acceleration(), 6, 1e-12);  // 3 before
    EXPECT_NEAR(motion_along(0, the_case).motion->acceleration(0.02), 2 * at_10[2], 1e-12);
    EXPECT_NEAR(motion_along(2, the_case).motion->acceleration(0.03), 2 * upwards[3], 1e-12);
}

TEST_F(JointRecords, LeaveYOutOfAPlanarSceneWithAWarning)
{
    const std::string planar = "kinematics: planar_rigid\n" +
                               with(moved_by("{" + three_records + ", x_azimuth: 10 deg}"),
                                    "[-1, -1, -1], upper: [1, 1, 0]", "[-1, -0.5, -1], upper: [1, 0.5, 0]");
    const Case the_case = read(planar);
    ASSERT_EQ(the_case.stages[1].motions.size(), 2);
    EXPECT_NEAR(motion_along(0, the_case).motion->acceleration(0.02), -2, 1e-12);
    EXPECT_NEAR(motion_along(2, the_case).motion->acceleration(0.03), 2, 1e-12);
    const bool is_told =
        std::any_of(the_case.warnings.begin(), the_case.warnings.end(), [](const std::string& warning) {
            return warning.find("foundation.motion: the motion along y is ignored") != std::string::npos;
        });
    EXPECT_TRUE(is_told);
    EXPECT_EQ(
        faults_of(with(planar, three_records + ", x_azimuth: 10 deg", "records: [a.txt], unit: g, axes: [y]")),
        "case.yaml:10: foundation.motion: no record along x or z; rotate them or assign other axes");
}

TEST_F(JointRecords, MustSayWhereTheyPoint)
{
    EXPECT_EQ(faults_of(moved_by("{records: [a.txt], unit: g}")),
              "case.yaml:9: foundation.motion.records: channel 1 has no direction; give azimuths: [0 deg, 90 deg, "
              "up], or axes: [x, y, z], one for each channel");
    EXPECT_EQ(faults_of(moved_by("{records: [a.txt, b.txt], unit: g, azimuths: [0 deg, 90 deg, up]}")),
              "case.yaml:9: foundation.motion.azimuths: 3 directions for 2 channels; give one for each channel");
    EXPECT_EQ(faults_of(moved_by("{records: [a.txt, b.txt], unit: g, azimuths: [0 deg, 5 deg]}")),
              "case.yaml:9: foundation.motion: azimuths 0 and 5 deg, nearly parallel; two sensors at least 10 deg "
              "apart");
    EXPECT_EQ(faults_of(moved_by("{records: [a.txt, b.txt], unit: g, axes: [x, x]}")),
              "case.yaml:9: foundation.motion.axes[1]: a second channel along x; give each channel its own axis");
    EXPECT_EQ(faults_of(moved_by("{records: [a.txt, b.txt], unit: g, axes: [x, y], x_azimuth: 0 deg}")),
              "case.yaml:9: foundation.motion.axes: axes and azimuths; give one of the two");
    EXPECT_EQ(faults_of(moved_by("{" + with(three_records, "10 deg", "up") + "}")).find("no fault"),
              std::string::npos);
}

TEST_F(JointRecords, AreRefusedBesideMotionsOfSingleAxes)
{
    EXPECT_EQ(faults_of(moved_by("{" + three_records + ", x: {record: a.txt, unit: g}}")),
              "case.yaml:9: foundation.motion.x: has no meaning here; records give all axes");
}

TEST_F(JointRecords, LoadBlocksAsBodyAccelerationsToo)
{
    const Case the_case =
        read(with(two_boxes, "duration: 0.2 s,",
                  "duration: 0.2 s, body_acceleration: [{blocks: masonry, " + three_records + "}],"));
    ASSERT_EQ(the_case.stages[1].body_accelerations.size(), 3);
    EXPECT_EQ(the_case.stages[1].body_accelerations[2].component, 2);
    EXPECT_EQ(the_case.stages[1].body_accelerations[2].motion->acceleration(0.03), 2);
}

TEST_F(JointRecords, ThatCannotBeReadAreOneFaultEach)
{
    EXPECT_EQ(faults_of(moved_by("{records: [a.txt, b.txt], azimuths: [0 deg, 90 deg, up]}")),
              "case.yaml:9: foundation.motion.records[0]: the unit of \"a.txt\" is not known; give unit: one of "
              "g, g/10, "
              "m/s2, cm/s2, mm/s2, gal, m/s, cm/s, mm/s, m, cm, mm\n"
              "case.yaml:9: foundation.motion.records[1]: the unit of \"b.txt\" is not known; give unit: one of "
              "g, g/10, "
              "m/s2, cm/s2, mm/s2, gal, m/s, cm/s, mm/s, m, cm, mm");
}

TEST_F(JointRecords, DifferFromOneSupportToTheOther)
{
    std::string text = moved_by("{x: {record: a.txt, unit: m/s2}}");
    text = with(text, "foundation: {blocks: foundation", "foundation:\n  - {blocks: foundation");
    text =
        with(text, "stages:", "  - {blocks: pier, motion: {x: {record: b.txt, unit: m/s2, scale: -1}}}\nstages:");
    text = with(text, "foundation:",
                "  - {box: {name: pier, lower: [2, -1, -1], upper: [3, 1, 0]}, group: pier}\nfoundation:");
    const Case the_case = read(text);
    const std::vector<FoundationMotion>& motions = the_case.stages[1].motions;
    ASSERT_EQ(motions.size(), 2);
    for (const FoundationMotion& motion : motions) {
        const int block = the_case.model.foundations.at(static_cast<std::size_t>(motion.foundation)).block;
        const bool is_pier = the_case.model.blocks.at(static_cast<std::size_t>(block)).name == "pier";
        EXPECT_EQ(motion.motion->acceleration(0.03), is_pier ? 3 : 0.5);
    }
    EXPECT_EQ(the_case.motions.size(), 2);
}

TEST_F(JointRecords, OfSeveralColumnsNeedAComponentWhenOneIsAskedFor)
{
    folder_.write("table.txt", "0.00 0 0 0\n0.01 1 2 3\n0.02 0 0 0\n");
    EXPECT_EQ(faults_of(moved_by("{x: {record: table.txt, unit: g}}")),
              "case.yaml:9: foundation.motion.x.record: 3 channels in the record; select one with component: "
              "column 2, column 3, column 4");
    const Case the_case = read(moved_by("{x: {record: table.txt, unit: g, component: 3}}"));
    EXPECT_NEAR(only_motion(the_case).peak_acceleration(), 3 * gravity, 1e-12);
}

TEST_F(JointRecords, WithoutATimeStepAreRefusedWithTheKeyToGive)
{
    folder_.write("values.txt", "0\n1\n2\n0\n");
    EXPECT_EQ(faults_of(moved_by("{x: {record: values.txt, unit: g}}")),
              "case.yaml:9: foundation.motion.x.record: values.txt: no time step; give the record a time_step");
    EXPECT_NEAR(only_motion(read(moved_by("{x: {record: values.txt, unit: g, time_step: 0.1 s}}"))).duration(),
                0.3, 1e-12);
}

}  // namespace
}  // namespace voussoir::app::reader
