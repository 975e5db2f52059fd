// A column that does not fit as drawn, against the one that was meant.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/audit.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"

namespace voussoir::app::studies::stability
{
namespace
{

constexpr double side = 1, height = 0.4;                        // m, of a block
constexpr double amplitude = 4, period = 0.5, duration = 0.75;  // m/s2, s, s

/// Five blocks on one another and on a held base; their joints overlap and gape in turn by a misfit [m], which is
/// the model's tolerance.
Model column(double misfit)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.3));
    model.fit_tolerance = 1.01 * misfit;
    scenes::hold(model, scenes::add_box(model, "base", {-3, -3, -1}, {3, 3, 0}));
    double top = 0;
    for (int i = 0; i < 5; ++i) {
        const double foot = top + (i % 2 == 0 ? -misfit : misfit);
        top = foot + height;
        scenes::add_box(model, fmt::format("block {}", i + 1), {-side / 2, -side / 2, foot},
                        {side / 2, side / 2, top});
    }
    return model;
}

/// Displacements of all blocks since the model was drawn [m], at rest and shaken by a sine along x.
std::vector<Eigen::Vector3d> shake(const Model& model, double time_step, CellRun& cell)
{
    const State drawn = initial_state(model);
    State state = drawn;
    Stage motion = scenes::motion_stage(duration, time_step);
    // Half a sine: of a whole one the stones slide as far back as they slid before.
    motion.motions.push_back({0, 0,
                              std::make_shared<const GroundMotion>(
                                  GroundMotion::sine_acceleration(amplitude, 1 / period, 0, period / 2))});
    std::vector<Eigen::Vector3d> moved;
    if (!run_counted(model, {scenes::rest_stage(), motion}, state, {}, cell)) return moved;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        moved.push_back(pose_of(model.kinematics, state, b).centroid -
                        pose_of(model.kinematics, drawn, b).centroid);
    return moved;
}

CellRun run_column(double misfit, double time_step)
{
    CellRun cell, meant;
    const Model model = column(misfit);
    const std::vector<Eigen::Vector3d> ours = shake(model, time_step, cell);
    const std::vector<Eigen::Vector3d> perfect = shake(column(0), time_step, meant);
    if (ours.empty() || perfect.empty()) {
        if (cell.diagnosis.empty()) cell.diagnosis = "what it is compared with: " + meant.diagnosis;
        return cell;
    }
    double largest = 0;
    for (std::size_t b = 0; b < ours.size(); ++b) {
        cell.error = std::max(cell.error, (ours[b] - perfect[b]).norm());
        largest = std::max(largest, (perfect[b] - perfect[0]).norm());
    }
    cell.error /= largest;
    cell.note = fmt::format("largest displacement from the ground {:.4g} m", largest);
    refuse_interpenetration(model, cell);
    return cell;
}

}  // namespace

StabilityScene fit_scene()
{
    StabilityScene scene;
    scene.name = "fit";
    scene.title = "A column whose joints overlap and gape as drawn";
    scene.quantity =
        "largest distance of a block from where it is in the column that was meant / largest displacement";
    scene.text =
        "Five blocks of 1 x 1 x 0.4 m (2000 kg/m3, rigid), friction coefficient 0.3, drawn with joints that "
        "overlap "
        "and gape in turn by as much as the fit_tolerance is, come to rest and are pushed along x by half a sine "
        "of "
        "4 "
        "m/s2 and 0.5 s, in which they slide. The same column drawn without errors moves alike: what stones "
        "overlap "
        "and gape by is no load.";
    scene.reference = "the same column without errors of drawing";
    scene.tolerance = 0.05;
    for (const double misfit : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
        for (const double h : {1e-4, 1e-3, 1e-2})
            add_cell(scene, fmt::format("misfit={:.0e}", misfit), {{"misfit", misfit, "m"}}, h,
                     [=] { return run_column(misfit, h); });
    return scene;
}

}  // namespace voussoir::app::studies::stability
