// Convex polyhedra: the shape of every block, or of every part of a glued block.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace voussoir
{

/// A closed convex polyhedron with planar polygonal faces. Made only by make_convex_polyhedron, so that whoever
/// holds one may rely on it being closed, outward-oriented and convex.
struct ConvexPolyhedron {
    /// An edge and its two faces.
    struct Edge {
        int from, to;     // vertices, in the direction the left face runs
        int left, right;  // the two faces that share the edge
    };
    std::vector<Eigen::Vector3d> vertices;  // m
    std::vector<std::vector<int>> faces;    // vertex loops, counter-clockwise seen from outside
    std::vector<Edge> edges;                // each once
    // Per face: it lies against another part of the same stone and never touches anything. Empty: no face does.
    std::vector<bool> glued;
    /// Whether a face lies against another part of the same stone.
    bool is_glued(int face) const { return !glued.empty() && glued[face]; }
    /// An edge of the cut between two parts; no edge of the stone.
    bool is_glued(const Edge& edge) const { return is_glued(edge.left) || is_glued(edge.right); }
};

/// Checks closedness, orientation and convexity, and finds the edges. Coplanar triangles should be merged into
/// polygons first (merge_coplanar_faces): contact is clipped face by face.
/// @param vertices (n) [m]; @param faces loops of vertex indices, counter-clockwise from outside
/// @param tolerance largest distance a vertex may lie outside a face plane, as a share of the bounding diagonal
/// @param name names the stone in error messages
/// @throws InputError when the shape is not closed, not consistently outward-oriented, or not convex
ConvexPolyhedron make_convex_polyhedron(std::vector<Eigen::Vector3d> vertices, std::vector<std::vector<int>> faces,
                                        const std::string& name = "polyhedron", double tolerance = 1e-6);

/// Joins edge-adjacent faces of a closed convex surface whose planes agree within `tolerance` (share of the
/// bounding diagonal) into one loop each, and drops vertices inside straight edges.
std::vector<std::vector<int>> merge_coplanar_faces(const std::vector<Eigen::Vector3d>& vertices,
                                                   const std::vector<std::vector<int>>& faces,
                                                   double tolerance = 1e-9);

/// An axis-aligned box. @param lower, upper opposite corners [m]
ConvexPolyhedron make_box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper);

/// The same shape moved by `offset` [m].
ConvexPolyhedron translated(ConvexPolyhedron shape, const Eigen::Vector3d& offset);

/// Unit outward normal of one face (Newell's sum over the loop, exact for planar faces).
Eigen::Vector3d face_normal(const ConvexPolyhedron& shape, int face);

}  // namespace voussoir
