// The block that Li drops and lets settle.
#pragma once

#include <vector>

#include "app/studies/verify/run_scene.h"

namespace voussoir::app::studies::verify
{

/// A cube of 2 m above a held plate, poisson 0.15, frictionless. Source: [Li2017], "Block rebound model".
struct LiBlock {
    double density = 2000;       // kg/m3
    double young = 3e8;          // Pa
    double corner_spring = 3e8;  // N/m, at each of the four corners
    double height = 0;           // m, of the lower face above the plate
};
constexpr double li_side = 2;        // m
constexpr double li_poisson = 0.15;  // -

/// @param duration [s] of the dynamic stage; there is no static one
scenes::StagedScene li_scene(const scenes::SceneSetting& setting, const LiBlock& block, double duration);

/// What a dropped block does.
struct Bounces {
    std::vector<double> heights;  // m, of the lower face: the drop, then the apex after each bounce
    double corner_depth = 0;      // m, penetration of the first impact
    double centroid_depth = 0;    // m, of the first impact: penetration and compression of the lower half
    double loss(int bounce) const { return 1 - heights[bounce + 1] / heights[bounce]; }
};

/// Drops the block and watches `count` bounces; adds the cost to `result`, and a failure when one is missing.
Bounces drop(const scenes::SceneSetting& setting, const LiBlock& block, int count, VerifyResult& result);

/// The tables and trends of the paper as benchmarks, and the exact rebound beside them.
std::vector<Benchmark> rebound_rows();

}  // namespace voussoir::app::studies::verify
