// Walls and arches under a horizontal load, and the factor of it at which they become a mechanism: by limit
// analysis over the engine's own contacts, and by the engine's static stages.
#pragma once

#include <cstdint>
#include <string>

#include "app/studies/scenes/scene_setting.h"
#include "app/studies/verify/references/limit_analysis.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"

namespace voussoir::app::studies::verify
{

/// Stones on held ones, and what they are.
struct LimitMasonry {
    std::string description;  // one line
    Model model;
};

/// The n-th of a row of random walls (running bond, every third with a window) and circular arches, two walls to
/// an arch: every fifth is spatial, the others planar, all rigid. Aspect, stones, thickness, embrace and friction
/// (0.3 to 0.8) are drawn; the same seed draws the same on every machine.
LimitMasonry random_masonry(std::uint64_t seed, int n);

/// The blocks and contact points of a model at its start as limit analysis takes them: their weight stays,
/// `factor` of it along +x is the live load. Cohesion is left out.
references::LimitProblem limit_problem(const Model& model);

/// A static stage under the weight and `factor` of it along +x.
Stage pushed(const scenes::SceneSetting& setting, double factor);

/// What the engine says of it.
RunReport push(const Model& model, const Stage& stage);

/// Where the engine's verdict changes from `completed` to something else, between two factors of which the first
/// stands and the second does not, to a share `width` of it; how often it ran.
struct EngineThreshold {
    double stands = 0, falls = 0;
    int runs = 0;
};
EngineThreshold engine_threshold(const Model& model, double stands, double falls, double width);

}  // namespace voussoir::app::studies::verify
