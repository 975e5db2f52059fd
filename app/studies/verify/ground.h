// Columns of ground: layers without sides on a viscous base, for waves from below.
#pragma once

#include <vector>

#include "app/studies/verify/run_scene.h"

namespace voussoir::app::studies::verify
{

/// A layer of blocks that are as thick as one another.
struct GroundLayer {
    double thickness = 0;  // m
    double speed = 0;      // m/s, of S waves
    int blocks = 1;
    RayleighDamping damping = {};
    std::vector<MaxwellBranch> branches = {};  // `speed` is then that at rest
};

/// Layers from below, all of one density and Poisson's ratio, bonded.
struct GroundColumn {
    std::vector<GroundLayer> layers;
    double density = 2000, poisson = 0.25;  // kg/m3, -
    double joints = 1;                      // times the default stiffness of joints
};

/// A column whose sides are tied and whose lowest face is viscous. Without gravity; no stage yet.
Model ground_model(const scenes::SceneSetting& setting, const GroundColumn& column);

/// The pulse of Ricker as a velocity, its peak [m/s] at 1.2 / frequency.
GroundMotion ricker_velocity(double peak, double frequency);

/// Velocity of the surface of a column along an axis, at every step of a run in which `motion` is the wave.
struct SurfaceMotion {
    std::vector<double> times, velocities;  // s, m/s
    RunReport report;
};
SurfaceMotion surface_motion(const scenes::SceneSetting& setting, const Model& model, int component,
                             const GroundMotion& motion, double duration, VerifyResult& result);

/// Rayleigh's damping with the same ratio at two frequencies [Hz].
RayleighDamping rayleigh(double ratio, double low, double high);

/// Layers on rock.
std::vector<Benchmark> ground_response_rows();

/// The decay of a column that is damped.
std::vector<Benchmark> ground_decay_rows();

}  // namespace voussoir::app::studies::verify
