#include "app/studies/stability/audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/studies/stability/engine.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::stability
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_held(const Model& model, int block)
{
    return std::any_of(model.foundations.begin(), model.foundations.end(),
                       [&](const Foundation& foundation) { return foundation.block == block; });
}

/// Sum over all blocks that have unknowns.
double weight_of(const Model& model, double g)
{
    double mass = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (!is_held(model, b)) mass += model.mass(b);
    return mass * g;
}

/// Vertical force of the structure on what is held [N].
double pressure_on_ground(const Model& model, const State& state)
{
    double sum = 0;
    for (const ContactPatch& patch : state.contacts.patches) {
        const bool a_held = is_held(model, patch.block_a), b_held = is_held(model, patch.block_b);
        if (a_held == b_held) continue;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPoint& point = state.contacts.points[i];
            const double on_a = point.normal_force * patch.normal.z() - point.shear_force.z();
            sum += b_held ? on_a : -on_a;
        }
    }
    return sum;
}

double farthest_from(const Model& model, const State& start, const State& now)
{
    double farthest = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        farthest = std::max(
            farthest,
            (pose_of(model.kinematics, now, b).centroid - pose_of(model.kinematics, start, b).centroid).norm());
    return farthest;
}

double lowest_centroid(const Model& model, const State& state)
{
    double lowest = infinity;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (!is_held(model, b)) lowest = std::min(lowest, pose_of(model.kinematics, state, b).centroid.z());
    return lowest;
}

}  // namespace

double smallest_size(const Model& model)
{
    double smallest = infinity;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (!is_held(model, b)) smallest = std::min(smallest, size_of(model, b));
    return smallest;
}

void refuse_interpenetration(const Model& model, CellRun& cell)
{
    if (cell.max_penetration <= smallest_size(model) / 2) return;
    cell.note += fmt::format("; blocks overlap by {:.3g} m", cell.max_penetration);
    cell.error = infinity;
}

void run_at_rest(const Model& model, double time_step, double duration, double g, CellRun& cell)
{
    State state = initial_state(model);
    if (!run_counted(model, {scenes::rest_stage(g)}, state, {}, cell)) return;
    const double weight = weight_of(model, g);
    const double unbalanced = weight > 0 ? std::abs(pressure_on_ground(model, state) - weight) / weight : 0;
    const State rest = state;
    state.stage = 0;
    begin_stage(model, 0, state);
    if (!run_counted(model, {scenes::motion_stage(duration, time_step, g)}, state, {}, cell)) return;
    const double drift = farthest_from(model, rest, state) / smallest_size(model);
    cell.error = std::max(unbalanced, drift);
    cell.note = fmt::format("force {}, drift {}", words::error_in_words(unbalanced), words::error_in_words(drift));
    cell.energy_residual = std::numeric_limits<double>::quiet_NaN();  // nothing moved: a share of nothing
    refuse_interpenetration(model, cell);
}

void run_audited(const Model& model, const Stage& motion, double lowest, State& state, CellRun& cell)
{
    state.stage = 0;
    begin_stage(model, 0, state);
    double appeared = 0, scale = 0;
    EnergyLedger last;
    RunObserver observer;
    observer.step = [&](const State&, const StepReport&, const RunReport& report) {
        const EnergyLedger& energy = last = report.energy;
        appeared = std::max(appeared, -energy.dissipated());
        scale = std::max({scale, std::abs(energy.input()), energy.start_kinetic + energy.start_strain});
    };
    if (!run_counted(model, {motion}, state, observer, cell)) return;
    const double gained = appeared > 0 ? appeared / scale : 0,
                 given = last.peak_given > 0 ? last.peak_given / scale : 0;
    cell.error = std::max({cell.energy_residual, gained, given});
    cell.note = fmt::format(
        "unaccounted {}, appeared {}, given by newly detected contacts {} of {:.3g} J; at the end friction "
        "{:.3g}, integrator {:.3g}, rotation {:.3g}, redetection {:.3g} J",
        words::error_in_words(cell.energy_residual), words::error_in_words(gained), words::error_in_words(given),
        scale, last.friction, last.algorithmic, last.algorithmic_rotation, last.redetection);
    refuse_interpenetration(model, cell);
    if (lowest_centroid(model, state) >= lowest) return;
    cell.note += "; a block fell through the ground";
    cell.error = infinity;
}

}  // namespace voussoir::app::studies::stability
