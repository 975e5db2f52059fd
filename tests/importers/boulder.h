// How a convex body stands on a floor, and how far it may be turned before it falls: by geometry alone.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
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

    /// How far it may be turned out of its rest on a face towards x, about the floor's y, and still roll back when
    /// it is let go without speed: it follows the steepest way down of the height of its centroid. [rad]
    double tilting_angle(int face) const
    {
        double stands = 0, falls = 1.2;
        while (falls - stands > 1e-4) {
            const double angle = 0.5 * (stands + falls);
            (rolls_back(face, angle) ? stands : falls) = angle;
        }
        return stands;
    }

    /// Which way is down for a body that was turned so, in its own axes.
    Eigen::Vector3d turned(int face, double angle) const
    {
        const Eigen::Vector3d down = normal(face);
        const Eigen::Vector3d x = (Eigen::Vector3d::UnitX() - down.x() * down).normalized();
        return std::cos(angle) * down + std::sin(angle) * x;
    }

    /// The corner on which it stands when `down` points down.
    Eigen::Vector3d lowest(const Eigen::Vector3d& down) const
    {
        return *std::max_element(
            shape_.vertices.begin(), shape_.vertices.end(),
            [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return down.dot(a) < down.dot(b); });
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

    bool rolls_back(int face, double angle) const
    {
        constexpr double step = 2e-4;  // rad
        Eigen::Vector3d down = turned(face, angle);
        for (double way = 0; way < 4; way += step) {
            const Eigen::Vector3d arm = lowest(down) - centroid_;
            down = (down - step * (arm - down.dot(arm) * down).normalized()).normalized();
        }
        return down.dot(normal(face)) > std::cos(0.5 * angle + 0.05);
    }

    Eigen::Vector3d centroid_;
    ConvexPolyhedron shape_;
};

}  // namespace voussoir::importers
