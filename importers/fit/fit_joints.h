// Stones of a survey fitted to each other: what faces each other gets one surface.
#pragma once

#include <string>
#include <vector>

#include "importers/fit/side.h"

namespace voussoir::importers::fit
{

/// What becomes of joints whose two sides were drawn differently.
enum class FitJoints {
    as_drawn,  // nothing
    shared,    // of warped ones the corners are shared and lie in one plane
    planar,    // the same of all, however bent they are, flat ones and those that are bent alike among them
};

/// What is allowed.
struct FitOptions {
    FitJoints how = FitJoints::shared;
    double planarity = 1e-5;     // share of a stone's diagonal: joints that are nearer to each other fit already
    double volume_error = 0.01;  // share of a stone's volume that its hull may exceed it by, on its free sides
};

/// What became of one stone.
struct FittedStone {
    bool fitted = false;        // its surface was changed
    double largest_move = 0;    // m: of a corner
    std::vector<Frame> joints;  // planes of its sides that face others
    std::string left;           // why it was left as drawn although its joints do not fit; empty if it was not
};

/// What became of an assembly.
struct Fit {
    std::vector<FittedStone> stones;  // in their order
    int joints = 0;                   // that did not fit, and do now
    int left = 0;                     // that did not fit, and were left
    double misfit_before = 0;         // m: largest overlap or gap between the sides of a joint as drawn
    double misfit_after = 0;          // m: the same when all is done
};

/// Fits the joints of an assembly: the sides of stones that lie on each other, as a survey or a form-finding
/// program gives them, warped and each with diagonals of its own. Corners that neighbours have in common become
/// one and move until every side that faces another one is flat (share_corners), a bed that faces two stones of a
/// curved course in two planes; free sides follow, and a stone that is convex but for them becomes convex.
/// Assemblies whose joints fit are not touched.
/// @param stones closed, outward, not crossing themselves [m]; changed in place. nullptr: a stone that takes no
/// part
Fit fit_joints(const std::vector<mesh::PolygonSurface*>& stones, const FitOptions& options);

}  // namespace voussoir::importers::fit
