// Where components point, in the spellings of the networks.

#include "records/formats/direction.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace voussoir::records
{

namespace
{

TEST(Direction, ReadsAzimuthsAndBearings)
{
    const std::vector<std::pair<std::string, double>> spellings{
        {"90 DEG", 90},
        {"360 Deg", 0},
        {" 0 deg", 0},
        {"360", 0},
        {"133", 133},
        {"N28W", 332},
        {"S62W", 242},
        {"S90E", 90},
        {"N00E", 0},
        {"n 90 e", 90},
        {"N-28-W", 332},
        {"S05E", 175},
        {"NS", 0},
        {"N-S", 0},
        {"EW", 90},
        {"E-W", 90},
        {"WE", 90},
        {"North", 0},
        {"west", 270},
        {"NE", 45},
        {"SW", 225},
        {"340 deg (Rcrdr Chan  1)", 340},
        {"N28W  Longitudinal Accelerometer Axis", 332},
        {"-30", 330},
        {"22.5 degrees", 22.5},
    };
    for (const auto& [text, azimuth] : spellings) {
        const formats::Direction direction = formats::parse_direction(text);
        ASSERT_TRUE(direction.azimuth.has_value()) << text;
        EXPECT_DOUBLE_EQ(*direction.azimuth, azimuth) << text;
        EXPECT_FALSE(direction.is_vertical || direction.points_down) << text;
    }
}

TEST(Direction, TellsUpFromDown)
{
    for (const std::string text : {"UP", "Up    Vertical Accelerometer Axis", "V", "vert.", "Z", "U-D"}) {
        EXPECT_TRUE(formats::parse_direction(text).is_vertical) << text;
        EXPECT_FALSE(formats::parse_direction(text).azimuth) << text;
    }
    EXPECT_TRUE(formats::parse_direction("DOWN").points_down);
    EXPECT_FALSE(formats::parse_direction("DOWN").is_vertical);
}

TEST(Direction, DoesNotGuess)
{
    for (const std::string text :
         {"", "  ", "Long", "T3", "N95W", "400", "nan", "1e9 deg", "90 m", "Northridge", "N28", "(90)"}) {
        const formats::Direction direction = formats::parse_direction(text);
        EXPECT_FALSE(direction.azimuth || direction.is_vertical || direction.points_down) << text;
    }
}

TEST(Direction, OfADownwardChannelIsLeftOutWithARemark)
{
    Channel channel;
    std::vector<std::string> remarks;
    formats::set_direction(channel, formats::parse_direction("down"), remarks);
    EXPECT_FALSE(channel.is_vertical);
    EXPECT_EQ(remarks.size(), 1);
    formats::set_direction(channel, formats::parse_direction("up"), remarks);
    EXPECT_TRUE(channel.is_vertical);
    EXPECT_EQ(remarks.size(), 1);
}

}  // namespace

}  // namespace voussoir::records
