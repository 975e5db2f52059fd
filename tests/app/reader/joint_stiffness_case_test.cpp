// How stiff the joints of a case are: the spellings, and what stands for none.
#include <gtest/gtest.h>

#include "app/reader/case_file.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

TEST(JointStiffness, ContactStiffnessNeedsItsUnit)
{
    const auto kind = [](const std::string& value) {
        return read(two_boxes, {"joints.dry.contact_stiffness=" + value}).model.joints[0].stiffness.kind;
    };
    EXPECT_EQ(kind("1e8 N/m"), ContactStiffness::Kind::per_point);
    EXPECT_EQ(kind("50 MPa/m"), ContactStiffness::Kind::per_area);
    EXPECT_NE(faults_of(two_boxes, {"joints.dry.contact_stiffness=1e8"}).find("no unit"), std::string::npos);
}

// Measured joints open like elastic ones, those of the papers have springs at their corners.
TEST(JointStiffness, TheLawOfFacesFollowsItsUnit)
{
    const auto face = [](const std::vector<std::string>& settings) {
        return read(two_boxes, settings).model.joints[0].face;
    };
    const std::string key = "joints.dry.contact_stiffness=";
    EXPECT_EQ(face({}), FaceLaw::points);
    EXPECT_EQ(face({key + "30 E/L"}), FaceLaw::points);
    EXPECT_EQ(face({key + "50 MPa/m"}), FaceLaw::linear);
    EXPECT_EQ(face({key + "1e8 N/m"}), FaceLaw::corners);
    EXPECT_EQ(face({key + "1e8 N/m", "joints.dry.face=linear"}), FaceLaw::linear);
    EXPECT_EQ(face({key + "50 MPa/m", "joints.dry.face=points"}), FaceLaw::points);
}

TEST(JointStiffness, ContactStiffnessMayBeSoManyTimesTheModulus)
{
    const std::string key = "joints.dry.contact_stiffness";
    for (const std::string text : {"300 E/L", "300E/L", "3e2  E/L"}) {
        const ContactStiffness stiffness = read(two_boxes, {key + "=" + text}).model.joints[0].stiffness;
        EXPECT_EQ(stiffness.kind, ContactStiffness::Kind::from_modulus) << text;
        EXPECT_EQ(stiffness.value, 300) << text;
    }
    EXPECT_EQ(read(two_boxes).model.joints[0].stiffness.value, 0);
    for (const std::string text : {"0 E/L", "-1 E/L", "E/L", "nan E/L", "1 E", "300 e/l"})
        EXPECT_NE(faults_of(two_boxes, {key + "=" + text}).find("300 E/L (of the stones)"), std::string::npos)
            << text;
}

// Rattling on stiff joints is dear; what only has to carry its weight has little of it.
TEST(JointStiffness, RigidStonesUnderTheirWeightAloneHaveNearlyRigidJoints)
{
    const auto times = [](const std::vector<std::string>& settings) {
        return read(two_boxes, settings).model.joints[0].stiffness.value;
    };
    const std::string
        rest = "stages=[{name: rest, type: static}]",
        rigid = "kinematics=spatial_rigid", sudden = "stages=[{name: go, type: dynamic, duration: 1 s}]",
        shaken = "foundation={blocks: foundation, motion: {x: {sine: {acceleration: 0.1 g, frequency: 2 Hz}}}}",
        pushed =
            "stages=[{name: go, type: dynamic, duration: 1 s, body_acceleration: [{blocks: masonry, x: "
            "{sine: {acceleration: 0.1 g, frequency: 2 Hz}}}]}]",
        raised = "stages=[{name: go, type: dynamic, duration: 1 s, gravity: {ramp: 1 s}}]",
        turned = "initial_state=[{blocks: stone, rotate: {axis: z, angle: 3 deg}}]",
        thrown = "initial_state=[{blocks: stone, velocity: [1, 0, 0]}]";
    EXPECT_EQ(times({rest, rigid}), 300);
    EXPECT_EQ(times({rest, "kinematics=spatial_deformable"}), 0);
    EXPECT_EQ(times({sudden, rigid}), 300);
    EXPECT_EQ(times({sudden, rigid, shaken}), 0);
    EXPECT_EQ(times({pushed, rigid}), 0);
    EXPECT_EQ(times({raised, rigid}), 0);
    EXPECT_EQ(times({sudden, rigid, thrown}), 0);
    EXPECT_EQ(times({rest, rigid, turned}), 300);
    EXPECT_EQ(times({rest, rigid, "joints.dry.contact_stiffness=7 E/L"}), 7);
    EXPECT_EQ(times({rest, rigid, "joints.dry.contact_stiffness=5e7 Pa/m"}), 5e7);
}

TEST(JointStiffness, ContactStiffnessFactorIsOneAndPositive)
{
    const std::string key = "joints.dry.contact_stiffness_factor";
    EXPECT_EQ(read(two_boxes).model.joints[0].stiffness.factor, 1);
    EXPECT_EQ(read(two_boxes, {key + "=4"}).model.joints[0].stiffness.factor, 4);
    EXPECT_EQ(faults_of(two_boxes, {key + "=0"}), "--set " + key + ": 0; must be > 0");
}

}  // namespace
}  // namespace voussoir::app::reader
