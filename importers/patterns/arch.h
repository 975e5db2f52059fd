// A free-standing arch of voussoirs on two springing stones.
#pragma once

#include "importers/patterns/arch_curve.h"
#include "importers/patterns/imperfection.h"

namespace voussoir::importers::patterns
{

/// All lengths in m.
struct Arch {
    std::string name;               // before the names of its stones; may be empty
    ArchCurve curve;                // the elevation
    double width = 1;               // along y
    int stones_across = 1;          // voussoirs side by side, their joints half a stone off in every second ring
    double springing_height = 0.5;  // of the springing stones below z = 0
    StoneImperfection imperfection;
};

/// "springing_left", "voussoir_01" ..., "keystone" in the middle of an odd number, "springing_right", with "_b2"
/// of stones side by side. x is along the span, y across from -width / 2 to width / 2, z up; the springing of the
/// intrados is z = 0. The springing stones are in group foundation, the others in group voussoirs. Each springing
/// stone is as wide as its joint and twice that where the joint is steep; its back is vertical.
/// @throws InputError with every parameter that makes no arch
Pattern arch(const Arch& arch);

/// "voussoir_07" or "keystone".
std::string voussoir_name(int number, int count);

/// The outlines of one voussoir: one, or two where the crown of a pointed arch lies inside it. @param i from 0
std::vector<std::vector<Point>> voussoir_outlines(const ArchCurve& curve, const std::vector<ArchJoint>& joints,
                                                  int i);

/// Its parts between two planes along y, glued where there are two.
std::vector<ConvexPolyhedron> voussoir_parts(const std::vector<std::vector<Point>>& outlines, double front,
                                             double back, const std::string& name);

}  // namespace voussoir::importers::patterns
