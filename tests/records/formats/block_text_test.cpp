// Corrected records as text: blocks of numbers of fixed width below titles in words.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/records/formats/composed.h"
#include "tests/records/reading.h"

namespace voussoir::records
{

namespace
{

// The second and third number touch, as wide ones do.
const std::vector<double> accelerations = {0.12, -1.325, -101.255, 250, -0.5, 3, 4, 5, 6, 7, 8, -200.125};

const std::string three_blocks =
    "CORRECTED ACCELEROGRAM   STATION 12   COMPONENT N10W\n"
    "12 POINTS AT EQUAL INTERVALS OF .020 SECONDS\n"
    "12 ACCELERATION VALUES IN CM/SEC/SEC\n" +
    in_lines(accelerations, 10, "%8.3f") + "12 VELOCITY VALUES IN CM/SEC\n" +
    in_lines(std::vector<double>(12, 1.5), 10, "%8.3f") + "12 DISPLACEMENT VALUES IN CM\n" +
    in_lines(std::vector<double>(12, 2.5), 10, "%8.3f");

}  // namespace

TEST(BlockText, TakesUnitStepAndAccelerationFromTheWords)
{
    const Record record = read(three_blocks);
    ASSERT_EQ(record.channels.size(), 1U);
    const Channel& channel = record.channels.front();
    EXPECT_EQ(channel.quantity, Quantity::acceleration);
    EXPECT_DOUBLE_EQ(channel.time_step, 0.02);
    ASSERT_EQ(channel.samples.size(), accelerations.size());
    for (std::size_t i = 0; i < accelerations.size(); ++i)
        EXPECT_NEAR(channel.samples[i], 0.01 * accelerations[i], 1e-15 + 1e-15 * std::abs(accelerations[i]));
    ASSERT_EQ(record.remarks.size(), 1U);
    expect_in(record.remarks.front(), "2 series of velocity or displacement");
}

TEST(BlockText, StepMayComeFromTheUserWhereTheFileHasNone)
{
    const std::string text = with(three_blocks, "12 POINTS AT EQUAL INTERVALS OF .020 SECONDS\n", "");
    expect_in(refusal(text), "no time step");
    EXPECT_DOUBLE_EQ(read(text, {.time_step = 0.01}).channels.front().time_step, 0.01);
    expect_in(refusal(three_blocks, in_g()), "the file is in cm/s2 but g was asked for");
}

TEST(BlockText, DamagedRowsAreRefusedWithTheirLine)
{
    expect_in(refusal(with(three_blocks, "250.000", "25x.000")), "announces");
    expect_in(refusal(with(three_blocks, "12 ACC", "13 ACC")), "announces");
    expect_in(refusal(with(three_blocks, "0.120", "O.I20")), "announces");  // not the velocity instead
    expect_in(refusal(with(three_blocks, "VALUES IN CM\n", "VALUES\n")), "without the unit");
    // Without a count only the words themselves can tell.
    const std::string uncounted = with(three_blocks, "12 ACC", "ACC");
    EXPECT_EQ(read(uncounted).channels.front().samples.size(), accelerations.size());
    expect_in(refusal(with(uncounted, "8.000-200.125", "8.000-2x0.125")), ":5: ");
}

}  // namespace voussoir::records
