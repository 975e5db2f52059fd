// A wedge that slides on two planes at once, along their line of intersection.
#include <fmt/format.h>

#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double plunge = 30 * scenes::degree, friction = 20 * scenes::degree;

struct Wedge {
    double left, right;  // degrees, how the planes dip across the line of intersection
};

std::string words(const Wedge& wedge, double error)
{
    return fmt::format("planes at {:g} and {:g} deg: {:.1e}", wedge.left, wedge.right, error);
}

scenes::SlidingScene scene_of(const scenes::SceneSetting& setting, const Wedge& wedge)
{
    scenes::SlidingScene scene =
        scenes::wedge_in_trough(setting, wedge.left * scenes::degree, wedge.right * scenes::degree, friction);
    scene.gravity = scenes::inclined_gravity(plunge);
    scene.rest_gravity = scenes::held_gravity(
        plunge, references::wedge_friction(wedge.left * scenes::degree, wedge.right * scenes::degree, friction));
    return scene;
}

VerifyResult let_slide(const scenes::SceneSetting& setting, const Wedge& wedge)
{
    scenes::SlidingScene scene = scene_of(setting, wedge);
    scene.duration = 1;
    const double equivalent =
        std::atan(references::wedge_friction(wedge.left * scenes::degree, wedge.right * scenes::degree, friction));
    VerifyResult result = compare_sliding(scene, setting, 0.1, [&](double t) {
        return Eigen::Vector3d(references::incline_displacement(scenes::papers_gravity, plunge, equivalent, 0, t),
                               0, 0);
    });
    result.note = words(wedge, result.error);
    return result;
}

/// The sine acts along the line of intersection.
VerifyResult shake(const scenes::SceneSetting& setting, const Wedge& wedge)
{
    constexpr double amplitude = 2, frequency = 1;  // m/s2, Hz
    scenes::SlidingScene scene = scene_of(setting, wedge);
    scene.duration = 4;
    scenes::add_sine(scene, 0, amplitude, frequency);
    references::SlidingProblem problem;
    problem.driving = [](double t) {
        const double sine = amplitude * std::sin(2 * std::numbers::pi * frequency * t);
        return Eigen::Vector2d(scenes::papers_gravity * std::sin(plunge) + sine, 0);
    };
    problem.pressing = [](double) { return scenes::papers_gravity * std::cos(plunge); };
    problem.friction =
        references::wedge_friction(wedge.left * scenes::degree, wedge.right * scenes::degree, friction);
    VerifyResult result = compare_sliding(scene, setting, 1, problem);
    result.note = words(wedge, result.error);
    return result;
}

VerifyResult slide_all(const scenes::SceneSetting& setting)
{
    VerifyResult total;
    add_run(total, let_slide(setting, {45, 45}));
    add_run(total, let_slide(setting, {30, 50}));
    return total;
}

VerifyResult shake_all(const scenes::SceneSetting& setting)
{
    VerifyResult total;
    add_run(total, shake(setting, {45, 45}));
    add_run(total, shake(setting, {55, 55}));
    add_run(total, shake(setting, {60, 50}));
    return total;
}

const std::string choices =
    "The paper does not specify the wedge, the sine and its direction within the vertical plane of the line of "
    "intersection. Ours is 1 m deep and 2 m long, 2500 kg/m3, 10 GPa, between planes that dip symmetrically and "
    "not. Spatial scenes only: the motion is not in one plane. ";

}  // namespace

std::vector<Benchmark> wedge_benchmarks()
{
    Benchmark gravity{.name = "wedge-gravity",
                      .title = "A wedge on two planes, plunge 30 degrees, friction 20 degrees, from rest",
                      .source = "yagoda-biran-hatzor, section 3.1.2",
                      .quantity = "largest distance from the closed form / largest displacement, the worse of two",
                      .choices = choices + "1 s.",
                      .paper_error = "",
                      .paper_level = {},
                      .setting = {},
                      .tolerance = 2e-3,
                      .sweep = standard_sweep(sliding_steps, stiffness_factors),
                      .run = slide_all};
    Benchmark sine = gravity;
    sine.name = "wedge-sine";
    sine.title =
        "A wedge on two planes, plunge 30 degrees, friction 20 degrees, under a sine along the intersection";
    sine.source = "yagoda-biran-hatzor, section 3.1.2, figure 8";
    sine.quantity =
        "largest distance from the vector analysis (integrated to 1e-8) / largest displacement, the worst "
        "of three";
    sine.choices =
        choices + "2 m/s2 at 1 Hz, 4 s; one wedge slides from the start, two are stable before the motion.";
    sine.paper_error = "below 7 %";
    sine.paper_level = 0.07;
    sine.run = shake_all;
    return {gravity, sine};
}

}  // namespace voussoir::app::studies::verify
