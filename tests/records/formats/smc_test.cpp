// SMC files: even and uneven samples, null values, and what is no record.

#include "tests/records/formats/composed.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

struct Composed {
    std::vector<double> integers = std::vector<double>(48, -32768), reals = std::vector<double>(50, 1.7e38);
    std::string title = "2 CORRECTED ACCELEROGRAM", component = "    133";
    std::string samples = " 1.5057E+0-2.2223E+0 4.0000E+1\n-1.0000E-1 2.0000E+0\n";

    Composed()
    {
        integers[15] = 2;
        integers[16] = 5;
        reals[1] = 200;
    }
    std::string text() const
    {
        return title +
               "\n*\nA1\n     1930  1   1    0000 A composed earthquake\n*\n"
               "station = The mason's yard   component=" +
               component + "\n*\n*\n*\n*\n*\n" + in_lines(integers, 8, "%10.0f") + in_lines(reals, 5, "%15.7E") +
               "|\n| a comment\n" + samples;
    }
};

TEST(Smc, ReadsEvenSamples)
{
    const Record record = read(Composed().text());
    const Channel& channel = record.channels.at(0);
    EXPECT_DOUBLE_EQ(channel.time_step, 0.005);
    ASSERT_EQ(channel.samples.size(), 5);
    EXPECT_DOUBLE_EQ(channel.samples[1], -0.022223);
    EXPECT_EQ(channel.azimuth, 133);
    EXPECT_EQ(record.station, "The mason's yard");
    EXPECT_TRUE(record.remarks.empty());
}

TEST(Smc, ReadsVelocityAndDisplacement)
{
    Composed composed;
    composed.title = "3 VELOCITY";
    EXPECT_EQ(read(composed.text()).channels.at(0).quantity, Quantity::velocity);
    composed.title = "4 DISPLACEMENT";
    EXPECT_EQ(read(composed.text()).channels.at(0).quantity, Quantity::displacement);
    EXPECT_DOUBLE_EQ(read(composed.text()).channels.at(0).samples[2], 0.4);
}

TEST(Smc, ReadsPairsWhereTheRateIsNotKnown)
{
    Composed composed;
    composed.reals[1] = 1.7e38;
    composed.integers[16] = 6;
    composed.samples = " 0.0000E+0-3.8075E-2 2.3471E-3 4.2845E-1 5.9187E-3 5.9983E-1\n";
    const Channel channel = read(composed.text() + std::string(80, '\0') + "\r\n").channels.at(0);
    EXPECT_EQ(channel.time_step, 0);
    EXPECT_EQ(channel.times, (std::vector<double>{0, 2.3471e-3, 5.9187e-3}));
    EXPECT_DOUBLE_EQ(channel.samples[1], 4.2845e-3);
    expect_in(refusal(composed.text(), {.time_step = 0.01}), "a time step was asked for");
    // Another file, another number for what is not known.
    composed.integers.assign(48, -1), composed.reals.assign(50, -1);
    composed.integers[16] = 6;
    EXPECT_EQ(read(composed.text()).channels.at(0).times.size(), 3);
}

TEST(Smc, ReadsDirectionsFromWordsOrNumbers)
{
    Composed composed;
    composed.component = "   up";
    EXPECT_TRUE(read(composed.text()).channels.at(0).is_vertical);
    composed.component = "";
    composed.integers[12] = 90, composed.integers[13] = 225;
    EXPECT_EQ(read(composed.text()).channels.at(0).azimuth, 225);
    composed.integers[12] = 0;
    EXPECT_TRUE(read(composed.text()).channels.at(0).is_vertical);
}

TEST(Smc, ReadsComponentsOneBehindTheOther)
{
    Composed up;
    up.component = " up";
    const Record record = read(Composed().text() + up.text());
    ASSERT_EQ(record.channels.size(), 2);
    EXPECT_TRUE(record.channels[1].is_vertical);
}

TEST(Smc, RefusesSpectraAndDamage)
{
    Composed spectra;
    spectra.title = "5 RESPONSE SPECTRA";
    expect_in(refusal(spectra.text()), "response spectra, not a time history");
    const Composed good;
    Composed composed;
    composed.integers[16] = 1e9;
    expect_in(refusal(composed.text()), "announces 1000000000 samples but the file holds 5");
    composed = good, composed.reals[1] = 0;
    expect_in(refusal(composed.text()), "0 samples a second");
    composed = good, composed.reals[1] = 1e30;
    expect_in(refusal(composed.text()), "1e+30 samples a second");
    composed = good, composed.samples += "The end\n";
    expect_in(refusal(composed.text()), "\"The end\" behind the samples");
    expect_in(refusal(with(good.text(), "-1.0000E-1", "    NaN   ")), "sample nan");
    expect_in(refusal(with(good.text(), "-1.0000E-1", " x.000 ")), "\"x.000");
    expect_in(refusal(good.text().substr(0, 700)), "48 and 50");
}

}  // namespace

}  // namespace voussoir::records
