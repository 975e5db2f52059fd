// The inclines of Li (time step and stiffness) and of Khan (a joint with a given stiffness).
#include <fmt/format.h>

#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double angle = 30 * scenes::degree;

VerifyResult slide_down(const scenes::SceneSetting& setting, const scenes::SlidingBlock& block, double duration,
                        double paper_from)
{
    scenes::SlidingScene scene = scenes::block_on_base(setting, block);
    scene.gravity = scenes::inclined_gravity(angle);
    scene.rest_gravity = scenes::held_gravity(angle, std::tan(block.friction));
    scene.duration = duration;
    return compare_sliding(scene, setting, paper_from, [&](double t) {
        return Eigen::Vector3d(
            references::incline_displacement(scenes::papers_gravity, angle, block.friction, 0, t), 0, 0);
    });
}

scenes::SlidingBlock block_of_li()
{
    return {.size = {1, 1, 0.5}, .material = {"rock", 2000, 3e8, 0.3}, .friction = 15 * scenes::degree};
}

VerifyResult khan(const scenes::SceneSetting& setting, const ContactStiffness& stiffness, double shear_to_normal)
{
    VerifyResult total;
    for (const double friction : {0.0, 10.0, 20.0, 25.0, 29.9}) {
        const scenes::SlidingBlock block{.size = {2, 1, 1},
                                         .material = {"rock", 2700, 1e10, 0.25},
                                         .friction = friction * scenes::degree,
                                         .stiffness = stiffness,
                                         .shear_to_normal_stiffness = shear_to_normal,
                                         .travel_to = {70, 5}};
        VerifyResult one = slide_down(setting, block, 5, 0.5);
        one.note = fmt::format("friction {:g} deg: {:.1e}", friction, one.error);
        add_run(total, one);
    }
    return total;
}

Benchmark benchmark_of_li()
{
    return {
        .name = "incline-li",
        .title = "A block on an incline of 30 degrees, friction 15 degrees, by time step and stiffness",
        .source = "li, section Inclined sliding block model, equations 10 and 11, figures 3 and 4",
        .quantity = "largest distance from the closed form / largest displacement",
        .choices =
            "Block, material and angles as in the paper; 2 s (not given). Its stiffnesses of 3e8, 3e9 and 3e10 "
            "N/m "
            "per contact point are 1, 10 and 100 times our default for this block; its time steps 1, 0.5 and 0.2 "
            "ms. It calls steps above 1 ms unusable: the sweep goes to 10 ms. The papers' measure is taken from "
            "0.2 s on.",
        .paper_error = "below 1 % at 1 ms and less",
        .paper_level = 0.01,
        .setting = {},
        .tolerance = 1e-5,
        .sweep = standard_sweep(sliding_steps, stiffness_factors),
        .run = [](const scenes::SceneSetting& setting) { return slide_down(setting, block_of_li(), 2, 0.2); }};
}

Benchmark benchmark_of_khan()
{
    return {
        .name = "incline-khan",
        .title = "A block of 2 x 1 m on an incline of 30 degrees, friction 0 to 29.9 degrees",
        .source = "khan, section 3.1, figures 2 to 4",
        .quantity = "largest distance from the closed form / largest displacement, the worst of five frictions",
        .choices =
            "2700 kg/m3 and 10 GPa (not given), the default contact stiffness; 5 s as in figure 4. The papers' "
            "measure is taken from 0.5 s on.",
        .paper_error = "below 2 % (hard contact)",
        .paper_level = 0.02,
        .setting = {},
        .tolerance = 1e-5,
        .sweep = standard_sweep(sliding_steps, stiffness_factors),
        .run = [](const scenes::SceneSetting& setting) { return khan(setting, {}, 0.5); }};
}

Benchmark benchmark_of_khan_soft()
{
    Benchmark benchmark = benchmark_of_khan();
    benchmark.name = "incline-khan-soft";
    benchmark.title += ", joint of 50 MPa/m";
    benchmark.choices =
        "As incline-khan with the paper's joint: 50 MPa/m, normal and shear. The block starts with its friction "
        "mobilised, so that the elastic slip of the joint (0.3 mm) has already occurred.";
    benchmark.paper_error = "below 1 % (soft contact)";
    benchmark.paper_level = 0.01;
    benchmark.run = [](const scenes::SceneSetting& setting) {
        return khan(setting, {ContactStiffness::Kind::per_area, 50e6}, 1);
    };
    return benchmark;
}

}  // namespace

std::vector<Benchmark> other_incline_benchmarks()
{
    std::vector<Benchmark> benchmarks{benchmark_of_li(), benchmark_of_khan(), benchmark_of_khan_soft()};
    add_planar(benchmarks[0]);
    make_planar(benchmarks[1]);
    make_planar(benchmarks[2]);
    return benchmarks;
}

}  // namespace voussoir::app::studies::verify
