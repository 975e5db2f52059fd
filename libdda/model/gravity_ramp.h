// Gravity that grows or turns in the course of a stage: for watching a structure fall.
#pragma once

#include <Eigen/Core>

namespace voussoir
{

/// How gravity comes to its value from another one, at the start of a stage.
struct GravityRamp {
    double duration = 0;                             // s; 0: gravity has its value from the start
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  // m/s2, at the start
    bool turns = false;                              // at a constant rate; else its components grow in proportion
};

/// Mean of gravity between two times of a stage [m/s2]; its value at that time when both are the same. Exact when
/// it grows in proportion; of second order in their distance when it turns.
/// @param gravity the value it comes to [m/s2] @param start, end stage times [s], start <= end
Eigen::Vector3d mean_gravity(const GravityRamp& ramp, const Eigen::Vector3d& gravity, double start, double end);

}  // namespace voussoir
