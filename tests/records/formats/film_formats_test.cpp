// USC, GeoNet and BHRC files: the heirs of the formats of hand-digitized films.

#include "tests/records/formats/composed.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

constexpr double g = 9.80665;

std::string usc(const std::string& component)
{
    return "FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:\nA COMPOSED EARTHQUAKE                21\n"
           "STATION USC# 1   THE YARD\nCOMP " +
           component +
           "                                            9\n"
           "NO. OF POINTS =      4      DURATION =    .031 SEC                      50\n"
           "UNITS ARE SEC AND G/10                                                  22\n" +
           in_lines(std::vector<double>(100, 0), 16, "%5.0f") + in_lines(std::vector<double>(50, 0), 8, "%10.3f") +
           "    .000  -.049   .004  1.000   .013-10.000\n    .031   .020\n";
}

TEST(Usc, ReadsUnevenPairs)
{
    const Record record = read(usc("N60W"));
    const Channel& channel = record.channels.at(0);
    EXPECT_EQ(record.format, "USC");
    EXPECT_EQ(channel.time_step, 0);
    EXPECT_EQ(channel.times, (std::vector<double>{0, 0.004, 0.013, 0.031}));
    EXPECT_DOUBLE_EQ(channel.samples[2], -g);
    EXPECT_EQ(channel.component, "N60W");
    EXPECT_EQ(channel.azimuth, 300);
    EXPECT_EQ(record.event, "A COMPOSED EARTHQUAKE");
    EXPECT_EQ(read(usc("UP") + usc("NS")).channels.size(), 2);
}

TEST(Usc, RefusesDamage)
{
    expect_in(refusal(with(usc("UP"), "=      4 ", "=   9999 ")), "announces 9999 samples but the file holds 4");
    expect_in(refusal(with(usc("UP"), "   .013", "   .003")), "time 0.003 s after 0.004 s");
    expect_in(refusal(with(usc("UP"), "-.049", "  NaN")), "sample nan");
    expect_in(refusal(usc("UP"), {.time_step = 0.01}), "omit it");
    expect_in(refusal(usc("UP").substr(0, 150)), "the file is cut short");
}

std::string geonet(bool corrected, const std::string& component)
{
    std::vector<double> integers(40, 0), reals(60, 0);
    integers[33] = 5;
    if (corrected) integers[34] = integers[35] = 5;
    reals[24] = 0.005, reals[25] = corrected ? 0.02 : 0.005;
    const std::string samples = "     0.4-12345.6     2.0     3.0    -4.5\n";
    return std::string(corrected ? "Corrected" : "Uncorrected") +
           " accelerogram 19300101_YARD GNS Science\n"
           "Site YARD      42 37 10S  173 03 13E     file:  1\nA yard\nNumber of points  5    Duration 0.02 s\n" +
           (corrected ? "Instrument corrected data at 0.020 sec intervals\n"
                      : "Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s\n") +
           "Component " + component +
           "\nAcceleration:  Peak -12345.6 mm/s/s at   0.01 s     RMS    54.28 mm/s/s\n" +
           in_lines(integers, 10, "%8.0f") + in_lines(reals, 10, "%8.4f") + samples +
           (corrected ? samples + samples : "");
}

TEST(Geonet, ReadsThreeComponents)
{
    const Record record = read(geonet(false, "S90E") + geonet(false, "N00E") + geonet(false, "Up"));
    ASSERT_EQ(record.channels.size(), 3);
    EXPECT_DOUBLE_EQ(record.channels[1].samples[1], -12.3456);
    EXPECT_DOUBLE_EQ(record.channels[1].time_step, 0.005);
    EXPECT_EQ(record.channels[0].azimuth, 90);
    EXPECT_TRUE(record.channels[2].is_vertical);
    EXPECT_EQ(record.station, "YARD");
    EXPECT_TRUE(record.remarks.empty());
}

TEST(Geonet, LeavesVelocityAndDisplacement)
{
    const Record record = read(geonet(true, "N28W  Longitudinal Axis") + geonet(true, "Up  Axis"));
    ASSERT_EQ(record.channels.size(), 2);
    EXPECT_DOUBLE_EQ(record.channels[1].time_step, 0.02);
    EXPECT_DOUBLE_EQ(record.channels[1].samples[4], -0.0045);
    ASSERT_EQ(record.remarks.size(), 1);
    expect_in(record.remarks.front(), "4 series of velocity or displacement");
}

TEST(Geonet, ScalesRawReadings)
{
    const Record record = read(with(geonet(false, "Up"), "1.00 mm/s/s", "0.10 mm/s/s"));
    EXPECT_DOUBLE_EQ(record.channels.at(0).samples[1], -1.23456);
    EXPECT_EQ(record.channels.at(0).unit_in_file, "0.1 mm/s2");
    EXPECT_EQ(record.remarks.size(), 1) << "the peak in the header is another";
}

TEST(Geonet, RefusesDamage)
{
    const std::string text = geonet(false, "Up"), corrected = geonet(true, "Up");
    expect_in(refusal(with(text, "intervals of 0.005", "intervals of 0.000")), "time step = 0 s");
    expect_in(refusal(with(text, "intervals of 0.005", "intervals of 0.010")), "0.01 s here but 0.005 s");
    expect_in(refusal(with(text, "       5", "99999999")), "announces 99999999 samples but the file holds 5");
    expect_in(refusal(with(text, "-12345.6     2.0", "     nan     2.0")), "sample nan");
    expect_in(refusal(corrected.substr(0, corrected.size() - 20)), "samples but the file holds");
    expect_in(refusal(text.substr(0, 500)), "it has 40 and 60");
}

std::string bhrc(const std::string& component)
{
    std::vector<double> reals(38, 0);
    reals[6] = 200;
    return "* VOL1DS FILE:  1/01\nInst Type = SSA-2\n\nCOMP " + component +
           "                         \nThe yard            Station   37.734 N 47.801 E   Azimuth L 50    T 140\n"
           "Epicenter 38.520 N 46.860 E   (BHRC   )\nNO. OF POINTS =      4      DURATION =   .020\n"
           "UNITS ARE SECONDS AND G/10\n" +
           in_lines(std::vector<double>(88, 0), 14, "%5.0f") + in_lines(reals, 6, "%13.6E") +
           "  .921041E-02  .140956E-01 -.189808E-01\n  .100000E+01\n/&\n";
}

TEST(Bhrc, ReadsThreeComponents)
{
    const Record record = read(bhrc("L1") + bhrc("V2") + bhrc("T3"));
    ASSERT_EQ(record.channels.size(), 3);
    EXPECT_DOUBLE_EQ(record.channels[0].samples[3], 0.1 * g);
    EXPECT_DOUBLE_EQ(record.channels[0].time_step, 0.005);
    EXPECT_EQ(record.channels[0].azimuth, 50);
    EXPECT_TRUE(record.channels[1].is_vertical);
    EXPECT_EQ(record.channels[2].azimuth, 140);
    EXPECT_EQ(record.station, "The yard");
}

TEST(Bhrc, RefusesDamage)
{
    expect_in(refusal(with(bhrc("L1"), "=      4", "= 123456")), "after 4 of the 123456 samples");
    expect_in(refusal(with(bhrc("L1"), "2.000000E+02", "1.000000E+02")), "100 samples a second");
    expect_in(refusal(with(with(bhrc("L1"), "2.000000E+02", "0.000000E+00"), "=   .020", "=   .000")),
              "time step = 0 s");
    expect_in(refusal(with(bhrc("L1"), "  .921041E-02", "          NaN")), "sample nan");
}

}  // namespace

}  // namespace voussoir::records
