// Stones of vaults: they share the corners of their joints.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::patterns
{

/// An edge of a joint through the thickness of a vault: its corners at the intrados and at the extrados.
struct ThroughEdge {
    int inner = 0, outer = 0;  // numbers of corners
};

/// A course of such edges, along a bed joint.
using BedLine = std::vector<ThroughEdge>;

/// Which ends of a stone are head joints; the others are open, where the stone goes on round a groin.
struct Heads {
    bool first = true, last = true;
};

/// Stones by corners that they share: neighbours have the same quadrilaterals in their joint.
class StoneGrid
{
 public:
    /// A convex part of a stone: the first and the last edge below, then above.
    struct Part {
        std::array<ThroughEdge, 4> edges;
        Heads heads;  // the others lie against another part of the stone
    };
    struct Stone {
        std::string name;
        std::vector<std::vector<int>> faces;  // of 3 or 4 corners, counter-clockwise from outside
        std::vector<Part> parts;              // none of a plug
    };

    /// The number of the corner at x [m], rounded to the nanometre so that the mesh is the same on every machine;
    /// the same number for the same place.
    int corner(const Eigen::Vector3d& x);
    /// A corner below another one, at the level z [m], that stands on firm ground: no warp moves it.
    int foot(int corner, double z);
    ThroughEdge foot(const ThroughEdge& edge, double z) { return {foot(edge.inner, z), foot(edge.outer, z)}; }

    /// Adds a stone without faces. @returns its number
    int add_stone(std::string name);
    /// Adds the faces of a stone between two bed lines to `stone`: quadrilaterals between neighbouring edges of
    /// both lines, counted from their ends; the longer line's surplus at the beginning makes triangles.
    /// @pre both lines have at least two edges and run in the same direction
    void add_faces(int stone, const BedLine& lower, const BedLine& upper, Heads heads = {});
    /// A stone that fills a ring of edges, of triangles above and below.
    void add_plug(int stone, const BedLine& ring);

    const std::vector<Eigen::Vector3d>& corners() const { return corners_; }  ///< m
    const std::vector<bool>& held() const { return held_; }                   ///< per corner: a foot
    const std::vector<Stone>& stones() const { return stones_; }

 private:
    void add_parts(Stone& stone, const BedLine& lower, const BedLine& upper, Heads heads) const;
    bool is_straight(const BedLine& line) const;

    std::vector<Eigen::Vector3d> corners_;
    std::vector<bool> held_;
    std::vector<Stone> stones_;
    std::map<std::array<std::int64_t, 3>, int> numbers_;  // by nanometres
};

/// The parts of a stone of flat faces, their common faces glued. @throws InputError when its faces are warped
std::vector<ConvexPolyhedron> parts_of(const StoneGrid& grid, const StoneGrid::Stone& stone);

/// Signed volume of a closed surface of a grid's corners [m3].
double volume_of(const std::vector<Eigen::Vector3d>& corners, const std::vector<std::vector<int>>& faces);

/// "03": a number with as many digits as the last one, at least two.
std::string numbered(int number, int last);

}  // namespace voussoir::importers::patterns
