// K-NET and KiK-net.

#include <gtest/gtest.h>

#include "tests/records/expected.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

std::string header(const std::string& direction, const std::string& scale = "100(gal)/200",
                   const std::string& duration = "2")
{
    return "Origin Time       2020/01/02 03:04:05\nMag.              5.5\nStation Code      ABC001\n"
           "Record Time       2020/01/02 03:04:30\nSampling Freq(Hz) 2Hz\nDuration Time(s)  " +
           duration + "\nDir.              " + direction + "\nScale Factor      " + scale +
           "\nMax. Acc. (gal)   1.0\nLast Correction   2020/01/02 03:04:00\nMemo.             \n";
}

TEST_F(RealRecords, KnetFilesNeedNothingFromTheUser)
{
    const std::vector<std::string> files = names("knet");
    EXPECT_GE(files.size(), 6);
    for (const std::string& name : files) {
        const Channel channel = check(name, {}, "K-NET, KiK-net").channels.at(0);
        EXPECT_EQ(channel.unit_in_file, expected_[name]["channels"][0]["units_in_file"].get<std::string>());
        EXPECT_EQ(channel.is_vertical, name.find(".UD") != std::string::npos) << name;
        EXPECT_EQ(channel.azimuth.has_value(), !channel.is_vertical) << name;
    }
}

TEST(Knet, ScalesCountsAndKeepsTheirOffset)
{
    const Record record = read(header("N-S") + "   8   10  12\r\n 10\r\n");
    const Channel& channel = record.channels.at(0);
    EXPECT_EQ(channel.component, "N-S");
    EXPECT_EQ(channel.azimuth, 0);
    EXPECT_EQ(channel.unit_in_file, "counts x 100(gal)/200 gal");
    EXPECT_DOUBLE_EQ(channel.time_step, 0.5);
    EXPECT_DOUBLE_EQ(channel.samples.at(0), 8 * 0.5 * 0.01);
    EXPECT_EQ(record.station, "ABC001");
    expect_in(record.remarks.at(0), "15 s before the header's Record Time 2020/01/02 03:04:30");
}

TEST(Knet, KnowsTheDirectionsOfKikNet)
{
    EXPECT_EQ(read(header("1") + "1 2 3 4\n").channels.at(0).azimuth, 0);
    EXPECT_EQ(read(header("5") + "1 2 3 4\n").channels.at(0).azimuth, 90);
    EXPECT_TRUE(read(header("6") + "1 2 3 4\n").channels.at(0).is_vertical);
    expect_in(read(header("2") + "1 2 3 4\n").remarks.at(0), "in the borehole");
}

TEST(Knet, RefusesWithLine)
{
    expect_in(refusal(header("N-S") + "1 2 3\n"), ":6: the header announces 4 samples but the file holds 3");
    expect_in(refusal(header("N-S", "100(gal)/200", "1e12") + "1 2 3 4\n"), "announces 2000000000000 samples");
    expect_in(refusal(header("N-S", "100(gal)/0") + "1 2 3 4\n"), ":8: Scale Factor = \"100(gal)/0\"");
    expect_in(refusal(header("N-S", "100/200") + "1 2 3 4\n"), "7845(gal)/8223790");
    expect_in(refusal(header("N-S") + "1 2 nan 4\n"), ":12: sample nan");
    std::string still = header("N-S") + "1 2 3 4\n";
    still.replace(still.find("2Hz"), 3, "0Hz");
    expect_in(refusal(still), ":5: time step = inf s");
}

TEST(Knet, AcceptsASampleMoreThanAnnounced)
{
    const Record record = read(header("N-S") + "1 2 3 4 5\n");
    EXPECT_EQ(record.channels.at(0).samples.size(), 5);
    expect_in(record.remarks.at(0), "announces 4 samples but the file holds 5");
}

}  // namespace

}  // namespace voussoir::records
