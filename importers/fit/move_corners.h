// A stone whose sides get other planes.
#pragma once

#include <map>
#include <vector>

#include "importers/fit/facing.h"

namespace voussoir::importers::fit
{

/// The vertices of a stone with every corner on the planes of its sides: moved as little as can be. Where more
/// than three planes meet, or two that are nearly one, a corner goes to where it is nearest to them. Other sides
/// stay flat, or become flat, as far as these planes let them, where that takes a move of at most `flat`.
/// @param vertices where they are already [m]
/// @param planes of sides, by number
/// @param flat [m]
std::vector<Eigen::Vector3d> move_corners(const SidedStone& stone, const std::vector<Eigen::Vector3d>& vertices,
                                          const std::map<int, Frame>& planes, double flat);

}  // namespace voussoir::importers::fit
