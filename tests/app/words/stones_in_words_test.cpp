// Many stones by part and course; no list that grows with the structure.
#include "app/words/stones_in_words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

namespace voussoir::testing
{
namespace
{

using app::words::part_of;
using app::words::stones_in_words;

TEST(PartOf, IsWhatStandsBeforeTheCourseOrTheNumber)
{
    for (const auto& [name, part] :
         {std::pair{"house_south_c03_b02", "house_south"}, std::pair{"pier_1_c01_b02", "pier_1"},
          std::pair{"wall_c01_l1_b04", "wall"}, std::pair{"arch_1_voussoir_07_b01", "arch_1_voussoir"},
          std::pair{"voussoir_52", "voussoir"}, std::pair{"Object.001", "Object"}, std::pair{"stone17", "stone"},
          std::pair{"keystone", "keystone"}, std::pair{"tower_cap", "tower_cap"}, std::pair{"_c1", "_c"},
          std::pair{"42", "42"}, std::pair{"", ""}})
        EXPECT_EQ(part_of(name), part) << name;
}

/// A wall of 6 courses of 10 stones, a ring of 15, and a cap.
std::vector<std::string> structure()
{
    std::vector<std::string> names;
    for (int course = 1; course <= 6; ++course)
        for (int stone = 1; stone <= 10; ++stone)
            names.push_back(fmt::format("wall_c{:02}_b{:02}", course, stone));
    for (int stone = 1; stone <= 15; ++stone) names.push_back(fmt::format("voussoir_{:02}", stone));
    names.emplace_back("cap");
    return names;
}

std::vector<int> from_to(int first, int last)
{
    std::vector<int> blocks(static_cast<std::size_t>(last - first + 1));
    std::iota(blocks.begin(), blocks.end(), first);
    return blocks;
}

TEST(StonesInWords, NamesFewOfThem)
{
    EXPECT_EQ(stones_in_words({75}, structure()), "cap");
    EXPECT_EQ(stones_in_words({0, 60, 75}, structure()), "wall_c01_b01, voussoir_01 and cap");
    EXPECT_EQ(stones_in_words({60, 75}, structure(), 5, "'"), "'voussoir_01' and 'cap'");
    EXPECT_EQ(stones_in_words({}, structure()), "");
}

TEST(StonesInWords, TellsManyByPartAndCourse)
{
    EXPECT_EQ(stones_in_words(from_to(35, 75), structure()),
              "cap, 25 of 60 stones of wall in courses 4 to 6 and all 15 stones of voussoir");
    EXPECT_EQ(stones_in_words(from_to(61, 69), structure()), "9 of 15 stones of voussoir numbered 02 to 10");
    EXPECT_EQ(stones_in_words(from_to(50, 59), structure(), 5, "'"), "10 of 60 stones of 'wall' in course 6");
    EXPECT_EQ(stones_in_words(from_to(0, 59), structure()), "all 60 stones of wall");
}

TEST(StonesInWords, CountsNumbersOfAnyWidth)
{
    std::vector<std::string> names;
    for (int stone = 1; stone <= 30; ++stone) names.push_back(fmt::format("drum{}", stone));
    EXPECT_EQ(stones_in_words(from_to(6, 12), names), "7 of 30 stones of drum numbered 7 to 13");
}

TEST(StonesInWords, DoesNotGrowWithTheNumberOfParts)
{
    std::vector<std::string> names;
    for (int part = 0; part < 100; ++part)
        for (int stone = 0; stone < 3; ++stone) names.push_back(fmt::format("pier_{}_c01_b{}", part, stone));
    EXPECT_EQ(
        stones_in_words(from_to(0, 299), names),
        "all 3 stones of pier_0, all 3 stones of pier_1, all 3 stones of pier_10, all 3 stones of pier_11, all 3 "
        "stones of pier_12 and 285 stones of 95 other parts");
}

}  // namespace
}  // namespace voussoir::testing
