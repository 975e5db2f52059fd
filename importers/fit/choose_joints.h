// Which joints of an assembly have to be fitted together.
#pragma once

#include <vector>

#include "importers/fit/shared_corners.h"

namespace voussoir::importers::fit
{

/// Joints to be fitted.
struct JointChoice {
    std::vector<Facing> joints;  // those that do not fit, and those whose sides hang together with one of them
    int left = 0;                // that do not fit, but have a side that is bent too much to be flattened
    double misfit = 0;           // m: the largest of all, as drawn

    int misfitting() const;  ///< Of the joints, how many do not fit.
};

/// What is a joint that can be fitted.
struct JointLimits {
    double planarity = 1e-5;   // share of a stone's diagonal: joints whose sides are nearer to each other fit
    double flat_enough = 0.2;  // share of a side's size: what bends further is no plane
    bool flatten = false;      // joints whose sides are bent alike do not fit either, nor flat ones that overlap
};

JointChoice choose_joints(const std::vector<SidedStone>& stones, const std::vector<Facing>& joints,
                          const JointLimits& limits);

/// Divides sides that face several stones, as the beds of a curved course in bond, into one for each of those
/// stones, along edges of the surface: those of `bent`, and all that hang together with one by joints.
/// @returns whether there were any
bool split_sides(const std::vector<Facing>& joints, const std::vector<SideOf>& bent,
                 std::vector<SidedStone>& stones);

/// Sides of joints that bend too much to be flattened.
std::vector<SideOf> bent_sides(const std::vector<Facing>& joints, const std::vector<SidedStone>& stones,
                               const JointLimits& limits);

/// Sides that are no plane when whole: sharing corners has not made them flat, or only by moving corners more than
/// twice as far as it takes when every side is divided.
/// @param whole, divided what sharing corners comes to, the vertices of the stones in the same order
std::vector<SideOf> bent_sides(const std::vector<Facing>& joints, const std::vector<SidedStone>& stones,
                               const SharedShape& whole, const SharedShape& divided);

/// Takes out the joints that could only be made flat by moving corners far, and what hangs together with them:
/// sides that face several stones of a curved course and have no edge to be divided at. @returns whether there
/// were any
bool leave_bent_joints(const SharedShape& shape, const std::vector<SidedStone>& stones, JointChoice& choice);

}  // namespace voussoir::importers::fit
