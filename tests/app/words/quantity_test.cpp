#include "app/words/quantity.h"

#include <gtest/gtest.h>

#include <numbers>

namespace voussoir::app::words
{
namespace
{

struct Written {
    const char* text;
    double si;
    Dimension dimension;
};

TEST(Quantity, ReadsUnitsAsPeopleWriteThem)
{
    using namespace dimension;
    const Written written[] = {
        {"4.5 GPa", 4.5e9, dimension::pressure},
        {"4.5GPa", 4.5e9, dimension::pressure},
        {"30 deg", std::numbers::pi / 6, dimension::angle},
        {"30°", std::numbers::pi / 6, dimension::angle},
        {"0.3 g", 0.3 * 9.80665, dimension::acceleration},
        {"9.81 m/s^2", 9.81, dimension::acceleration},
        {"2 ms", 0.002, dimension::time},
        {"24 kN/m3", 24e3, dimension::unit_weight},
        {"24 kN/m³", 24e3, dimension::unit_weight},
        {"2400 kg/m3", 2400, dimension::density},
        {"2.4 t/m3", 2400, dimension::density},
        {"50 MPa/m", 50e6, dimension::stiffness_per_area},
        {"1e8 N/m", 1e8, dimension::stiffness_per_point},
        {"2.5 Hz", 2.5, dimension::frequency},
        {"0.5 1/s", 0.5, dimension::rate},
        {"0.5 s^-1", 0.5, dimension::rate},
        {"5 %", 0.05, dimension::number},
        {"+3 ft", 3 * 0.3048, dimension::length},
        {"-1 mm", -0.001, dimension::length},
    };
    for (const Written& one : written) {
        const ParsedQuantity quantity = parse_quantity(one.text);
        EXPECT_EQ(quantity.problem, "") << one.text;
        EXPECT_DOUBLE_EQ(quantity.value, one.si) << one.text;
        EXPECT_TRUE(quantity.has(one.dimension)) << one.text;
        EXPECT_FALSE(quantity.bare) << one.text;
    }
}

TEST(Quantity, BareNumbersAreMarkedAsSuch)
{
    EXPECT_TRUE(parse_quantity("0.25").bare);
    EXPECT_DOUBLE_EQ(parse_quantity("1e-3").value, 1e-3);
}

TEST(Quantity, ABareNumberLacksAUnitWhereSeveralAreInUse)
{
    const auto lacks = [](const char* text, const Dimension& dimension) {
        return lacks_unit(parse_quantity(text), dimension);
    };
    EXPECT_TRUE(lacks("0.35", dimension::acceleration));
    EXPECT_TRUE(lacks("30", dimension::angle));
    EXPECT_FALSE(lacks("0.35 g", dimension::acceleration));
    EXPECT_FALSE(lacks("0", dimension::acceleration)) << "nothing is nothing in any unit";
    EXPECT_FALSE(lacks("2", dimension::length));
    EXPECT_FALSE(lacks("2", dimension::number));
    EXPECT_EQ(with_units(" 0.35 ", dimension::acceleration), "write 0.35 g or 0.35 m/s2");
}

TEST(Quantity, APressureIsNoDensity)
{
    EXPECT_FALSE(parse_quantity("2400 Pa").has(dimension::density));
    EXPECT_FALSE(parse_quantity("50 MPa/m").has(dimension::stiffness_per_point));
}

TEST(Quantity, RefusesWhatIsNoFiniteNumber)
{
    for (const char* text : {"nan", ".nan", "inf", "-inf", ".inf", "-.inf", "1e999", "1e308 GPa", "-nan m"})
        EXPECT_EQ(parse_quantity(text).problem, "not a finite number") << text;
    for (const char* text : {"", " ", "abc", "GPa", "--3", "m 3"})
        EXPECT_EQ(parse_quantity(text).problem, "not a number") << text;
}

TEST(Quantity, NamesTheUnitItDoesNotKnow)
{
    EXPECT_EQ(parse_quantity("4.5 Gpa").problem, "unknown unit \"Gpa\", did you mean GPa?");
    for (const char* text :
         {"1 xyz", "1 m//s", "1 m/", "1 /", "1 m3x", "1,5 m", "1 m^", "1 m99999999999", "3 3 m"})
        EXPECT_NE(parse_quantity(text).problem.find("unknown unit"), std::string::npos) << text;
}

TEST(Quantity, RangesSayWhatTheyAllow)
{
    EXPECT_EQ(in_words(Range::positive(), dimension::time), "must be > 0");
    EXPECT_EQ(in_words(Range{0, 1, true, false}, dimension::number), "must be >= 0 and < 1");
    EXPECT_FALSE(Range::positive().contains(0));
    EXPECT_TRUE(Range::non_negative().contains(0));
    EXPECT_FALSE(Range::any().contains(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace voussoir::app::words
