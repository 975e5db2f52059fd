// Two blocks, the lower of which is shaken.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/studies/verify/families.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/sliding.h"

namespace voussoir::app::studies::verify
{
namespace
{

constexpr double friction = 18 * scenes::degree, frequency = 0.25, duration = 8;  // rad, Hz, s
constexpr double amplitude = 0.5 * scenes::papers_gravity;                        // m/s2

GroundMotion ground(double phase)
{
    return GroundMotion::sine_acceleration(amplitude, frequency, phase, 1e6);
}

/// From rest: a = A sin(w t + p), v = A/w (cos p - cos(w t + p)), d = A/w^2 (w t cos p - sin(w t + p) + sin p).
struct BaseMotion {
    double phase, omega = 2 * std::numbers::pi * frequency;
    double acceleration(double t) const { return amplitude * std::sin(omega * t + phase); }
    double velocity(double t) const { return amplitude / omega * (std::cos(phase) - std::cos(omega * t + phase)); }
    double displacement(double t) const
    {
        const double turned = omega * t * std::cos(phase) - std::sin(omega * t + phase) + std::sin(phase);
        return amplitude / (omega * omega) * turned;
    }
};

/// Velocity, and acceleration as its change over each step, against those of the reference.
std::string other_quantities(const History& ours, const std::vector<references::SlidingPoint>& slid,
                             const BaseMotion& base)
{
    double v_worst = 0, v_largest = 0, a_squares = 0, a_largest = 0, before = 0, before_ours = 0, t_before = 0;
    for (std::size_t i = 0; i < ours.times.size(); ++i) {
        const double t = ours.times[i], exact = base.velocity(t) + slid[i].velocity.x(),
                     v = ours.velocities[i].x();
        v_worst = std::max(v_worst, std::abs(v - exact));
        v_largest = std::max(v_largest, std::abs(exact));
        const double a = (exact - before) / (t - t_before), a_ours = (v - before_ours) / (t - t_before);
        a_squares += (a_ours - a) * (a_ours - a) * (t - t_before) / duration;
        a_largest = std::max(a_largest, std::abs(a));
        before = exact, before_ours = v, t_before = t;
    }
    return fmt::format("velocity {:.1e} of its largest, acceleration {:.1e} (root mean square) of its largest",
                       v_worst / v_largest, std::sqrt(a_squares) / a_largest);
}

VerifyResult shake(const scenes::SceneSetting& setting, double phase)
{
    scenes::SlidingScene scene = scenes::block_on_base(setting, {.size = {1, 1, 0.5},
                                                                 .material = {"stone", 2500, 1e10, 0.25},
                                                                 .friction = friction,
                                                                 .travel_from = {-40, -5},
                                                                 .travel_to = {40, 5}});
    scene.duration = duration;
    scene.motions.push_back({0, 0, std::make_shared<const GroundMotion>(ground(phase))});
    const BaseMotion base{phase};
    references::SlidingProblem problem;
    problem.driving = [=](double t) { return Eigen::Vector2d(-base.acceleration(t), 0); };
    problem.pressing = [](double) { return scenes::papers_gravity; };
    problem.friction = std::tan(friction);
    EngineRun run = run_engine(scene, setting);
    const std::vector<references::SlidingPoint> slid = references::slide(problem, run.history.times);
    const History reference = reference_history(
        problem, run.history.times, [&](double t) { return Eigen::Vector3d(base.displacement(t), 0, 0); });
    run.result.answer = answer_of(run.history);
    run.result.picture = picture_of(run.history, reference);
    run.result.error = worst_error(run.history, reference);
    run.result.note = fmt::format("{}: displacement {:.1e}, {}", phase == 0 ? "sine" : "cosine", run.result.error,
                                  other_quantities(run.history, slid, base));
    return run.result;
}

VerifyResult shake_both(const scenes::SceneSetting& setting)
{
    VerifyResult total;
    add_run(total, shake(setting, 0));
    add_run(total, shake(setting, std::numbers::pi / 2));
    return total;
}

}  // namespace

std::vector<Benchmark> two_blocks_benchmarks()
{
    std::vector<Benchmark> rows{
        {.name = "two-sliding-blocks",
         .title = "A block on a moving block, 0.5 g at 0.25 Hz, friction 18 degrees",
         .source = "ma, section Two Sliding Blocks, figure 1",
         .quantity =
             "largest distance from the rigid blocks (integrated to 1e-8) / largest displacement of the top "
             "block, the worse of two phases",
         .choices =
             "Block 1 x 1 x 0.5 m and 2500 kg/m3 (not given), 10 GPa. Two periods, 8 s (not given). The phase is "
             "not given: the sine from rest, whose base drifts, and the cosine. Figure 1 itself: figure not "
             "available.",
         .paper_error = "\"excellent agreement\", no number",
         .paper_level = {},
         .setting = {},
         .tolerance = 3e-3,
         .sweep = standard_sweep(sliding_steps, stiffness_factors),
         .run = shake_both}};
    rows.push_back(rows.front());
    Benchmark& newmark_block = rows.back();
    newmark_block.name = "newmark-block";
    newmark_block.title += ", rigid, 2 ms";
    newmark_block.choices += " The setting of a case that says nothing of it.";
    newmark_block.setting.time_step = 2e-3;
    newmark_block.tolerance = 1e-5;
    newmark_block.sweep.clear();
    return rows;
}

}  // namespace voussoir::app::studies::verify
