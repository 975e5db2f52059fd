// `voussoir limit` as its user meets it, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "tests/app/program_start.h"
#include "tests/app/test_files.h"

namespace voussoir::app::studies::limit
{

namespace
{

namespace fs = std::filesystem;

class LimitCommand : public ::testing::Test
{
 protected:
    Ended limit(const std::string& towards, std::vector<std::string> more = {}, const std::string& file = {})
    {
        std::vector<std::string> arguments{"limit", file.empty() ? case_ : file, "--towards=" + towards};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return voussoir(folder_, arguments);
    }
    nlohmann::json answer(const std::string& towards, std::vector<std::string> more = {},
                          const std::string& file = {})
    {
        more.insert(more.end(), {"--json", "-"});
        const Ended ended = limit(towards, more, file);
        EXPECT_EQ(ended.exit_code, 0) << ended.errors;
        return nlohmann::json::parse(ended.output, nullptr, false);
    }
    void expect_refusal(const std::string& towards, const std::string& part, std::vector<std::string> more = {},
                        const std::string& file = {})
    {
        more.insert(more.end(), {"-o", folder_ / "made", "--json", folder_ / "made.json"});
        const Ended ended = limit(towards, more, file);
        EXPECT_EQ(ended.exit_code, 2);
        EXPECT_NE(ended.errors.find(part), std::string::npos) << part << " is not in:\n" << ended.errors;
        EXPECT_FALSE(fs::exists(folder_ / "made"));
        EXPECT_FALSE(fs::exists(folder_ / "made.json"));
    }

    TemporaryFolder folder_;
    std::string case_ = folder_.write("boxes.yaml", two_boxes);  // a cube of 1 m on a floor, 30 deg of friction
    std::string arch_ = VOUSSOIR_CASES "/arch_planar.yaml";
};

const double slope = 1 / std::sqrt(3.0);  // tan 30 deg

}  // namespace

TEST_F(LimitCommand, BlockSlidesAtItsFriction)
{
    for (const std::string towards : {"1,0,0", "-2,0,0", "3,4,0"}) {
        const nlohmann::json json = answer(towards);
        EXPECT_NEAR(json["associated_g"], slope, 1e-4) << towards;
        EXPECT_NEAR(json["tilt_deg"], 30, 0.01);
        EXPECT_EQ(json["sliding_slides_at_g"], json["associated_g"]) << "no other joint that wedges it";
        EXPECT_EQ(json["mechanism"]["joints"][0]["motion"], "slides");
        ASSERT_EQ(json["mechanism"]["stones"].size(), 1u);
        EXPECT_EQ(json["mechanism"]["stones"][0]["stone"], "stone");
    }
}

TEST_F(LimitCommand, BlockTopplesAboutItsEdge)
{
    const std::vector<std::string> rough{"--set", "joints.dry.friction=80 deg"};
    const nlohmann::json json = answer("1,0,0", rough);
    EXPECT_NEAR(json["associated_g"], 1, 1e-4) << "as wide as it is high";
    EXPECT_EQ(json["mechanism"]["joints"][0]["motion"], "opens");
    EXPECT_GT(json["mechanism"]["stones"][0]["spin_per_m"][1], 0) << "over its right edge";
    EXPECT_NEAR(answer("1,1,0", rough)["associated_g"], std::sqrt(2.0), 1e-4) << "over its corner";
}

// The body force adds to gravity however gravity leans.
TEST_F(LimitCommand, LeaningGravityIsPartOfIt)
{
    const double lean = 10 * std::numbers::pi / 180;
    const std::string direction = std::to_string(std::tan(lean)) + ", 0, -1]";
    const nlohmann::json json = answer("1,0,0", {"--set", "gravity={direction: [" + direction + "}"});
    EXPECT_NEAR(json["associated_g"], std::cos(lean) * (slope - std::tan(lean)), 1e-4);
    EXPECT_TRUE(json["tilt_deg"].is_null()) << "a table that is tilted turns what leans already";
}

// Virtual work over all sets of four hinges [Oppenheim1992], as the case says.
TEST_F(LimitCommand, ArchFallsOnFourHinges)
{
    const nlohmann::json json = answer("1,0,0", {}, arch_);
    EXPECT_NEAR(json["associated_g"], 0.3736, 1e-4);
    EXPECT_EQ(json["left_out"], nlohmann::json({"motions of the ground"}));
    std::multiset<std::string> motions;
    for (const nlohmann::json& joint : json["mechanism"]["joints"]) motions.insert(joint["motion"]);
    EXPECT_EQ(motions, (std::multiset<std::string>{"opens", "opens", "opens", "opens"}));
    EXPECT_NEAR(answer("-1,0,0", {}, arch_)["associated_g"], json["associated_g"], 1e-5) << "it is symmetric";
}

// A joint of 1 m2 that bonds: it bears its shear strength beside its friction, and no tilt asks the same.
TEST_F(LimitCommand, BondAddsToFriction)
{
    const nlohmann::json json =
        answer("1,0,0", {"--set", "joints.dry={friction: 30 deg, cohesion: 10 kPa, tensile_strength: 8 kPa}"});
    EXPECT_NEAR(json["associated_g"], slope + 10e3 / (2400 * 9.80665), 1e-4);
    EXPECT_EQ(json["bonded_points"], 4);
    EXPECT_TRUE(json["tilt_deg"].is_null());
    EXPECT_TRUE(json["sliding_stands_at_g"].is_null()) << "of brittle joints it is not known";
}

TEST_F(LimitCommand, NoLimitIsSaidAndNotInvented)
{
    const Ended pressed = limit("0,0,-1");
    EXPECT_EQ(pressed.exit_code, 3);
    EXPECT_NE(pressed.errors.find("No acceleration"), std::string::npos) << pressed.errors;
    const std::string leaning = folder_.write(
        "leaning.yaml",
        with(two_boxes, "lower: [-0.5, -0.5, 0], upper: [50 cm,", "lower: [0.7, -0.5, 0], upper: [2,"));
    const Ended falling = limit("1,0,0", {}, leaning);
    EXPECT_EQ(falling.exit_code, 3);
    EXPECT_NE(falling.errors.find("do not stand under their own weight"), std::string::npos) << falling.errors;
}

TEST_F(LimitCommand, WritesPageAndJson)
{
    const Ended ended = limit("1,0,0", {"-o", folder_ / "made", "--json", folder_ / "made.json"});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    EXPECT_NE(ended.output.find("the limit is 0.5774 g (5.662 m/s2)"), std::string::npos) << ended.output;
    const std::string page = contents(folder_ / "made/limit.md");
    EXPECT_NE(page.find("voussoir limit"), std::string::npos);
    EXPECT_NE(page.find("| stone | "), std::string::npos) << page;
    EXPECT_TRUE(nlohmann::json::parse(contents(folder_ / "made.json"))["in_words"].is_array());
}

TEST_F(LimitCommand, RefusesWhatHasNoAnswer)
{
    expect_refusal("0,0,0", "--towards");
    expect_refusal("1,0", "--towards");
    expect_refusal("0,1,0", "planar", {}, arch_);
    expect_refusal("1,0,0", "no gravity", {"--set", "gravity={magnitude: 0 m/s2}"});
}

}  // namespace voussoir::app::studies::limit
