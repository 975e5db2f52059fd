// Whole cases made of boxes: what a good one becomes, and what is said about bad ones.
#include "app/reader/case_file.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "app/reader/blocks.h"
#include "app/reader/overlaps.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

TEST(CaseFile, BecomesAModelWithStages)
{
    const Case the_case = read(two_boxes);
    const Model& model = the_case.model;
    EXPECT_EQ(the_case.title, "Two boxes");
    ASSERT_EQ(model.blocks.size(), 2);
    EXPECT_EQ(model.groups, (std::vector<std::string>{"foundation", "masonry"}));
    EXPECT_NEAR(model.mass(1), 2400, 1e-9);
    EXPECT_NEAR(model.joint_between(0, 1).friction_angle, std::numbers::pi / 6, 1e-15);
    EXPECT_EQ(model.joints[0].stiffness.kind, ContactStiffness::Kind::from_modulus);
    ASSERT_EQ(model.foundations.size(), 1);
    EXPECT_EQ(model.foundations[0].block, 0);
    EXPECT_TRUE(model.foundations[0].fully_held());
    ASSERT_EQ(the_case.stages.size(), 2);
    EXPECT_EQ(the_case.stages[0].type, StageType::static_equilibrium);
    EXPECT_DOUBLE_EQ(the_case.stages[0].control.time_step, 1);
    EXPECT_DOUBLE_EQ(the_case.stages[1].control.time_step, 0.002);
    EXPECT_DOUBLE_EQ(the_case.stages[1].duration, 0.2);
    EXPECT_DOUBLE_EQ(the_case.output.every, 0.02);
    EXPECT_FALSE(the_case.output.snapshots);
    EXPECT_EQ(the_case.output.histories.at(0).block, "stone");
}

TEST(CaseFile, FrictionMayDependOnTheSpeedOfSlip)
{
    const std::string table =
        "friction: 30 deg, friction_at_speed: [{speed: 1 cm/s, friction: 25 deg}, {speed: 0.1 m/s, friction: 20 "
        "deg}]";
    const JointMaterial joint = read(with(two_boxes, "friction: 30 deg", table)).model.joints.at(0);
    ASSERT_EQ(joint.friction_at_speed.size(), 2u);
    const auto tangent = [](double angle) { return std::tan(angle * std::numbers::pi / 180); };
    EXPECT_NEAR(friction_coefficient(joint, 0), tangent(30), 1e-15);
    EXPECT_NEAR(friction_coefficient(joint, 0.005), 0.5 * (tangent(30) + tangent(25)), 1e-15);
    EXPECT_NEAR(friction_coefficient(joint, 0.055), 0.5 * (tangent(25) + tangent(20)), 1e-15);
    EXPECT_NEAR(friction_coefficient(joint, 3), tangent(20), 1e-15);
    const std::string none = "friction: 30 deg, friction_at_speed: []";
    EXPECT_NE(faults_of(with(two_boxes, "friction: 30 deg", none)).find("an empty list"), std::string::npos);
    const std::string descending =
        "friction: 30 deg, friction_at_speed: [{speed: 2 m/s, friction: 25 deg}, {speed: 1 m/s, friction: 20 "
        "deg}]";
    EXPECT_NE(faults_of(with(two_boxes, "friction: 30 deg", descending)).find("speeds must be in ascending order"),
              std::string::npos);
}

TEST(CaseFile, PrintsEveryDefaultItTakes)
{
    const Case the_case = read(with(two_boxes, ", time_step: 2 ms", ""));
    EXPECT_TRUE(has_default(the_case, "kinematics = spatial_deformable"));
    EXPECT_TRUE(has_default(the_case, "gravity = 9.80665 m/s2 along -z"));
    EXPECT_TRUE(has_default(the_case, "time_step = auto, 0.00"));
    EXPECT_TRUE(has_default(the_case, "blocks[1]: material = granite, group = masonry"));
    EXPECT_TRUE(has_default(the_case, "foundation: x = fixed, y = fixed, z = fixed, rotation = fixed"));
    EXPECT_FALSE(has_default(read(two_boxes), "stages[1]: time_step"));
}

TEST(CaseFile, ListsAllFaultsAtOnceWithLines)
{
    std::string text = with(two_boxes, "young: 4.5 GPa", "yung: 4.5 GPa");
    text = with(text, "time_step: 2 ms", "time_step: -1 ms");
    text = with(text, "friction: 30 deg", "friction: 30 m");
    text = with(text, "block: stone", "block: stome");
    EXPECT_EQ(
        faults_of(text),
        "case.yaml:3: materials.granite.young: missing; give a pressure such as 4.5 GPa\n"
        "case.yaml:3: materials.granite.yung: unknown key; did you mean young?\n"
        "case.yaml:5: joints.dry.friction: \"30 m\" has the wrong dimension; expected an angle such as 30 deg\n"
        "case.yaml:12: stages[1].time_step: -1 ms; must be > 0\n"
        "case.yaml:13: output.histories.top.block: no block \"stome\"; did you mean stone?");
}

TEST(CaseFile, PlacesFaultsOfOverridesAtTheOption)
{
    EXPECT_EQ(faults_of(two_boxes, {"stages[1].time_step=0 s"}), "--set stages[1].time_step: 0 s; must be > 0");
    EXPECT_DOUBLE_EQ(read(two_boxes, {"stages[1].time_step=1 ms"}).stages[1].control.time_step, 0.001);
    EXPECT_EQ(read(two_boxes, {"kinematics=spatial_rigid"}).model.kinematics, Kinematics::spatial_rigid);
    EXPECT_TRUE(read(two_boxes, {"output=null"}).output.histories.empty());
}

// 0.7 was 40.1 deg in radians, and its writer meant the tangent.
TEST(CaseFile, FrictionWithoutUnitIsAFaultThatOffersAngleAndCoefficient)
{
    EXPECT_EQ(faults_of(two_boxes, {"joints.dry.friction=0.7"}),
              "--set joints.dry.friction: \"0.7\" has no unit; write 0.7 deg for an angle, or {coefficient: 0.7}, "
              "which is 34.99 deg");
    EXPECT_NE(faults_of(two_boxes, {"joints.dry.friction=-0.7"}).find("has no unit"), std::string::npos);
    EXPECT_EQ(faults_of(two_boxes, {"joints.dry.friction=95 deg"}),
              "--set joints.dry.friction: 95 deg; must be >= 0 and < 1.5708 rad (90 deg)");
}

TEST(CaseFile, FrictionMayBeACoefficient)
{
    const auto angle = [](const std::string& friction) {
        return read(two_boxes, {"joints.dry.friction=" + friction}).model.joints.at(0).friction_angle;
    };
    EXPECT_DOUBLE_EQ(angle("{coefficient: 0.7}"), std::atan(0.7));
    EXPECT_EQ(angle("{coefficient: 0}"), 0);
    EXPECT_EQ(angle("0"), 0);
    const auto said = [](const std::string& friction) {
        return faults_of(two_boxes, {"joints.dry.friction=" + friction});
    };
    EXPECT_EQ(said("{coefficient: -1}"),
              "--set joints.dry.friction: joints.dry.friction.coefficient: -1; must be >= 0 and <= 1e+06");
    EXPECT_NE(said("{coefficient: 35 deg}").find("expected a number without unit"), std::string::npos);
    EXPECT_NE(said("{coeficient: 0.7}").find("did you mean coefficient?"), std::string::npos);
    EXPECT_NE(said("{}").find("coefficient: missing"), std::string::npos);
    const std::string at_speed = "joints.dry.friction_at_speed=[{speed: 1 cm/s, friction: {coefficient: 0.5}}]";
    EXPECT_DOUBLE_EQ(read(two_boxes, {at_speed}).model.joints.at(0).friction_at_speed.at(0).angle, std::atan(0.5));
}

TEST(CaseFile, NumbersWithoutTheUnitThatDecidesAreFaults)
{
    const std::string motion = "foundation.motion.x=";
    const std::pair<std::string, std::string> bare[] = {
        {motion + "{ricker: {acceleration: 0.35, frequency: 2 Hz}}", "write 0.35 g or 0.35 m/s2"},
        {motion + "{ricker: {acceleration: 1 g, frequency: 2 Hz}, scale_to_pga: 0.35}",
         "write 0.35 g or 0.35 m/s2"},
        {motion + "{ricker: {acceleration: 1 g, frequency: 2 Hz}, processing: [{scale_to_pga: 0.35}]}",
         "write 0.35 g or 0.35 m/s2"},
        {motion + "{ricker: {acceleration: 1 g, frequency: 2 Hz}, processing: [{scale_to_pgv: 20}]}",
         "write 20 cm/s or 20 m/s"},
        {motion + "{sine: {acceleration: 1 g, frequency: 2 Hz, phase: 90}}", "write 90 deg or 90 rad"},
        {"gravity.magnitude=9.81", "write 9.81 g or 9.81 m/s2"},
        {"stages[1].gravity={tilt: 10, towards: [1, 0, 0]}", "write 10 deg or 10 rad"},
        {"blocks[1].rotate={axis: z, angle: 30}", "write 30 deg or 30 rad"},
        {"initial_state=[{blocks: stone, spin: [0, 0, 20]}]", "write 20 rad/s or 20 deg/s"},
        {"materials.granite.young=4500", "write 4500 MPa or 4500 Pa"},
        {"materials.granite.density=24", "write 24 kg/m3 or 24 kN/m3"},
        {"joints.dry.cohesion=0.1", "write 0.1 MPa or 0.1 Pa"},
    };
    for (const auto& [setting, remedy] : bare)
        EXPECT_NE(faults_of(two_boxes, {setting}).find(" has no unit; " + remedy), std::string::npos)
            << setting << ": " << faults_of(two_boxes, {setting});
}

TEST(CaseFile, NothingNeedsNoUnitAndNeitherDoLengthsAndTimes)
{
    EXPECT_EQ(faults_of(two_boxes, {"joints.dry.cohesion=0", "blocks[1].rotate={axis: z, angle: 0}",
                                    "stages[1].time_step=0.002", "output.every=0.02"}),
              "no fault");
}

TEST(CaseFile, OverlappingBoxesAreRefusedAndTouchingOnesAreNot)
{
    EXPECT_EQ(faults_of(with(two_boxes, "[-0.5, -0.5, 0]", "[-0.5, -0.5, -0.1]")),
              "case.yaml:8: blocks[1].box: floor and stone: overlap by 0.1 m; stones may touch but not overlap");
}

TEST(CaseFile, BoxesTurnAboutTheirCentreOrAPoint)
{
    const Case the_case = read(with(two_boxes, "upper: [50 cm, 0.5, 1]",
                                    "upper: [50 cm, 0.5, 1], rotate: {axis: [0, 0, 2], angle: 90 deg, about: [0, "
                                    "1, 0]}"));
    EXPECT_TRUE(the_case.model.blocks[1].moments.centroid.isApprox(Eigen::Vector3d(1, 1, 0.5), 1e-14));
}

TEST(CaseFile, JointsFollowTheirRules)
{
    std::string text =
        with(two_boxes, "  dry: {friction: 30 deg}", "  dry: {friction: 30 deg}\n  slick: {friction: 10 deg}");
    EXPECT_NE(faults_of(text).find("default_joint: missing"), std::string::npos);
    text += "default_joint: dry\njoint_rules: [{between: [masonry, foundation], joint: slick}]\n";
    const Model model = read(text).model;
    EXPECT_EQ(model.joint_between(0, 1).name, "slick");
    EXPECT_EQ(model.joint_between(1, 0).name, "slick");
    EXPECT_EQ(model.joint_between(1, 1).name, "dry");
}

TEST(CaseFile, MotionActsInTheOnlyDynamicStage)
{
    const std::string sine = "{sine: {acceleration: 0.5 g, frequency: 2.5 Hz}}";
    const std::string text =
        with(two_boxes, "{blocks: foundation}", "{blocks: foundation, motion: {x: " + sine + "}}");
    const Case the_case = read(text);
    ASSERT_EQ(the_case.stages[1].motions.size(), 1);
    EXPECT_TRUE(the_case.stages[0].motions.empty());
    EXPECT_EQ(the_case.stages[1].motions[0].component, 0);
    EXPECT_DOUBLE_EQ(the_case.stages[1].motions[0].motion->duration(), 0.2);
    EXPECT_EQ(the_case.motions.size(), 1);
    EXPECT_NE(faults_of(text, {"stages[2]={type: dynamic, duration: 1 s}"}).find("2 dynamic stages"),
              std::string::npos);
    const Case named =
        read(text, {"stages[2]={name: more, type: dynamic, duration: 1 s}", "foundation.motion_stage=more"});
    EXPECT_TRUE(named.stages[1].motions.empty());
    EXPECT_EQ(named.stages[2].motions.size(), 1);
    EXPECT_NE(faults_of(text, {"foundation.x=free"}).find("a motion of a free component"), std::string::npos);
}

TEST(CaseFile, ARecordGivesItsDurationAndIsScaledToAPeak)
{
    const TemporaryFolder folder;
    folder.write("record.txt", "0.00 0.0\n0.01 1.0\n0.02 -2.0\n0.03 0.0\n");
    const std::string text =
        with(with(two_boxes, ", duration: 0.2 s", ""), "{blocks: foundation}",
             "{blocks: foundation, motion: {z: {record: record.txt, unit: m/s2, scale_to_pga: "
             "0.1 g}}}");
    const Case the_case = read_case(folder.write("case.yaml", text), {});
    EXPECT_NEAR(the_case.stages[1].duration, 0.03, 1e-12);
    EXPECT_NEAR(the_case.stages[1].motions.at(0).motion->peak_acceleration(), 0.1 * 9.80665, 1e-12);
    EXPECT_NE(the_case.motions.at(0).residual_velocity, 0);
    const Case corrected = read_case(folder / "case.yaml", {"foundation.motion.z.end_correction=true"});
    EXPECT_NEAR(corrected.motions.at(0).residual_velocity, 0, 1e-12);
}

TEST(CaseFile, BodyAccelerationLoadsAFreeGroup)
{
    const Case the_case =
        read(two_boxes, {"stages[1].body_acceleration=[{blocks: masonry, y: {sine: {acceleration: 1 m/s2, "
                         "frequency: 1 Hz}}}]"});
    ASSERT_EQ(the_case.stages[1].body_accelerations.size(), 1);
    EXPECT_EQ(the_case.stages[1].body_accelerations[0].block, 1);
    EXPECT_EQ(the_case.stages[1].body_accelerations[0].component, 1);
}

TEST(CaseFile, ARigidSceneHasNoStressToDraw)
{
    EXPECT_EQ(read(two_boxes, {"output.snapshots={color: principal_stress}"}).output.snapshots->color,
              SnapshotColor::principal_stress);
    EXPECT_NE(faults_of(two_boxes, {"output.snapshots={color: principal_stress}", "kinematics=spatial_rigid"})
                  .find("rigid scene, which has no stress"),
              std::string::npos);
}

TEST(CaseFile, AFilmIsAskedForByTrueOrByItsWishes)
{
    EXPECT_FALSE(read(two_boxes).output.film);
    EXPECT_FALSE(read(two_boxes, {"output.video=false"}).output.film);
    const Case plain = read(two_boxes, {"output.video=true"});
    ASSERT_TRUE(plain.output.film);
    EXPECT_EQ(plain.output.film->width, 1280);
    EXPECT_EQ(plain.output.film->slow_down, 1);
    const Case slow = read(two_boxes, {"output.video={color: slip, format: webp, size: [640, 360], fps: 30, "
                                       "slow_down: 10}"});
    ASSERT_TRUE(slow.output.film);
    EXPECT_EQ(slow.output.film->color, SnapshotColor::slip);
    EXPECT_EQ(slow.output.film->format, FilmFormat::webp);
    EXPECT_EQ(slow.output.film->height, 360);
    EXPECT_EQ(slow.output.film->frames_per_second, 30);
    EXPECT_EQ(slow.output.film->slow_down, 10);
}

TEST(CaseFile, PicturesAndFilmsHaveTheLooksOfTheCommandLine)
{
    const Case the_case = read(
        two_boxes, {"output.snapshots={color: friction, hide: foundation, cut: [\"z>5\", \"x<-9\"], label: [st*], "
                    "view: top, orthographic: true, forces: true}",
                    "output.video={color: group, follow: structure, orbit: 90 deg, view: \"30,20\"}"});
    ASSERT_TRUE(the_case.output.snapshots && the_case.output.film);
    EXPECT_EQ(the_case.output.snapshots->color, SnapshotColor::friction);
    const LookOptions& look = the_case.output.snapshots->look;
    EXPECT_EQ(look.hidden, std::vector<std::string>{"foundation"});
    EXPECT_EQ(look.cuts, (std::vector<std::string>{"z>5", "x<-9"}));
    EXPECT_EQ(look.labels, std::vector<std::string>{"st*"});
    EXPECT_EQ(look.view, "top");
    EXPECT_TRUE(look.orthographic && look.forces && !look.ground);
    EXPECT_EQ(the_case.output.film->color, SnapshotColor::group);
    EXPECT_EQ(the_case.output.film->look.follow, "structure");
    EXPECT_NEAR(the_case.output.film->look.orbit, 90, 1e-9);
}

TEST(CaseFile, ALookThatCannotBeDrawnIsRefusedBeforeTheRun)
{
    const auto said = [](const std::string& look) {
        return faults_of(two_boxes, {"output.snapshots={" + look + "}"});
    };
    EXPECT_NE(said("hide: tower_*").find("\"tower_*\" is the name of no stone and of no group"),
              std::string::npos);
    EXPECT_NE(said("hide: \"*\"").find("no stone is left"), std::string::npos);
    EXPECT_NE(said("cut: [\"z>-9\"]").find("no stone is left"), std::string::npos);
    EXPECT_NE(said("cut: \"w>1\"").find("give an axis, < or >"), std::string::npos);
    EXPECT_NE(said("label: foundation").find("is the name of no stone"), std::string::npos) << "it is a group";
    EXPECT_NE(said("view: above").find("give front, right, back"), std::string::npos);
    EXPECT_NE(said("follow: nobody").find("\"nobody\" is the name of no stone"), std::string::npos);
    EXPECT_NE(said("ground: true").find("no foundation follows a motion"), std::string::npos);
    EXPECT_NE(said("orbit: 90 deg").find("orbit"), std::string::npos) << "of films alone";
}

TEST(CaseFile, AFilmThatCannotBeIsRefused)
{
    const auto said = [](const std::string& setting) { return faults_of(two_boxes, {setting}); };
    EXPECT_NE(said("output.video={size: [641, 360]}").find("even width and height"), std::string::npos);
    EXPECT_NE(said("output.video={slow_down: 30000}").find("<= 10000"), std::string::npos);
    EXPECT_NE(said("output.video={fps: 0}").find("from 1 to 120"), std::string::npos);
    EXPECT_NE(said("output.video=yes_please").find("output.video"), std::string::npos);
    EXPECT_NE(faults_of(two_boxes, {"output.video={slow_down: 9000}", "stages[1].duration=5 s"})
                  .find("a film of 1125000 frames"),
              std::string::npos);
    EXPECT_NE(faults_of(two_boxes, {"output.video=true", "stages[1]=null"}).find("no time passes"),
              std::string::npos);
}

TEST(CaseFile, KeysOfTheOtherKindOfStageSaySo)
{
    EXPECT_EQ(faults_of(two_boxes, {"stages[0].duration=3 s"}),
              "--set stages[0].duration: has no meaning here; a static stage ends at equilibrium");
    EXPECT_EQ(faults_of(two_boxes, {"stages[1].integrator=newmark", "stages[1].dissipation=0.1"}),
              "--set stages[1].dissipation: has no meaning here; it belongs to integrator: energy_decaying");
}

TEST(CaseFile, StepsOfMotionMayFollowTheirError)
{
    EXPECT_EQ(faults_of(two_boxes, {"stages[1].step_error=0.01 mm"}), "no fault");
    EXPECT_NE(faults_of(two_boxes, {"stages[0].step_error=0.01 mm"}), "no fault");
    EXPECT_EQ(faults_of(two_boxes, {"stages[1].integrator=newmark", "stages[1].step_error=0.01 mm"}),
              "--set stages[1].step_error: has no meaning here; it belongs to integrator: energy_decaying");
    EXPECT_NE(faults_of(two_boxes, {"stages[1].step_error=0 mm"}), "no fault");
    EXPECT_NE(faults_of(two_boxes, {"stages[1].step_error=2 ms"}), "no fault");
}

TEST(CaseFile, NewmarkRefusesARestitutionThatItWouldLeaveOut)
{
    const std::string bouncing = with(two_boxes, "friction: 30 deg}", "friction: 30 deg, restitution: 0.3}");
    EXPECT_EQ(faults_of(bouncing), "no fault");
    EXPECT_NE(faults_of(bouncing, {"stages[1].integrator=newmark"})
                  .find("integrator: newmark leaves impacts to the springs, but joint dry has a restitution"),
              std::string::npos);
    EXPECT_EQ(faults_of(two_boxes, {"stages[1].integrator=newmark"}), "no fault");  // 0, the default
}

// It would leave them out without a word.
TEST(CaseFile, ThePublishedIterationRefusesWhatItDoesNotKnow)
{
    const std::string bends = with(two_boxes, "time_step: 2 ms}", "time_step: 2 ms, open_close: published}");
    EXPECT_NE(faults_of(bends).find("case.yaml:12: stages[1]: open_close: published does not bend stones"),
              std::string::npos)
        << faults_of(bends);
    const std::string published = with(bends, "friction: 30 deg}", "friction: 30 deg, face: corners}");
    ASSERT_EQ(faults_of(published), "no fault");
    for (const std::string key : {"cohesion: 1 MPa", "tensile_strength: 1 kPa", "relaxation_time: 1 ms"}) {
        const std::string joint = with(published, "face: corners}", "face: corners, " + key + "}");
        EXPECT_NE(faults_of(joint).find("case.yaml:12: stages[1]: open_close: published has no cohesion"),
                  std::string::npos)
            << faults_of(joint);
        EXPECT_EQ(faults_of(with(joint, ", open_close: published", "")), "no fault");
    }
    for (const std::string key : {"max_open_close: 6", "force_tolerance: 1e-3", "integrator: energy_decaying",
                                  "step_error: 0.1 mm", "divide_up_to_blocks: 10"}) {
        const std::string stage = with(published, "published}", "published, " + key + "}");
        EXPECT_NE(faults_of(stage).find("has no meaning here; the published iteration has"), std::string::npos)
            << faults_of(stage);
    }
}

std::string with_joint(const std::string& keys)
{
    return with(two_boxes, "friction: 30 deg}", "friction: 30 deg, " + keys + "}");
}

double relaxation_time(const Case& the_case)
{
    return the_case.model.joints.at(0).relaxation_time;
}

TEST(CaseFile, JointsHaveARestitutionOrADashpot)
{
    const auto restitution = [](const std::string& keys) {
        return read(keys.empty() ? std::string(two_boxes) : with_joint(keys)).model.joints.at(0).restitution;
    };
    EXPECT_EQ(restitution(""), 0.0);
    EXPECT_EQ(restitution("restitution: 0.3"), 0.3);
    EXPECT_EQ(restitution("restitution: none"), std::nullopt);
    EXPECT_EQ(restitution("relaxation_time: 1 ms"), std::nullopt);
    EXPECT_EQ(restitution("relaxation_time: 1 ms, restitution: none"), std::nullopt);
    EXPECT_EQ(faults_of(with_joint("restitution: 1.2")),
              "case.yaml:5: joints.dry.restitution: 1.2; must be >= 0 and <= 1");
    EXPECT_EQ(faults_of(with_joint("relaxation_time: 1 ms, restitution: 0.3")),
              "case.yaml:5: joints.dry.restitution: restitution beside a relaxation_time; a joint has one or the "
              "other; or write restitution: none");
}

TEST(RenamedKeys, AreReadUnderTheirFormerNameWithAWarning)
{
    const Case now = read(with_joint("relaxation_time: 1 ms"));
    EXPECT_DOUBLE_EQ(relaxation_time(now), 1e-3);
    EXPECT_TRUE(now.warnings.empty());
    const Case before = read(with_joint("dashpot: 1 ms"));
    EXPECT_DOUBLE_EQ(relaxation_time(before), 1e-3);
    ASSERT_EQ(before.warnings.size(), 1);
    EXPECT_TRUE(before.warnings[0].ends_with(
        "case.yaml:5: joints.dry.dashpot: this key is now called relaxation_time; the former name is accepted in "
        "this release only"))
        << before.warnings[0];
    EXPECT_EQ(faults_of(with_joint("dashpot: -1 ms")), "case.yaml:5: joints.dry.dashpot: -1 ms; must be >= 0");
    EXPECT_EQ(faults_of(with_joint("relaxation_time: 1 ms, dashpot: 1 ms")),
              "case.yaml:5: joints.dry.dashpot: the former name of relaxation_time, which is given too; keep "
              "relaxation_time");
}

TEST(RenamedKeys, AreWarnedOfOnce)
{
    const Case both =
        read(with_joint("dashpot: 1 ms}\n  wet: {friction: 20 deg, dashpot: 2 ms"), {"default_joint=dry"});
    EXPECT_DOUBLE_EQ(both.model.joints.at(1).relaxation_time, 2e-3);
    EXPECT_EQ(both.warnings.size(), 1);
}

TEST(RenamedKeys, MayBeSetUnderEitherName)
{
    for (const std::string in_the_file : {"dashpot", "relaxation_time"})
        for (const std::string set : {"dashpot", "relaxation_time"}) {
            const std::string text = with_joint(in_the_file + ": 1 ms");
            const Case changed = read(text, {"joints.dry." + set + "=2 ms"});
            EXPECT_DOUBLE_EQ(relaxation_time(changed), 2e-3) << in_the_file << ", " << set;
            EXPECT_EQ(changed.warnings.size(), set == "dashpot" ? 1 : 0) << in_the_file << ", " << set;
            EXPECT_DOUBLE_EQ(relaxation_time(read(text, {"joints.dry." + set + "=null"})), 0);
        }
    EXPECT_EQ(
        read(two_boxes, {"joints.dry.dashpot=2 ms"}).warnings.at(0),
        "--set joints.dry.dashpot: this key is now called relaxation_time; the former name is accepted in this "
        "release only");
}

TEST(Patterns, StarsAndQuestionMarks)
{
    EXPECT_TRUE(matches_pattern("abutment_left", "abutment_*"));
    EXPECT_TRUE(matches_pattern("abc", "*c"));
    EXPECT_TRUE(matches_pattern("abc", "a?c"));
    EXPECT_TRUE(matches_pattern("", "*"));
    EXPECT_FALSE(matches_pattern("abc", "a?"));
    EXPECT_FALSE(matches_pattern("voussoir", "abutment_*"));
    EXPECT_FALSE(matches_pattern(std::string(200, 'a'), "*a*a*a*a*a*a*a*a*a*a*b"));  // in no time
}

TEST(Overlaps, DepthIsTheShortestWayOut)
{
    const ConvexPolyhedron cube = make_box({0, 0, 0}, {1, 1, 1});
    EXPECT_NEAR(overlap_depth(cube, cube, {0.75, 0.5, 0}), 0.25, 1e-15);
    EXPECT_LE(overlap_depth(cube, cube, {1, 0, 0}), 0);
    // Two cubes edge to edge, which only an edge-edge axis can part: both turned by 45 degrees about different
    // axes.
    const auto turned = [](ConvexPolyhedron shape, const Eigen::Vector3d& axis) {
        const Eigen::AngleAxisd rotation(std::numbers::pi / 4, axis);
        for (Eigen::Vector3d& vertex : shape.vertices) vertex = rotation * vertex;
        return shape;
    };
    const ConvexPolyhedron centred = make_box({-1, -1, -1}, {1, 1, 1});
    const ConvexPolyhedron a = turned(centred, Eigen::Vector3d::UnitX());
    const ConvexPolyhedron b = turned(centred, Eigen::Vector3d::UnitY());
    EXPECT_LT(overlap_depth(a, b, {0, 0, 2 * std::numbers::sqrt2 + 1e-3}), 0);
    EXPECT_NEAR(overlap_depth(a, b, {0, 0, 2 * std::numbers::sqrt2 - 1e-3}), 1e-3, 1e-9);
}

}  // namespace
}  // namespace voussoir::app::reader
