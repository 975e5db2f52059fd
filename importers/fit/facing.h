// Which sides of which stones face each other, and how far apart they were drawn.
#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "importers/fit/side.h"

namespace voussoir::importers::fit
{

/// A stone with its sides.
struct SidedStone {
    const mesh::PolygonSurface* surface = nullptr;
    std::vector<Side> sides;
    double size = 0;  // m: the cube root of its volume
};

/// A point of the area where two sides face each other.
struct FacingPoint {
    Eigen::Vector3d place;  // m, half way between the sides
    double gap = 0;         // m, between the sides as drawn; < 0: they overlap
    double area = 0;        // m2 that it stands for
};

/// Two sides that face each other.
struct Facing {
    int stone_a = 0, side_a = 0, stone_b = 0, side_b = 0;
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, from a to b
    std::vector<FacingPoint> points;
    std::map<int, double> area_of_face_a, area_of_face_b;  // m2 of it, by the faces of either stone
    double area = 0;                                       // m2
    bool misfits = false;                                  // what choose_joints found
    double smallest_gap = 0, largest_gap = 0;              // m

    double misfit() const { return std::max(-smallest_gap, largest_gap); }
};

/// The joints of an assembly, in the order of its stones: sides whose normals are opposite within 25 degrees,
/// which share at least a twentieth of the smaller one's area and lie on each other but for a tenth of its size.
/// Faces that open like a wedge, or stand apart all over as for mortar, were meant so and are none.
std::vector<Facing> find_facing(const std::vector<SidedStone>& stones);

}  // namespace voussoir::importers::fit
