// How a convex body stands on a floor, and how far the floor may be tilted: by geometry alone.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <vector>

#include "importers/exact/triangle_surface.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers
{

/// A convex body that rolls over its faces without slip.
class RollingBody
{
 public:
    /// @param points of which it is the hull @param centroid [m]
    RollingBody(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& centroid) : centroid_(centroid)
    {
        const exact::TriangleSurface hull = exact::convex_hull(points);
        std::vector<std::vector<int>> faces;
        for (const Eigen::Vector3i& t : hull.triangles) faces.push_back({t[0], t[1], t[2]});
        shape_ = make_convex_polyhedron(hull.vertices, faces, "body", 1e-6);
    }

    /// The face on which it comes to rest when it is set down with z up: it rolls over the edge that its weight
    /// lies beyond, from face to face.
    int settle() const
    {
        int face = 0;
        for (int f = 0; f < static_cast<int>(shape_.faces.size()); ++f)
            if (face_normal(shape_, f).z() < face_normal(shape_, face).z()) face = f;
        return roll(face, -face_normal(shape_, face)).value_or(-1);
    }

    Eigen::Vector3d normal(int face) const { return face_normal(shape_, face); }
    int corners(int face) const { return static_cast<int>(shape_.faces[face].size()); }

    /// How far the floor may be tilted until gravity, turned towards `x` of the floor, rolls it off its face and
    /// on past a quarter of a right angle. @param face on which it stands, with its own x along the floor's as
    /// near as can be @returns [rad]
    double tilting_angle(int face) const
    {
        const Eigen::Vector3d up = -normal(face);
        const Eigen::Vector3d x = (Eigen::Vector3d::UnitX() - up.x() * up).normalized();
        constexpr double step = 1e-4;
        for (double angle = 0; angle < 1.5; angle += step) {
            const Eigen::Vector3d against =
                std::cos(angle) * up - std::sin(angle) * x;  // gravity, in the body's axes
            // Rolling turns the body by little over the small faces of its underside: what it has turned by
            // counts.
            const std::optional<int> on = roll_with(face, up, against);
            if (!on) return angle;
        }
        return 1.5;
    }

 private:
    /// The edge of a face beyond which the weight lies most; -1: within the face.
    int overhung(int face, const Eigen::Vector3d& against) const
    {
        const Eigen::Vector3d n = normal(face);
        const std::vector<int>& loop = shape_.faces[face];
        const Eigen::Vector3d& corner = shape_.vertices[loop[0]];
        const Eigen::Vector3d foot = centroid_ + n.dot(corner - centroid_) / n.dot(-against) * -against;
        int worst = -1;
        double most = 0;
        for (int i = 0; i < static_cast<int>(loop.size()); ++i) {
            const Eigen::Vector3d from = shape_.vertices[loop[i]],
                                  to = shape_.vertices[loop[(i + 1) % loop.size()]];
            const double out = (to - from).normalized().cross(n).dot(foot - from);
            if (out > most) {
                most = out;
                worst = i;
            }
        }
        return worst;
    }

    int across(int face, int side) const
    {
        const std::vector<int>& loop = shape_.faces[face];
        const int a = loop[side], b = loop[(side + 1) % loop.size()];
        for (const ConvexPolyhedron::Edge& edge : shape_.edges)
            if ((edge.from == a && edge.to == b) || (edge.from == b && edge.to == a))
                return edge.left == face ? edge.right : edge.left;
        return -1;
    }

    /// On a level floor.
    std::optional<int> roll(int face, Eigen::Vector3d up) const
    {
        for (int i = 0; i < 10000; ++i) {
            const int side = overhung(face, up);
            if (side < 0) return face;
            face = across(face, side);
            up = -normal(face);
        }
        return std::nullopt;
    }

    /// On a tilted floor: the body turns about each edge it rolls over, and gravity turns back in its axes.
    std::optional<int> roll_with(int face, const Eigen::Vector3d& start, Eigen::Vector3d against) const
    {
        for (int i = 0; i < 10000; ++i) {
            const int side = overhung(face, against);
            if (side < 0) return face;
            const int next = across(face, side);
            against = Eigen::Quaterniond::FromTwoVectors(normal(face), normal(next)) * against;
            face = next;
            if (-normal(face).dot(start) < std::cos(0.4)) return std::nullopt;
        }
        return std::nullopt;
    }

    Eigen::Vector3d centroid_;
    ConvexPolyhedron shape_;
};

}  // namespace voussoir::importers
