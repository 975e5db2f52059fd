// SAC in both byte orders and as text, evenly sampled or not.

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "tests/records/expected.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

struct SacFile {
    float delta = 0.01F, azimuth = 90, inclination = 90;
    std::int32_t count = 3, type = 1, is_even = 1;
    std::vector<float> numbers{1, -2, 3};
};

void append(std::string& bytes, std::uint32_t bits, bool is_big)
{
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> (8 * (is_big ? 3 - i : i)));
}

std::string compose(const SacFile& file, bool is_big)
{
    std::vector<float> reals(70, -12345);
    reals[0] = file.delta, reals[5] = 0, reals[57] = file.azimuth, reals[58] = file.inclination;
    std::vector<std::int32_t> integers(40, -12345);
    integers[0] = 2020, integers[1] = 82, integers[2] = 5, integers[3] = 24, integers[4] = 0, integers[5] = 0;
    integers[6] = 6, integers[9] = file.count, integers[15] = file.type, integers[16] = 8;
    integers[35] = file.is_even, integers[36] = integers[37] = integers[38] = integers[39] = 0;
    std::string bytes;
    for (const float real : reals) append(bytes, std::bit_cast<std::uint32_t>(real), is_big);
    for (const std::int32_t integer : integers) append(bytes, static_cast<std::uint32_t>(integer), is_big);
    std::string words;
    for (int i = 0; i < 24; ++i) words += "-12345  ";
    words.replace(0, 8, "ABC     ")
        .replace(24, 8, "00      ")
        .replace(160, 8, "HNE     ")
        .replace(168, 8, "XX      ");
    bytes += words;
    for (const float number : file.numbers) append(bytes, std::bit_cast<std::uint32_t>(number), is_big);
    return bytes;
}

TEST_F(RealRecords, SacFilesAreListedWithoutAUnit)
{
    const std::vector<std::string> files = names("sac");
    EXPECT_GE(files.size(), 3);
    for (const std::string& name : files) {
        const Record record = check(name, {}, "SAC");
        EXPECT_EQ(record.station, "CJ.T001230");
        EXPECT_EQ(record.channels.at(0).component, expected_[name]["component"].get<std::string>());
        EXPECT_EQ(record.channels.at(0).is_vertical, name.find("HNZ") != std::string::npos);
        EXPECT_EQ(record.channels.at(0).time_step, 0.02);
        expect_in(record.remarks.at(0), "acceleration but states no unit");
        EXPECT_EQ(read_record(data_folder() / name, in_g()).channels.at(0).unit_in_file, "g");
    }
}

TEST(Sac, ReadsBothByteOrdersAndText)
{
    std::string text;
    for (int line = 0; line < 14; ++line) {
        const char* first = line == 0 ? "       0.0100000" : "      -12345.00";
        text += first;
        for (int i = 1; i < 5; ++i) text += line == 11 && i > 1 && i < 4 ? "       90.00000" : "      -12345.00";
        text += '\n';
    }
    text +=
        "      2020        82         5        24         0\n         0         6         0         0         3\n";
    for (int line = 2; line < 8; ++line)
        text += line == 3   ? "         1         8    -12345    -12345    -12345\n"
                : line == 7 ? "         1         0         0         0         0\n"
                            : "    -12345    -12345    -12345    -12345    -12345\n";
    text += "ABC     -12345          \n";
    for (int line = 1; line < 6; ++line) text += "-12345  -12345  -12345  \n";
    text += "-12345  -12345  HNE     \nXX      -12345  -12345  \n  1.0 -2.0  3.0\n";
    for (const std::string& content : {compose({}, false), compose({}, true), text}) {
        const Record record = read(content, {.unit = "m/s2"});
        EXPECT_EQ(record.format, "SAC");
        EXPECT_EQ(record.station, "XX.ABC");
        EXPECT_EQ(record.channels.at(0).component, "HNE");
        EXPECT_EQ(record.channels[0].azimuth, 90);
        EXPECT_DOUBLE_EQ(record.channels[0].time_step, 0.01);
        EXPECT_EQ(record.channels[0].samples, (std::vector<double>{1, -2, 3}));
    }
}

TEST(Sac, ReadsTimesOfUnevenSamples)
{
    const SacFile uneven{.is_even = 0, .numbers = {1, -2, 3, 0, 0.5F, 2}};
    const Channel channel = read(compose(uneven, false), in_g()).channels.at(0);
    EXPECT_EQ(channel.time_step, 0);
    EXPECT_EQ(channel.times, (std::vector<double>{0, 0.5, 2}));
    EXPECT_EQ(channel.samples.size(), 3);
    EXPECT_NO_THROW(to_ground_motion(channel, "x"));
    const SacFile backwards{.is_even = 0, .numbers = {1, -2, 3, 0, 0.5F, 0.25F}};
    expect_in(refusal(compose(backwards, false)), "time 0.25 s of sample 3");
}

TEST(Sac, RefusesSpectraAndDamage)
{
    expect_in(refusal(compose({.type = 2}, false)), "a spectrum, not a time history");
    expect_in(refusal(compose({.delta = 0}, false)), "time step = 0 s");
    expect_in(refusal(compose({.count = 2000000000}, true)), "announces 2000000000 samples but the file holds 3");
    expect_in(refusal(compose({.count = -1}, true)), "announces -1 samples");
    expect_in(refusal(compose({.numbers = {1, NAN, 3}}, false)), "sample 2 is nan");
    const std::string good = compose({}, false);
    for (std::size_t length = 1; length < good.size(); ++length) refusal(good.substr(0, length), in_g(0.01));
}

TEST(Sac, TakesTheSensitivityOfTheEpochThatCoversItsStart)
{
    const auto epoch = [](const char* from, const char* to, const char* value) {
        return "<Channel code=\"HNE\" locationCode=\"00\" startDate=\"" + std::string(from) + "\" endDate=\"" +
               to + "\"><Azimuth>45</Azimuth><Dip>0</Dip><Response><InstrumentSensitivity><Value>" + value +
               "</Value><Frequency>1</Frequency><InputUnits><Name>M/S**2</Name></InputUnits><OutputUnits>"
               "<Name>COUNTS</Name></OutputUnits></InstrumentSensitivity></Response></Channel>";
    };
    const auto station = [&](const std::string& channels) {
        return "<FDSNStationXML><Network code=\"XX\"><Station code=\"ABC\">" + channels +
               "</Station></Network></FDSNStationXML>";
    };
    const std::string older = epoch("2010-01-01T00:00:00", "2020-03-22T05:24:00", "100");
    const std::string newer = epoch("2020-03-22T05:24:00.000Z", "2030-01-01T00:00:00", "400");
    const TemporaryFile xml(station(older + newer), "station.xml");
    const Channel channel = read(compose({}, true), {.response = xml.path()}).channels.at(0);
    EXPECT_EQ(channel.unit_in_file, "counts / 400 per m/s2");
    EXPECT_DOUBLE_EQ(channel.samples.at(1), -2.0 / 400);
    EXPECT_EQ(channel.azimuth, 45);
    const TemporaryFile past(station(older), "past.xml");
    const auto reason = [&](const std::filesystem::path& response, const ReadOptions& options) {
        ReadOptions with = options;
        with.response = response;
        try {
            parse_record("x.sac", compose({}, true), with);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    expect_in(reason(past.path(), {}), "0 epochs of channel XX.ABC.00.HNE at 2020-03-22T05:24:00");
    expect_in(reason(xml.path(), in_g()), "both a unit and a response");
    const TemporaryFile twice(station(newer + newer), "twice.xml");
    expect_in(reason(twice.path(), {}), "2 epochs");
    const TemporaryFile zero(station(epoch("2010-01-01", "2030-01-01", "0")), "zero.xml");
    expect_in(reason(zero.path(), {}), "no InstrumentSensitivity");
    const TemporaryFile broken("<FDSNStationXML><Network", "broken.xml");
    expect_in(reason(broken.path(), {}), "broken.xml, byte");
}

}  // namespace

}  // namespace voussoir::records
