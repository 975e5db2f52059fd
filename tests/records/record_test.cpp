// Reading records: what is read is what the file says, and what cannot be read is refused with file and line.

#include "records/record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "libdda/errors.h"
#include "records/units.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

constexpr double g = 9.80665;

const std::string peer_header =
    "PEER NGA STRONG MOTION DATABASE RECORD\n"
    "Somewhere, 1/2/2003, Station, 067\n"
    "ACCELERATION TIME SERIES IN UNITS OF G\n";

TEST(PeerAt2, ReadsSamplesStepUnitAndComponent)
{
    const Record record =
        read(peer_header + "NPTS=   7, DT=   .0050 SEC,   \n  .1E+00 -.2E+00 1.5 0 -3\n .25 4E-1\n");
    ASSERT_EQ(record.channels.size(), 1);
    const Channel& channel = record.channels.front();
    EXPECT_EQ(record.format, "PEER AT2");
    EXPECT_EQ(channel.component, "067");
    EXPECT_EQ(channel.quantity, Quantity::acceleration);
    EXPECT_EQ(channel.unit_in_file, "g");
    EXPECT_DOUBLE_EQ(channel.time_step, 0.005);
    ASSERT_EQ(channel.samples.size(), 7);
    EXPECT_DOUBLE_EQ(channel.samples[1], -0.2 * g);
    EXPECT_DOUBLE_EQ(channel.samples[6], 0.4 * g);
    EXPECT_DOUBLE_EQ(peak(channel), 3 * g);
}

TEST(PeerAt2, ReadsEveryStyleOfItsCountLineAndOfItsLineEnds)
{
    for (const std::string count : {"NPTS=  2, DT= .01000 SEC", "2    0.0100    NPTS, DT", "NPTS=2,DT=.01",
                                    "npts= 2, dt= 1e-2 sec,", "  2  .01  NPTS, DT, SEC"}) {
        for (const char* end : {"\n", "\r\n", "\r\r\n"}) {
            std::string content;
            for (const std::string& line :
                 {std::string("A"), std::string("B, X"), std::string("IN UNITS OF G. FILTER POINTS: HP=0.2 Hz"),
                  count, std::string(" .1 .2")}) {
                content += line;
                content += end;
            }
            const Record record = read(content);
            EXPECT_DOUBLE_EQ(record.channels.front().time_step, 0.01) << count;
            EXPECT_DOUBLE_EQ(record.channels.front().samples[1], 0.2 * g) << count;
        }
    }
}

TEST(PeerAt2, ReadsVelocityAndDisplacementByTheirUnit)
{
    const Record velocity = read("A\nB, X\nVELOCITY TIME SERIES IN UNITS OF CM/SEC\nNPTS= 2, DT= .01 SEC\n 1 2\n");
    EXPECT_EQ(velocity.channels.front().quantity, Quantity::velocity);
    EXPECT_DOUBLE_EQ(velocity.channels.front().samples[1], 0.02);
    const Record displacement =
        read("A\nB, X\nDISPLACEMENT TIME SERIES IN UNITS OF CM\nNPTS= 2, DT= .01 SEC\n1 2\n");
    EXPECT_EQ(displacement.channels.front().quantity, Quantity::displacement);
    const GroundMotion motion = to_ground_motion(displacement.channels.front(), "x");
    EXPECT_DOUBLE_EQ(motion.displacement(0.01), 0.01) << "counted from its first sample";
}

TEST(PeerAt2, ReadsNumbersThatTouchAndFortranDoubles)
{
    const Record record = read(peer_header + "NPTS= 4, DT= .01 SEC\n-1.0E-01-2.0E-01 3.0D-01-4.0D-01\n");
    ASSERT_EQ(record.channels.front().samples.size(), 4);
    EXPECT_DOUBLE_EQ(record.channels.front().samples[1], -0.2 * g);
    EXPECT_DOUBLE_EQ(record.channels.front().samples[3], -0.4 * g);
}

TEST(PeerAt2, RefusesWithLine)
{
    expect_in(refusal(peer_header + "NPTS= 4, DT= .01 SEC\n .1 .2 .3\n"),
              ":4: the header announces 4 samples but");
    expect_in(refusal(peer_header + "NPTS= 2, DT= .01 SEC\n .1 .2 .3\n"), "holds 3");
    expect_in(refusal(peer_header + "NPTS= 2, DT= 0 SEC\n .1 .2\n"), ":4: time step = 0 s");
    expect_in(refusal(peer_header + "NPTS= 2, DT= -.01 SEC\n .1 .2\n"), "must be finite and greater than 0");
    expect_in(refusal(peer_header + "NPTS= 2, DT= 10 MSEC\n .1 .2\n"), ":4:");
    expect_in(refusal(peer_header + "NPTS= many, DT= .01 SEC\n .1 .2\n"), ":4:");
    expect_in(refusal(peer_header + "NPTS= 3, DT= .01 SEC\n .1\n nan .2\n"), ":6: sample nan");
    expect_in(refusal(peer_header + "NPTS= 3, DT= .01 SEC\n .1\n .2 inf\n"), ":6: sample inf");
    expect_in(refusal(peer_header + "NPTS= 3, DT= .01 SEC\n .1 *****\n .2\n"), ":5: not a line of numbers");
    expect_in(refusal(peer_header + "NPTS= 2, DT= .01 SEC\n .1 .2\n", {.unit = "cm/s2"}),
              "the file is in g but cm/s2");
    expect_in(refusal(peer_header + "NPTS= 2, DT= .01 SEC\n .1 .2\n", {.time_step = 0.02}),
              "0.02 s was asked for");
}

TEST(PeerAt2, WithoutAUnitIsListedAsStoredAndMovesNothing)
{
    for (const std::string line : {"C", "IN UNITS OF FURLONG"}) {
        const Record record = read("A\nB\n" + line + "\nNPTS= 2, DT= .01 SEC\n .1 .2\n");
        EXPECT_FALSE(has_unit(record.channels.at(0)));
        EXPECT_EQ(record.channels[0].samples, (std::vector<double>{0.1, 0.2}));
        EXPECT_THROW(to_ground_motion(record.channels[0], "A"), InputError);
    }
}

TEST(PeerAt2, RefusesAHugeAnnouncedCountWithoutMakingRoomForIt)
{
    expect_in(refusal(peer_header + "NPTS= 10000000000, DT= .01 SEC\n .1 .2\n"), "10000000000 samples but");
    expect_in(refusal(peer_header + "NPTS= 1e300, DT= .01 SEC\n .1 .2\n"), "announces 1e+300 samples");
    expect_in(refusal(peer_header + "NPTS= -5, DT= .01 SEC\n .1 .2\n"), "announces -5 samples");
}

TEST(PeerAt2, NamesEveryFaultAtOnce)
{
    const std::string text = refusal("A\nB\nC\nNPTS= 9, DT= 0 SEC\n .1 .2\n x\n");
    for (const std::string part : {":4: time step = 0", ":4: the header announces 9", ":6: not a line"}) {
        expect_in(text, part);
    }
}

TEST(CorrectedAcc, ReadsAndChecksItsHeader)
{
    const std::string header =
        "Orientation                   : NS\n"
        "Time Increment (s)            : 0.005\n"
        "Number of Data                : 4\n";
    const std::string samples = "Accelaration time series in m/s/s\n-1.0E-01 2.0E-01-3.0E-01\n 1.5E-01\n";
    const Record record = read(header + "PGA (m/s/s) : 3.0E-01\n" + samples);
    EXPECT_EQ(record.channels.front().component, "NS");
    EXPECT_EQ(record.channels.front().azimuth, 0);
    EXPECT_EQ(record.channels.front().samples.size(), 4);
    EXPECT_DOUBLE_EQ(record.channels.front().samples[2], -0.3);
    EXPECT_DOUBLE_EQ(record.channels.front().time_step, 0.005);
    expect_in(refusal(header + "PGA (m/s/s) : 3.1E-01\n" + samples), ":4: the header announces a peak of 0.31");
    expect_in(refusal(header + samples + " 1.0E-01\n"), "holds 5");
}

TEST(ReadRecord, RefusesWhatIsNoRecord)
{
    expect_in(refusal(""), "the file is empty");
    expect_in(refusal("\n\n\n"), "a text without a line of numbers");
    expect_in(refusal("once upon a time\n"), "a text without a line of numbers");
    expect_in(refusal(std::string("0 1\n1 2\n\0\1\2", 11), in_g()), "binary content");
    const std::filesystem::path folder = testing::TempDir();
    EXPECT_THROW(read_record(folder, {}), InputError);
    EXPECT_THROW(read_record(folder / "no_such_record.at2", {}), InputError);
    EXPECT_THROW(read_record("/dev/zero", in_g(0.01)), InputError);
}

TEST(ReadRecord, RandomBytesAreRefused)
{
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        std::string bytes(1 + random() % 3000, ' ');
        for (char& byte : bytes) byte = static_cast<char>(random());
        const TemporaryFile file(bytes);
        EXPECT_THROW(read_record(file.path(), in_g(0.01)), InputError);
    }
}

TEST(ReadRecord, AnyCutOrChangedByteIsReadOrRefusedButNeverACrash)
{
    const std::string good = peer_header + "NPTS= 6, DT= .01 SEC\n .1E+00 .2 .3\n .4 .5 .6\n";
    std::mt19937 random(2);
    int refused = 0;
    for (std::size_t length = 1; length < good.size(); ++length) {
        std::string changed = good;
        changed[random() % changed.size()] = static_cast<char>(random() % 128);
        for (const std::string& content : {good.substr(0, length), changed}) {
            const TemporaryFile file(content);
            try {
                const Record record = read_record(file.path(), {});
                for (const double sample : record.channels.front().samples) EXPECT_TRUE(std::isfinite(sample));
            } catch (const InputError&) {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, static_cast<int>(good.size()) - 4);  // every cut but those of the last digits' line end
}

TEST(Units, AreFoundByTheirUsualSpellings)
{
    for (const char* spelling : {"cm/s2", "CM/SEC2", "cm/sec/sec", "cm / s^2", "cm/s**2", "gal", "Gals"}) {
        ASSERT_TRUE(find_unit(spelling)) << spelling;
        EXPECT_EQ(find_unit(spelling)->quantity, Quantity::acceleration);
        EXPECT_DOUBLE_EQ(find_unit(spelling)->factor, 0.01);
    }
    EXPECT_DOUBLE_EQ(find_unit("G")->factor, 9.80665);
    EXPECT_EQ(find_unit("mm")->quantity, Quantity::displacement);
    EXPECT_EQ(find_unit("m/s")->quantity, Quantity::velocity);
    EXPECT_FALSE(find_unit(""));
    EXPECT_FALSE(find_unit("km"));
    EXPECT_FALSE(find_unit("counts"));
}

}  // namespace

}  // namespace voussoir::records
