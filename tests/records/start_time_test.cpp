// Components that do not begin at the same moment.

#include "records/start_time.h"

#include <gtest/gtest.h>

#include <cmath>

#include "records/processing/processing.h"
#include "tests/records/channels.h"
#include "tests/records/expected.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

using std::chrono::microseconds;

Channel starting(const char* instant, const std::string& component, std::vector<double> samples,
                 double time_step = 0.5)
{
    Channel channel = of_samples(std::move(samples), time_step, component);
    channel.start = parse_instant(instant);
    EXPECT_TRUE(channel.start.has_value()) << instant;
    return channel;
}

std::string knet(const std::string& record_time)
{
    return "Record Time       " + record_time +
           "\nSampling Freq(Hz) 2Hz\nDuration Time(s)  2\nDir.              N-S\nScale Factor      100(gal)/200\n"
           "1 2 3 4\n";
}

TEST(StartTime, IsReadAsHeadersWriteIt)
{
    const Instant instant = std::chrono::sys_days(std::chrono::year(2009) / 4 / 6) + std::chrono::hours(1) +
                            std::chrono::minutes(32) + std::chrono::milliseconds(40500);
    for (const char* text : {"2009/04/06 01:32:40.5", "20090406_013240.500", "2009-04-06T01:32:40.5"})
        EXPECT_EQ(parse_instant(text), instant) << text;
    EXPECT_EQ(to_text(instant), "2009-04-06T01:32:40");
    for (const char* text : {"", "2009", "2009/13/06 01:32:40", "2009/02/30 01:32:40", "2009/04/06 25:32:40",
                             "2009/04/06 01:32", "2009/04/06 01:32:nan", "2009/04/06 01:32:1e99", "x"})
        EXPECT_FALSE(parse_instant(text)) << text;
}

TEST(StartTime, IsUtcOfTheFirstSample)
{
    // Record Time is 15 s after the first sample and on Japan's clocks, 9 h ahead.
    EXPECT_EQ(read(knet("2020/01/02 03:04:30")).channels.at(0).start, parse_instant("2020/01/01 18:04:15"));
    EXPECT_FALSE(read(knet("")).channels.at(0).start);
    const Record dyna = read(
        "STATION_CODE: NCR\nSAMPLING_INTERVAL_S: 0.01\nNDATA: 2\nSTREAM: HNE\nUNITS: cm/s^2\n"
        "DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20190728_160919.870\nDATA_TYPE: ACCELERATION\n 1\n 2\n");
    EXPECT_EQ(dyna.channels.at(0).start, parse_instant("2019-07-28T16:09:19.87"));
}

std::vector<Channel> channels_of(const std::vector<std::string>& files)
{
    std::vector<Channel> channels;
    for (const std::string& file : files)
        for (const Channel& channel : read_record(data_folder() / file, {}).channels) channels.push_back(channel);
    return channels;
}

TEST_F(RealRecords, ComponentsCutByTheDataCentreBeginTogether)
{
    std::vector<Channel> channels = channels_of(names("esm_dyna"));
    ASSERT_EQ(channels.size(), 3);
    for (const Channel& channel : channels)
        EXPECT_EQ(channel.start, parse_instant("2019-07-28T16:09:19.87")) << channel.component;
    EXPECT_TRUE(bring_into_step(channels).empty());
}

/// A digitizer closes its packets when they are full: the files of one request begin up to 1.2 s apart.
TEST_F(RealRecords, ComponentsInPacketsAreBroughtIntoStep)
{
    std::vector<Channel> channels = channels_of(names("mseed"));
    ASSERT_EQ(channels.size(), 3);
    EXPECT_EQ(bring_into_step(channels).size(), 2);
    for (const Channel& channel : channels) {
        const std::chrono::duration<double> apart = *channel.start - *channels.front().start;
        EXPECT_LT(std::abs(apart.count()), channel.time_step / 2) << channel.component;
    }
}

TEST(StartTime, ComponentsAreCutToTheirCommonBeginning)
{
    const Channel first = starting("2020/01/01 00:00:00", "x", {1, 2, 3, 4, 5, 6});
    const Channel second = starting("2020/01/01 00:00:01", "y", {3, 4, 5, 6});
    const processing::ProcessedRecord together = processing::process({first, second}, {});
    EXPECT_EQ(together.channels[0].samples, second.samples);
    EXPECT_EQ(together.channels[1].samples, second.samples);
    ASSERT_EQ(together.sentences.size(), 1);
    EXPECT_EQ(together.sentences[0],
              "component \"x\": 1 s cut, to start with the last component at 2020-01-01T00:00:01");
    EXPECT_TRUE(processing::process(together.channels, {}).sentences.empty()) << "already in step";
    // A window does not lose the start.
    const processing::ProcessedRecord later = processing::process({first}, {processing::TimeWindow{1, 2}});
    EXPECT_EQ(later.channels[0].start, second.start);
}

TEST(StartTime, IsMetAtTheNearestSampleAndTheRestIsTold)
{
    std::vector<Channel> channels{starting("2020/01/01 00:00:00", "x", {1, 2, 3, 4, 5, 6}),
                                  starting("2020/01/01 00:00:00.9", "y", {3, 4, 5, 6})};
    const std::vector<std::string> sentences = bring_into_step(channels);
    EXPECT_EQ(channels[0].samples.front(), 3);  // at 1.0 s, nearer to 0.9 than 0.5
    ASSERT_EQ(sentences.size(), 1);
    expect_in(sentences[0], "1 s cut");
    expect_in(sentences[0], "0.1 s late of it");
}

TEST(StartTime, ThatNobodyKnowsIsToldWhenItMatters)
{
    const Channel known = starting("2020/01/01 00:00:00", "x", {1, 2, 3});
    const Channel unknown = of_samples({1, 2, 3}, 0.5, "y"), longer = of_samples({1, 2, 3, 4}, 0.5, "z");
    EXPECT_TRUE(processing::process({unknown, unknown}, {}).sentences.empty());
    for (const Channel& other : {known, longer}) {
        const processing::ProcessedRecord record = processing::process({other, unknown}, {});
        ASSERT_EQ(record.sentences.size(), 1);
        expect_in(record.sentences[0], "\"y\" have no start time");
        EXPECT_EQ(record.channels[0].samples, other.samples);
    }
}

TEST(StartTime, OfRecordsWithoutACommonMomentIsRefused)
{
    std::vector<Channel> channels{starting("2020/01/01 00:00:00", "x", {1, 2, 3}),
                                  starting("2020/01/01 00:00:01", "y", {3, 4, 5, 6})};
    try {
        bring_into_step(channels);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        expect_in(error.what(), "component \"x\": begins at 2020-01-01T00:00:00 and ends before another begins");
    }
    // Instants as far apart as a damaged header can put them.
    channels[0].start = Instant(microseconds::min());
    channels[1].start = Instant(microseconds::max());
    EXPECT_THROW(bring_into_step(channels), InputError);
}

TEST(StartTime, WindowsSayWhichComponentsEndEarly)
{
    const processing::ProcessedRecord record = processing::process(
        {of_samples({1, 2, 3}, 1, "x"), of_samples({1, 2, 3, 4, 5}, 1, "y")}, {processing::TimeWindow{1, 4}});
    expect_in(record.sentences.back(), "window 1 to 4 s: component \"x\" ends at 2 s");
}

}  // namespace

}  // namespace voussoir::records
