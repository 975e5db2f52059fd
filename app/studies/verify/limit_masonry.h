// Walls and arches under a horizontal load, and the factor of it at which they become a mechanism: by limit
// analysis over the engine's own contacts, and by the engine's static stages.
#pragma once

#include <cstdint>
#include <string>

#include "app/studies/scenes/scene_setting.h"
#include "importers/patterns/vaults.h"
#include "importers/patterns/wall.h"
#include "libdda/limit/limit_problem.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"

namespace voussoir::app::studies::verify
{

/// Stones on held ones, and what they are.
struct LimitMasonry {
    std::string description;  // one line
    Model model;
};

/// Adds a stone of group 0; a planar scene takes the outline of a prism along y.
void add_stone(Model& model, const std::string& name, const ConvexPolyhedron& shape);

/// Adds the stones of a wall to a model; its base is held.
void add_wall(Model& model, const importers::patterns::Wall& wall);

/// Adds the stones of a barrel vault, one along each course, to a model; the supports are held.
void add_arch(Model& model, const importers::patterns::BarrelVault& vault);

/// A circular arch of one ring, half a metre wide, mean radius 2 m. @param share thickness / mean radius
/// @param half_embrace [rad]
importers::patterns::BarrelVault circular_arch(double share, double half_embrace, int courses);

constexpr std::uint64_t limit_masonry_seed = 1;  // of the 200 of the tests

/// The n-th of a row of random walls (running bond, every third with a window) and circular arches, two walls to
/// an arch: every fifth is spatial, the others planar, all rigid. Aspect, stones, thickness, embrace and friction
/// (0.3 to 0.8) are drawn; the same seed draws the same on every machine.
/// @param in_plane the spatial ones as planar scenes: all of them are prisms, pushed in their plane
LimitMasonry random_masonry(std::uint64_t seed, int n, bool in_plane = false);

/// The blocks and contact points of a model at its start as limit analysis takes them: their weight stays, so much
/// of it along +x is the live load. Cohesion is left out.
limit::LimitProblem limit_problem(const Model& model, limit::FacePoints points = limit::FacePoints::corners);

/// A run of one static stage under the weight and `factor` of it along +x.
struct Pushed {
    RunReport report;
    double cpu_time = 0;  // s
};
Pushed push(const Model& model, double factor, const scenes::SceneSetting& setting = {});

/// Between which two factors the verdict changes from `completed` to something else.
struct EngineThreshold {
    double stands = 0, falls = 0;
    std::int64_t steps = 0, step_cuts = 0, iterations = 0;  // of all runs
    double cpu_time = 0;                                    // s
};

/// By bisection between a factor that stands and one that falls, to a share `width` of the latter.
EngineThreshold engine_threshold(const Model& model, double stands, double falls, double width,
                                 const scenes::SceneSetting& setting = {});

}  // namespace voussoir::app::studies::verify
