// Numbers in fixed fields, and the samples made of them.

#include "records/formats/fields.h"

#include "records/formats/samples.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

std::vector<double> fields(const std::string& line, std::size_t width)
{
    std::vector<double> numbers;
    return formats::parse_fields(line, width, numbers) ? numbers : std::vector<double>{};
}

TEST(Fields, TellsNumbersThatTouchApart)
{
    using Numbers = std::vector<double>;
    EXPECT_EQ(fields("  1.171726-12.626200 -7.202959", 10), (Numbers{1.171726, -12.6262, -7.202959}));
    EXPECT_EQ(fields(" 59.976  -.049100.005", 7), (Numbers{59.976, -0.049, 100.005}));
    EXPECT_EQ(fields("5.0000000-999.00000 4.0000000", 10), (Numbers{5, -999, 4}));
    EXPECT_EQ(fields(" -999 -999 -99915050    2 -999", 5), (Numbers{-999, -999, -999, 15050, 2, -999}));
    EXPECT_EQ(fields("-12345678    -5", 8), (Numbers{-12345678, -5})) << "no two fields touch here";
    EXPECT_EQ(fields("-1234567-7654321", 8), (Numbers{-1234567, -7654321}));
    EXPECT_EQ(fields(" 1.5057E+0-2.2223E+0", 10), (Numbers{1.5057, -2.2223}));
    EXPECT_EQ(fields("1.5057E+0-2.2223E+0", 0), (Numbers{1.5057, -2.2223}));
    EXPECT_EQ(fields("-0.049100.005", 0), Numbers{}) << "nobody can know";
    EXPECT_EQ(fields("1.0 ******* 2.0", 7), Numbers{});
    EXPECT_EQ(fields("0.1700000E+39", 10), Numbers{0.17e39}) << "wider than its field, and whole";
    EXPECT_EQ(fields("", 7), Numbers{});
}

TEST(Fields, ReadsTheWidthOfAFortranFormat)
{
    EXPECT_EQ(formats::format_width("13400 Accelerogram points at 200 pts/sec in units of g. Format: (8f9.6)"), 9);
    EXPECT_EQ(formats::format_width(" 100 Integer-header values follow on  10 lines, Format= (10I8)"), 8);
    EXPECT_EQ(formats::format_width("units=cm/sec2(04),Format=(1E15.6)"), 15);
    EXPECT_EQ(formats::format_width("8(1PE10.4E1)"), 10);
    EXPECT_EQ(
        formats::format_width(" 3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)"), 0);
}

TEST(Fields, ReadsWordsOfHeaders)
{
    EXPECT_DOUBLE_EQ(formats::number_after("No. of Points =  3500  Record Length = 35.0", "points").value(), 3500);
    EXPECT_FALSE(formats::number_after("No. of Points =  many", "points"));
    EXPECT_EQ(formats::text_after("Units of uncor data are sec and g .        Max", " and "), "g");
    EXPECT_EQ(formats::text_after("SPACED AT .02 SEC. (UNITS: CM/SEC/SEC)", "units:"), "CM/SEC/SEC");
    EXPECT_EQ(formats::text_after("nothing of it", "units:"), "");
}

TEST(Fields, SpreadsTimesThatArePrintedAlike)
{
    SourceFile file;
    load_source_bytes("film", "10.00 1 10.00 2 10.01 3\n10.02 4 10.02 5\n", file);
    std::vector<std::string> remarks;
    FaultList faults;
    const formats::TimedSamples samples =
        formats::split_pairs(file, formats::read_block(file, 0, 0), remarks, faults);
    ASSERT_TRUE(faults.empty());
    EXPECT_EQ(remarks.size(), 1);
    const std::vector<double> times{10, 10.005, 10.01, 10.02, 10.03};
    ASSERT_EQ(samples.times.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(samples.times[i], times[i], 1e-12);
    EXPECT_EQ(samples.values, (std::vector<double>{1, 2, 3, 4, 5}));
}

}  // namespace

}  // namespace voussoir::records
