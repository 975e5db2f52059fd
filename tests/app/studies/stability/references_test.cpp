// The block on springs against what is known when the springs are stiff, or when nothing is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/studies/stability/references/block_on_springs.h"
#include "app/studies/verify/references/rocking.h"
#include "app/studies/verify/references/sliding.h"

namespace voussoir::reference
{
namespace
{

constexpr double gravity = 9.81;

std::vector<double> times_to(double end, int count)
{
    std::vector<double> times;
    for (int i = 1; i <= count; ++i) times.push_back(end * i / count);
    return times;
}

app::studies::stability::references::SpringBlock flat_block(double stiffness)
{
    app::studies::stability::references::SpringBlock block;
    block.half_width = 0.5;
    block.half_height = 0.05;
    block.mass = 200;
    block.inertia = block.mass * (1 + 0.01) / 12;
    block.normal_stiffness = stiffness;
    block.shear_stiffness = stiffness / 2;
    block.friction = 0.2;
    block.gravity = gravity;
    block.amplitude = 5;
    block.period = 2;
    block.pulse_end = 2;
    return block;
}

TEST(BlockOnSprings, SlidesAsARigidBlockWhenTheSpringsAreStiff)
{
    const std::vector<double> times = times_to(2, 40);
    app::studies::verify::references::SlidingProblem rigid;
    rigid.friction = 0.2;
    rigid.pressing = [](double) { return gravity; };
    rigid.driving = [](double t) { return Eigen::Vector2d(-5 * std::sin(std::numbers::pi * t), 0); };
    const std::vector<app::studies::verify::references::SlidingPoint> exact =
        app::studies::verify::references::slide(rigid, times);
    const std::vector<app::studies::stability::references::SpringBlockPoint> ours =
        app::studies::stability::references::block_on_springs(flat_block(1e9), times);
    double largest = 0, worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        largest = std::max(largest, std::abs(exact[i].displacement.x()));
        worst = std::max(worst, std::abs(exact[i].displacement.x() - ours[i].x));
    }
    EXPECT_GT(largest, 0.3);
    EXPECT_LT(worst, 1e-3 * largest);
}

TEST(BlockOnSprings, SoftSpringsLagByTheirOwnCompliance)
{
    // A pulse too weak to slide: the block follows the ground but for the stretch of its shear springs,
    // m a / (2 k_t), once the pulse is slow against the springs.
    app::studies::stability::references::SpringBlock block = flat_block(1e6);
    block.amplitude = 1;
    block.period = 4;
    block.pulse_end = 4;
    const double stretch = block.mass * 1 / (2 * block.shear_stiffness);
    const app::studies::stability::references::SpringBlockPoint at_peak =
        app::studies::stability::references::block_on_springs(block, {1.0}).front();
    EXPECT_NEAR(at_peak.x, -stretch, 0.05 * stretch);
}

TEST(BlockOnSprings, RocksAsARigidBlockUntilItLands)
{
    app::studies::verify::references::RockingBlock rigid;
    rigid.half_width = 0.5;
    rigid.half_height = 1.5;
    rigid.gravity = gravity;
    rigid.amplitude = 5;
    rigid.frequency = 1;
    app::studies::stability::references::SpringBlock block;
    block.half_width = rigid.half_width;
    block.half_height = rigid.half_height;
    block.mass = 1200;
    block.inertia = block.mass * (1 + 9) / 12;
    block.normal_stiffness = 1e11;
    block.shear_stiffness = 5e10;
    block.friction = 1.5;
    block.gravity = gravity;
    block.amplitude = 5;
    block.period = 1;
    block.pulse_end = 0.5;
    const double landing = app::studies::verify::references::first_impact(rigid).value();
    const std::vector<double> times = times_to(0.95 * landing, 20);
    const std::vector<double> exact = app::studies::verify::references::rocking_angles(rigid, times);
    const std::vector<app::studies::stability::references::SpringBlockPoint> ours =
        app::studies::stability::references::block_on_springs(block, times);
    double largest = 0, worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        largest = std::max(largest, std::abs(exact[i]));
        worst = std::max(worst, std::abs(exact[i] - ours[i].lean));
    }
    EXPECT_GT(largest, 0.01);
    EXPECT_LT(worst, 0.01 * largest);
}

TEST(BlockOnSprings, LetGoOnAStiffEdgeTurnsAboutItAsItsWeightFalls)
{
    app::studies::stability::references::SpringBlock block;
    block.half_width = 1;
    block.half_height = 3;
    block.mass = 2400;
    block.inertia = block.mass * (4.0 + 36) / 12;
    block.normal_stiffness = 1e11;
    block.shear_stiffness = 5e10;
    block.friction = 1.5;
    block.gravity = gravity;
    block.start_lean = 0.2;
    const double t = 0.6, dt = 1e-3;
    const std::vector<app::studies::stability::references::SpringBlockPoint> points =
        app::studies::stability::references::block_on_springs(block, {t - dt, t, t + dt});
    const double spin = (points[2].lean - points[0].lean) / (2 * dt);
    const double radius = std::hypot(1.0, 3.0), alpha = std::atan2(1.0, 3.0);
    const double fall = radius * (std::cos(alpha - block.start_lean) - std::cos(alpha - points[1].lean));
    const double about_edge = block.inertia + block.mass * radius * radius;
    EXPECT_LT(points[1].lean, 0.9 * block.start_lean);
    EXPECT_GT(points[1].lean, 0);
    EXPECT_NEAR(0.5 * about_edge * spin * spin, block.mass * gravity * fall, 0.01 * block.mass * gravity * fall);
}

}  // namespace
}  // namespace voussoir::reference
