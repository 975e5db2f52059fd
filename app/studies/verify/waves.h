// Stacked layers for shear waves: constant-strain blocks, bonded, much wider than high.
#pragma once

#include <memory>
#include <vector>

#include "app/studies/verify/references/layered_site.h"
#include "app/studies/verify/run_scene.h"

namespace voussoir::app::studies::verify
{

/// A layer of one or more blocks.
struct Layer {
    double thickness = 0;  // m
    double speed = 0;      // m/s, of shear waves in the intact material
    int blocks = 1;
};

/// Layers from the base upwards on a rigid base that moves along x. All joints are bonded: elastic springs of the
/// documented stiffness that neither open nor slide. No gravity, for nothing else acts on an elastic stack.
struct Column {
    std::vector<Layer> layers;
    double density = 0;  // kg/m3
    double poisson = 0;  // -
    double width = 0;    // m; a stack that is wide against its height shears and does not bend
};

scenes::StagedScene column_scene(const scenes::SceneSetting& setting, const Column& column,
                                 const GroundMotion& base, double duration);

/// The same blocks and joints for the exact solutions: one entry per block.
std::vector<references::SiteLayer> site_of(const scenes::SceneSetting& setting, const Column& column);

/// Young's modulus of a layer [Pa].
double young_of(const Column& column, const Layer& layer);

/// The response of 15 layers against the exact solution.
std::vector<Benchmark> site_rows();

/// A wave through a joint that slips.
std::vector<Benchmark> slip_rows();

}  // namespace voussoir::app::studies::verify
