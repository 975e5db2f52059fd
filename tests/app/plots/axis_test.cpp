// Axes of diagrams, and diagrams on their way to the program that draws them.
#include "app/plots/axis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/plots/diagram.h"

namespace voussoir::app::plots
{
namespace
{

TEST(Axis, LogarithmicTicksArePowersOfTenWithNothingOutside)
{
    const Axis axis = axis_for({3e-5, 2e-2}, true);
    EXPECT_LT(axis.share(3e-5), 0.1);
    EXPECT_GT(axis.share(3e-5), 0);
    EXPECT_GT(axis.share(2e-2), 0.9);
    int labelled = 0;
    for (const Tick& tick : ticks_of(axis)) {
        EXPECT_GE(axis.share(tick.value), 0);
        EXPECT_LE(axis.share(tick.value), 1);
        if (!tick.is_labelled) continue;
        ++labelled;
        EXPECT_NEAR(std::log10(tick.value), std::round(std::log10(tick.value)), 1e-12);
    }
    EXPECT_EQ(labelled, 3);  // 1e-4, 1e-3, 1e-2
}

TEST(Axis, ASingleValueStillGetsTwoPowersOfTen)
{
    int labelled = 0;
    for (const Tick& tick : ticks_of(axis_for({2e-3}, true))) labelled += tick.is_labelled ? 1 : 0;
    EXPECT_GE(labelled, 2);
}

TEST(Axis, LinearTicksAreRoundAndFewAtAnyScale)
{
    for (const double scale : {1e-7, 0.3, 1.0, 42.0, 6e8}) {
        const Axis axis = axis_for({-0.2 * scale, 0.9 * scale}, false);
        const std::vector<Tick> ticks = ticks_of(axis);
        EXPECT_GE(ticks.size(), 4u) << scale;
        EXPECT_LE(ticks.size(), 12u) << scale;
        const double step = ticks[1].value - ticks[0].value;
        const double leading = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
        EXPECT_TRUE(std::abs(leading - 1) < 1e-6 || std::abs(leading - 2) < 1e-6 || std::abs(leading - 5) < 1e-6)
            << leading;
    }
    EXPECT_GE(ticks_of(axis_for({5, 5}, false)).size(), 4u);
    EXPECT_LE(ticks_of(axis_for({5, 5 * (1 + 4e-16)}, false)).size(), 12u);
}

TEST(Diagram, GoesThroughJsonUnchanged)
{
    Figure figure{"name", "title", "subtitle", {}, true, {"a note"}};
    figure.diagrams.push_back(
        {"x [s]", "y [m]", {{"exact", {0, 1}, {2, 3}, true}}, {{"limit", 0.5, true}}, true, false, false});
    const std::vector<Figure> back = figures_of_json(figures_json({figure}));
    ASSERT_EQ(back.size(), 1u);
    const Diagram& diagram = back[0].diagrams.at(0);
    EXPECT_TRUE(back[0].stacked);
    EXPECT_TRUE(diagram.logarithmic_x);
    EXPECT_FALSE(diagram.logarithmic_y);
    EXPECT_FALSE(diagram.marks);
    EXPECT_TRUE(diagram.curves.at(0).is_reference);
    EXPECT_EQ(diagram.curves[0].y, (std::vector<double>{2, 3}));
    EXPECT_TRUE(diagram.levels.at(0).tolerance);
    EXPECT_EQ(back[0].notes, figure.notes);
}

}  // namespace
}  // namespace voussoir::app::plots
