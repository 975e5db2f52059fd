// Ties and dowels in a report: their figures are those of the results, those of results without them too.
#include "app/report/bars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/results/hdf5_file.h"
#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

constexpr double strength = 20e3;  // N, of the tie

/// A stone on rollers, nearly, held by a tie of 20 kN in tension; a dowel of steel under another one. Gravity
/// leans.
std::string tied()
{
    return R"(title: A tied stone
kinematics: spatial_rigid
materials: {stone: {density: 2000 kg/m3, young: 5 GPa, poisson: 0.2}}
joints: {dry: {friction: 5 deg}}
blocks:
  - box: {name: ground, lower: [-4, -1, -1], upper: [4, 1, 0]}
    group: foundation
  - box: {name: wall, lower: [-4, -1, 0], upper: [-3, 1, 1]}
    group: foundation
  - box: {name: stone, lower: [-0.5, -0.5, 0], upper: [0.5, 0.5, 1]}
  - box: {name: drum, lower: [2, -0.5, 0], upper: [3, 0.5, 1]}
    group: drums
bars:
  - name: tie
    from: {block: wall, at: [-3, 0, 0.1]}
    to: {block: stone, at: [-0.5, 0, 0.1]}
    diameter: 10 mm
    yield_strength: 254.6479 MPa
  - {name: dowel, between: [foundation, drums], diameter: 40 mm, length: 15 cm, yield_strength: 2000 MPa}
foundation: {blocks: foundation, motion: {x: {sine: {acceleration: -20 m/s2, frequency: 4 Hz, duration: 0.5 s}}}}
stages: [{name: rest, type: static}, {name: shaking, type: dynamic, duration: 0.7 s, time_step: 1 ms}]
output: {every: 10 ms, trust: never}
)";
}

class Bars : public CommandTest
{
 protected:
    void run(const std::string& folder, const std::string& rest = "")
    {
        folder_.write("case.yaml", tied());
        voussoir("run case.yaml -o " + folder + " -q " + rest);
        ASSERT_TRUE(std::filesystem::exists(folder_.path() / folder / "summary.json")) << output_;
    }
    Json report(const std::string& folder)
    {
        EXPECT_EQ(voussoir("report " + folder + " --no-film -q"), 0) << output_;
        return Json::parse(contents(folder + "/report.json"));
    }
    static Json section(const Json& page)
    {
        for (const Json& one : page.at("sections"))
            if (one.at("title") == bars_title) return one;
        return {};
    }
    static Json row(const Json& page, const std::string& name)
    {
        const Json of = section(page);
        for (const Json& one : of.at("tables").at(0).at("rows"))
            if (one.at(0) == name) return one;
        return {};
    }
    static double number(const Json& cell) { return std::stod(cell.get<std::string>()); }
};

TEST_F(Bars, HaveTheirLargestForceShareOfStrengthAndWhatIsLeft)
{
    run("results");
    const Json page = report("results"), tie = row(page, "tie"), dowel = row(page, "dowel ground drum");
    const Json summary = Json::parse(contents("results/summary.json")).at("bars");
    ASSERT_EQ(summary.at(0).at("name"), "tie");
    const double largest = summary.at(0).at("largest_tension_N").get<double>();
    EXPECT_NEAR(largest, strength, 0.01 * strength) << "it yields: 2 t at 2 g";
    EXPECT_NEAR(number(tie.at(3)), largest / 1e3, 1e-3 * largest / 1e3);
    EXPECT_NEAR(number(tie.at(6)), 100 * largest / strength, 0.2);
    EXPECT_EQ(tie.at(7), "tension");
    EXPECT_NEAR(number(tie.at(8)), summary.at(0).at("yielded_time_s").get<double>(), 1e-3);
    EXPECT_EQ(tie.at(11).get<std::string>().rfind("yielded at ", 0), 0U) << tie;
    // The dowel carries shear; when is that of the stored frames.
    const results::Hdf5File file = results::Hdf5File::open(folder_.path() / "results/results.h5");
    const auto frames = file.read<double>("/frames/bars"), times = file.read<double>("/frames/time");
    const std::size_t columns = file.texts_attribute("/frames/bars", "columns").size();
    std::size_t at = 0;
    double most = 0, longest = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (const double shear = frames[(2 * i + 1) * columns + 1]; shear > most) most = shear, at = i;
        longest = std::max(longest, frames[2 * i * columns + 2]);
    }
    EXPECT_NEAR(number(dowel.at(5)), summary.at(1).at("largest_shear_N").get<double>() / 1e3, 0.01);
    EXPECT_LE(most, summary.at(1).at("largest_shear_N").get<double>() * (1 + 1e-9));
    EXPECT_EQ(dowel.at(7), "shear");
    EXPECT_NEAR(number(dowel.at(8)), times[at], 1e-3);
    EXPECT_NEAR(number(tie.at(9)), 1e3 * longest, 0.01 * 1e3 * longest);
    EXPECT_NEAR(number(tie.at(10)), 1e3 * summary.at(0).at("elongation_m").get<double>(), 0.01 * 1e3 * longest);
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "results/report/bars.png"));
    bool first_page = false;
    for (const Json& one : page.at("sections").at(0).at("tables").at(0).at("rows"))
        first_page = first_page || (one.at(0) == "bar that came closest to yielding" && one.at(2) == "tie");
    EXPECT_TRUE(first_page);
}

TEST_F(Bars, StandSideBySideInAComparison)
{
    run("weak");
    run("strong", "--set 'bars[0].yield_strength=2000 MPa'");
    ASSERT_EQ(voussoir("compare weak strong --no-film -q"), 0) << output_;
    const Json tie = row(Json::parse(contents("comparison/comparison.json")), "tie");
    for (const auto& [folder, column] : {std::pair{"weak", 1}, std::pair{"strong", 2}}) {
        const Json bars = Json::parse(contents(std::string(folder) + "/summary.json")).at("bars");
        const double tension = bars.at(0).at("largest_tension_N").get<double>() / 1e3;
        EXPECT_NEAR(number(tie.at(static_cast<std::size_t>(column))), tension, 1e-3 * tension) << folder;
    }
    EXPECT_LT(number(tie.at(6)), 60) << "the strong one has ten times the strength";
    EXPECT_EQ(tie.at(10).get<std::string>().rfind("elastic", 0), 0U) << tie;
}

// Files of before have no bars in their frames, and a killed run has no summary.
TEST_F(Bars, OfOldResultsOrOfAKilledRunTellWhatIsKnown)
{
    run("results");
    const results::Hdf5File file = results::Hdf5File::open(folder_.path() / "results/results.h5");
    const auto times = file.read<double>("/frames/time");
    const std::vector<BarCourse> killed = bars_of(file, times, "{}");
    const std::string summary = contents("results/summary.json");
    const std::vector<BarCourse> whole = bars_of(file, times, summary);
    ASSERT_EQ(killed.size(), 2U);
    EXPECT_FALSE(killed[0].yielded_since.has_value());
    EXPECT_GT(killed[0].yielded, 0);
    EXPECT_NEAR(killed[0].use().value(), 1, 0.02);
    EXPECT_LE(killed[1].force[2].value, whole[1].force[2].value);
    EXPECT_EQ(killed[0].tension.size(), times.size());

    BarCourse elastic;
    elastic.strength[0] = elastic.strength[2] = std::numeric_limits<double>::infinity();
    elastic.force[2].value = 5;
    EXPECT_EQ(elastic.governing(), BarForce::shear);
    EXPECT_FALSE(elastic.use().has_value());
}

}  // namespace
}  // namespace voussoir::app::report
