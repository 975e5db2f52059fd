// A block at the point of sliding under a sum of three sines.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/studies/verify/families.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double angle = 15 * scenes::degree;
using Terms = std::vector<Eigen::Vector2d>;  // amplitude [m/s2], angular frequency [rad/s]

/// Table 2: 0.1 g at the first frequency, 0.05 g at half of it, 0.025 g at a quarter.
Terms set_of(double first)
{
    const double g = scenes::papers_gravity, omega = first * std::numbers::pi;
    return {{0.1 * g, omega}, {0.05 * g, omega / 2}, {0.025 * g, omega / 4}};
}

VerifyResult shake(const scenes::SceneSetting& setting, double first, double duration)
{
    scenes::SlidingScene scene = scenes::block_on_base(
        setting, {.material = {"rock", 2700, 5e9, 0.25}, .friction = angle, .travel_to = {50, 5}});
    scene.gravity = scenes::inclined_gravity(angle);
    scene.rest_gravity = scenes::held_gravity(angle, std::tan(angle));
    scene.duration = duration;
    const Terms terms = set_of(first);
    for (const Eigen::Vector2d& term : terms)
        scenes::add_horizontal(
            scene, GroundMotion::sine_acceleration(term[0], term[1] / (2 * std::numbers::pi), 0, 1e6), angle);
    // Friction as steep as the plane leaves a / cos along it: (cos + sin tan) a.
    VerifyResult result = compare_sliding(scene, setting, duration, [&](double t) {
        return Eigen::Vector3d(references::sum_of_sines_displacement(terms, t) / std::cos(angle), 0, 0);
    });
    result.note = fmt::format("set from {:g} pi, {:g} s: {:.1e}", first, duration, result.error);
    return result;
}

VerifyResult shake_all(const scenes::SceneSetting& setting)
{
    VerifyResult total;
    for (const double first : {8, 10, 15}) add_run(total, shake(setting, first, 5));
    add_run(total, shake(setting, 10, 10));
    return total;
}

}  // namespace

std::vector<Benchmark> three_sines_benchmarks()
{
    return {
        {.name = "three-sines",
         .title = "A block on a plane of 15 degrees, friction 15 degrees, under the sum of three sines",
         .source = "tsesarsky, section 4.1, table 2, figures 5 and 6",
         .quantity = "largest distance from the closed form / largest displacement, the worst of three sets",
         .choices =
             "Block 1 x 1 x 0.3 m (not given), 2700 kg/m3, 5 GPa; 5 s (not given; 10 s for the second set beside "
             "it). The paper's equation 7 is valid for a plane at rest; a horizontal acceleration on its incline "
             "is 1/cos 15 = 1.035 times that along the plane, which is used here. The sum never reverses the "
             "slip, but brings it to rest once per period of the slowest sine. The paper's steps of 5 and 2.5 ms "
             "are in the sweep, and its measure is taken at the end. Figure 6 itself: figure not available.",
         .paper_error = "4.5 % at 5 ms, 1.5 % at 2.5 ms",
         .paper_level = 0.015,
         .setting = {},
         .tolerance = 3e-3,
         .sweep = standard_sweep(sliding_steps, stiffness_factors),
         .run = shake_all}};
}

}  // namespace voussoir::app::studies::verify
