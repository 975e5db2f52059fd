// What every pattern of named convex stones gives: stones with groups, and masses that rest on them.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::patterns
{

/// The group of stones that stand on firm ground, in every pattern.
inline constexpr const char* foundation_group = "foundation";

/// Which way a stone can be made smaller without leaving its beds: what imperfections may do to it.
enum class Play {
    none,    // a stone that carries others on several sides, or a concave one
    across,  // along y only: a voussoir between radial joints
    level,   // along x and y: a stone between level beds
};

/// One stone in place.
struct PatternStone {
    std::string name;                     // unique in its pattern
    std::string group;                    // as masons call it: voussoirs, pier, spandrel, ...
    std::vector<ConvexPolyhedron> parts;  // m; several of a concave stone, the faces between them glued
    Play play = Play::none;               // of imperfections
    double friction_factor = 1;           // -, on the coefficient of friction of its joints
};

/// A mass without a shape that moves with a stone: fill, floor, roof, bell.
struct PatternMass {
    std::string stone;   // its name
    double mass = 0;     // kg
    Eigen::Vector3d at;  // m
};

/// A whole pattern.
struct Pattern {
    std::vector<PatternStone> stones;
    std::vector<PatternMass> masses;
};

/// A point of an elevation (x, z) or of a plan (x, y) [m].
using Point = Eigen::Vector2d;

/// Rounded to the nanometre, without negative zero: patterns are the same on every machine.
double to_nanometre(double metres);
Point to_nanometre(const Point& point);

/// The corners of a convex outline in order, counter-clockwise, without those that repeat another or lie on a
/// straight side. @param points in either order round the outline [m]
std::vector<Point> clean_outline(const std::vector<Point>& points);

/// A regular outline about a point, counter-clockwise, two sides parallel to each axis. @param width across the
/// flats [m] @param sides a multiple of 4
std::vector<Point> regular_outline(const Point& centre, double width, int sides);

/// A convex outline of the elevation (x, z) drawn along y. @throws InputError when no convex stone comes of it
ConvexPolyhedron prism_along_y(const std::vector<Point>& outline, double front, double back,
                               const std::string& name);

/// A convex outline of the plan (x, y) drawn up z. Face i + 2 is that of the side from corner i of the clean
/// outline to the next. @throws InputError likewise
ConvexPolyhedron prism_up(const std::vector<Point>& outline, double foot, double top, const std::string& name);

/// Between two outlines of as many corners at two levels, corner on corner: a drum, a frustum, a capital.
/// @pre both outlines run counter-clockwise and their sides are parallel
ConvexPolyhedron frustum(const std::vector<Point>& lower, double foot, const std::vector<Point>& upper, double top,
                         const std::string& name);

/// From an outline about the axis up to another one, and from that to a point of the axis above it; a pyramid
/// where the other one is empty. @pre as of a frustum @throws InputError when it is not convex
ConvexPolyhedron pointed_frustum(const std::vector<Point>& lower, double foot, const std::vector<Point>& upper,
                                 double top, double tip, const std::string& name);

/// Marks the faces of a part that lie in the plane through `point` with this normal as glued.
void glue(ConvexPolyhedron& part, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

/// Volume of a stone [m3].
double volume_of(const PatternStone& stone);

/// The faces of a stone that are not glued, as one surface. Corners of its parts at one place are one vertex.
mesh::PolygonSurface surface_of(const std::string& name, const std::vector<ConvexPolyhedron>& parts);

}  // namespace voussoir::importers::patterns
