#include "app/studies/stability/one_block.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/engine.h"

namespace voussoir::app::studies::stability
{

using Eigen::Vector3d;

namespace
{

constexpr double reach = 20;  // m, of the base on each side

references::SpringBlock spring_block(const OneBlock& scene)
{
    constexpr double points_an_edge = 2;
    references::SpringBlock block;
    block.half_width = scene.length / 2;
    block.half_height = scene.height / 2;
    block.mass = scene.density * scene.length * scene.width * scene.height;
    block.inertia = block.mass * (scene.length * scene.length + scene.height * scene.height) / 12;
    block.normal_stiffness = points_an_edge * scene.stiffness;
    block.shear_stiffness = JointMaterial{}.shear_to_normal_stiffness * block.normal_stiffness;
    block.friction = scene.friction;
    block.gravity = scenes::papers_gravity;
    block.amplitude = scene.amplitude;
    block.period = scene.period;
    block.pulse_end = scene.pulse_end;
    block.start_lean = scene.start_lean;
    return block;
}

/// The box, turned about its lower +x edge if it leans.
ConvexPolyhedron shape_of(const OneBlock& scene)
{
    const ConvexPolyhedron box =
        make_box({-scene.length, -scene.width / 2, 0}, {0, scene.width / 2, scene.height});
    const bool leans = scene.start_lean != 0;
    const Vector3d edge(scene.length / 2, 0, leans ? -references::start_sink(spring_block(scene)) : 0);
    const Eigen::AngleAxisd turn(scene.start_lean, Vector3d::UnitY());
    std::vector<Vector3d> corners;
    for (const Vector3d& corner : box.vertices) corners.push_back(edge + turn * corner);
    return make_convex_polyhedron(corners, box.faces, "block");
}

Model model_of(const OneBlock& scene)
{
    JointMaterial joint = scenes::dry_joint(scene.friction, scene.stiffness);
    joint.face = FaceLaw::corners;  // the reference has springs under the edges
    Model model = make_model(scene.kinematics, scenes::stone(scene.density, scene.young), joint);
    scenes::hold(model,
                 scenes::add_box(model, "base", {-reach, -2 * scene.width, -2}, {reach, 2 * scene.width, 0}));
    model.blocks.push_back(make_block("block", 0, 0, {shape_of(scene)}));
    return model;
}

references::SpringBlockPoint point_of(const Model& model, const State& state)
{
    const Pose block = pose_of(model.kinematics, state, 1);
    const double base = pose_of(model.kinematics, state, 0).centroid.x();
    return {block.centroid.x() - base, std::atan2(block.map(0, 2), block.map(2, 2))};
}

/// Until it has nearly come back, or fallen.
double first_swing(const OneBlock& scene)
{
    constexpr double sample = 1e-3, longest = 4, fallen = 0.5;  // s, s, rad
    constexpr double share_of_return = 0.05;                    // of the largest lean
    std::vector<double> times;
    for (int i = 1; i <= static_cast<int>(longest / sample); ++i) times.push_back(i * sample);
    const std::vector<references::SpringBlockPoint> points =
        references::block_on_springs(spring_block(scene), times);
    double largest = std::abs(scene.start_lean);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double lean = std::abs(points[i].lean);
        largest = std::max(largest, lean);
        const bool swung = times[i] > scene.pulse_end && lean < share_of_return * largest;
        if (lean > fallen || swung) return times[i];
    }
    return longest;
}

/// Largest distance from the reference over all times, and its largest size.
std::pair<double, double> distance_of(const OneBlockHistory& history, double references::SpringBlockPoint::*what)
{
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < history.exact.size(); ++i) {
        const double distance = std::abs(history.engine[i].*what - history.exact[i].*what);
        if (!std::isfinite(distance)) return {distance, largest};  // nothing is larger than NaN
        worst = std::max(worst, distance);
        largest = std::max(largest, std::abs(history.exact[i].*what));
    }
    return {worst, largest};
}

}  // namespace

CellRun run_swing(OneBlock scene, double time_step)
{
    scene.duration = first_swing(scene);
    CellRun cell;
    const OneBlockHistory history = run_one_block(scene, time_step, cell);
    const auto [worst, largest] = distance_of(history, &references::SpringBlockPoint::lean);
    cell.error = worst / largest;
    cell.note += fmt::format("; largest lean {:.3g} rad in {:.3g} s", largest, scene.duration);
    return cell;
}

OneBlock sliding_block(double stiffness)
{
    OneBlock scene;
    scene.height = 0.1;
    scene.friction = 0.2;
    scene.stiffness = stiffness;
    scene.amplitude = 5;
    scene.period = scene.pulse_end = 3;
    scene.duration = 3.5;
    return scene;
}

CellRun run_sliding(const OneBlock& scene, double time_step)
{
    CellRun cell;
    const OneBlockHistory history = run_one_block(scene, time_step, cell);
    const auto [worst, largest] = distance_of(history, &references::SpringBlockPoint::x);
    cell.error = worst / largest;
    return cell;
}

namespace
{

/// What the springs say of a run that gave up.
std::string sink_in_words(const OneBlock& scene)
{
    const references::SpringBlock block = spring_block(scene);
    const double standing = block.mass * block.gravity / (2 * block.normal_stiffness);
    const double sink = scene.start_lean != 0 ? references::start_sink(block) : standing;
    const double least = std::min({scene.length, scene.width, scene.height});
    return fmt::format("by the reference it settles {:.3g} m, {:.3g} % of its least width, under its weight alone",
                       sink, 100 * sink / least);
}

}  // namespace

OneBlockHistory run_one_block(const OneBlock& scene, double time_step, CellRun& cell)
{
    const Model model = model_of(scene);
    State state = initial_state(model);
    OneBlockHistory history;
    cell.note = sink_in_words(scene);
    if (scene.start_lean == 0 && !run_counted(model, {scenes::rest_stage()}, state, {}, cell)) return history;
    Stage motion = scenes::motion_stage(scene.duration, time_step);
    motion.control.integrator = scene.integrator;
    motion.control.step_error = scene.step_error;
    if (scene.amplitude > 0) {
        const GroundMotion pulse =
            GroundMotion::sine_acceleration(scene.amplitude, 1 / scene.period, 0, scene.pulse_end);
        motion.motions.push_back({0, 0, std::make_shared<const GroundMotion>(pulse)});
    }
    state.stage = 0;
    begin_stage(model, 0, state);
    const double start = point_of(model, state).x;
    double loss = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport& report) {
        const references::SpringBlockPoint point = point_of(model, now);
        history.times.push_back(now.stage_time);
        history.engine.push_back({point.x - start, point.lean + scene.start_lean});
        loss = report.energy.algorithmic;
    };
    if (!run_counted(model, {motion}, state, observer, cell)) return history;
    history.exact = references::block_on_springs(spring_block(scene), history.times);
    cell.note = fmt::format("loss of the integrator {:.3g} J", loss);
    return history;
}

}  // namespace voussoir::app::studies::stability
