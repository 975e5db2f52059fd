// A rigid block that stands on springs under its two lower edges, on moving ground: what blocks that slide and
// rock on contacts of a given stiffness do. Knows nothing of the engine.
#pragma once

#include <vector>

namespace voussoir::app::studies::stability::references
{

/// A block in the x-z plane. The ground accelerates along x by amplitude sin(2 pi t / period) until `pulse_end`.
struct SpringBlock {
    double half_width = 0, half_height = 0;  // m
    double mass = 0;                         // kg
    double inertia = 0;                      // kg m2, about y through the centroid
    double normal_stiffness = 0;             // N/m, of each lower edge
    double shear_stiffness = 0;              // N/m, of each lower edge
    double friction = 0;                     // -, coefficient
    double gravity = 0;                      // m/s2
    double amplitude = 0;                    // m/s2
    double period = 0;                       // s
    double pulse_end = 0;                    // s
    double start_lean = 0;                   // rad; 0: it stands
};

/// How deep the edge of a leaning block starts in its spring [m]: the force on it is what a rigid block that
/// begins to turn about it would have, m g (1 - m R^2 sin^2(alpha - lean) / (I + m R^2)), so that it does not
/// bounce.
double start_sink(const SpringBlock& block);

/// Seen from the ground.
struct SpringBlockPoint {
    double x = 0;     // m, of the centroid since the start
    double lean = 0;  // rad, towards +x
};

/// Equations of motion with finite rotation. Under each lower edge: a normal spring that only pushes, N = k
/// <-gap>, and a shear spring of elongation s that follows the edge and is cut back to |k_t s| = friction x N
/// where it would exceed it (elastic-frictional, as in [Mindlin1949] and [GoodmanTaylorBrekke1968]); s is
/// forgotten when the edge lifts. Starts at rest: standing on its compressed springs, or leaning on one edge,
/// whose normal spring is compressed by start_sink and whose shear spring is free. Velocity Verlet at a twentieth
/// of the time unit 1/omega of the stiffest spring, and never more than 1e-5 s.
/// @param times ascending, the first > 0 [s]. @returns one point each
std::vector<SpringBlockPoint> block_on_springs(const SpringBlock& block, const std::vector<double>& times);

}  // namespace voussoir::app::studies::stability::references
