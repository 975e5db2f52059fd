// COSMOS files: headers, units and counts are read, not assumed.

#include "tests/records/formats/composed.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

constexpr double g = 9.80665;

struct Composed {
    std::vector<double> integers = std::vector<double>(100, -999), reals = std::vector<double>(100, -999);
    std::string title = "Uncorrected acceleration  (Format v01.20 with 13 text lines)";
    std::string channel = "Sta Chan  1: 340 deg (Rcrdr Chan  1)";
    std::string samples =
        "       5 acceleration pts, approx 0 secs, units=g.     (02)Format=(8f9.6)\n"
        "  .100000-1.000000-2.000000 3.00000010.000000\n";

    Composed()
    {
        integers[0] = 1;
        reals[61] = 5;  // ms
    }
    std::string text() const
    {
        return title + "\nA composed earthquake\nStatn No: 05- 1 Code:CE-1  The mason's yard\n" + channel +
               "\nValues used when parameter or data value is unknown/unspecified:   -999, -999.0\n"
               " 100 Integer-header values follow on  10 lines, Format= (10I8)\n" +
               in_lines(integers, 10, "%8.0f") +
               " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n" + in_lines(reals, 6, "%13.6f") +
               "   2 Comment line(s) follow, each starting with a \"|\":\n |<SCNL>1.HNN.CE.--   <AUTH>CE\n| a "
               "remark\n" +
               samples + "End-of-data for Chan  1 acceleration\n";
    }
};

TEST(Cosmos, ReadsChannelsOneBehindTheOther)
{
    Composed up;
    up.channel = "Sta Chan  2:  Up   (Rcrdr Chan  2)";
    const Record record = read(Composed().text() + up.text());
    ASSERT_EQ(record.channels.size(), 2);
    const Channel& channel = record.channels.front();
    EXPECT_DOUBLE_EQ(channel.time_step, 0.005);
    ASSERT_EQ(channel.samples.size(), 5);
    EXPECT_DOUBLE_EQ(channel.samples[4], 10 * g);
    EXPECT_EQ(channel.azimuth, 340);
    EXPECT_EQ(channel.component, "1.HNN.CE.--");
    EXPECT_TRUE(record.channels[1].is_vertical);
    EXPECT_EQ(record.station, "CE-1  The mason's yard");
    EXPECT_TRUE(record.remarks.empty());
}

/// "Format=(8F10.5)" is no code of a unit: 8 is that of inches a second.
TEST(Cosmos, ReadsAUnitWithoutACode)
{
    Composed composed;
    const std::string announcement = "units=g.     (02)Format=(8f9.6)";
    composed.samples = with(composed.samples, announcement, "units=g,Format=(8F9.6)");
    EXPECT_DOUBLE_EQ(read(composed.text()).channels.front().samples[4], 10 * g);
    composed.samples = with(composed.samples, "units=g,", "units=cm/s^2 (4),");
    EXPECT_DOUBLE_EQ(read(composed.text()).channels.front().samples[4], 0.1);
    composed.samples = with(composed.samples, "cm/s^2 (4)", "g (4)");
    expect_in(refusal(composed.text()), "units=g with code 4, which is cm/s2");
}

TEST(Cosmos, TakesTheAzimuthFromTheHeaderWhereTheWordsHaveNone)
{
    Composed composed;
    composed.channel = "Sta Cha:  1: 20 deg";
    EXPECT_EQ(read(composed.text()).channels.front().azimuth, 20);
    composed.channel = "Sta Chan   ?:Other";
    EXPECT_FALSE(read(composed.text()).channels.front().azimuth);
    composed.integers[53] = 123;
    EXPECT_EQ(read(composed.text()).channels.front().azimuth, 123);
    composed.integers[53] = 400;
    EXPECT_TRUE(read(composed.text()).channels.front().is_vertical);
    composed.integers[53] = 401;
    EXPECT_FALSE(read(composed.text()).channels.front().is_vertical);
    EXPECT_EQ(read(composed.text()).remarks.size(), 1);
}

TEST(Cosmos, KnowsTheUnitsByTheirCodes)
{
    const auto unit_of = [](const std::string& unit) {
        Composed composed;
        composed.samples = with(composed.samples, "units=g.     (02)", unit);
        return read(composed.text()).channels.front();
    };
    EXPECT_DOUBLE_EQ(unit_of("units=cm/sec2(04)").samples[4], 0.1);
    EXPECT_DOUBLE_EQ(unit_of("units=      (07)").samples[4], 0.254);
    EXPECT_DOUBLE_EQ(unit_of("units=      (11)").samples[4], 0.01 * g);
    EXPECT_EQ(unit_of("units=cm/sec (05)").quantity, Quantity::velocity);
    EXPECT_EQ(unit_of("units=cm     (06)").quantity, Quantity::displacement);
    EXPECT_FALSE(has_unit(unit_of("units=volts  (51)")));
}

TEST(Cosmos, ScalesCountsByRecorderAndSensor)
{
    Composed raw;
    raw.title = "Raw acceleration counts   (Format v01.20 with 13 text lines)";
    raw.integers[0] = 0;
    raw.samples =
        "       4 raw accel. pts, approx 0 secs, units=counts (50),Format=(10I8)\n    3284-1234567-7654321    "
        "3308\n";
    EXPECT_FALSE(has_unit(read(raw.text()).channels.front()));
    EXPECT_DOUBLE_EQ(read(raw.text()).channels.front().samples[2], -7654321);
    raw.reals[21] = 0.298;  // 1e-6 V
    raw.reals[41] = 0.625;  // V/g
    const Channel channel = read(raw.text()).channels.front();
    EXPECT_NEAR(channel.samples[1], -1234567 * 0.298e-6 / 0.625 * g, 1e-12);
    raw.reals[46] = 2;  // gain
    EXPECT_NEAR(read(raw.text()).channels.front().samples[1], channel.samples[1] / 2, 1e-12);
}

TEST(Cosmos, TakesTheRawStepOnlyWhereThereIsNoOther)
{
    Composed composed;
    composed.reals[33] = 0.02;
    EXPECT_DOUBLE_EQ(read(composed.text()).channels.front().time_step, 0.005);
    composed.reals[61] = -999;
    EXPECT_DOUBLE_EQ(read(composed.text()).channels.front().time_step, 0.02);
    composed.reals[33] = -999;
    expect_in(refusal(composed.text()), "no time step");
    EXPECT_DOUBLE_EQ(read(composed.text(), {.time_step = 0.01}).channels.front().time_step, 0.01);
    composed.reals[61] = 0;
    expect_in(refusal(composed.text()), "time step = 0 s");
}

TEST(Cosmos, KeepsTheAccelerationBesideVelocity)
{
    Composed composed;
    const std::string velocity =
        with(with(composed.samples, "acceleration", "velocity"), "units=g.     (02)", "units=cm/sec (05)");
    composed.samples += velocity;
    const Record record = read(composed.text());
    ASSERT_EQ(record.channels.size(), 1);
    EXPECT_EQ(record.channels.front().quantity, Quantity::acceleration);
    EXPECT_EQ(record.remarks.size(), 1);
    composed.samples = velocity;
    EXPECT_EQ(read(composed.text()).channels.front().quantity, Quantity::velocity);
}

TEST(Cosmos, RemarksOnAPeakThatIsNotThatOfTheSamples)
{
    Composed composed;
    composed.reals[63] = 10.004;
    EXPECT_TRUE(read(composed.text()).remarks.empty());
    composed.reals[63] = 11;
    ASSERT_EQ(read(composed.text()).remarks.size(), 1);
}

TEST(Cosmos, RefusesDamage)
{
    const std::string text = Composed().text();
    expect_in(refusal(with(text, "       5 acc", "       9 acc")),
              "\"End-of-data for Chan  1 acceleration\" after 5 of the 9");
    expect_in(refusal(with(text, "       5 acc", "1000000000000 acc")), "after 5 of the 1000000000000 samples");
    expect_in(refusal(with(text, "  .100000", "      inf")), "sample inf; must be finite");
    expect_in(refusal(with(text, " 100 Integer", " 1000000000000 Integer")), "a header of 1e+12 numbers");
    expect_in(refusal(with(text, " 100 Real", " 108 Real")), "a header of 108 numbers of which 100 are there");
    expect_in(refusal(with(text, "(02)", "(04)")), "units=g with code 4, which is cm/s2");
    expect_in(refusal(text.substr(0, 200)), "\"Integer-header values follow\"");
    expect_in(refusal(text.substr(0, text.find("       5 acc"))), "no line that counts samples");
    Composed spectra;
    spectra.integers[0] = 3;
    expect_in(refusal(spectra.text()), "response spectra, not a time history");
}

}  // namespace

}  // namespace voussoir::records
