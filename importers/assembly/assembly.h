// Stones as a structure: what touches what and over which area, what stands apart, hangs in the air, overlaps or
// is too thin, and what to do about it. Knows nothing of files: the same for mesh files, boxes and patterns.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::assembly
{

/// Shares of a stone's size, the cube root of its volume.
namespace assembly_tolerance
{
constexpr double contact = 1e-3;  // of each of two stones: nearer faces touch; the engine's own rule
constexpr double gap = 0.2;       // of the smaller stone: facing faces nearer than this were meant to touch
constexpr double ground = 0.05;   // of the stone: it stands on the ground when it reaches so near the lowest point
constexpr double thin = 0.01;     // least width over largest diameter: less is a sliver
constexpr double short_edge = 1e-3;      // length over largest diameter: less is a short edge
constexpr double size_ratio = 1e3;       // of the volumes of two stones: more is extreme
constexpr double touching_share = 0.25;  // of the facing area: less is an edge that touches, not a face
constexpr double sliver_share = 0.01;    // of the smaller face: less is a corner that touches
constexpr int many_parts = 20;           // of one concave stone: more make a run slow
}  // namespace assembly_tolerance

/// A stone as the assembly sees it.
struct AssemblyStone {
    std::string name;                     // unique
    std::vector<ConvexPolyhedron> parts;  // m; all in one frame
    double volume = 0;                    // m3, of the stone as drawn
    double volume_error = 0;              // share of it by which approximating parts differ; 0: exact
    bool foundation = false;              // held by the ground
    bool endless = false;                 // ground without sides: no shape of it is wrong
};

/// How two stones touch.
enum class Touch {
    face,    // as stones should
    tilted,  // two facing faces at an angle: an edge touches and the rest stands open
    corner,  // faces that overlap each other by next to nothing
    edge,    // two edges that cross
};

/// All contacts of one pair of stones, a < b.
struct StoneContact {
    int a = 0, b = 0;                                    // stones
    Touch touch = Touch::face;                           // of the largest patch
    int patches = 0;                                     // pairs of parts that touch
    double area = 0;                                     // m2, nearer than the contact tolerance
    double facing_area = 0;                              // m2, of the contact polygons
    double smaller_face = 0;                             // m2, of the two faces of the largest patch
    double smallest_gap = 0;                             // m, < 0: the stones overlap by this depth
    double largest_gap = 0;                              // m, inside the contact polygons
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    // unit, mean over the area, from a to b
    std::vector<std::vector<Eigen::Vector3d>> polygons;  // the contact polygons, m
};

/// Two facing faces that were meant to touch and do not, a < b.
struct StoneGap {
    int a = 0, b = 0;                                    // stones
    double width = 0;                                    // m, mean over the area
    double widest = 0;                                   // m
    double area = 0;                                     // m2, that faces the other stone
    std::vector<std::vector<Eigen::Vector3d>> polygons;  // the facing areas, half way between the faces, m
};

/// Gaps of nearly one width.
struct GapGroup {
    double narrowest = 0, widest = 0;  // m
    std::vector<int> gaps;             // indices into Assembly::gaps
};

/// Two stones that share space, a < b.
struct StoneOverlap {
    int a = 0, b = 0;   // stones
    double volume = 0;  // m3
    double depth = 0;   // m, the shortest shift that parts them, of the deepest pair of parts; 0: not known
};

/// A stone that is very thin or has a very short edge.
struct SliverStone {
    int stone = 0;                                      // which
    double width = 0, diameter = 0, shortest_edge = 0;  // m
    bool thin = false;                                  // else only its edge is short
    std::vector<std::vector<Eigen::Vector3d>> marks;    // what a picture marks: polygons, or an edge of two points
};

/// One kind of finding in words.
struct AssemblyFinding {
    std::string kind;         // "gaps", "overlaps", "floating", ...
    std::string what;         // what was found
    std::string advice;       // what to do
    std::vector<int> stones;  // that it is about
    bool harmless = false;    // worth knowing, nothing to mend
};

/// Stones as a structure: what touches, what gapes, what stands on what.
struct Assembly {
    std::vector<AssemblyStone> stones;         // all of them
    std::vector<StoneContact> contacts;        // ascending in (a, b)
    std::vector<StoneGap> gaps;                // ascending in (a, b)
    std::vector<GapGroup> gap_groups;          // ascending widths
    std::vector<StoneOverlap> overlaps;        // ascending in (a, b)
    std::vector<std::vector<int>> components;  // of the contact graph, largest first
    std::vector<int> ground;                   // the foundations, or the stones that reach the lowest level
    bool ground_given = false;                 // the ground is the case's foundations
    std::vector<int> floating;                 // touch no other stone
    std::vector<int> unsupported;              // no path of contacts leads from them to the ground
    std::vector<SliverStone> slivers;          // ascending
    int largest = -1, smallest = -1;           // stones, foundations that were given apart
    double size_ratio = 1;                     // of their volumes
    double typical_size = 0;                   // m, median of the stones' sizes
    Eigen::Vector3d extent = Eigen::Vector3d::Zero();  // m, of the bounding box
    std::vector<AssemblyFinding> findings;             // in words
};

/// What the words need to know about where the stones came from.
struct AssemblyOrigin {
    double metres_per_unit = 0;  // of the one mesh file; 0: not one file
    bool from_case = false;      // remedies are keys of a case file, else options of `voussoir import`
    int refused_stones = 0;      // are not among the stones
    // Stones that begin turned or moving: what they touch, or do not, is meant.
    std::set<std::string> apart = {};
};

/// Examines stones as a structure. Contacts are found by the engine's own search and so are what a run will see.
/// @param overlaps pairs of stones whose shared volume [m3] is known from exact intersection; those that the
/// contact search finds deeper than the contact tolerance are added Cost: two contact searches; 10,000 stones take
/// about a second.
Assembly examine_assembly(std::vector<AssemblyStone> stones, const std::vector<StoneOverlap>& overlaps,
                          const AssemblyOrigin& origin);

/// Surface polygons of the region that two convex shapes share [m]; empty when they share none.
std::vector<std::vector<Eigen::Vector3d>> shared_region(const ConvexPolyhedron& a, const ConvexPolyhedron& b);

/// Volume that a closed, outward-oriented surface of polygons encloses [m3].
double volume_inside(const std::vector<std::vector<Eigen::Vector3d>>& region);

/// "25 mm", "1.25 m": three digits in the unit that suits.
std::string length_words(double metres);

}  // namespace voussoir::importers::assembly
