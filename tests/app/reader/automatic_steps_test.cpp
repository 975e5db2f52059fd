// Time steps that a case leaves to the program.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{

namespace
{

/// A column on a floor that a sine shakes; `stage` is added to its dynamic stage.
std::string column(const std::string& stage, const std::string& output = "every: 20 ms")
{
    return "kinematics: planar_rigid\n"
           "thickness: 1 m\n"
           "materials: {stone: {density: 2000 kg/m3, young: 3 GPa, poisson: 0.2}}\n"
           "joints: {dry: {friction: 40 deg}}\n"
           "blocks:\n"
           "  - {box: {name: floor, lower: [-3, -1], upper: [3, 0]}, group: foundation}\n"
           "  - {wall: {name: column, length: 1 m, height: 3 m, thickness: 1 m, block: [1 m, 0.5 m]}}\n"
           "foundation: {blocks: foundation, motion: {x: {sine: {acceleration: 0.1 g, frequency: 1 Hz, duration: "
           "2 "
           "s}}}}\n"
           "stages:\n"
           "  - {name: self-weight, type: static}\n"
           "  - {name: earthquake, type: dynamic" +
           stage + "}\noutput: {" + output + "}\n";
}

const StepControl& control_of(const Case& the_case)
{
    return the_case.stages.at(1).control;
}

}  // namespace

TEST(AutomaticSteps, AreChosenWhereNoneIsGiven)
{
    const Case absent = read(column("")), asked = read(column(", time_step: auto"));
    const Case given = read(column(", time_step: 2 ms"));
    EXPECT_TRUE(control_of(absent).automatic);
    EXPECT_TRUE(control_of(asked).automatic);
    EXPECT_FALSE(control_of(given).automatic);
    EXPECT_EQ(control_of(absent).time_step, control_of(asked).time_step);
    EXPECT_EQ(control_of(given).time_step, 2e-3);
    EXPECT_FALSE(absent.stages[0].control.automatic) << "a static stage has no time";
    EXPECT_TRUE(has_default(absent, "time_step = auto, 0.00"));
    EXPECT_FALSE(has_default(given, "stages[1]: time_step"));
}

TEST(AutomaticSteps, EndWhereFramesAreDue)
{
    for (const char* every : {"20 ms", "5 ms", "7 ms", "0.3 ms", "1 s"}) {
        const Case the_case = read(column("", std::string("every: ") + every));
        const double parts = the_case.output.every / control_of(the_case).time_step;
        EXPECT_NEAR(parts, std::round(parts), 1e-9) << every;
        EXPECT_GE(parts, 1 - 1e-9) << every;
    }
}

TEST(AutomaticSteps, AreShorterWhereStonesVibrateOrStagesAreShort)
{
    const auto step = [](const std::string& stage, const std::vector<std::string>& set) {
        return control_of(read(column(stage), set)).time_step;
    };
    // The column sways at 23 Hz or at 230, beyond all that is judged.
    EXPECT_LT(step("", {"joints.dry.contact_stiffness=10 GPa/m"}),
              step("", {"joints.dry.contact_stiffness=1000 GPa/m"}));
    EXPECT_LE(step(", duration: 50 ms", {}), 1e-3) << "fifty steps at least";
    EXPECT_GE(step(", duration: 50 ms, min_time_step: 1.5 ms", {}), 1.5e-3);
}

TEST(AutomaticSteps, AreRefusedWhereTheyMakeNoSense)
{
    EXPECT_NE(faults_of(column(", time_step: auto, open_close: published")).find("give a step such as 0.1 ms"),
              std::string::npos);
    EXPECT_FALSE(control_of(read(column(", open_close: published"))).automatic);
    EXPECT_NE(faults_of(column(""), {"stages[0].time_step=auto"}).find("its step is no time"), std::string::npos);
    EXPECT_NE(faults_of(column(", time_step: automatic")).find("stages[1].time_step"), std::string::npos);
}

}  // namespace voussoir::app::reader
