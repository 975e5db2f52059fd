// A wedge that slides on two planes at once, along their line of intersection.
#include <fmt/format.h>

#include <cmath>

#include "app/verify/families.h"
#include "app/verify/settings.h"
#include "app/verify/sliding.h"

namespace voussoir
{
namespace
{

constexpr double plunge = 30 * degree, friction = 20 * degree;

struct Wedge {
    double left, right;  // degrees, how the planes dip across the line of intersection
};

std::string words(const Wedge& wedge, double error)
{
    return fmt::format("planes at {:g} and {:g} deg: {:.1e}", wedge.left, wedge.right, error);
}

Scene scene_of(const VerifySetting& setting, const Wedge& wedge)
{
    Scene scene = wedge_in_trough(setting, wedge.left * degree, wedge.right * degree, friction);
    scene.gravity = inclined_gravity(plunge);
    scene.rest_gravity = held_gravity(plunge, wedge_friction(wedge.left * degree, wedge.right * degree, friction));
    return scene;
}

VerifyResult let_slide(const VerifySetting& setting, const Wedge& wedge)
{
    Scene scene = scene_of(setting, wedge);
    scene.duration = 1;
    const double equivalent = std::atan(wedge_friction(wedge.left * degree, wedge.right * degree, friction));
    VerifyResult result = compare_sliding(scene, setting, 0.1, [&](double t) {
        return Eigen::Vector3d(incline_displacement(papers_gravity, plunge, equivalent, 0, t), 0, 0);
    });
    result.note = words(wedge, result.error);
    return result;
}

/// The sine acts along the line of intersection.
VerifyResult shake(const VerifySetting& setting, const Wedge& wedge)
{
    constexpr double amplitude = 2, frequency = 1;  // m/s2, Hz
    Scene scene = scene_of(setting, wedge);
    scene.duration = 4;
    add_sine(scene, 0, amplitude, frequency);
    SlidingProblem problem;
    problem.driving = [](double t) {
        const double sine = amplitude * std::sin(2 * std::numbers::pi * frequency * t);
        return Eigen::Vector2d(papers_gravity * std::sin(plunge) + sine, 0);
    };
    problem.pressing = [](double) { return papers_gravity * std::cos(plunge); };
    problem.friction = wedge_friction(wedge.left * degree, wedge.right * degree, friction);
    VerifyResult result = compare_sliding(scene, setting, 1, problem);
    result.note = words(wedge, result.error);
    return result;
}

VerifyResult slide_all(const VerifySetting& setting)
{
    VerifyResult total;
    add_run(total, let_slide(setting, {45, 45}));
    add_run(total, let_slide(setting, {30, 50}));
    return total;
}

VerifyResult shake_all(const VerifySetting& setting)
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

}  // namespace voussoir
