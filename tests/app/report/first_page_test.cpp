// What a reader takes away from the first page: it is what the results say, and how sure it is stands beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/results/hdf5_file.h"
#include "app/results/results_reader.h"
#include "tests/app/command_test.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

/// A stone 1 m wide, 1 m deep and of a height on a ground that is held, and what happens to it.
std::string stone_case(double height, const std::string& rest)
{
    return "title: A stone\nkinematics: planar_rigid\nthickness: 1 m\nmaterials: {stone: {density: 2000 kg/m3, "
           "young: "
           "5 GPa, poisson: 0.2}}\njoints: {dry: {friction: 30 deg}}\nblocks:\n"
           "  - box: {name: ground, lower: [-4, -1], upper: [4, 0]}\n    group: foundation\n"
           "  - box: {name: stone, lower: [-0.5, 0], upper: [0.5, " +
           std::to_string(height) + "]}\n" + rest;
}

class FirstPage : public CommandTest
{
 protected:
    Json report_of(const std::string& case_text, const std::string& rest = "")
    {
        folder_.write("case.yaml", case_text);
        voussoir("run case.yaml -o results " + rest);
        said_ = output_;
        EXPECT_EQ(voussoir("report results --no-film -q"), 0) << output_;
        return Json::parse(contents("results/report.json"));
    }
    Json summary() const { return Json::parse(contents("results/summary.json")); }
    static Json section(const Json& report, const std::string& title)
    {
        for (const Json& one : report.at("sections"))
            if (one.at("title") == title) return one;
        return {};
    }
    static Json table(const Json& report, const std::string& title, const std::string& name)
    {
        const Json of = section(report, title);
        if (of.contains("tables"))
            for (const Json& one : of.at("tables"))
                if (one.at("name") == name) return one;
        return {};
    }
    /// The row of key results that begins so; null: none.
    static Json key(const Json& report, const std::string& quantity)
    {
        const Json of = table(report, "Key results", "key_results");
        for (const Json& row : of.at("rows"))
            if (row.at(0) == quantity) return row;
        return {};
    }
    bool page_has(const std::string& part) const
    {
        return contents("results/report.html").find(part) != std::string::npos;
    }
    results::ResultsReader results() const
    {
        return results::ResultsReader(folder_.path() / "results/results.h5");
    }

    std::string said_;  // by the run
};

const std::string shaken =
    "foundation: {blocks: foundation, motion: {x: {sine: {acceleration: 1.5 m/s2, frequency: 2 Hz, duration: 1 "
    "s}}}}\n"
    "stages: [{name: rest, type: static}, {name: shaking, type: dynamic, duration: 1.5 s, time_step: 5 ms, "
    "damping: {rate: "
    "2 1/s}}]\noutput: {every: 20 ms, trust: always}\n";

// A joint half as stiff as its stone, and a damping that takes a stiff one for granted.
TEST_F(FirstPage, ALimitThatIsBrokenStandsUnderTheVerdictInTheWordsOfTheConsole)
{
    std::string text = stone_case(1, shaken);
    text.replace(text.find("friction: 30 deg"), 16, "friction: 30 deg, contact_stiffness: 0.05 E/L");
    text.replace(text.find("time_step: 5 ms"), 15, "time_step: 5 ms, integrator: newmark");
    const Json report = report_of(text);
    const auto doubts = report.at("doubts").get<std::vector<std::string>>();
    ASSERT_FALSE(doubts.empty()) << said_;
    EXPECT_EQ(doubts, summary().at("warnings").get<std::vector<std::string>>()) << "the case has none of its own";
    const std::string page = contents("results/report.html"), head = page.substr(0, page.find("<h1>"));
    for (const std::string& doubt : doubts) {
        EXPECT_NE(said_.find("warning: " + doubt), std::string::npos) << doubt << "\n" << said_;
        EXPECT_NE(head.find("<li>" + doubt + "</li>"), std::string::npos) << "above the title: " << doubt;
        EXPECT_NE(contents("results/report.md").find("Before you use these figures:"), std::string::npos);
    }
    EXPECT_TRUE(page_has("<body class=\"doubt\">")) << "no green where a limit is broken";
}

TEST_F(FirstPage, ARunWithinItsLimitsHasNothingThere)
{
    const Json report = report_of(stone_case(1, shaken), "--set 'stages[1].time_step=1 ms'");
    EXPECT_TRUE(report.at("doubts").empty()) << report.at("doubts");
    EXPECT_TRUE(page_has("<body>\n"));
    EXPECT_FALSE(page_has("class=\"doubts\""));
    EXPECT_TRUE(section(report, "Ties, clamps and dowels").is_null()) << "no bars, no chapter";
    EXPECT_TRUE(key(report, "bar that came closest to yielding").is_null());
    EXPECT_TRUE(key(report, "tilt at the onset of motion").is_null());
}

TEST_F(FirstPage, BesideEachFigureStandsHowSureItIs)
{
    Json report = report_of(stone_case(1, shaken), "--set 'stages[1].time_step=1 ms'");
    const Json unknown = table(report, "Key results", "key_results");
    for (const Json& row : unknown.at("rows")) EXPECT_EQ(row.at(3), "not known") << row;
    report = report_of(stone_case(1, shaken),
                       "--set 'stages[1].time_step=1 ms' --set output.error_estimate=true "
                       "--set 'joints.dry.friction=5 deg'");
    const Json slip = key(report, "largest slip of a joint");
    const Json estimate = summary().at("error_estimate");
    for (const Json& quantity : estimate.at("quantities")) {
        if (quantity.at("name") != "largest slip of a joint") continue;
        const double half = 1e3 * quantity.at("half_step").at("difference").get<double>();
        const std::string told = slip.at(3);
        EXPECT_EQ(told.rfind("± ", 0), 0U) << told;
        const double scale = told.find("µm") < told.find("with") ? 1e-3 : 1;
        EXPECT_NEAR(scale * std::stod(told.substr(std::string("± ").size())), half, 6e-3 * half) << told;
        EXPECT_NE(told.find("with half the time step"), std::string::npos) << told;
        EXPECT_NE(told.find("with twice the contact stiffness"), std::string::npos) << told;
    }
    EXPECT_EQ(key(report, "largest thrust in a joint").at(3), "not known");
}

// What the ground carries sideways, summed from the stored contacts, over the weight of the stone of 2 t.
TEST_F(FirstPage, TheBaseShearIsThatOfTheStoredContacts)
{
    const Json report = report_of(stone_case(1, shaken), "--set 'stages[1].time_step=1 ms'");
    const results::ResultsReader run = results();
    double most = 0, when = 0;
    for (std::size_t i = 0; i < run.times.size(); ++i) {
        double sideways = 0;
        for (const JointResultant& contact : run.frame(i).contacts) sideways += contact.force.x();
        if (std::abs(sideways) > most) most = std::abs(sideways), when = run.times[i];
    }
    const std::string told = key(report, "largest base shear").at(1);
    EXPECT_NEAR(std::stod(told), most / (2000 * 9.80665), 1e-3) << told;
    EXPECT_NEAR(std::stod(told.substr(told.find("t = ") + 4)), when, 6e-3) << told;
    EXPECT_NE(told.find(" of the weight, "), std::string::npos) << told;
}

// A stone slides when the table is steeper than its friction, and turns over before where it is slender.
TEST_F(FirstPage, ATableThatTiltsNamesTheAngleAtWhichTheStoneMoves)
{
    const std::string tilting =
        "foundation: {blocks: foundation}\nstages: [{name: rest, type: static}, {name: tilting, type: dynamic, "
        "duration: 9 s, time_step: 2 ms, gravity: {ramp: 9 s, tilt: 45 deg, towards: [1, 0, 0]}}]\n"
        "output: {every: 50 ms, trust: never}\n";
    for (const auto& [height, angle] : {std::pair{1.0, 30.0}, std::pair{3.0, std::atan(1 / 3.0) * 57.29578}}) {
        const Json report = report_of(stone_case(height, tilting));
        const Json row = key(report, "tilt at the onset of motion");
        ASSERT_FALSE(row.is_null());
        const std::string told = row.at(1);
        const double from = std::stod(told), to = std::stod(told.substr(told.find(" to ") + 4));
        EXPECT_GT(to, angle) << told;
        EXPECT_LT(from, angle + 1) << told << ": some 0.15 s later 0.1 mm have been gone";
        EXPECT_NEAR(to - from, 0.25, 0.06) << "5 deg/s, every 50 ms: " << told;
        EXPECT_EQ(row.at(2), "ground and stone");
    }
    const Json report = report_of(stone_case(1, tilting), "--set 'stages[1].gravity.tilt=20 deg'");
    EXPECT_EQ(key(report, "tilt at the onset of motion").at(1),
              "none up to 20°: no joint opened or slid by 0.1 mm");
}

// A stone that has slid by half a millimetre on its soft bed before the table turns: that is no onset, and it puts
// none off.
TEST_F(FirstPage, TheOnsetCountsFromWhereTheTableBeginsToTurn)
{
    const Json report = report_of(
        stone_case(1,
                   "foundation: {blocks: foundation}\nstages: [{name: rest, type: static, gravity: {tilt: 5 deg, "
                   "towards: [1, 0, 0]}}, {name: tilting, type: dynamic, duration: 9 s, time_step: 2 ms, gravity: "
                   "{ramp: 9 s, from: 5 deg, tilt: 20 deg, towards: [1, 0, 0]}}]\noutput: {every: 50 ms, trust: "
                   "never}\n"),
        "--set 'joints.dry.contact_stiffness=10 MPa/m'");
    const double settled = results().model.rest.joints.at(0).motion.largest_slip;
    EXPECT_GT(settled, 2e-4);
    const std::string told = key(report, "tilt at the onset of motion").at(1);
    const double more = 5 * 1e-4 / settled;  // deg, by which the bed yields by another 0.1 mm
    EXPECT_NEAR(std::stod(told), 5 + more, 0.5) << told;
}

TEST_F(FirstPage, MotionsContactsAndStepsAreToldAsTheyWereRun)
{
    const Json report = report_of(stone_case(1, shaken),
                                  "--set 'stages[1].time_step=1 ms' --set "
                                  "'joints.dry.contact_stiffness=3 GPa/m'");
    EXPECT_EQ(section(report, "Ground motion").at("points").at(0),
              summary().at("motions").at(0).at("description"));
    const Json motion = table(report, "Ground motion", "motions").at("rows").at(0);
    EXPECT_EQ(motion.at(0), "shaking");
    EXPECT_EQ(motion.at(1), "x");
    EXPECT_NEAR(std::stod(motion.at(3).get<std::string>()), 1.5, 1e-3);
    EXPECT_NEAR(std::stod(motion.at(6).get<std::string>()), std::numbers::pi / (2 * 9.80665) * 1.5 * 1.5 / 2, 0.01)
        << "Arias: pi / 2g, mean square, 1 s";
    const Json joint = table(report, "What was analysed", "joint_materials").at("rows").at(0);
    EXPECT_EQ(joint.at(4), "3e+09 Pa/m");
    EXPECT_EQ(joint.at(5), "linear") << "the default of a measured stiffness";
    const Json stages = table(report, "What was analysed", "stages").at("rows");
    EXPECT_EQ(stages.at(0).at(3), "to rest");
    EXPECT_EQ(stages.at(1).at(3), "1");
    EXPECT_EQ(stages.at(1).at(4), "energy_decaying, dissipation 0.01");
    EXPECT_EQ(stages.at(1).at(5), "2 1/s");
}

}  // namespace
}  // namespace voussoir::app::report
