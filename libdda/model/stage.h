// What stays constant in a stage: how the ground moves, what damps, how its steps are made.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "libdda/model/boundary.h"
#include "libdda/model/gravity_ramp.h"
#include "libdda/model/ground_motion.h"
#include "libdda/model/standard_gravity.h"
#include "libdda/model/step_control.h"

namespace voussoir
{

/// Ground motion of one component of one foundation.
struct FoundationMotion {
    int foundation = 0;                          // index into Model::foundations
    int component = 0;                           // 0, 1, 2: x, y, z
    std::shared_ptr<const GroundMotion> motion;  // of the ground
};

/// A body force m a(t) on one block along one axis: the ground's own frame, or a load on a free abutment.
struct BodyAcceleration {
    int block = 0;                               // index into Model::blocks
    int component = 0;                           // 0, 1, 2: x, y, z
    std::shared_ptr<const GroundMotion> motion;  // its acceleration is a(t)
};

/// Kinetic damping: velocities are reduced after each step.
struct Damping {
    double rate = 0;             // 1/s: velocity relative to the ground times exp(-rate h) each step
    double factor_per_step = 1;  // the papers' dynamic coefficient k01; depends on the step, for comparison only
};

/// What a stage looks for.
enum class StageType {
    static_equilibrium,  // rest: velocities are zeroed after each step
    dynamic,             // motion in time
};

/// Constant in a stage.
struct Stage {
    std::string name;                                  // as in the case file
    StageType type = StageType::dynamic;               // static or dynamic
    double duration = 0;                               // s; dynamic only
    Eigen::Vector3d gravity{0, 0, -standard_gravity};  // m/s2
    GravityRamp gravity_ramp;                          // dynamic only: how gravity comes to its value
    std::vector<FoundationMotion> motions;             // components without one stay
    std::vector<BodyAcceleration> body_accelerations;  // beside gravity
    std::vector<IncomingWave> incoming_waves;          // dynamic only
    bool looks_for_rest = false;                       // dynamic: part of a static stage, which lets stones go
    Damping damping;                                   // none by default
    StepControl control;                               // how its steps are made
    // Static only: the stage ends when every block's unbalanced force is below this share of its load in two
    // consecutive steps without change of contact state.
    double unbalanced_tolerance = 1e-8;
    int max_static_steps = 2000;  // of each increment of gravity; then the run gives up
    // Dynamic only: the run ends, collapsed, when this many blocks have fallen; 0: when all have left.
    int stop_after_fallen = 0;
    // Static only: gravity is raised to its value in this many equal increments, for friction remembers its path.
    int gravity_increments = 1;

    /// Whether it moves the structure, which only comes to rest before: damage counts from there.
    bool moves() const { return type == StageType::dynamic || !motions.empty(); }
};

}  // namespace voussoir
