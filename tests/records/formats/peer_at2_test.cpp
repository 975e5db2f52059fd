// The header styles of PEER's files that record_test.cpp does not have.

#include <gtest/gtest.h>

#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

constexpr double g = 9.80665;

std::string with_count(const std::string& count)
{
    return "PEER STRONG MOTION DATABASE RECORD\nQUAKE 01/02/94 1231, STATION - NAME, 360 (CDMG STATION 1)\n"
           "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.12 Hz LP=25.0 Hz\n" +
           count + "\n .1 .2\n";
}

TEST(PeerStyles, CountsBeforeAfterAndInBrackets)
{
    for (const char* count :
         {"(NPTS, DT)   2  .01", "2 .01 (NPTS,DT)", "NPTS: 2; DT: .01 s", "NPTS = 2 , DT = .01 SEC ,",
          "NPTS 2, DT .01", "DT= .01 SEC, NPTS= 2", "NPTS=  2, DT= .01 SEC, DURATION= 5 SEC"}) {
        const Record record = read(with_count(count));
        EXPECT_EQ(record.channels.at(0).samples.size(), 2) << count;
        EXPECT_DOUBLE_EQ(record.channels[0].time_step, 0.01) << count;
        EXPECT_DOUBLE_EQ(record.channels[0].samples[1], 0.2 * g) << count;
    }
    expect_in(refusal(with_count("NPTS= 2, DT= VARIABLE")), ":4: \"NPTS= 2, DT= VARIABLE\"");
}

TEST(PeerStyles, UnitsInWordsAndInBrackets)
{
    struct Style {
        const char* line;
        const char* unit;
    };
    for (const Style& style :
         {Style{"VELOCITY TIME HISTORY IN UNITS OF CM/S. FILTER POINTS: HP=0.1", "cm/s"},
          Style{"VELOCITY TIME SERIES IN UNITS OF CM/SEC", "cm/s"},
          Style{"Velocity time series in units of cm/sec", "cm/s"},
          Style{"DISPLACEMENT TIME SERIES IN UNITS OF CM", "cm"},
          Style{"ACCELERATION TIME HISTORY (G'S): NIT = 2", "g"}, Style{"Acceleration in cm/s/s", "cm/s2"},
          Style{"Units: (m/s2)", "m/s2"}, Style{"UNITS OF G FILTERED", "g"}}) {
        const Record record = read("A\nB, C, 90\n" + std::string(style.line) + "\nNPTS= 2, DT= .01 SEC\n 1 2\n");
        EXPECT_EQ(record.channels.at(0).unit_in_file, style.unit) << style.line;
    }
    EXPECT_EQ(read("A\nB\nVELOCITY TIME SERIES IN UNITS OF CM/S\nNPTS= 2, DT= .01\n 1 2\n").format, "PEER VT2");
    EXPECT_EQ(read("A\nB\nC\nNPTS= 2, DT= .01 SEC, UNITS: G\n 1 2\n").channels.at(0).unit_in_file, "g");
    expect_in(refusal("A\nB\nVELOCITY TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .01\n 1 2\n"), ":3: velocity in g");
}

TEST(PeerStyles, DirectionsOfTheComponent)
{
    const auto component = [](const std::string& name) {
        const Record record = read("PEER STRONG MOTION\nQuake, 1/2/2003, Station, " + name +
                                   "\nIN UNITS OF G\nNPTS= 2, DT= .01\n 1 2\n");
        EXPECT_EQ(record.station, "Station");
        EXPECT_EQ(record.event, "Quake, 1/2/2003");
        return record.channels.at(0);
    };
    EXPECT_EQ(component("67").azimuth, 67);
    EXPECT_EQ(component("090 (CUE)").azimuth, 90);
    EXPECT_EQ(component("360").azimuth, 0);
    for (const char* up : {"UP", "-V", "VERT", "V", "UD"}) EXPECT_TRUE(component(up).is_vertical) << up;
    EXPECT_FALSE(component("DWN").is_vertical);
    EXPECT_FALSE(component("DWN").azimuth);
    EXPECT_FALSE(component("8 points a row").azimuth);
}

TEST(PeerStyles, LinesAroundTheCount)
{
    const std::string matched =
        "TIME-DOMAIN CORRECTION\n***OLD HEADERS FOLLOW***\nmatched\nOUTPUT ACCELERATION TIME HISTORY (G'S): NIT = "
        "2\n"
        " 16384 DT = .0050 SEC , AMAX = .9 G\n***END***\nNPTS= 2, DT= .01 SEC, SCALED BY 2\n .1 .2\n";
    EXPECT_EQ(read(matched).channels.at(0).unit_in_file, "g");
    EXPECT_EQ(read(with_count("NPTS= 2, DT= .01 SEC\na remark")).channels.at(0).samples.size(), 2);
}

}  // namespace

}  // namespace voussoir::records
