// Kinetic damping against time step: the factor per step of the papers, and a rate.
#include <fmt/format.h>

#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/references/kinetic_damping.h"
#include "app/studies/verify/run_scene.h"
#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

namespace
{

constexpr double time_steps[] = {0.1, 0.01, 0.001, 0.0001};  // s, of figure 19
constexpr double finest_step = 1e-5;                         // s, that of the papers: a rate must reach it
constexpr double factor = 0.97;                              // "kinetic damping of 3%"
constexpr double acceleration = 1, duration = 5;  // m/s2, s: not printed; the sum is linear in the first

/// A free block of 1 m and its weight.
double fall(scenes::SceneSetting setting, double time_step, const Damping& damping, VerifyResult& result)
{
    setting.time_step = time_step;
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"mass", 1000, 1e9, 0.2}, {}, 1);
    scenes::add_box(scene.model, "mass", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    scene.stages = {scenes::dynamic_stage(setting, duration, {acceleration, 0, 0})};
    scene.stages[0].damping = damping;
    State state = initial_state(scene.model);
    run_scene(scene, state, {}, result);
    const double moved = pose_of(setting.kinematics, state, 0).centroid.x();
    result.answer.push_back(moved);
    return moved;
}

VerifyResult run_factor(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "displacement / undamped displacement:";
    const double undamped = 0.5 * acceleration * duration * duration;
    for (const double h : time_steps) {
        const double moved = fall(setting, h, {.factor_per_step = factor}, result);
        const double exact =
            references::displacement_with_factor(acceleration, factor, h, std::lround(duration / h));
        result.error = std::max(result.error, std::abs(moved / exact - 1));
        result.note += fmt::format(" {:.4g} at {:g} s,", moved / undamped, h);
    }
    // Its 197 blocks ran with this factor at 1e-5 s.
    result.note +=
        fmt::format(" for the same factor {:g} per step; at the paper's 1e-5 s it is a rate of {:.0f} /s", factor,
                    -std::log(factor) / 1e-5);
    return result;
}

/// The rate that equals the factor at the largest step: the answer must stay where it was there.
VerifyResult run_rate(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const double rate = -std::log(factor) / time_steps[0];
    const double exact = references::displacement_with_rate(acceleration, rate, duration);
    result.note = fmt::format("rate {:.4f} /s; displacement / exact:", rate);
    const auto add = [&](double h) {
        const double moved = fall(setting, h, {.rate = rate}, result);
        result.error = std::max(result.error, std::abs(moved / exact - 1));
        result.note += fmt::format(" {:.6f} at {:g} s,", moved / exact, h);
    };
    for (const double h : time_steps) add(h);
    add(finest_step);
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> kinetic_damping_benchmarks()
{
    Benchmark row;
    row.source = "yagoda-biran-hatzor, section 4.2.2, figure 19";
    row.setting.time_step = 1e-3;  // four steps are run in each; this one names none of them
    std::vector<Benchmark> rows;

    row.name = "kinetic-damping-factor";
    row.title = "Constant force, 3 % damping per step, at 0.1 to 0.0001 s";
    row.quantity = "largest |displacement / closed form of the discrete sum - 1|";
    row.paper_error = "displacement decreases with the time step; figure not available";
    row.tolerance = 1e-9;
    row.run = run_factor;
    rows.push_back(row);
    rows.back().setting = as_in_papers(row.setting);  // the sum is that of end-of-step forces

    row.name = "kinetic-damping-rate";
    row.title = "Constant force, damping as a rate, at 0.1 to 0.00001 s";
    row.quantity = "largest |displacement / exact displacement - 1|";
    row.paper_error = "the papers have no rate";
    row.tolerance = 0.01;
    row.run = run_rate;
    rows.push_back(row);
    return rows;
}

}  // namespace voussoir::app::studies::verify
