// What each joint of the start of a run does and carries now.
#pragma once

#include <vector>

#include "libdda/analysis/joint_openings.h"
#include "libdda/analysis/joint_resultants.h"

namespace voussoir
{

/// A joint in a state. Forces are of all contacts between its two blocks.
struct JointNow {
    JointMotion motion;       // since the start
    double normal_force = 0;  // N, > 0 pressing: component of the resultant along the contacts' mean normal
    double shear_force = 0;   // N, what of the resultant is across it
    double eccentricity = 0;  // m, of the point where the normal forces act from the centroid of the contact area
    double area_in_use = 0;   // m2, tributary area of the contact points that are closed
    bool broken = false;      // it was bonded at the start, and nothing between its blocks is bonded any more
};

/// One for each joint. @param contacts joint_resultants of the state
std::vector<JointNow> joints_now(const Model& model, const std::vector<WatchedJoint>& joints, const State& state,
                                 const std::vector<JointResultant>& contacts);

}  // namespace voussoir
