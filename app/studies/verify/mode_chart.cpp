// First motion of a block on an incline, point by point of the chart.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/families.h"
#include "app/studies/verify/mode_chart_points.h"
#include "app/studies/verify/run_scene.h"
#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

using Eigen::Vector3d;
using references::Mode;

namespace
{

constexpr double degrees = std::numbers::pi / 180;
// The chart has neither length nor modulus in it. Half a diagonal of 30 m turns by less than 0.01 degree in the 30
// ms that are watched, so that what is seen is the first motion; the modulus makes the slowest vibration on the
// contact springs short against the ramp, as for the rigid block of the chart.
constexpr double half_diagonal = 30, thickness = 15;  // m
constexpr double density = 2500, young = 1e16;
constexpr double ramp = 12e-3, watched = 30e-3;  // s
// Of the forces of a block, what a step may leave unbalanced: less than the kinematics are to agree to.
constexpr double tightness = 1e-7;
// Accelerations below this are none: there is some vibration on the contact springs.
constexpr double smallest = 1e-4;  // of force / mass

/// The load per mass as the plane sees it: x down the slope, z out of it.
Vector3d gravity_on(const ChartCase& point)
{
    return scenes::papers_gravity * Vector3d(std::sin(point.alpha), 0, -std::cos(point.alpha));
}

Vector3d push_on(const ChartCase& point)
{
    const double beta = point.chart.psi - point.alpha;
    return scenes::papers_gravity * std::tan(beta) * Vector3d(std::cos(point.alpha), 0, std::sin(point.alpha));
}

BodyAcceleration body_load(int component, std::vector<double> samples, double time_step)
{
    const GroundMotion motion = GroundMotion::from_acceleration(std::move(samples), time_step, "load");
    return {1, component, std::make_shared<const GroundMotion>(motion)};
}

/// A hand holds the block against the slope and lets go within `ramp`, gently, for a sudden load on elastic
/// contacts overshoots twofold.
scenes::StagedScene chart_scene(const scenes::SceneSetting& setting, const ChartCase& point)
{
    JointMaterial joint;
    joint.face = FaceLaw::corners;  // between the modes it rocks on its springs by less than the chart tells apart
    joint.name = "joint";
    joint.friction_angle = point.chart.phi;
    const double width = 2 * half_diagonal * std::sin(point.chart.delta);
    const double height = 2 * half_diagonal * std::cos(point.chart.delta);
    joint.stiffness = scenes::stiffness_by_rule(setting, height / young);
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"rock", density, young, 0.2}, joint, thickness);
    scenes::hold(scene.model,
                 scenes::add_box(scene.model, "slope", {-90, -0.5 * thickness, -15}, {90, 0.5 * thickness, 0}));
    scenes::add_box(scene.model, "block", {-0.5 * width, -0.5 * thickness, 0},
                    {0.5 * width, 0.5 * thickness, height});

    const Vector3d weight = gravity_on(point), push = push_on(point);
    Stage held = scenes::static_stage(setting, weight), freed = scenes::dynamic_stage(setting, watched, weight);
    const double forever = 1e3;  // s
    held.body_accelerations = {body_load(0, {-weight.x(), -weight.x()}, forever),
                               body_load(2, {push.z(), push.z()}, forever)};
    std::vector<double> samples;
    const double interval = ramp / 64;
    for (int i = 0; (i - 1) * interval <= watched; ++i) {  // one sample beyond the end
        const double share = std::min(1.0, i / 64.0), hand = 0.5 * (1 + std::cos(std::numbers::pi * share));
        samples.push_back(push.x() - hand * (weight.x() + push.x()));
    }
    freed.body_accelerations = {body_load(0, samples, interval), body_load(2, {push.z(), push.z()}, forever)};
    scene.stages = {held, freed};
    for (Stage& stage : scene.stages) stage.control.force_tolerance = tightness;
    return scene;
}

/// Speeds of the lower edge along the slope [m/s] and of rotation towards the valley, times half the diagonal.
struct Motion {
    double slip = 0, turn = 0;
};

Motion motion_of(const Model& model, const State& state, const ChartCase& point)
{
    const Vector3d lever(half_diagonal * std::sin(point.chart.delta), 0,
                         -half_diagonal * std::cos(point.chart.delta));
    const Vector3d spin = angular_velocity_of(model, state, 1);
    const Pose pose = pose_of(model.kinematics, state, 1);
    const Vector3d edge = velocity_of(model.kinematics, state, 1) + spin.cross(Vector3d(pose.map * lever));
    return {edge.x(), half_diagonal * spin.y()};
}

/// Mean accelerations from the end of the ramp on, in units of force / mass.
Motion first_motion(const scenes::SceneSetting& setting, const ChartCase& point, VerifyResult& result)
{
    const scenes::StagedScene scene = chart_scene(setting, point);
    State state = initial_state(scene.model);
    Motion early, late;
    double early_time = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (now.stage == 0) return;
        late = motion_of(scene.model, now, point);
        if (now.stage_time > ramp * (1 + 1e-9)) return;
        early = late;
        early_time = now.stage_time;
    };
    run_scene(scene, state, observer, result);
    const double scale = (watched - early_time) * (gravity_on(point) + push_on(point)).norm();
    return {(late.slip - early.slip) / scale, (late.turn - early.turn) / scale};
}

Mode mode_from(const Motion& motion)
{
    const bool slides = motion.slip > smallest, topples = motion.turn > smallest;
    if (slides && topples) return Mode::both;
    if (slides) return Mode::sliding;
    return topples ? Mode::toppling : Mode::stable;
}

/// How far the seen accelerations are from the chart's.
struct Spread {
    double largest_of_none = 0, smallest_of_some = INFINITY, largest_difference = 0;
};

void add(double seen, double expected, Spread& spread)
{
    if (expected == 0)
        spread.largest_of_none = std::max(spread.largest_of_none, std::abs(seen));
    else
        spread.smallest_of_some = std::min(spread.smallest_of_some, seen);
    spread.largest_difference = std::max(spread.largest_difference, std::abs(seen - expected));
}

VerifyResult run_chart(const scenes::SceneSetting& setting, ChartKind kind, int count, std::uint64_t seed)
{
    VerifyResult result;
    int wrong = 0;
    std::string where;
    Spread spread;
    for (const ChartCase& point : chart_points(kind, count, seed)) {
        const Mode expected = references::mode_of(point.chart);
        const Motion seen = first_motion(setting, point, result);
        if (!result.failure.empty()) return result;
        double slip = 0, turn = 0;
        references::first_accelerations(point.chart, expected, slip, turn);
        result.answer.insert(result.answer.end(), {seen.slip, seen.turn});
        add(seen.slip, slip, spread);
        add(seen.turn, turn, spread);
        if (mode_from(seen) == expected) continue;
        ++wrong;
        where += fmt::format(
            "; psi {:.2f} delta {:.2f} phi {:.2f}: {} instead of {} ({:.1e}, {:.1e} for {:.1e}, {:.1e})",
            point.chart.psi / degrees, point.chart.delta / degrees, point.chart.phi / degrees,
            references::name_of(mode_from(seen)), references::name_of(expected), seen.slip, seen.turn, slip, turn);
    }
    result.error = static_cast<double>(wrong) / count;
    result.paper_measure = wrong;
    result.note = fmt::format(
        "{} of {} points disagree (seed {}); largest motion where none is expected {:.0e}, smallest where motion "
        "is expected {:.0e}, largest difference {:.0e} (of force / mass){}",
        wrong, count, seed, spread.largest_of_none, spread.smallest_of_some, spread.largest_difference, where);
    return result;
}

Benchmark row(const std::string& name, const std::string& title, const std::string& source,
              const std::string& paper_error, ChartKind kind, int count, std::uint64_t seed)
{
    Benchmark benchmark;
    benchmark.name = name;
    benchmark.title = title;
    benchmark.source = source;
    benchmark.quantity = "fraction of points whose first motion differs from the chart";
    benchmark.paper_error = paper_error;
    benchmark.setting.time_step = 1e-3;
    benchmark.sweep = sweep_of(benchmark.setting, {2e-3, 1e-3, 5e-4, 2e-4});
    benchmark.run = [=](const scenes::SceneSetting& setting) { return run_chart(setting, kind, count, seed); };
    return benchmark;
}

}  // namespace

std::vector<Benchmark> mode_chart_benchmarks(std::uint64_t seed)
{
    // Each chart has points of its own.
    std::vector<Benchmark> charts{
        row("mode-chart-gravity", "First motion on an incline, gravity", "yagoda-biran-hatzor, section 3.2.2.1",
            "2 of 51 points", ChartKind::gravitational, 51, 3 * seed),
        row("mode-chart-pseudo-static-2d", "First motion under an earthquake force, the planar set",
            "yagoda-biran-hatzor, section 3.2.1.1", "4 of 110 points", ChartKind::pseudo_static, 110,
            3 * seed + 1),
        row("mode-chart-pseudo-static-3d", "First motion under an earthquake force, the spatial set",
            "yagoda-biran-hatzor, section 3.2.2.2", "none of 89 points", ChartKind::pseudo_static, 89,
            3 * seed + 2)};
    add_planar(charts[0]);
    make_planar(charts[1], false);
    add_planar(charts[2]);
    return charts;
}

}  // namespace voussoir::app::studies::verify
