// The map of a wall of 50 blocks.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/audit.h"
#include "app/studies/stability/axes.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"

namespace voussoir::app::studies::stability
{
namespace
{

constexpr int courses = 10, blocks_a_course = 5;
constexpr double length = 0.6, height = 0.3, thickness = 0.4;  // m, of a block
constexpr double amplitude = 6, period = 1, duration = 1.1;    // m/s2, s, s
constexpr double refinement = 10;                              // of the time step, in what it is compared with

/// Running bond, five blocks a course, every second course begins with half a block; on a base it slides on.
Model wall_of_50(double stiffness)
{
    Model model = make_model(Kinematics::planar_rigid, scenes::stone(), scenes::dry_joint(0.7, stiffness));
    model.thickness = thickness;
    model.joints.push_back(scenes::dry_joint(0.2, stiffness));
    model.joints.back().name = "damp course";
    model.groups = {"wall", "ground"};
    model.joint_of_groups = {0, 1, 1, 1};
    scenes::hold(model, scenes::add_box(model, "ground", {-5, 0, -1}, {8, thickness, 0}));
    model.blocks[0].group = 1;
    for (int course = 0; course < courses; ++course) {
        double left = 0;
        for (int i = 0; i < blocks_a_course; ++i) {
            const bool half = i == (course % 2 == 0 ? blocks_a_course - 1 : 0);
            const double right = left + (half ? 0.5 : 1) * length, foot = course * height;
            scenes::add_box(model, fmt::format("course {} block {}", course + 1, i + 1), {left, 0, foot},
                            {right, thickness, foot + height});
            left = right;
        }
    }
    return model;
}

/// What is compared: statistics, for single blocks are sensitive to everything. [m]
struct WallMotion {
    std::string failure;
    double median_peak = 0, largest_peak = 0, median_residual = 0;  // of displacement along x from the ground
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

/// Displacements of all blocks along x from the ground since they stood at rest.
std::vector<double> displacements(const Model& model, const State& state, const State& rest)
{
    const auto along = [&](const State& of, int block) {
        return pose_in<2>(model.kinematics, of, block).centroid.x();
    };
    const double ground = along(state, 0) - along(rest, 0);
    std::vector<double> values;
    for (int b = 1; b < static_cast<int>(model.blocks.size()); ++b)
        values.push_back(along(state, b) - along(rest, b) - ground);
    return values;
}

WallMotion shake(const Model& model, const State& rest, double time_step, CellRun* counted)
{
    const auto pulse =
        std::make_shared<const GroundMotion>(GroundMotion::sine_acceleration(amplitude, 1 / period, 0, period));
    Stage motion = scenes::motion_stage(duration, time_step);
    motion.motions.push_back({0, 0, pulse});
    State state = rest;
    state.stage = 0;
    begin_stage(model, 0, state);
    std::vector<double> peaks(model.blocks.size() - 1);
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const std::vector<double> moved = displacements(model, now, rest);
        for (std::size_t i = 0; i < peaks.size(); ++i) peaks[i] = std::max(peaks[i], std::abs(moved[i]));
    };
    WallMotion result;
    if (counted) {
        run_counted(model, {motion}, state, observer, *counted);
        result.failure = counted->diagnosis;
    } else {
        result.failure = run_reference(model, {motion}, state, observer);
    }
    result.median_peak = median(peaks);
    result.largest_peak = *std::max_element(peaks.begin(), peaks.end());
    result.median_residual = median(displacements(model, state, rest));
    return result;
}

CellRun run_wall(double stiffness, double time_step)
{
    const Model model = wall_of_50(stiffness);
    CellRun cell;
    State rest = initial_state(model);
    if (!run_counted(model, {scenes::rest_stage()}, rest, {}, cell)) return cell;
    const WallMotion ours = shake(model, rest, time_step, &cell);
    if (!cell.diagnosis.empty()) return cell;
    const WallMotion fine = shake(model, rest, time_step / refinement, nullptr);
    cell.error =
        std::max({std::abs(ours.median_peak - fine.median_peak), std::abs(ours.largest_peak - fine.largest_peak),
                  std::abs(ours.median_residual - fine.median_residual)}) /
        fine.median_peak;
    cell.note = fmt::format("median peak {:.4g} m, largest {:.4g} m, median residual {:.4g} m", ours.median_peak,
                            ours.largest_peak, ours.median_residual);
    if (!fine.failure.empty()) cell.note += "; the run with a finer step failed: " + fine.failure;
    if (!fine.failure.empty()) cell.error = std::numeric_limits<double>::infinity();  // nothing to compare with
    refuse_interpenetration(model, cell);
    return cell;
}

}  // namespace

StabilityScene wall_scene()
{
    StabilityScene scene;
    scene.name = "wall";
    scene.title = "A wall of 50 blocks is shaken";
    scene.quantity =
        "largest difference of median peak, largest peak and median residual displacement of its blocks along the "
        "wall / median peak";
    scene.text =
        "Ten courses of five blocks of 0.6 x 0.3 x 0.4 m (2000 kg/m3, rigid, in the plane) in running bond, "
        "friction coefficient 0.7 between them and 0.2 under the wall, two contact points per joint. The ground "
        "accelerates by one sine of 6 m/s2 and 1 s along the wall: it slides as a whole and deforms in its "
        "joints. It is compared with a run at a ten times smaller step. Results with overlaps of more than half a "
        "block are not accepted.";
    scene.reference = "the same wall at a tenth of the step";
    scene.tolerance = 0.05;
    scene.over_stiffness_and_step = true;
    for (const double k : contact_stiffnesses)
        for (const double h : wall_time_steps)
            add_cell(scene, fmt::format("k={:.0e}", k), {{"contact stiffness", k, "N/m"}}, h, [k, h] {
                return run_wall(k, h);
            }).budget = 600;
    return scene;
}

}  // namespace voussoir::app::studies::stability
