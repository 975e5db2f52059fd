// `voussoir ensemble` as its user meets it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/program_start.h"
#include "tests/app/studies/ensemble/scenes.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

namespace fs = std::filesystem;

class EnsembleCommand : public ::testing::Test
{
 protected:
    Ended ensemble(std::vector<std::string> arguments, const std::string& vary = testing::vary_friction)
    {
        arguments.insert(arguments.begin(), {"ensemble", case_, "--vary", vary});
        return voussoir(folder_, arguments);
    }
    void expect_refusal(const std::vector<std::string>& arguments, const std::string& part,
                        const std::string& vary = testing::vary_friction)
    {
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {"-o", folder_ / "made", "--json", folder_ / "made.json"});
        const Ended ended = ensemble(all, vary);
        EXPECT_EQ(ended.exit_code, 2);
        EXPECT_NE(ended.errors.find(part), std::string::npos) << part << " is not in:\n" << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "made"));
        EXPECT_FALSE(fs::exists(folder_ / "made.json"));
    }

    TemporaryFolder folder_;
    std::string case_ = folder_.write("stone.yaml", testing::shaken_stone(testing::gentle_wave, "2 ms"));
};

}  // namespace

TEST_F(EnsembleCommand, WritesTableJsonPageAndPicture)
{
    const Ended ended = ensemble({"--jobs", "2", "-o", folder_ / "made", "--json", folder_ / "made.json"});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    EXPECT_NE(ended.output.find("top: peak drift [mm]"), std::string::npos) << ended.output;
    EXPECT_NE(ended.output.find("agree in every measure"), std::string::npos) << ended.output;
    const nlohmann::json json = nlohmann::json::parse(contents(folder_ / "made.json"));
    EXPECT_TRUE(json["agrees"]);
    EXPECT_EQ(json["runs"].size(), 9u);
    EXPECT_TRUE(json["engine"].contains("commit"));
    EXPECT_EQ(json["settings"][1]["time_step_s"], 1e-3);
    EXPECT_EQ(json["measures"][0]["values"].size(), 3u);
    for (const std::string loss :
         {"algorithmic", "friction", "damping"}) {  // under its former name for one release
        EXPECT_TRUE(json["runs"][0][loss + "_fraction"].is_number()) << loss;
        EXPECT_EQ(json["runs"][0][loss + "_share"], json["runs"][0][loss + "_fraction"]) << loss;
    }
    const std::string page = contents(folder_ / "made/ensemble.md");
    EXPECT_NE(page.find("stone.yaml --vary '" + testing::vary_friction + "' --jobs 2 -o made`"), std::string::npos)
        << page;
    EXPECT_NE(page.find("| top: peak drift [mm] |"), std::string::npos) << page;
    if (page.find("ensemble/drift.png") != std::string::npos) {
        EXPECT_EQ(contents(folder_ / "made/ensemble/drift.png").substr(1, 3), "PNG");
    }
}

// It counted as a structure that stands, with exit code 0.
TEST_F(EnsembleCommand, ACaseThatFindsNoEquilibriumHasNoVerdictAndExitCodeThree)
{
    const Ended ended = ensemble({"--set", "gravity.direction=[0.9, 0, -0.1]", "--stiffness-factor", "1"});
    EXPECT_EQ(ended.exit_code, 3) << ended.output;
    EXPECT_NE(ended.output.find("gave up: stage 'rest' finds no equilibrium"), std::string::npos) << ended.output;
    EXPECT_NE(ended.errors.find("of the runs failed to converge or to come to rest: no verdict is possible"),
              std::string::npos)
        << ended.errors;
}

TEST_F(EnsembleCommand, RefusesWhatItCannotUseBeforeItRuns)
{
    expect_refusal({}, "names no key", "nothing");
    expect_refusal({}, "much", "joints.soft.friction=30 deg,much");
    expect_refusal({"--open", "0"}, "--open");
    expect_refusal({"--open", "1s"}, "--open");
    expect_refusal({"--set", "output.histories=null"}, "output.histories");
    const std::string file = folder_.write("file", "");
    EXPECT_EQ(ensemble({"-o", file + "/made"}).exit_code, 2);
    case_ = folder_ / "none.yaml";
    expect_refusal({}, "none.yaml");
}

}  // namespace voussoir::app::studies::ensemble
