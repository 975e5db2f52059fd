// A flat block on a foundation that shakes in one, two and three directions.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

/// d(t) = amplitude (1 - cos 2 pi frequency t); amplitude 0: this direction rests.
struct Cosine {
    double amplitude = 0, frequency = 1;  // m, Hz
    double omega() const { return 2 * std::numbers::pi * frequency; }
    double displacement(double t) const { return amplitude * (1 - std::cos(omega() * t)); }
    double acceleration(double t) const { return amplitude * omega() * omega() * std::cos(omega() * t); }
};
using Motion = std::array<Cosine, 3>;

constexpr double friction = 0.6;
const Motion one_direction{{{0.5, 2}, {}, {}}};
const Motion two_directions{{{0.3, 2}, {0.2, 4}, {}}};
const Motion three_directions{{{0.1, 2}, {0.1, 4}, {0.1, 1}}};  // equation 9

/// E L = 3.3e10 N/m and E A = 1e11 N follow from the stiffness ratios the paper prints: 3 x 3 m, 11 GPa.
scenes::SlidingScene scene_of(const scenes::SceneSetting& setting, const Motion& motion)
{
    scenes::SlidingScene scene = scenes::block_on_base(setting, {.size = {3, 3, 0.3},
                                                                 .material = {"stone", 2500, 1.1e10, 0.2},
                                                                 .friction = std::atan(friction),
                                                                 .travel_from = {-10, -10},
                                                                 .travel_to = {10, 10}});
    scene.duration = 5;
    for (int axis = 0; axis < 3; ++axis)
        if (motion[axis].amplitude > 0)
            scenes::add_cosine_motion(scene, axis, motion[axis].amplitude, motion[axis].frequency);
    return scene;
}

/// Equation 8: seen from the base, the block is driven by minus its acceleration.
references::SlidingProblem equation_8(const Motion& motion)
{
    references::SlidingProblem problem;
    problem.driving = [=](double t) {
        return Eigen::Vector2d(-motion[0].acceleration(t), -motion[1].acceleration(t));
    };
    problem.pressing = [=](double t) { return scenes::papers_gravity + motion[2].acceleration(t); };
    problem.friction = friction;
    return problem;
}

VerifyResult shake(const scenes::SceneSetting& setting, const Motion& motion)
{
    const auto base = [&](double t) {
        return Eigen::Vector3d(motion[0].displacement(t), motion[1].displacement(t), motion[2].displacement(t));
    };
    return compare_sliding(scene_of(setting, motion), setting, 0.3, equation_8(motion), base);
}

/// The stiffnesses of figure 15 and two more, in N/m per contact point, as factors of the default.
std::vector<double> stiffnesses_of_figure_15()
{
    const double default_one = scenes::stiffness_per_point(scene_of({}, three_directions));
    std::vector<double> factors;
    for (const double stiffness : {1e6, 1e7, 1e8, 1e9, 1e10, 1e11}) factors.push_back(stiffness / default_one);
    return factors;
}

struct Words {
    std::string name, title, source, paper_error;
    double paper_level, tolerance;
};

/// At 1 ms with its sweep, and at 0.1 ms.
void add_both(std::vector<Benchmark>& list, const Words& words, const Motion& motion,
              const std::vector<double>& factors, const std::string& choices)
{
    Benchmark benchmark{
        .name = words.name,
        .title = words.title,
        .source = words.source,
        .quantity = "largest distance from equation 8 (integrated to 1e-8) / largest displacement of the block",
        .choices =
            "A block of 3 x 3 x 0.3 m, 2500 kg/m3, 11 GPa, so that E L and E A correspond to the paper's "
            "stiffness ratios; 5 s. Friction coefficient 0.6. The papers' measure is taken from 0.3 s on." +
            choices,
        .paper_error = words.paper_error,
        .paper_level = words.paper_level,
        .setting = {},
        .tolerance = words.tolerance,
        .sweep = standard_sweep({5e-3, 2.5e-3, 1e-3, 5e-4, 2.5e-4, 1e-4}, factors),
        .run = [motion](const scenes::SceneSetting& setting) { return shake(setting, motion); }};
    list.push_back(benchmark);
    benchmark.name += "-fine";
    benchmark.title += ", at 0.1 ms";
    benchmark.setting.time_step = 1e-4;
    benchmark.tolerance = 1e-3;
    benchmark.sweep.clear();
    list.push_back(benchmark);
}

}  // namespace

std::vector<Benchmark> foundation_benchmarks()
{
    const std::string source = "yagoda-biran-hatzor, section 3.4.2, equation 8, figure ";
    const std::vector<double> factors = stiffnesses_of_figure_15();
    std::vector<Benchmark> list;
    add_both(list,
             {"foundation-1d", "A block on a foundation shaken in one direction (0.5 m, 2 Hz)", source + "13",
              "below 1 % after 0.3 s", 0.01, 5e-3},
             one_direction, stiffness_factors,
             " The text and the axis of figure 13 give 0.5 m, its caption 0.2 m: 0.5 m fits the axis.");
    list = with_planar(std::move(list));
    add_both(list,
             {"foundation-2d", "A block on a foundation shaken in two directions (0.3 m, 2 Hz; 0.2 m, 4 Hz)",
              source + "14", "below 10 %", 0.1, 7e-3},
             two_directions, stiffness_factors, " The friction of figure 14 is not printed: 0.6 as in figure 13.");
    add_both(list,
             {"foundation-3d", "A block on a foundation shaken in three directions (equation 9)", source + "15",
              "below 3 % (k = 1e7 N/m), below 10 % (1e8, 1e9)", 0.03, 7e-3},
             three_directions, factors,
             " Stiffnesses varied: 1e6, 1e7, 1e8, 1e9, 1e10, 1e11 N/m per contact point (figure 15 has the second "
             "to fourth). The error is that of the vector, including the vertical part; the paper's is that of "
             "the horizontal displacement.");
    return list;
}

}  // namespace voussoir::app::studies::verify
