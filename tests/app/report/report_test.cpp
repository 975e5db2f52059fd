// Reports of runs of the built program: what they say first, the mechanism in words, what is in the page.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <thread>

#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

/// Stones 1 m thick in a plane, on a ground that is held.
std::string planar_case(const std::string& title, const std::string& stones, const std::string& rest)
{
    return "title: " + title +
           "\nkinematics: planar_rigid\nthickness: 1 m\nmaterials: {stone: {density: 2400 kg/m3, young: 5 GPa, "
           "poisson: 0.2}}\njoints: {dry: {friction: 40 deg}}\nblocks:\n"
           "  - box: {name: ground, lower: [-4, 0, -1], upper: [4, 1, 0]}\n    group: foundation\n" +
           stones + "foundation: {blocks: foundation}\n" + rest + "output: {every: 20 ms, trust: never}\n";
}

const std::string drums =
    "  - box: {name: drum_1, lower: [-0.5, 0, 0], upper: [0.5, 1, 1]}\n"
    "  - box: {name: drum_2, lower: [-0.5, 0, 1], upper: [0.5, 1, 2]}\n"
    "  - box: {name: cap, lower: [-0.2, 0, 2], upper: [0.2, 1, 2.6]}\n"
    "  - box: {name: finial, lower: [-0.15, 0, 2.6], upper: [0.15, 1, 3]}\n";

class Report : public CommandTest
{
 protected:
    /// Runs a case and reports it. @param rest of the command line of `run`
    Json report_of(const std::string& case_text, const std::string& rest = "")
    {
        folder_.write("case.yaml", case_text);
        return report_of_case("case.yaml", rest);
    }
    Json report_of_case(const std::string& file, const std::string& rest)
    {
        voussoir("run " + file + " -o results -q " + rest);
        return report_of_results();
    }
    Json report_of_results()
    {
        EXPECT_EQ(voussoir("report results --no-film -q"), 0) << output_;
        return Json::parse(contents("results/report.json"));
    }
    /// The arch of seven stones at rest under a gravity of its own.
    Json arch(const std::string& settings)
    {
        return report_of_case(
            VOUSSOIR_CASES "/arch_planar.yaml",
            "--set foundation.motion=null --set output.snapshots=null --set stages[1]=null " + settings);
    }
    static std::vector<std::string> points(const Json& report, const std::string& section)
    {
        for (const Json& one : report.at("sections"))
            if (one.at("title") == section) return one.at("points").get<std::vector<std::string>>();
        return {};
    }
    static bool any(const std::vector<std::string>& lines, const std::string& part)
    {
        return std::any_of(lines.begin(), lines.end(),
                           [&](const std::string& line) { return line.find(part) != std::string::npos; });
    }
    static bool begins(const Json& report, const std::string& words)
    {
        return report.at("first_line").get<std::string>().rfind(words, 0) == 0;
    }
};

// Limit analysis has the hinges in turn at the inner and the outer face: [Oppenheim1992].
TEST_F(Report, FourHingesOfAnArchPushedSideways)
{
    const Json report = arch("--set 'gravity.direction=[0.38, -1]'");
    EXPECT_TRUE(begins(report, "COLLAPSED"));
    EXPECT_EQ(report.at("mechanism"), "hinges");
    EXPECT_NE(report.at("mechanism_line").get<std::string>().find("four hinges: three bodies"), std::string::npos);
    const std::vector<std::string> lines = points(report, "How it moved");
    EXPECT_TRUE(any(lines, "Hinge between springer_left and voussoir_1: turns about its edge towards +x"));
    EXPECT_TRUE(any(lines, "Hinge between voussoir_3 and voussoir_4: turns about its upper edge"));
    EXPECT_TRUE(any(lines, "Hinge between voussoir_5 and voussoir_6: turns about its lower edge"));
    EXPECT_TRUE(any(lines, "Hinge between voussoir_7 and springer_right: turns about its edge towards +x"));
    EXPECT_FALSE(any(lines, "slide on each other"));
}

TEST_F(Report, AnArchPushedTheOtherWayIsItsMirrorImage)
{
    const Json report = arch("--set 'gravity.direction=[-0.38, -1]'");
    EXPECT_EQ(report.at("mechanism"), "hinges");
    const std::vector<std::string> lines = points(report, "How it moved");
    EXPECT_TRUE(any(lines, "Hinge between voussoir_7 and springer_right: turns about its edge towards -x"));
    EXPECT_TRUE(any(lines, "Hinge between voussoir_4 and voussoir_5: turns about its upper edge"));
    EXPECT_TRUE(any(lines, "Hinge between voussoir_2 and voussoir_3: turns about its lower edge"));
    EXPECT_TRUE(any(lines, "Hinge between springer_left and voussoir_1: turns about its edge towards -x"));
}

TEST_F(Report, AnArchOfLowFrictionSlides)
{
    const Json report = arch("--set 'joints.dry.friction=5 deg'");
    EXPECT_TRUE(begins(report, "COLLAPSED"));
    EXPECT_EQ(report.at("mechanism"), "slides");
    const std::vector<std::string> lines = points(report, "How it moved");
    EXPECT_TRUE(any(lines, "springer_left and voussoir_1 slide on each other"));
    EXPECT_TRUE(any(lines, "voussoir_7 and springer_right slide on each other"));
}

TEST_F(Report, AnArchThatStands)
{
    const Json report = arch("--set 'gravity.direction=[0.37, -1]'");
    EXPECT_TRUE(begins(report, "The structure stands"));
    EXPECT_EQ(report.at("mechanism"), "stands");
    EXPECT_EQ(report.at("mechanism_line").get<std::string>().rfind("The structure stands", 0), 0U);
}

// The console said 1,816 joints opened, by steps, the report 1,745, by frames.
TEST_F(Report, CountsTheJointsThatTheRunCounted)
{
    const Json report =
        report_of_case(VOUSSOIR_CASES "/arch_planar.yaml", "--set output.snapshots=null --set 'output.every=2 s'");
    const Json joints = Json::parse(contents("results/summary.json")).at("joints");
    const std::string line = report.at("mechanism_line");
    EXPECT_GT(joints.at("opened").get<int>(), 0) << "between the frames, which are few";
    EXPECT_NE(line.find("Of " + joints.at("count").dump() + " joints " + joints.at("opened").dump() +
                        " opened and " + joints.at("slid").dump() + " slid"),
              std::string::npos)
        << line;
}

TEST_F(Report, AWallThatOverturns)
{
    const Json report =
        report_of(planar_case("A wall", "  - box: {name: wall, lower: [0, 0, 0], upper: [0.5, 1, 3]}\n",
                              "stages: [{name: tilting, type: dynamic, duration: 6 s, time_step: 2 ms, gravity: "
                              "{ramp: 3 s, tilt: 15 deg, towards: [1, 0, 0]}}]\n"));
    EXPECT_TRUE(begins(report, "COLLAPSED: the structure has fallen"));
    EXPECT_EQ(report.at("mechanism"), "overturns");
    EXPECT_TRUE(
        any(points(report, "How it moved"), "Hinge between ground and wall: turns about its edge towards +x"));
    EXPECT_NE(report.at("mechanism_line").get<std::string>().find("turned by up to 90°"), std::string::npos);
}

TEST_F(Report, ATowerThatShedsItsTop)
{
    const Json report = report_of(planar_case(
        "A tower", drums,
        "initial_state: [{blocks: cap, velocity: [4.5 m/s, 0, 0]}, {blocks: finial, velocity: [4.5 m/s, 0, 0]}]\n"
        "stages: [{name: push, type: dynamic, duration: 1.5 s, time_step: 2 ms}]\n"));
    EXPECT_TRUE(begins(report, "COLLAPSED"));
    EXPECT_EQ(report.at("mechanism"), "sheds");
    EXPECT_NE(report.at("mechanism_line").get<std::string>().find("two stones come off (cap and finial)"),
              std::string::npos)
        << report.at("mechanism_line");
    const Json& results = report.at("sections").at(0);
    EXPECT_EQ(results.at("tables").at(1).at("name"), "fallen");
    EXPECT_EQ(results.at("tables").at(1).at("rows").size(), 2U);
}

TEST_F(Report, ATossedStoneIsNoMechanism)
{
    const Json report =
        report_of(planar_case("A toss", "  - box: {name: tossed, lower: [0, 0, 1], upper: [0.4, 1, 1.3]}\n",
                              "initial_state: [{blocks: tossed, velocity: [1 m/s, 0, 0]}]\n"
                              "stages: [{name: flight, type: dynamic, duration: 0.2 s, time_step: 2 ms}]\n"));
    EXPECT_EQ(report.at("mechanism"), "loose");
    EXPECT_NE(report.at("mechanism_line").get<std::string>().find("moved off: one stone (tossed)"),
              std::string::npos);
}

TEST_F(Report, ARunThatGaveUpSaysSoFirst)
{
    const Json report =
        report_of(planar_case("A tower", drums, "stages: [{name: rest, type: static, max_static_steps: 2}]\n"));
    EXPECT_TRUE(begins(report, "FAILED")) << report.at("first_line");
    EXPECT_EQ(
        report.at("mechanism_line").get<std::string>().rfind("Nothing has come off as far as the run went", 0), 0U)
        << "nobody knows whether it stands: " << report.at("mechanism_line");
    EXPECT_NE(contents("results/report.html").find("<body class=\"alarm\">"), std::string::npos);
}

/// What stands in the body of a page before its heading.
std::string first_words(const std::string& page)
{
    const std::size_t body = page.find("<body"), heading = page.find("<h1>");
    return page.substr(body, heading - body);
}

TEST_F(Report, AKilledRunSaysSoFirst)
{
    folder_.write("case.yaml",
                  planar_case("A tower", drums,
                              "stages: [{name: long, type: dynamic, duration: 2000 s, time_step: 1 ms, "
                              "motion: {x: {sine: {acceleration: 0.1 g, frequency: 2 Hz}}}}]\n"));
    const std::string run =
        "'" VOUSSOIR_PROGRAM "' run case.yaml -o results -q --set 'output.every=500 ms' & sleep 6; kill -9 $!";
    ASSERT_EQ(std::system(("cd '" + folder_.path().string() + "' && " + run).c_str()), 0);
    const Json report = report_of_results();
    EXPECT_EQ(report.at("outcome"), "unfinished");
    EXPECT_TRUE(begins(report, "UNFINISHED: the run was killed"));
    EXPECT_NE(first_words(contents("results/report.html")).find("UNFINISHED"), std::string::npos);
    EXPECT_EQ(contents("results/report.md").rfind("**UNFINISHED", 0), 0U);
}

TEST_F(Report, NamesThatAreMarkupStayText)
{
    std::string text =
        planar_case("'<script>alert(1)</script>'",
                    "  - box: {name: '<img src=x onerror=alert(2)>', lower: [0, 0, 0], upper: [1, 1, 1]}\n",
                    "stages: [{name: '</pre><b>', type: dynamic, duration: 0.1 s, time_step: 2 ms}]\n");
    const Json report = report_of(text);
    EXPECT_EQ(report.at("title"), "<script>alert(1)</script>");
    const std::string page = contents("results/report.html");
    for (const char* markup : {"<script>alert", "<img src=x", "</pre><b>"})
        EXPECT_EQ(page.find(markup), std::string::npos) << markup;
    EXPECT_NE(page.find("<h1>&lt;script&gt;alert(1)&lt;/script&gt;</h1>"), std::string::npos);
    EXPECT_NE(page.find("&lt;img src=x onerror=alert(2)&gt;"), std::string::npos);
    EXPECT_EQ(contents("results/report.md").find("\n# <script"), std::string::npos);
}

/// Every address that a page would fetch.
std::vector<std::string> addresses(const std::string& page)
{
    std::vector<std::string> found;
    const std::regex source(R"((src|href|url)\s*[=(]\s*"?([^"\s>]{1,40}))");
    const std::string text =
        page.substr(0, page.find("<script"));  // what a script asks for the page's policy forbids
    for (std::sregex_iterator i(text.begin(), text.end(), source), end; i != end; ++i) found.push_back((*i)[2]);
    return found;
}

TEST_F(Report, ThePageHasAllInsideAndAsksNothingOfANetwork)
{
    folder_.write("case.yaml", with(two_boxes, "output: {", "output: {report: true, "));
    ASSERT_EQ(voussoir("run case.yaml -o results"), 0) << output_;
    EXPECT_NE(output_.find("results/report.html"), std::string::npos) << output_;
    const std::string page = contents("results/report.html");
    int pictures = 0, films = 0;
    for (const std::string& address : addresses(page)) {
        pictures += address.rfind("data:image/png;base64,iVBOR", 0) == 0;
        films += address.rfind("data:video/mp4;base64,", 0) == 0;
        EXPECT_TRUE(address.rfind("data:", 0) == 0 || address[0] == '#') << address;
    }
    EXPECT_GE(pictures, 5) << "of the structure, its stresses, histories, energies, steps";
    EXPECT_EQ(films, 1);
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    EXPECT_NE(page.find("histories.png"), 0U);
    EXPECT_LT(page.size(), std::size_t{15} << 20);
    for (const char* part :
         {"class=\"outcome\">", "Energy balance", "density [kg/m3]", "title: Two boxes", "Command: voussoir run"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST_F(Report, ARunThatAsksForNothingLoadsNothingOfIt)
{
    // What the loader tells of every program that is started and of every library.
    const auto loaded = [&](const std::string& output) {
        folder_.write("case.yaml", with(two_boxes, "output: {", "output: {" + output));
        std::filesystem::create_directory(folder_.path() / "loader");  // a file for each process
        EXPECT_EQ(voussoir("run case.yaml -o results -q", "env LD_DEBUG=files LD_DEBUG_OUTPUT=loader/of"), 0);
        std::string told;
        for (const auto& file : std::filesystem::directory_iterator(folder_.path() / "loader"))
            told += contents(file.path());
        std::filesystem::remove_all(folder_.path() / "loader");
        EXPECT_NE(told.find("libhdf5"), std::string::npos);
        std::vector<std::string> found;
        for (const char* name :
             {"OSMesa", "cairo", "voussoir-render", "voussoir-report", "voussoir-plot", "ffmpeg"})
            if (told.find(name) != std::string::npos) found.emplace_back(name);
        return found;
    };
    EXPECT_EQ(loaded(""), std::vector<std::string>{});
    EXPECT_EQ(loaded("report: true, ").size(), 6U) << "and with a report the loader tells of all six";
}

TEST_F(Report, TablesHaveTheFiguresOfTheRun)
{
    report_of(two_boxes);
    const Json summary = Json::parse(contents("results/summary.json"));
    std::istringstream lines(contents("results/report/energy.csv"));
    std::map<std::string, double> energy;
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t after = line.find(',', line.find(',') + 1); line.rfind("part,", 0) != 0)
            energy[line.substr(0, after)] = std::stod(line.substr(after + 1));
    for (const auto& [key, term] :
         std::map<std::string, std::string>{{"contact_J", "at the end,springs of joints"},
                                            {"strain_J", "at the end,strain of stones"},
                                            {"gravity_work_J", "put in,gravity"}})
        EXPECT_NEAR(1e3 * energy.at(term), summary.at("energy").at(key).get<double>(),
                    1e-3 * std::abs(1e3 * energy.at(term)))
            << term << " [kJ]";
    // the ground carries the stone of 2.4 t
    const std::string reactions = contents("results/report/reactions.csv");
    EXPECT_NEAR(std::stod(reactions.substr(reactions.rfind(',') + 1)), 2.4 * 9.80665, 0.02) << reactions;
}

// A stone of 1 x 1 x 1 m on the floor, a plate that reaches over its edge, and one that hangs in the air.
TEST_F(Report, TheGeometryIsCertified)
{
    report_of(with(two_boxes, "foundation: {blocks",
                   "  - {box: {name: plate, lower: [-0.5, -0.5, 1], upper: [4.5, 0.5, 1.25]}}\n"
                   "  - {box: {name: bird, lower: [0, 0, 5], upper: [0.1, 0.1, 5.1]}}\nfoundation: {blocks"),
              "--set stages[0]=null --set output.trust=never");
    const auto has = [&](const std::string& row, const std::string& words) {
        std::istringstream lines(contents("results/report/geometry.csv"));
        for (std::string line; std::getline(lines, line);)
            if (line.find(row) != std::string::npos) return line.find(words) != std::string::npos;
        return false;
    };
    EXPECT_TRUE(has("extent", "5 x 1 x 5.1"));
    EXPECT_TRUE(has("smallest stone", "0.001,bird"));
    EXPECT_TRUE(has("largest stone", "1.25,plate"));
    EXPECT_TRUE(has("not closed", ",0,"));
    EXPECT_TRUE(has("encloses", ",0,"));
    EXPECT_TRUE(has("contact area", ",2,2")) << "of 1 m2 each";
    EXPECT_TRUE(has("without a joint", ",1,bird"));
    EXPECT_TRUE(has("no chain", ",1,bird"));
    EXPECT_TRUE(has("a quarter", ",0,"));
}

TEST_F(Report, BadInputIsOneSentence)
{
    EXPECT_EQ(voussoir("report nowhere"), 2);
    EXPECT_NE(output_.find("no such file"), std::string::npos) << output_;
    folder_.write("results.h5", "not a results file");
    EXPECT_EQ(voussoir("report ."), 2);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "report.html"));
}

}  // namespace
}  // namespace voussoir::app::report
