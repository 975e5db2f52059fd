// `voussoir stability` as its user meets it.
#include <nlohmann/json.hpp>

#include "tests/app/command_test.h"

namespace voussoir::app::studies::stability
{
namespace
{

namespace fs = std::filesystem;

class StabilityCommand : public CommandTest
{
 protected:
    int stability(const std::string& arguments) { return voussoir("stability " + arguments); }
};

/// Seconds, all of them together; of each kind of scene that is quick.
const std::string quick =
    "sliding/k=1e+06/h=0.005 sliding/k=1e+10/h=0.01 rocking/k=1e+08/h=0.005 rocking/k=1e+11/h=0.005 "
    "modulus/E=1e+09/h=0.01 column/E=1e+07 column/E=1e+11 density/above=1e+02/h=0.001 shape/pillar=10/h=0.001 "
    "shape/slab=100/h=0.01 friction/phi=80-dip=60/h=0.01 gravity/stack=10/h=0.01 ";

TEST_F(StabilityCommand, ListsWithoutRunning)
{
    EXPECT_EQ(stability("--list"), 0);
    EXPECT_NE(output_.find("sliding/k=1e+08/h=0.001"), std::string::npos);
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(StabilityCommand, NamesTheNearestCell)
{
    EXPECT_EQ(stability("slidng"), 2);
    EXPECT_NE(output_.find("did you mean sliding?"), std::string::npos) << output_;
}

TEST_F(StabilityCommand, QuickCellsPassAndTellAllFigures)
{
    EXPECT_EQ(stability(quick + "--json out.json"), 0) << output_;
    const nlohmann::json cells = nlohmann::json::parse(contents("out.json")).at("cells");
    ASSERT_EQ(cells.size(), 12u);
    for (const nlohmann::json& cell : cells) {
        EXPECT_EQ(cell.at("outcome"), "passed") << cell.dump();
        EXPECT_TRUE(cell.at("scene").is_string());
        EXPECT_FALSE(cell.at("parameters").empty());
        for (const auto& [name, value] : cell.at("parameters").items()) EXPECT_TRUE(value.is_string()) << name;
        EXPECT_TRUE(cell.at("time_step_s").is_number());
        EXPECT_FALSE(cell.at("reference").get<std::string>().empty());
        EXPECT_LE(cell.at("error").get<double>(), cell.at("tolerance").get<double>());
        EXPECT_EQ(cell.at("diagnosis"), "");
        EXPECT_GT(cell.at("steps").get<int>(), 0);
        EXPECT_GE(cell.at("step_cuts").get<int>(), 0);
        EXPECT_GT(cell.at("iterations").get<int>(), 0);
        EXPECT_GE(cell.at("cpu_time_s").get<double>(), 0);
    }
    EXPECT_EQ(cells[0].at("parameters").at("contact stiffness"), "1e+06 N/m");
    fs::remove(folder_ / "out.json");
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(StabilityCommand, AToleranceThatCannotBeMetMakesACellWrong)
{
    EXPECT_EQ(stability("sliding/k=1e+06/h=0.005 --tolerance-factor 1e-9 --json out.json"), 1);
    const nlohmann::json cell = nlohmann::json::parse(contents("out.json")).at("cells").at(0);
    EXPECT_EQ(cell.at("outcome"), "wrong");
    EXPECT_GT(cell.at("error").get<double>(), cell.at("tolerance").get<double>());
    EXPECT_NE(cell.at("diagnosis"), "");
}

TEST_F(StabilityCommand, WritesPageFiguresAndMaps)
{
    EXPECT_EQ(stability("sliding/k=1e+06/h=0.005 column/E=1e+11 -o map"), 0) << output_;
    const std::string page = contents("map/stability.md");
    EXPECT_NE(page.find("`voussoir stability sliding/k=1e+06/h=0.005 column/E=1e+11 -o map`"), std::string::npos);
    EXPECT_NE(page.find("\n## sliding\n"), std::string::npos);
    const nlohmann::json figures = nlohmann::json::parse(contents("map/stability/stability.json"));
    EXPECT_EQ(figures.at("cells").size(), 2u);
    const nlohmann::json& engine = figures.at("engine");
    for (const char* key : {"version", "commit", "dirty", "sources", "instruction_set"})
        EXPECT_TRUE(engine.contains(key)) << key;
    const std::string behaviour = engine.at("behaviour");
    EXPECT_EQ(behaviour.size(), 12u);
    EXPECT_NE(page.find("; behaviour " + behaviour + ". "), std::string::npos);
    if (!fs::exists(fs::path(VOUSSOIR_PROGRAM).parent_path() / "voussoir-plot"))
        GTEST_SKIP() << "built without Cairo";
    EXPECT_GT(fs::file_size(folder_ / "map/stability/sliding.png"), 5000u);
    EXPECT_GT(fs::file_size(folder_ / "map/stability/extremes.png"), 5000u);
}

TEST_F(StabilityCommand, APageOfTablesSaysHowItsMapsAreMade)
{
    EXPECT_EQ(stability("sliding/k=1e+06/h=0.005 column/E=1e+11 --tables -o map"), 0) << output_;
    const std::string page = contents("map/stability.md");
    EXPECT_NE(page.find("column/E=1e+11 --tables -o map`, not edited by hand. The same without `--tables` draws"),
              std::string::npos);
    const bool has_plots = fs::exists(fs::path(VOUSSOIR_PROGRAM).parent_path() / "voussoir-plot");
    EXPECT_EQ(page.find("](stability/sliding.png)") != std::string::npos, has_plots);
    EXPECT_EQ(fs::exists(folder_ / "map/stability/sliding.png"), has_plots);
    EXPECT_EQ(page.find("extremes.png"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "map/stability/extremes.png"));
}

}  // namespace
}  // namespace voussoir::app::studies::stability
