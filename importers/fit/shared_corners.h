// Corners of neighbouring stones made one, and moved until the sides that face each other are flat.
#pragma once

#include <map>
#include <vector>

#include "importers/fit/facing.h"

namespace voussoir::importers::fit
{

/// A side of a stone, by number.
struct SideOf {
    int stone = 0, side = 0;
    auto operator<=>(const SideOf&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 errs
};

/// What a fit comes to.
struct SharedShape {
    std::map<SideOf, Frame> planes;                      // of all sides that face others
    std::vector<std::vector<Eigen::Vector3d>> vertices;  // of each stone [m]
    std::map<SideOf, double> misfit;                     // m: how far a corner of the joints lies off the plane
};

/// Corners that two facing sides have in common, but for noise, become one. They are then moved as little as can
/// be so that every side that faces another one is flat, and the corners of what faces it lie in its plane: a
/// joint of two sides has one plane, and where four stones meet their corners stay one point. What cannot be flat,
/// a side that faces two stones of a curved course, keeps the least squares of it, in `misfit`. Gauss-Newton's
/// iteration on corners and planes. Source: [LiuPottmann2006] (flat faces as the constraint; the rest is ours).
/// @param joints sides that are nearly flat
SharedShape share_corners(const std::vector<SidedStone>& stones, const std::vector<Facing>& joints);

}  // namespace voussoir::importers::fit
