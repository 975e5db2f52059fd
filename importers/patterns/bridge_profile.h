// The elevation of one arch of a bridge: stepped voussoirs, and the beds of what stands on them.
#pragma once

#include "importers/patterns/arch_curve.h"

namespace voussoir::importers::patterns
{

/// Of an arch about x = 0.
struct BridgeProfile {
    std::vector<ArchJoint> joints;  // from left to right, the upper ends on beds
    std::vector<int> bed_of_joint;  // where each joint ends
    std::vector<double> beds;       // m, levels from the springing stones upwards
    int crown_bed = 0;              // of the highest backs; courses above it run through

    /// The back of the impost at the left springing, from the intrados: how far it reaches out [m].
    double skewback() const { return joints.front().intrados.x() - joints.front().extrados.x(); }
    int courses() const { return static_cast<int>(beds.size()) - 1; }
    double crown() const { return beds[crown_bed]; }  // m, level of the highest backs
    /// Adds courses of about this height up to a level.
    void carry_on(double level, double height);
    /// Where a course (from 0) ends against the left half of the arch [m]. @pre course < crown_bed
    double end_of_course(int course) const;
    /// The outline of a voussoir (from 0).
    std::vector<Point> outline(int voussoir) const;
    /// The bed on which its back lies.
    int bed_of_back(int voussoir) const { return std::max(bed_of_joint[voussoir], bed_of_joint[voussoir + 1]); }
};

/// From the springing stones to the highest backs. @param course height of a course [m]
/// @param crown the highest backs are drawn up to this level, if they end below it [m]
/// @throws InputError when the backs do not rise from the springing to the crown, or a voussoir is not convex
BridgeProfile profile_of(const ArchCurve& curve, double course, double crown = 0);

}  // namespace voussoir::importers::patterns
