// The references of sliding blocks against cases that have a closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/studies/verify/references/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double degree = std::numbers::pi / 180, g = 9.81;

std::vector<double> times_until(double end, int count)
{
    std::vector<double> times;
    for (int i = 1; i <= count; ++i) times.push_back(end * i / count);
    return times;
}

references::SlidingProblem on_level_ground(double friction)
{
    references::SlidingProblem problem;
    problem.driving = [](double) { return Eigen::Vector2d(0, 0); };
    problem.pressing = [](double) { return g; };
    problem.friction = friction;
    return problem;
}

TEST(SlidingReference, APushedBlockBrakesEvenlyAndStays)
{
    references::SlidingProblem problem = on_level_ground(0.5);
    problem.start_velocity = {3, 4};
    const double stop = 5 / (0.5 * g);
    for (const references::SlidingPoint& point : references::slide(problem, {stop, 2 * stop})) {
        EXPECT_NEAR(point.displacement.norm(), 2.5 * stop, 1e-10);
        EXPECT_NEAR(point.displacement.x() / point.displacement.y(), 0.75, 1e-10);
        EXPECT_LT(point.velocity.norm(), 1e-9);
    }
}

// Equation 3 of Yagoda-Biran and Hatzor holds from the first slip to the first stop.
TEST(SlidingReference, AShakenBlockFollowsEquation3UntilItStops)
{
    const double angle = 45 * degree, friction_angle = 50 * degree, amplitude = 2, omega = 2 * std::numbers::pi;
    references::SlidingProblem problem;
    problem.driving = [=](double t) {
        return Eigen::Vector2d(g * std::sin(angle) + amplitude * std::sin(omega * t) * std::cos(angle), 0);
    };
    problem.pressing = [=](double t) {
        return g * std::cos(angle) - amplitude * std::sin(omega * t) * std::sin(angle);
    };
    problem.friction = std::tan(friction_angle);
    const double theta = std::asin(std::tan(friction_angle - angle) * g / amplitude) / omega;
    const double gain = std::cos(angle) + std::sin(angle) * problem.friction;
    const double steady = g * (std::sin(angle) - std::cos(angle) * problem.friction);
    const std::vector<double> times = times_until(0.6, 60);
    const std::vector<references::SlidingPoint> points = references::slide(problem, times);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = times[i], since = std::max(t - theta, 0.0);
        const double exact =
            t < theta ? 0
                      : steady * since * since / 2 + amplitude * gain / (omega * omega) *
                                                         (omega * std::cos(omega * theta) * since -
                                                          std::sin(omega * t) + std::sin(omega * theta));
        EXPECT_NEAR(points[i].displacement.x(), exact, 1e-10) << t;
        EXPECT_EQ(points[i].displacement.y(), 0);
    }
}

// Without friction the block stays behind; with enough of it, it goes with the ground.
TEST(SlidingReference, ABaseWithoutFrictionMovesAloneAndOneWithMuchTakesTheBlockAlong)
{
    references::SlidingProblem problem = on_level_ground(0);
    problem.driving = [](double t) { return Eigen::Vector2d(-3 * std::cos(5 * t), 0); };
    const std::vector<double> times = times_until(3, 30);
    const std::vector<references::SlidingPoint> free = references::slide(problem, times);
    for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR(free[i].displacement.x(), -3.0 / 25 * (1 - std::cos(5 * times[i])), 1e-10);
    problem.friction = 0.4;
    for (const references::SlidingPoint& point : references::slide(problem, times))
        EXPECT_EQ(point.displacement.norm(), 0);
}

// Two equal loads at a right angle are one load along the diagonal, through stops and reversals.
TEST(SlidingReference, TwoDirectionsAlongTheDiagonalAreOne)
{
    references::SlidingProblem one = on_level_ground(0.2), two = one;
    one.driving = [](double t) { return Eigen::Vector2d(5 * std::sin(6 * t), 0); };
    two.driving = [](double t) { return Eigen::Vector2d(3 * std::sin(6 * t), 4 * std::sin(6 * t)); };
    const std::vector<double> times = times_until(4, 400);
    const std::vector<references::SlidingPoint> a = references::slide(one, times),
                                                b = references::slide(two, times);
    for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR((b[i].displacement - a[i].displacement.x() * Eigen::Vector2d(0.6, 0.8)).norm(), 0, 1e-9);
}

// A slip that never stops is a smooth equation: twice the output times must not change the answer.
TEST(SlidingReference, TheAnswerDoesNotHangOnTheOutputTimes)
{
    references::SlidingProblem problem = on_level_ground(0.6);
    problem.driving = [](double t) {
        return Eigen::Vector2d(-47 * std::cos(12.566 * t), -126 * std::cos(25.133 * t));
    };
    const references::SlidingPoint coarse = references::slide(problem, times_until(5, 50)).back();
    const references::SlidingPoint fine = references::slide(problem, times_until(5, 5000)).back();
    EXPECT_LT((coarse.displacement - fine.displacement).norm(), 1e-8 * fine.displacement.norm());
}

TEST(SlidingReference, ThreeSinesInClosedFormAreWhatIsIntegrated)
{
    const std::vector<Eigen::Vector2d> terms{{1, 10}, {0.5, 5}, {0.25, 2.5}};
    references::SlidingProblem problem = on_level_ground(0.3);
    problem.driving = [&](double t) {
        double sum = 0.3 * g;  // as on a plane as steep as its friction
        for (const Eigen::Vector2d& term : terms) sum += term[0] * std::sin(term[1] * t);
        return Eigen::Vector2d(sum, 0);
    };
    const std::vector<double> times = times_until(2.4, 24);  // less than a period of the slowest
    const std::vector<references::SlidingPoint> points = references::slide(problem, times);
    for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR(points[i].displacement.x(), references::sum_of_sines_displacement(terms, times[i]), 1e-9);
}

TEST(SlidingReference, AFlatWedgeIsAPlaneAndARightOneResistsMoreByRootTwo)
{
    EXPECT_NEAR(references::wedge_friction(1e-9, 1e-9, 20 * degree), std::tan(20 * degree), 1e-12);
    EXPECT_NEAR(references::wedge_friction(45 * degree, 45 * degree, 20 * degree),
                std::sqrt(2) * std::tan(20 * degree), 1e-12);
    EXPECT_NEAR(references::incline_displacement(g, 30 * degree, 30 * degree, 2, 3), 6, 1e-12);
}

}  // namespace
}  // namespace voussoir::app::studies::verify
