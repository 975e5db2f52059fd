// miniSEED: real files in Steim 2, and small ones composed here in the other encodings, with gaps and damage.

#include <gtest/gtest.h>

#include <bit>

#include "tests/records/expected.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

void put(std::string& bytes, std::size_t at, std::uint64_t value, unsigned size)
{
    for (unsigned i = 0; i < size; ++i) bytes[at + i] = static_cast<char>(value >> (8 * (size - 1 - i)));
}

/// A record of 512 bytes at 10 Hz, big endian. @param second of 2020-03-22T00:00, @param tenths of one more
std::string record(const std::string& channel, int second, int tenths, int encoding,
                   const std::vector<double>& data)
{
    std::string bytes(512, '\0');
    bytes.replace(0, 20, "000001D ABC    " + channel + "XX");
    put(bytes, 20, 2020, 2), put(bytes, 22, 82, 2);
    bytes[26] = static_cast<char>(second);
    put(bytes, 28, static_cast<std::uint64_t>(tenths) * 1000, 2);
    put(bytes, 30, data.size(), 2), put(bytes, 32, 10, 2), put(bytes, 34, 1, 2);
    bytes[39] = 1;
    put(bytes, 44, 64, 2), put(bytes, 46, 48, 2);
    put(bytes, 48, 1000, 2), put(bytes, 50, 0, 2);
    bytes[52] = static_cast<char>(encoding), bytes[53] = 1, bytes[54] = 9;
    std::size_t at = 64;
    if (encoding == 10) {  // Steim 1, every difference in a word of its own
        put(bytes, 64, 0x03FFFFFF, 4);
        put(bytes, 68, static_cast<std::uint32_t>(static_cast<std::int32_t>(data.front())), 4);
        put(bytes, 72, static_cast<std::uint32_t>(static_cast<std::int32_t>(data.back())), 4);
        double before = 0;
        at = 76;
        for (const double sample : data) {
            put(bytes, at, static_cast<std::uint32_t>(static_cast<std::int32_t>(sample - before)), 4);
            before = sample, at += 4;
        }
        return bytes;
    }
    for (const double sample : data) {
        const auto whole = static_cast<std::int32_t>(encoding < 4 ? sample : 0);
        if (encoding == 1) put(bytes, at, static_cast<std::uint16_t>(whole), 2), at += 2;
        if (encoding == 3) put(bytes, at, static_cast<std::uint32_t>(whole), 4), at += 4;
        if (encoding == 4) put(bytes, at, std::bit_cast<std::uint32_t>(static_cast<float>(sample)), 4), at += 4;
        if (encoding == 5) put(bytes, at, std::bit_cast<std::uint64_t>(sample), 8), at += 8;
    }
    return bytes;
}

TEST_F(RealRecords, MiniseedFilesAreCounts)
{
    const std::vector<std::string> files = names("mseed");
    EXPECT_GE(files.size(), 3);
    for (const std::string& name : files) {
        const Record record = check(name, {}, "miniSEED");
        EXPECT_EQ(record.channels.at(0).component, expected_[name]["component"].get<std::string>());
        EXPECT_EQ(record.station, "SL.KOGS");
        EXPECT_EQ(record.channels[0].is_vertical, name.find("HNZ") != std::string::npos);
    }
}

TEST_F(RealRecords, TheSensitivityOfTheStationTurnsCountsIntoMotion)
{
    const std::filesystem::path response = data_folder() / "motions/SL.KOGS.xml";
    for (const std::string& name : names("mseed")) {
        const Channel counts = read_record(data_folder() / name, {}).channels.at(0);
        const Record record = read_record(data_folder() / name, {.response = response});
        const Channel& motion = record.channels.at(0);
        if (name.find("HNE") != std::string::npos) {
            EXPECT_EQ(motion.unit_in_file, "counts / 428054 per m/s2");
            EXPECT_EQ(motion.azimuth, 90);
        }
        EXPECT_EQ(motion.quantity, Quantity::acceleration);
        EXPECT_NEAR(peak(motion), peak(counts) / 428054, 5e-3 * peak(motion));  // its three sensors are much alike
        expect_in(record.remarks.back(), "no poles and zeros");
    }
    const std::string at2 = names("peer_at2").front();
    EXPECT_THROW(read_record(data_folder() / at2, {.response = response}), InputError);
}

TEST(Miniseed, ReadsEveryEncodingAndChannel)
{
    const std::vector<double> data{1, -2, 3, 4};
    for (const int encoding : {1, 3, 4, 5, 10}) {
        const Record found = read(record("HNE", 0, 0, encoding, data) + record("HNZ", 0, 0, encoding, data) +
                                  record("HNE", 0, 4, encoding, data));
        ASSERT_EQ(found.channels.size(), 2) << encoding;
        EXPECT_EQ(found.channels[0].component, "XX.ABC..HNE");
        EXPECT_EQ(found.channels[0].samples, (std::vector<double>{1, -2, 3, 4, 1, -2, 3, 4})) << encoding;
        EXPECT_DOUBLE_EQ(found.channels[0].time_step, 0.1);
        EXPECT_FALSE(has_unit(found.channels[0]));
        EXPECT_TRUE(found.channels[1].is_vertical);
    }
}

TEST(Miniseed, PutsRecordsInOrderAndRefusesGapsAndOverlaps)
{
    const std::vector<double> first{1, 2}, second{3, 4};
    EXPECT_EQ(read(record("HNE", 0, 2, 3, second) + record("HNE", 0, 0, 3, first)).channels.at(0).samples,
              (std::vector<double>{1, 2, 3, 4}));
    expect_in(refusal(record("HNE", 0, 0, 3, first) + record("HNE", 3, 2, 3, second)),
              ", byte 512: a gap of 3 s in XX.ABC..HNE at 2020-03-22T00:00:00.2");
    expect_in(refusal(record("HNE", 0, 0, 3, first) + record("HNE", 0, 1, 3, second)), "an overlap of 0.1 s");
}

TEST(Miniseed, RefusesDamage)
{
    const std::string good = record("HNE", 0, 0, 3, {1, 2, 3}) + record("HNE", 0, 3, 3, {1, 2, 3});
    expect_in(refusal(good.substr(0, 900)), ", byte 512: ");
    expect_in(refusal(record("HNE", 0, 0, 4, {1, NAN})), "not a finite number");
    std::string many = record("HNE", 0, 0, 3, {1, 2, 3});
    put(many, 30, 60000, 2);  // announces more samples than a record can hold
    expect_in(refusal(many), ", byte 0: ");
    std::string steim = record("HNE", 0, 0, 10, {1, 2, 3});
    put(steim, 72, 77, 4);  // the last sample, which Steim states to prove itself
    expect_in(refusal(steim), ", byte 0: ");
    std::string still = record("HNE", 0, 0, 3, {1, 2, 3});
    put(still, 32, 0, 2);
    expect_in(refusal(still), "time step = inf s");
    expect_in(refusal("MS\x03 something"), "miniSEED 3");
}

}  // namespace

}  // namespace voussoir::records
