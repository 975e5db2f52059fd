// Rods and dowels of scenes.
#pragma once

#include "libdda/model/model.h"

namespace voussoir::app::studies::scenes
{

/// A rod between the centroids of two blocks that pulls, elastic. @param stiffness [N/m]
inline Bar rod_between(const Model& model, int a, int b, double stiffness)
{
    Bar bar;
    bar.name = "rod";
    bar.block_a = a;
    bar.block_b = b;
    bar.length = (model.blocks[static_cast<std::size_t>(b)].moments.centroid -
                  model.blocks[static_cast<std::size_t>(a)].moments.centroid)
                     .norm();
    bar.axial = stiffness;
    return bar;
}

/// A dowel that holds the shear of a horizontal joint. @param at its place [m]; @param stiffness [N/m]; @param
/// shear at which it yields [N]
inline Bar dowel_in(const Model& model, int a, int b, const Eigen::Vector3d& at, double stiffness, double shear)
{
    Bar bar;
    bar.name = "dowel";
    bar.block_a = a;
    bar.block_b = b;
    bar.anchor_a = at - model.blocks[static_cast<std::size_t>(a)].moments.centroid;
    bar.anchor_b = at - model.blocks[static_cast<std::size_t>(b)].moments.centroid;
    bar.is_rod = false;
    bar.lateral = stiffness;
    bar.shear = shear;
    bar.tension = 0;
    return bar;
}

}  // namespace voussoir::app::studies::scenes
