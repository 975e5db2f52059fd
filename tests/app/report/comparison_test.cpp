// Two runs side by side: the figures are those of the runs, what differs in the cases is named, the film has both.
#include "app/report/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::report
{
namespace
{

using Json = nlohmann::json;

TEST(LinesOnlyIn, CountsEqualLinesAndKeepsTheirOrder)
{
    EXPECT_EQ(lines_only_in("a\nb\nc\nb\n", "b\nc\n"), (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(lines_only_in("b\nc\n", "a\nb\nc\nb\n"), std::vector<std::string>{});
    EXPECT_EQ(lines_only_in("x\n\n  \n", ""), std::vector<std::string>{"x"}) << "empty lines tell nothing";
}

class Comparison : public CommandTest
{
 protected:
    void SetUp() override
    {
        folder_.write("case.yaml", with(two_boxes, "stages:\n",
                                        "initial_state: [{blocks: stone, velocity: [0.5 m/s, 0, 0]}]\nstages:\n"));
        ASSERT_EQ(voussoir("run case.yaml -o rough -q --set stages[0]=null --set 'stages[0].duration=0.4 s'"), 0)
            << output_;
        ASSERT_EQ(voussoir("run case.yaml -o smooth -q --set stages[0]=null --set 'stages[0].duration=0.4 s' "
                           "--set 'joints.dry.friction=10 deg'"),
                  0)
            << output_;
    }
    static Json section(const Json& page, const std::string& title)
    {
        for (const Json& one : page.at("sections"))
            if (one.at("title") == title) return one;
        return {};
    }
    /// A row of the first table of a section, by its first cell.
    static Json row(const Json& page, const std::string& title, const std::string& first)
    {
        const Json table = section(page, title).at("tables").at(0);
        for (const Json& one : table.at("rows"))
            if (one.at(0) == first) return one;
        return {};
    }
};

TEST_F(Comparison, HasTheFiguresOfBothRuns)
{
    ASSERT_EQ(voussoir("compare rough smooth/results.h5 --no-film -q"), 0) << output_;
    const Json page = Json::parse(contents("comparison/comparison.json"));
    const Json slip = row(page, "Key figures", "joint slip [mm]");
    const double a = std::stod(slip.at(1).get<std::string>()), b = std::stod(slip.at(2).get<std::string>());
    // v^2 / (2 g tan(phi)): 22 mm and 72 mm
    EXPECT_NEAR(a, 1e3 * 0.25 / (2 * 9.80665 * std::tan(30 * 3.14159265 / 180)), 0.05 * a);
    EXPECT_NEAR(b, 1e3 * 0.25 / (2 * 9.80665 * std::tan(10 * 3.14159265 / 180)), 0.05 * b);
    EXPECT_NEAR(std::stod(slip.at(3).get<std::string>()), b - a, 0.0101);  // three roundings to a hundredth
    EXPECT_NEAR(std::stod(slip.at(4).get<std::string>()), b / a, 0.01);
    EXPECT_EQ(row(page, "Stones and joints", "stone").at(0), "stone");
    EXPECT_EQ(section(page, "What differs").at("text"), "B  --set joints.dry.friction=10 deg\n");
    EXPECT_EQ(section(page, "Stones and joints").at("paragraphs").at(0),
              "Of the stones, 2 are in both, 0 only in A, 0 only in B; of the joints 1, 0 and 0.");
    EXPECT_NE(contents("comparison/comparison.html").find("A: rough and B: smooth"), std::string::npos);
    EXPECT_NE(contents("comparison/comparison/stones.csv").find("stone,A [mm],B [mm]"), std::string::npos);
}

TEST_F(Comparison, HasAFilmOfBothAndPicturesWithOneScale)
{
    ASSERT_EQ(voussoir("compare rough smooth -o both -q"), 0) << output_;
    const Json page = Json::parse(contents("both/comparison.json"));
    EXPECT_FALSE(section(page, "Film").is_null());
    EXPECT_GT(std::filesystem::file_size(folder_.path() / "both/comparison/film.mp4"), 5000U);
    EXPECT_NE(contents("both/comparison.html").find("data:video/mp4;base64,"), std::string::npos);
    EXPECT_NE(contents("both/comparison.html").find("A on the left, B on the right"), std::string::npos);
}

TEST_F(Comparison, BadInputIsOneSentence)
{
    EXPECT_EQ(voussoir("compare rough rough/results.h5"), 2);
    EXPECT_NE(output_.find("the same run twice"), std::string::npos) << output_;
    EXPECT_EQ(voussoir("compare rough nowhere"), 2);
    EXPECT_NE(output_.find("nowhere: no such file"), std::string::npos) << output_;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "comparison"));
}

}  // namespace
}  // namespace voussoir::app::report
