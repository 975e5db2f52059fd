// DYNA of ESM and ITACA, and ITACA's older header.

#include <gtest/gtest.h>

#include "tests/records/expected.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

std::string header(const std::string& kind, const std::string& units, const std::string& count = "3")
{
    return "EVENT_NAME: TESTQUAKE\nEVENT_ID: 17\nEVENT_DATE_YYYYMMDD: 20200102\nNETWORK: XX\nSTATION_CODE: ABC\n"
           "SAMPLING_INTERVAL_S: 0.005000\nNDATA: " +
           count + "\nSTREAM: HNN\nUNITS: " + units +
           "\nPGA_CM/S^2: -2.5\nPGV_CM/S: -2.5\nHEADER_FORMAT: DYNA 1.2\nDATA_TYPE: " + kind + "\nUSER5: \n";
}

TEST_F(RealRecords, DynaFilesNeedNothingFromTheUser)
{
    const std::vector<std::string> files = names("esm_dyna");
    EXPECT_GE(files.size(), 3);
    for (const std::string& name : files) {
        const Record record = check(name, {}, "DYNA (ESM, ITACA)");
        EXPECT_TRUE(record.remarks.empty());  // the header's peak is the samples' peak
        EXPECT_EQ(record.station, "HI.ARS1");
        EXPECT_NE(record.event.find("GREECE"), std::string::npos);
        EXPECT_EQ(record.channels[0].is_vertical, record.channels[0].component == "HNZ");
        EXPECT_EQ(record.channels[0].azimuth.has_value(), record.channels[0].component != "HNZ");
    }
}

TEST(Dyna, ReadsAccelerationVelocityAndDisplacementWithAnyLineEndAndSpacing)
{
    const std::string samples = "1.0\r\n -2.5\r\n\r\n0.5\r\n";
    const Channel acceleration = read(header("ACCELERATION", "cm/s^2") + samples).channels.at(0);
    EXPECT_EQ(acceleration.component, "HNN");
    EXPECT_EQ(acceleration.azimuth, 0);
    EXPECT_DOUBLE_EQ(acceleration.samples.at(1), -0.025);
    EXPECT_DOUBLE_EQ(acceleration.time_step, 0.005);
    const Channel velocity = read(header("VELOCITY", " CM/S ") + samples).channels.at(0);
    EXPECT_EQ(velocity.quantity, Quantity::velocity);
    EXPECT_DOUBLE_EQ(velocity.samples.at(1), -0.025);
    EXPECT_EQ(read(header("DISPLACEMENT", "cm") + samples).channels.at(0).quantity, Quantity::displacement);
}

TEST(Dyna, ReadsTheOlderHeaderOfItaca)
{
    const Record record = read(
        "EVENT_NAME: OLD\nMAGNITUDE_S: \nSTATION_CODE: NCR\nSAMPLING_INTERVAL_S: 0.01\nNDATA: 2\n"
        "COMPONENT: WE\nUNITS: cm/s^2\nPGA_CM/S^2: 2\nDATA_TYPE: PROCESSED ACCELERATION\n 1\n 2\n");
    EXPECT_EQ(record.channels.at(0).component, "WE");
    EXPECT_EQ(record.channels[0].azimuth, 90);
    EXPECT_EQ(record.station, "NCR");
}

TEST(Dyna, RefusesWithLine)
{
    expect_in(refusal(header("ACCELERATION", "cm/s^2", "1e12") + "1\n2\n3\n"),
              ":7: the header announces 1000000000000 samples but the file holds 3");
    expect_in(refusal(header("ACCELERATION", "cm/s^2") + "1\nnan\n3\n"), ":16: sample nan");
    expect_in(refusal(header("ACCELERATION RESPONSE SPECTRUM", "cm/s^2") + "0.01 1\n0.02 2\n"),
              ":13: response spectra");
    expect_in(refusal(header("VELOCITY", "cm/s^2") + "1\n2\n3\n"), "in cm/s2");
    std::string zero = header("ACCELERATION", "cm/s^2") + "1\n2\n3\n";
    zero.replace(zero.find("0.005000"), 8, "0.000000");
    expect_in(refusal(zero), ":6: time step = 0 s");
    expect_in(refusal(header("ACCELERATION", "cm/s^2") + "1\n2\n3\n", {.response = "x.xml"}), "holds no counts");
}

TEST(Dyna, TellsWhenTheHeadersPeakIsAnother)
{
    EXPECT_TRUE(read(header("ACCELERATION", "cm/s^2") + "1\n-2.5\n0\n").remarks.empty());
    expect_in(read(header("ACCELERATION", "cm/s^2") + "1\n-2.6\n0\n").remarks.at(0), "peak of -2.5");
}

TEST(Dyna, WithoutAUnitIsListedAsStored)
{
    EXPECT_FALSE(has_unit(read(header("ACCELERATION", "") + "1\n2\n3\n").channels.at(0)));
}

}  // namespace

}  // namespace voussoir::records
