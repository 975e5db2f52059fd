// Reading records: what is read is what the file says, and what cannot be read is refused with file and line.

#include "records/record.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "libdda/errors.h"
#include "records/units.h"
#include "tests/records/test_files.h"

namespace voussoir
{

namespace
{

constexpr double g = 9.80665;

const std::string peer_header =
    "PEER NGA STRONG MOTION DATABASE RECORD\n"
    "Somewhere, 1/2/2003, Station, 067\n"
    "ACCELERATION TIME SERIES IN UNITS OF G\n";

Record read(const std::string& content, const ReadOptions& options = {})
{
    const TemporaryFile file(content);
    return read_record(file.path(), options);
}

/// The faults of a file that must be refused, one line each.
std::string refusal(const std::string& content, const ReadOptions& options = {})
{
    const TemporaryFile file(content);
    try {
        read_record(file.path(), options);
    } catch (const InputError& error) {
        EXPECT_NE(error.faults.front().place.find(file.path().string()), std::string::npos);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << content;
    return "";
}

void expect_in(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in \"" << text << "\"";
}

ReadOptions in_g()
{
    return {.unit = "g", .time_step = {}, .column = {}};
}
ReadOptions in_g(double time_step)
{
    return {.unit = "g", .time_step = time_step, .column = {}};
}

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
    EXPECT_DOUBLE_EQ(motion.displacement(0.01), 0.02);
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
    expect_in(refusal("A\nB\nC\nNPTS= 2, DT= .01 SEC\n .1 .2\n"), ":3: no unit");
    expect_in(refusal("A\nB\nIN UNITS OF FURLONG\nNPTS= 2, DT= .01 SEC\n .1 .2\n"), "unknown unit \"FURLONG\"");
    expect_in(
        refusal(peer_header + "NPTS= 2, DT= .01 SEC\n .1 .2\n", {.unit = "cm/s2", .time_step = {}, .column = {}}),
        "the file is in g but cm/s2");
    expect_in(
        refusal(peer_header + "NPTS= 2, DT= .01 SEC\n .1 .2\n", {.unit = {}, .time_step = 0.02, .column = {}}),
        "0.02 s was asked for");
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
    for (const std::string part :
         {":3: no unit", ":4: time step = 0", ":4: the header announces 9", ":6: not a line"}) {
        expect_in(text, part);
    }
}

TEST(TextTable, ReadsTwoColumns)
{
    const Record record =
        read("A heading\nTime[s] Accel[g]\n# a remark\n0.00\t0.1\n0.02\t-0.3\n0.04\t0.2\n", in_g());
    EXPECT_EQ(record.format, "two-column text");
    ASSERT_EQ(record.channels.size(), 1);
    EXPECT_EQ(record.channels.front().component, "column 2");
    EXPECT_DOUBLE_EQ(record.channels.front().time_step, 0.02);
    EXPECT_DOUBLE_EQ(record.channels.front().samples[1], -0.3 * g);
}

TEST(TextTable, ReadsCommasSemicolonsAndByteOrderMarks)
{
    for (const std::string content :
         {"0,1\n1,2\n2,-3\n", "0; 1\n1; 2\n2; -3\n", "\xEF\xBB\xBF t v\n0 1\n1 2\n2 -3"}) {
        const Record record = read(content, in_g());
        EXPECT_EQ(record.channels.front().samples.size(), 3) << content;
        EXPECT_DOUBLE_EQ(record.channels.front().samples[2], -3 * g) << content;
    }
}

TEST(TextTable, ReadsEveryColumnAfterTimeOrTheOneAskedFor)
{
    const std::string content = "0 1 10 100\n.5 2 20 200\n1 3 30 300\n1.5 4 40 400\n";
    const Record all = read(content, in_g());
    ASSERT_EQ(all.channels.size(), 3);
    EXPECT_EQ(all.channels[2].component, "column 4");
    EXPECT_DOUBLE_EQ(all.channels[2].samples[3], 400 * g);
    const Record one = read(content, {.unit = "m/s2", .time_step = {}, .column = 3});
    ASSERT_EQ(one.channels.size(), 1);
    EXPECT_DOUBLE_EQ(one.channels.front().samples[1], 20);
    EXPECT_DOUBLE_EQ(one.channels.front().time_step, 0.5);
    expect_in(refusal(content, {.unit = "g", .time_step = {}, .column = 5}), "columns 1 to 4");
    expect_in(refusal(content, {.unit = "g", .time_step = {}, .column = 0}), "columns 1 to 4");
}

TEST(TextTable, ReadsValuesOnlyRowByRow)
{
    for (const std::string content : {"1\n2\n3\n4\n5\n", "1 2 3\n4 5\n*** End Data ***\n"}) {
        const Record record = read(content, in_g(0.02));
        EXPECT_EQ(record.format, "values-only text");
        ASSERT_EQ(record.channels.front().samples.size(), 5) << content;
        EXPECT_DOUBLE_EQ(record.channels.front().samples[4], 5 * g);
        EXPECT_DOUBLE_EQ(record.channels.front().time_step, 0.02);
    }
}

TEST(TextTable, NeverGuessesUnitOrTimeStep)
{
    const std::string both = refusal("1\n2\n3\n");
    expect_in(both, "no unit");
    expect_in(both, "no time step");
    expect_in(refusal("0 1\n1 2\n2 3\n"), "no unit");
    expect_in(refusal("0 1\n1 2\n2 3\n", {.unit = "stone", .time_step = {}, .column = {}}), "unit \"stone\"");
    expect_in(refusal("1\n2\n3\n", in_g(0)), "time step = 0 s");
    expect_in(refusal("0 1\n1 2\n2 3\n", in_g(0.5)), "0.5 s was asked for");
}

TEST(TextTable, RefusesUnevenTimesAtTheLineWhereTheyChange)
{
    expect_in(refusal("t a\n0 1\n.01 2\n.02 3\n.04 4\n.05 5\n", in_g()), ":5: time 0.04 s after 0.02 s");
    expect_in(refusal("0 1\n.01 2\n.01 3\n.02 4\n", in_g()), ":3: time 0.01 s after 0.01 s");
    expect_in(refusal("0 1\n.01 2\n-.02 3\n.03 4\n", in_g()), ":3:");
    // A step that creeps, each time by less than can be seen between neighbours.
    std::string creeping;
    double time = 0;
    for (int i = 0; i < 500; ++i) {
        time += 0.01 * (1 + 0.015 * std::sin(i * 0.01));
        creeping += std::to_string(time) + " 1\n";
    }
    expect_in(refusal(creeping, in_g()), "even step");
}

TEST(TextTable, AcceptsTimesRoundedInPrint)
{
    std::string content;
    for (int i = 0; i < 1000; ++i) {
        char line[40];
        std::snprintf(line, sizeof line, "%.4f %d\n", i / 128.0, i);
        content += line;
    }
    EXPECT_NEAR(read(content, in_g()).channels.front().time_step, 1 / 128.0, 1e-7);
}

TEST(TextTable, ColumnAndStepTogetherOverruleTheTimes)
{
    const Record record = read("0 1\n.01 2\n.01 3\n.02 4\n", {.unit = "g", .time_step = 0.005, .column = 2});
    EXPECT_DOUBLE_EQ(record.channels.front().time_step, 0.005);
    EXPECT_EQ(record.channels.front().samples.size(), 4);
}

TEST(TextTable, RefusesDamagedRowsWithLine)
{
    expect_in(refusal("0 1\n1 2\n2\n3 4\n", in_g()), ":3: 1 number where the first row has 2");
    expect_in(refusal("0 1\n1 2\n2 3\n3\n", in_g()), ":4: 1 number where");
    expect_in(refusal("0 1\n1 2x\n2 3\n", in_g()), ":2: not a line of numbers");
    expect_in(refusal("0 1x\n1 2\n2 3\n", in_g()), ":1: not a line of numbers");
    expect_in(refusal("0 1\n1 nan\n2 3\n", in_g()), ":2: nan in column 2");
    expect_in(refusal("0 1\n1 -inf\n2 3\n", in_g()), ":2: -inf in column 2");
    expect_in(refusal("0 1\n1 1e999\n2 3\n", in_g()), ":2: inf in column 2");
    expect_in(refusal("0 1\n***\n1 2\n2 3\n", in_g()), ":2: not a line of numbers");
    expect_in(refusal("0 1\n", in_g()), "1 sample");
}

TEST(TextTable, RefusesDecimalCommas)
{
    expect_in(refusal("0,00 0,1\n0,01 0,2\n0,02 0,3\n", in_g()), "not a record in a format we read");
    expect_in(refusal("0,00;0,1\n0,01;0,2\n0,02;0,3\n", in_g()), "not a record in a format we read");
    expect_in(refusal("0,12\n0,15\n0,11\n", in_g()), ":2: time 0 s after 0 s");
}

TEST(TextTable, OneDamagedTimeDoesNotTurnTimesIntoSamples)
{
    std::string content;
    for (int i = 0; i < 40; ++i) {
        content += std::to_string(i == 20 ? 3 : 0.01 * i) + " 1 2\n";
    }
    expect_in(refusal(content, in_g(0.01)), ":22: time");
}

TEST(TextTable, NamesTheFirstFaultsAndCountsTheRest)
{
    std::string content = "0 1\n";
    for (int i = 0; i < 5000; ++i) content += "bad\n";
    const std::string text = refusal(content, in_g());
    expect_in(text, "more faults");
    EXPECT_LT(text.size(), 5000);
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

}  // namespace voussoir
