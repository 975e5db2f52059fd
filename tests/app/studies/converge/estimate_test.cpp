// Order, extrapolation and their refusal on series that are made up.
#include "app/studies/converge/estimate.h"

#include <gtest/gtest.h>

#include <cmath>

namespace voussoir::app::studies::converge
{
namespace
{

std::vector<Sample> scalars(const std::vector<double>& values)
{
    std::vector<Sample> samples;
    for (const double value : values) samples.push_back(Sample::Constant(1, 1, value));
    return samples;
}

/// 3 + c h^p + d h^q at every step.
std::vector<Sample> series_of(const std::vector<double>& steps, double c, double p, double d = 0, double q = 1)
{
    std::vector<double> values;
    for (const double h : steps) values.push_back(3 + c * std::pow(h, p) + d * std::pow(h, q));
    return scalars(values);
}

const std::vector<double> halved{4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4};

TEST(Estimate, RecoversAKnownOrderAndTheLimit)
{
    for (const std::vector<double>& steps :
         {halved, std::vector<double>{5e-3, 2e-3, 1e-3}, {1e-2, 3e-3, 2e-3, 1e-4}})
        for (const double order : {1.0, 2.0}) {
            const Estimate found = estimate(series_of(steps, -40, order), steps);
            ASSERT_TRUE(found.order) << found.no_order;
            EXPECT_NEAR(*found.order, order, 1e-6);
            EXPECT_NEAR(found.reference(0, 0), 3, 1e-8);
            for (std::size_t i = 0; i < steps.size(); ++i)
                EXPECT_NEAR(found.errors[i], 40 * std::pow(steps[i], order) / 3, 1e-8);
        }
}

// What is left of the next order lies within the stated uncertainty.
TEST(Estimate, IsAsUncertainAsItSays)
{
    for (const double next : {-5e3, -1e3, 1e3, 5e3}) {
        const Estimate found = estimate(series_of(halved, 40, 1, next, 2), halved);
        ASSERT_TRUE(found.order) << found.no_order;
        EXPECT_NEAR(*found.order, 1, 0.2);
        EXPECT_LT(std::abs(found.reference(0, 0) - 3) / 3, found.uncertainty);
        EXPECT_LT(found.uncertainty, found.errors.back());
    }
}

TEST(Estimate, OfThreeRunsIsUncertainByTheWholeCorrection)
{
    const std::vector<double> steps{4, 2, 1};
    const Estimate found = estimate(scalars({7, 5, 4}), steps);
    ASSERT_TRUE(found.order);
    EXPECT_NEAR(found.reference(0, 0), 3, 1e-9);
    EXPECT_NEAR(found.uncertainty, 1.0 / 3, 1e-9);
}

TEST(Estimate, RefusesWhatShowsNoOrder)
{
    const auto reason = [](const std::vector<double>& values) {
        const std::vector<double> steps(halved.begin(),
                                        halved.begin() + static_cast<std::ptrdiff_t>(values.size()));
        const Estimate found = estimate(scalars(values), steps);
        EXPECT_FALSE(found.order);
        EXPECT_EQ(found.reference(0, 0), values.back());
        EXPECT_EQ(found.errors.back(), 0);
        return found.no_order;
    };
    EXPECT_EQ(reason({1, 2, 1.5, 1.75}), "the differences change sign");
    EXPECT_EQ(reason({1, 2, 2.5, 3.5}), "the differences do not decrease");
    EXPECT_EQ(reason({1, 2, 2.9, 3.7}), "the differences hardly decrease");
    EXPECT_EQ(reason({1, 9, 9.9, 9.9001}), "the differences decrease faster than order 6");
    EXPECT_EQ(reason({1, 2, 2.2, 2.3}), "the order changes from 2.32 to 1.00");
    EXPECT_EQ(reason({2, 2, 2, 2}), "the runs agree to rounding");
    EXPECT_EQ(reason({1, 2}), "an order requires three runs");
}

// Three times the last difference at a ratio of 2, more at a smaller one, and no less than the difference before.
TEST(Estimate, WithoutAnOrderIsCautious)
{
    EXPECT_NEAR(estimate(scalars({1, 3, 2, 2.5}), {8, 4, 2, 1}).uncertainty, 3 * 0.5 / 2.5, 1e-12);
    EXPECT_NEAR(estimate(scalars({2, 2.5}), {1.5, 1}).uncertainty, 3 * 0.5 / 0.5 / 2.5, 1e-12);
    EXPECT_NEAR(estimate(scalars({1, 3, 2, 2.1}), {8, 4, 2, 1}).uncertainty, 1 / 2.1, 1e-12);
    EXPECT_TRUE(std::isinf(estimate(scalars({1}), {1}).uncertainty));
}

TEST(Estimate, DoesNotReadAnOrderOutOfTheResolution)
{
    const std::vector<double> steps{4, 2, 1};
    const Estimate found = estimate(scalars({7, 5, 4}), steps, 1.5);
    EXPECT_FALSE(found.order);
    EXPECT_NEAR(found.uncertainty, 3 / 4.0, 1e-12);
    EXPECT_NEAR(estimate(scalars({4, 4, 4}), steps, 1.5).uncertainty, 0.75 / 4, 1e-12);
}

TEST(Estimate, OfAQuantityThatIsZeroIsZero)
{
    const Estimate found = estimate(scalars({0, 0, 0}), {4, 2, 1});
    EXPECT_EQ(found.errors, (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(found.uncertainty, 0);
}

TEST(Estimate, OfAFinestRunThatIsZeroIsFinite)
{
    const Estimate found = estimate(scalars({1, -2, 0}), {4, 2, 1});
    EXPECT_FALSE(found.order);
    EXPECT_TRUE(found.vanishes);
    EXPECT_EQ(found.errors, (std::vector<double>{0.5, 1, 0}));
    EXPECT_NEAR(found.uncertainty, 3, 1e-12);
}

/// (3 x times): (sin t, h^p cos t, 0).
Sample history(double h, double order)
{
    Sample sample = Sample::Zero(3, 60);
    for (int i = 0; i < 60; ++i) {
        sample(0, i) = std::sin(0.1 * i);
        sample(1, i) = std::pow(h, order) * std::cos(0.1 * i);
    }
    return sample;
}

TEST(Estimate, OfAHistoryIsItsLargestDistance)
{
    std::vector<Sample> samples;
    for (const double h : halved) samples.push_back(history(h, 2));
    const Estimate found = estimate(samples, halved);
    ASSERT_TRUE(found.order) << found.no_order;
    EXPECT_NEAR(*found.order, 2, 1e-6);
    const double largest = size_of(history(0, 2));
    for (std::size_t i = 0; i < halved.size(); ++i)
        EXPECT_NEAR(found.errors[i], halved[i] * halved[i] / largest, 1e-12);
}

// Rocking after many impacts: every run is another history of about the same size.
TEST(Estimate, OfHistoriesThatPartShowsNoOrder)
{
    std::vector<Sample> samples;
    for (const double phase : {0.3, 2.0, 4.1, 1.0, 5.0}) {
        samples.push_back(Sample::Zero(3, 60));
        for (int i = 0; i < 60; ++i) samples.back()(0, i) = std::sin(0.1 * i + phase);
    }
    const Estimate found = estimate(samples, halved);
    EXPECT_FALSE(found.order);
    EXPECT_GT(found.uncertainty, 0.5);
}

}  // namespace
}  // namespace voussoir::app::studies::converge
