// Wartman's eight tests of a block on an inclined plane on a shaking table.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "app/studies/verify/families.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double angle = 11.37 * scenes::degree, ramp = 1.5, duration = 5;  // rad, s, s

struct TableTest {
    double frequency, acceleration;  // Hz, g
    double measured;                 // m, displacement of the block on the plane
};

/// Table 1.
constexpr std::array<TableTest, 8> tests{{{2.66, 0.28, 0.05367},
                                          {4, 0.25, 0.06604},
                                          {5.33, 0.19, 0.03341},
                                          {6, 0.19, 0.03647},
                                          {6.67, 0.22, 0.03410},
                                          {7.3, 0.22, 0.03353},
                                          {8, 0.23, 0.03937},
                                          {8.66, 0.21, 0.02882}}};

/// Ramped up for 1.5 s, full for 2 s, ramped down for 1.5 s.
double table_acceleration(const TableTest& test, double t)
{
    const double envelope = std::clamp(std::min(t, duration - t) / ramp, 0.0, 1.0);
    return envelope * test.acceleration * scenes::papers_gravity *
           std::sin(2 * std::numbers::pi * test.frequency * t);
}

GroundMotion sampled(const TableTest& test)
{
    constexpr double step = 1e-4;  // s; a straight line between samples is then within 4e-6 of the sine
    std::vector<double> samples;
    for (int i = 0; i <= static_cast<int>(duration / step + 0.5); ++i)
        samples.push_back(table_acceleration(test, i * step));
    return GroundMotion::from_acceleration(std::move(samples), step, "ramped sine");
}

/// How the interface of geotextile and geomembrane resists.
struct Interface {
    double at_rest = 0;  // rad
    std::vector<FrictionAtSpeed> at_speed;
};

/// What the paper prints of it, nothing of it fitted: 12.7 degrees in the tilt test, 16 degrees "most likely" at
/// 2.54 cm/s, 20 % more per decade of speed ([Kim1999]), 19 degrees as the largest that was back-calculated.
/// Through the first two, twenty percent a decade gives 12.7 degrees at 0.21 cm/s and 19.0 degrees at 25.4 cm/s.
Interface rate_dependent_interface()
{
    constexpr double speed = 0.0254, angle = 16 * scenes::degree, per_decade = 0.2;  // m/s, rad
    Interface interface {
        12.7 * scenes::degree, {}
    };
    const double rise_per_decade = per_decade * std::tan(angle);
    const double slowest = std::log10(speed) - (std::tan(angle) - std::tan(interface.at_rest)) / rise_per_decade;
    const double fastest = std::log10(speed) + (std::tan(19 * scenes::degree) - std::tan(angle)) / rise_per_decade;
    constexpr int points = 16;
    for (int i = 0; i <= points; ++i) {
        const double decade = slowest + i * (fastest - slowest) / points;
        const double coefficient = std::tan(interface.at_rest) + (decade - slowest) * rise_per_decade;
        interface.at_speed.push_back({std::pow(10, decade), std::atan(coefficient)});
    }
    return interface;
}

/// The same table for the reference: its own interpolation.
std::function<double(double)> friction_of(const Interface& interface)
{
    if (interface.at_speed.empty()) return {};
    return [interface](double speed) {
        const auto& table = interface.at_speed;
        const auto above =
            std::find_if(table.begin(), table.end(), [=](const auto& p) { return p.speed > speed; });
        if (above == table.end()) return std::tan(table.back().angle);
        const double low = above == table.begin() ? 0 : std::prev(above)->speed;
        const double from = std::tan(above == table.begin() ? interface.at_rest : std::prev(above)->angle);
        const double share = (speed - low) / (above->speed - low);
        return (1 - share) * from + share * std::tan(above->angle);
    };
}

references::SlidingProblem newmark_block(const TableTest& test, const Interface& interface)
{
    references::SlidingProblem problem;
    problem.driving = [=](double t) {
        const double push = table_acceleration(test, t);
        return Eigen::Vector2d(scenes::papers_gravity * std::sin(angle) + push * std::cos(angle), 0);
    };
    problem.pressing = [=](double t) {
        return scenes::papers_gravity * std::cos(angle) - table_acceleration(test, t) * std::sin(angle);
    };
    problem.friction = std::tan(interface.at_rest);
    problem.friction_at = friction_of(interface);
    return problem;
}

/// In the table's frame: the block carries m a. @param end displacement at the end [m]
VerifyResult shake(const scenes::SceneSetting& setting, const TableTest& test, const Interface& interface,
                   double& end)
{
    scenes::SlidingScene scene = scenes::block_on_base(setting, {.size = {0.0508, 0.0508, 0.0254},
                                                                 .material = {"steel", 24400, 2e11, 0.3},
                                                                 .friction = interface.at_rest,
                                                                 .travel_from = {-0.2, -0.2},
                                                                 .travel_to = {0.5, 0.2}});
    scene.model.joints[0].friction_at_speed = interface.at_speed;
    scene.gravity = scenes::inclined_gravity(angle);
    scene.duration = duration;
    scenes::add_horizontal(scene, sampled(test), angle);
    EngineRun run = run_engine(scene, setting);
    const History reference = reference_history(newmark_block(test, interface), run.history.times);
    run.result.answer = answer_of(run.history);
    run.result.picture = picture_of(run.history, reference);
    run.result.error = worst_error(run.history, reference);
    if (!run.history.displacements.empty()) end = run.history.displacements.back().x();
    run.result.paper_measure = std::abs(end - test.measured) / test.measured;
    return run.result;
}

VerifyResult shake_rate_dependent(const scenes::SceneSetting& setting)
{
    const Interface interface = rate_dependent_interface();
    VerifyResult total;
    for (const TableTest& test : tests) {
        double end = 0;
        VerifyResult one = shake(setting, test, interface, end);
        one.note = fmt::format("{:g} Hz: measured {:.2f} cm, computed {:.2f}", test.frequency, 100 * test.measured,
                               100 * end);
        add_run(total, one);
    }
    return total;
}

VerifyResult shake_all(const scenes::SceneSetting& setting)
{
    VerifyResult total;
    for (const TableTest& test : tests) {
        double with_16 = 0, with_17 = 0;
        add_run(total, shake(setting, test, {16 * scenes::degree, {}}, with_16));
        VerifyResult upper = shake(setting, test, {17 * scenes::degree, {}}, with_17);
        upper.note = fmt::format("{:g} Hz: measured {:.2f} cm, computed {:.2f} (16 deg), {:.2f} (17 deg)",
                                 test.frequency, 100 * test.measured, 100 * with_16, 100 * with_17);
        add_run(total, upper);
    }
    return total;
}

}  // namespace

std::vector<Benchmark> shaking_table_benchmarks()
{
    Benchmark constant;
    constant.name = "shaking-table";
    constant.title = "The eight shaking-table tests of a block on a plane of 11.37 degrees";
    constant.source = "tsesarsky, section 4.2, table 1 (measured by Wartman 1999)";
    constant.quantity =
        "largest distance from the Newmark-type block (1e-8) / largest displacement, the worst of eight tests at "
        "friction 16 and 17 degrees";
    constant.choices =
        "The table acceleration of table 1 (its displacement d_T is not consistent with it: 4 pi^2 f^2 d_T is 0.9 "
        "to 2.6 times a_h, and 0.3 times in test 8, where 0.19 cm must be meant). Block of 5.08 x 5.08 x 2.54 cm "
        "of 1.6 kg; steel. The papers' measure is the worst difference from the measured end displacement, which "
        "is due to the friction law, not to the computation: constant friction.";
    constant.paper_error = "20 % (17 deg), 80 % (16 deg) of the measured";
    constant.tolerance = 3e-3;
    constant.sweep = standard_sweep({5e-3, 2.5e-3, 1e-3, 5e-4});
    constant.run = shake_all;

    Benchmark rate_dependent = constant;
    rate_dependent.name = "shaking-table-rate-dependent";
    rate_dependent.title = "The same with friction that increases with the sliding speed";
    rate_dependent.quantity =
        "largest distance from the Newmark-type block with the same law (1e-8) / largest displacement, the worst "
        "of eight tests";
    rate_dependent.choices =
        "Friction from the values printed in the paper for the interface, nothing fitted: 12.7 degrees at rest "
        "(tilt test), 16 degrees at 2.54 cm/s, increasing by 20 % of it per decade of speed up to 19 degrees. "
        "Figure 2, the back-calculated law: figure not available.";
    rate_dependent.paper_error = "constant friction only";
    rate_dependent.run = shake_rate_dependent;
    return {constant, rate_dependent};
}

}  // namespace voussoir::app::studies::verify
