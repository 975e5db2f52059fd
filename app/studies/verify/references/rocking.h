// The rigid block that rocks about its lower edges: the full equation, the linearised one, Housner's impacts.
#pragma once

#include <optional>
#include <vector>

namespace voussoir::app::studies::verify::references
{

/// A free-standing block whose ground moves with a_p sin(2 pi f t) for half a cycle; no sliding.
struct RockingBlock {
    double half_width = 0;   // b, m
    double half_height = 0;  // h, m
    double gravity = 0;      // m/s2
    double amplitude = 0;    // a_p, m/s2
    double frequency = 0;    // f, Hz
    bool linear = false;     // sin(alpha - theta) as alpha - theta, cos as 1: slender blocks, small angles
};

/// Slenderness angle alpha = atan(b / h) [rad].
double slenderness(const RockingBlock& block);

/// Angular velocity after an impact / before it, 1 - 1.5 sin^2 alpha: angular momentum about the new edge is kept.
/// Source: [Housner1963]
double housner_restitution(const RockingBlock& block);

/// Angle at the given times [rad], positive towards +x when the ground accelerates towards -x.
/// theta'' = -p^2 {sin(alpha sgn theta - theta) + (a/g) cos(alpha sgn theta - theta)}, p^2 = 3 g / (4 R); uplift
/// when |a| passes g tan alpha, impacts at located zeros of theta. @param times ascending, the first >= 0 [s]
/// Source: [MakrisRoussos2000] (linear: [Yim1980])
std::vector<double> rocking_angles(const RockingBlock& block, const std::vector<double>& times);

/// Time of the first impact after uplift; none when the block overturns. [s]
std::optional<double> first_impact(const RockingBlock& block);

/// Smallest a_p that overturns the block before its first impact, by bisection to 1e-9 m/s2.
double overturning_threshold(RockingBlock block);

/// Restitution of the impact between two apexes of free rocking, from the energy of each.
/// @param before, after |angle| of the apexes [rad]
double restitution_between(const RockingBlock& block, double before, double after);

}  // namespace voussoir::app::studies::verify::references
