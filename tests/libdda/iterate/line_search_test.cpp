// The one rule by which all stones, and single ones, go along a direction.
#include "libdda/iterate/line_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir::step
{

namespace
{

struct Found {
    Reach reach;
    double slope = 0;  // last evaluated
    int evaluations = 0;
};

template <class Slope>
Found search(const Slope& slope)
{
    Found found;
    found.reach = line_search(slope(0.0), IterationRules().of_all, [&](double s) {
        ++found.evaluations;
        return found.slope = slope(s);
    });
    return found;
}

}  // namespace

TEST(LineSearch, GoesTheWholeWayWhereItLeadsToBalance)
{
    const Found found = search([](double s) { return s - 1; });
    EXPECT_TRUE(found.reach.is_found);
    EXPECT_EQ(found.reach.low, 1);
    EXPECT_EQ(found.evaluations, 1);
}

// A stone that is stopped by another after a tenth of its way.
TEST(LineSearch, FindsTheCornerWhereAContactCloses)
{
    const Found found = search([](double s) { return -1 + 0.1 * s + 100 * std::max(s - 0.1, 0.0); });
    EXPECT_TRUE(found.reach.is_found);
    EXPECT_LE(std::abs(found.slope), 0.5);
    EXPECT_NEAR(found.reach.low, 0.11, 0.005);
    EXPECT_EQ(found.reach.low, found.reach.high);
}

TEST(LineSearch, StopsShortOfWhereABlockInverts)
{
    const Found found =
        search([](double s) { return s > 0.3 ? std::numeric_limits<double>::infinity() : -1 + 2 * s; });
    EXPECT_TRUE(found.reach.is_found);
    EXPECT_LE(found.reach.low, 0.3);
    EXPECT_LE(std::abs(found.slope), 0.5);
}

// Where no share of the direction brings balance the two ends lie on either side of the jump.
TEST(LineSearch, TellsBetweenWhichTheForcesTurn)
{
    const Found found = search([](double s) { return s < 0.4 ? -1.0 : 1.0; });
    EXPECT_FALSE(found.reach.is_found);
    EXPECT_LT(found.reach.low, 0.4);
    EXPECT_GE(found.reach.high, 0.4);
    EXPECT_LT(found.reach.high - found.reach.low, 1e-3);
    EXPECT_EQ(found.evaluations, IterationRules().of_all.most_evaluations);
}

}  // namespace voussoir::step
