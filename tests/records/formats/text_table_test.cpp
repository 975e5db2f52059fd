// Text tables: columns, separators, times and everything a table can get wrong.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

constexpr double g = 9.80665;

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

/// North, east and up, row by row, would be one series of nonsense.
TEST(TextTable, DoesNotStirThreeComponentsIntoOneSeries)
{
    const std::string content = "NS,EW,UD\n1,10,100\n2,20,200\n0,30,300\n";
    expect_in(refusal(content, in_g(0.01)), ":2: three numbers on every line and no time");
    const Record record = read(content, {.unit = "m/s2", .time_step = 0.01, .column = 2});
    EXPECT_EQ(record.channels.at(0).samples, (std::vector<double>{10, 20, 30}));
}

TEST(TextTable, DoesNotTakeAnIndexForTheTime)
{
    expect_in(refusal(",Time (s),Acc\n0,0.00,.1\n1,0.01,.2\n2,0.02,.3\n", in_g()), "calls column 2 the time");
    expect_in(refusal("\tt\ta\n0\t0.00\t.1\n1\t0.01\t.2\n2\t0.02\t.3\n", in_g()), "calls column 2 the time");
    EXPECT_EQ(read("Time,x,timely\n0,1,2\n1,2,3\n2,3,4\n", in_g()).channels.size(), 2);
}

TEST(TextTable, SaysThatNoUnitIsTakenFromTheHeading)
{
    const Record record = read("Time (s), Acc (g)\n0,1\n1,2\n");
    EXPECT_FALSE(has_unit(record.channels.at(0)));
    expect_in(record.remarks.at(0), "\"Time (s), Acc (g)\", but no unit is taken");
    EXPECT_TRUE(read("Time (s), Acc (g)\n0,1\n1,2\n", in_g()).remarks.empty());
    EXPECT_TRUE(read("0,1\n1,2\n").remarks.empty());
}

TEST(TextTable, TellsACountAndAStepAboveTheValuesInOneSentence)
{
    const std::string faults = refusal("5 0.01\n1\n2\n3\n4\n", in_g(0.01));
    expect_in(faults, ":1: 2 numbers where every other line has 1");
    EXPECT_EQ(faults.find(":2:"), std::string::npos);
}

TEST(TextTable, NeverGuessesUnitOrTimeStep)
{
    expect_in(refusal("1\n2\n3\n"), "no time step");
    EXPECT_FALSE(has_unit(read("0 1\n1 2\n2 3\n").channels.at(0)));
    EXPECT_FALSE(has_unit(read("1\n2\n3\n", {.time_step = 0.01}).channels.at(0)));
    expect_in(refusal("0 1\n1 2\n2 3\n", {.unit = "stone"}), "unit \"stone\"");
    expect_in(refusal("1\n2\n3\n", in_g(0)), "time step = 0 s");
    expect_in(refusal("0 1\n1 2\n2 3\n", in_g(0.5)), "0.5 s was asked for");
}

TEST(TextTable, KeepsUnevenTimesAndTellsWhereTheyChange)
{
    const Record record = read("t a\n0 1\n.01 2\n.02 3\n.04 4\n.05 5\n", in_g());
    const Channel& channel = record.channels.at(0);
    EXPECT_EQ(channel.time_step, 0);
    EXPECT_EQ(channel.times, (std::vector<double>{0, 0.01, 0.02, 0.04, 0.05}));
    EXPECT_EQ(channel.samples.size(), 5);
    expect_in(record.remarks.at(0), ":5 (mean step 0.0125 s)");
    EXPECT_DOUBLE_EQ(to_ground_motion(channel, "x").duration(), 0.05);
    // A step that creeps, each time by less than can be seen between neighbours.
    std::string creeping;
    double time = 0;
    for (int i = 0; i < 500; ++i) {
        time += 0.01 * (1 + 0.015 * std::sin(i * 0.01));
        creeping += std::to_string(time) + " 1\n";
    }
    EXPECT_EQ(read(creeping, in_g()).channels.at(0).times.size(), 500);
    expect_in(refusal("0 1\n.01 2\n.03 3\n", in_g(0.015)), ":3: time 0.03 s after 0.01 s");
}

TEST(TextTable, RefusesTimesThatDoNotIncrease)
{
    expect_in(refusal("0 1\n.01 2\n.01 3\n.02 4\n", in_g()), ":3: time 0.01 s after 0.01 s");
    expect_in(refusal("0 1\n.01 2\n-.02 3\n.03 4\n", in_g()), ":3:");
}

TEST(TextTable, RefusesResponseSpectraByTheirHeading)
{
    for (const std::string heading :
         {"Period (s)  Sa (g)\n", "# Response spectrum\n", "T, PSA\n", "5% damping\nperiod value\n",
          "PEER DATABASE SPECTRUM.\nNO FREQ RD RV PRV AA PAA MAG PER\n"})
        expect_in(refusal(heading + "0.1 1\n0.2 2\n0.3 3\n", in_g()), "response spectra, not a time history");
    for (const std::string heading :
         {"time (s)  Sa-matched, 5% damping\n", "Frequency range: 0.12-23 Hz\n", "t a\n",
          "Instrument: natural period 0.05 s, damping 0.6\n", "frequency 25 Hz, damping 0.65\n"})
        EXPECT_EQ(read(heading + "0.1 1\n0.2 2\n0.3 3\n", in_g()).channels.size(), 1) << heading;
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
    expect_in(refusal("0,00 0,1\n0,01 0,2\n0,02 0,3\n", in_g()), ":1: numbers with decimal commas");
    expect_in(refusal("0,00;0,1\n0,01;0,2\n0,02;0,3\n", in_g()), ":1: numbers with decimal commas");
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

TEST(TextTable, TakesTheCountAndTheStepOfTheFirstLine)
{
    for (const std::string rows : {"0.1\n-0.3\n0.2\n0.4\n", "0.1 -0.3 0.2\n0.4\n", "0.1 -0.3\n0.2 0.4\n"}) {
        const Record record = read("4 0.005\n" + rows, in_g());
        ASSERT_EQ(record.channels.size(), 1) << rows;
        EXPECT_EQ(record.channels.front().time_step, 0.005);
        ASSERT_EQ(record.channels.front().samples.size(), 4);
        EXPECT_DOUBLE_EQ(record.channels.front().samples[1], -0.3 * g);
    }
    const Record table = read("4 0.005\n5 0.1\n6 0.2\n", in_g());  // times 4, 5 and 6 s
    EXPECT_EQ(table.channels.front().time_step, 1);
    expect_in(refusal("5 0.005\n0.1\n-0.3\n0.2\n0.4\n", in_g()), "so many samples must follow");
}

TEST(TextTable, NamesTheFirstFaultsAndCountsTheRest)
{
    std::string content = "0 1\n";
    for (int i = 0; i < 5000; ++i) content += "bad\n";
    const std::string text = refusal(content, in_g());
    expect_in(text, "more faults");
    EXPECT_LT(text.size(), 5000);
}

}  // namespace

}  // namespace voussoir::records
