// CSMIP volumes 1 and 2: what the header says is what is read.

#include "tests/records/formats/composed.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

constexpr double g = 9.80665;

std::string numbers(std::size_t reals)
{
    return in_lines(std::vector<double>(100, -999), 16, "%5.0f") +
           in_lines(std::vector<double>(reals, 0), 8, "%10.3f");
}

std::string volume_1(const std::string& component, const std::string& samples)
{
    return "Uncorrected Accelerogram Data             Processed: 01/01/30, nobody\n"
           "A composed earthquake\n\n\n"
           "Station No. 1    1.0N, 2.0W\nThe mason's yard\n"
           "Chan  1: " +
           component +
           "      (Sta Chn: 1)\n"
           "No. of Points =      5  Record Length =  .025 sec   at 200 Samples/sec\n"
           "Units of uncor data are sec and g/10.     Max = .2 g\n" +
           numbers(50) + samples;
}
const std::string pairs = "   .000  1.000   .005 -2.000   .010  3.000   .015  -.500   .020   .250\n";
const std::string series =
    "     5 Accelerogram points at 200 pts/sec in units of g .   Format: (8f9.6)\n"
    "  .100000-1.000000-2.000000 3.00000010.000000\n";
const std::string end = "/&  ----------  End of Data for Channel   1  ----------\n";

TEST(Csmip, ReadsPairsInTheUnitOfTheHeader)
{
    const Record record = read(volume_1("N28W", pairs) + end);
    ASSERT_EQ(record.channels.size(), 1);
    const Channel& channel = record.channels.front();
    EXPECT_DOUBLE_EQ(channel.time_step, 0.005);
    ASSERT_EQ(channel.samples.size(), 5);
    EXPECT_DOUBLE_EQ(channel.samples[2], 0.3 * g);
    EXPECT_EQ(channel.azimuth, 332);
    EXPECT_EQ(channel.component, "chan 1: N28W");
    EXPECT_EQ(record.station, "Station No. 1, The mason's yard");
    EXPECT_EQ(record.event, "A composed earthquake");
    EXPECT_TRUE(record.remarks.empty());
}

TEST(Csmip, ReadsSeriesInTheFormatTheyAnnounce)
{
    const Record record = read(volume_1("Up", series) + end + volume_1(" 90 Deg", series));
    ASSERT_EQ(record.channels.size(), 2);
    const Channel& channel = record.channels.front();
    EXPECT_DOUBLE_EQ(channel.time_step, 0.005);
    EXPECT_EQ(channel.unit_in_file, "g");
    ASSERT_EQ(channel.samples.size(), 5);
    EXPECT_DOUBLE_EQ(channel.samples[1], -g);
    EXPECT_DOUBLE_EQ(channel.samples[4], 10 * g);
    EXPECT_TRUE(channel.is_vertical);
    EXPECT_EQ(record.channels[1].azimuth, 90);
}

std::string volume_2()
{
    std::string text = volume_1("360 Deg", "");
    text = "Corrected accelerogram   1      Chan  1: 360 Deg     from\n" + text.substr(0, text.find(" -999")) +
           numbers(100);
    for (const std::string kind : {"accel", "veloc", "displ"}) {
        const std::string unit = kind == "accel" ? "cm/sec2" : kind == "veloc" ? "cm/sec" : "cm";
        text += " 3 points of " + kind + " data equally spaced at  .020 sec, in " + unit + ". (8f10.6)\n";
        text += "  1.171726-12.626200  7.000000\n";
    }
    return text + end;
}

TEST(Csmip, KeepsTheAccelerationOfVolume2)
{
    const Record record = read(volume_2());
    ASSERT_EQ(record.channels.size(), 1);
    EXPECT_DOUBLE_EQ(record.channels.front().samples[1], -0.126262);
    EXPECT_DOUBLE_EQ(record.channels.front().time_step, 0.02);
    ASSERT_EQ(record.remarks.size(), 1);
    expect_in(record.remarks.front(), "2 series of velocity or displacement");
}

TEST(Csmip, ReadsUnevenTimesAsSuch)
{
    const Record record =
        read(volume_1("EW", "   .000  1.000   .005 -2.000   .030  3.000   .035  -.500   .050   .250\n"));
    EXPECT_EQ(record.channels.front().time_step, 0);
    EXPECT_EQ(record.channels.front().times, (std::vector<double>{0, 0.005, 0.03, 0.035, 0.05}));
}

TEST(Csmip, AcceptsOneSampleMoreThanAnnounced)
{
    const Record record = read(volume_1("EW", pairs + "   .025   .125\n"));
    EXPECT_EQ(record.channels.front().samples.size(), 6);
    ASSERT_EQ(record.remarks.size(), 1);
    expect_in(record.remarks.front(), "announces 5 samples but there is one more");
}

TEST(Csmip, RefusesDamage)
{
    const std::string text = volume_1("EW", series) + end;
    expect_in(refusal(with(text, "     5 Accel", "     9 Accel")),
              "\"/&  ----------  End of Data for Channel \" after 5 of the 9");
    expect_in(refusal(with(text, "     5 Accel", "1000000000000 Accel")), "after 5 of the 1000000000000 samples");
    expect_in(refusal(with(text, "     5 Accel", "     0 Accel")), "announces 0 samples");
    expect_in(refusal(with(text, "at 200 pts", "at 0 pts")), "time step = inf s");
    expect_in(refusal(with(text, "  .100000", "      NaN")), ":25: sample nan; must be finite");
    expect_in(refusal(with(text, "  .100000", "*********")), ":25: \"*********");
    expect_in(refusal(with(text, "  .100000", "    1e308")),
              "sample 1e+308; must be finite and smaller than 1e+30");
    expect_in(refusal(volume_1("EW", "")), "a channel without samples");
    expect_in(refusal(volume_1("EW", with(pairs, "   .250", ""))), "a time without a value");
    expect_in(refusal(volume_1("EW", with(pairs, "   .015", "   .005"))), "time 0.005 s after 0.01 s");
    expect_in(refusal(with(volume_2(), "at  .020", "at  .000")), "time step = 0 s");
    expect_in(refusal("Response and Fourier amplitude spectra for\nCorrected accelerogram\n" + volume_1("EW", "")),
              ":1: response spectra, not a time history");
    expect_in(refusal("Corrected accelerogram   1      Chan  1: 360 Deg     from\n1 2\n"),
              "a record holds at least 2");
    expect_in(refusal(text, {.unit = "cm/s2"}), "the file is in g but cm/s2 was asked for");
    expect_in(refusal(text, {.column = 2}), "a column was asked for");
}

TEST(Csmip, LeavesAnUnknownUnitOpen)
{
    const std::string text = with(volume_1("EW", series), "units of g .", "units of volts.");
    EXPECT_FALSE(has_unit(read(text).channels.front()));
    EXPECT_DOUBLE_EQ(read(text, in_g()).channels.front().samples[1], -g);
}

}  // namespace

}  // namespace voussoir::records
