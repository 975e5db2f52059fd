#include "app/studies/stability/run_down.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/stability/engine.h"

namespace voussoir::app::studies::stability
{

using Eigen::Vector3d;

void run_down(const Model& model, double angle, double friction, double g, double time_step, CellRun& cell)
{
    constexpr double mobilised = 1 - 1e-5;  // a static stage has no answer at the limit itself
    constexpr double duration = 1;          // s
    const double dip = angle * std::numbers::pi / 180;
    Stage rest = scenes::rest_stage(), motion = scenes::motion_stage(duration, time_step);
    motion.gravity = g * Vector3d(std::sin(dip), 0, -std::cos(dip));
    rest.gravity = motion.gravity;
    rest.gravity.x() = std::min(rest.gravity.x(), mobilised * friction * -rest.gravity.z());
    State state = initial_state(model);
    if (!run_counted(model, {rest}, state, {}, cell)) return;
    state.stage = 0;
    begin_stage(model, 0, state);
    const Vector3d start = pose_of(model.kinematics, state, 1).centroid;
    if (!run_counted(model, {motion}, state, {}, cell)) return;
    const Vector3d moved = pose_of(model.kinematics, state, 1).centroid - start;
    const double exact = std::max(0.0, 0.5 * g * (std::sin(dip) - friction * std::cos(dip)) * duration * duration);
    cell.error = (moved - Vector3d(exact, 0, 0)).norm() / (exact > 0 ? exact : size_of(model, 1));
}

}  // namespace voussoir::app::studies::stability
