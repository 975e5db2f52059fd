#include "importers/exact/glued_faces.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

using Polygon = std::vector<Vector3d>;

Polygon polygon_of(const ConvexPolyhedron& part, int face)
{
    Polygon polygon;
    for (const int v : part.faces[face]) polygon.push_back(part.vertices[v]);
    return polygon;
}

double area_of(const Polygon& polygon)
{
    Vector3d twice = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        twice += (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]);
    return twice.norm() / 2;
}

/// Area that two convex polygons of one plane share [m2]. Source: [SutherlandHodgman1974].
double shared_area(Polygon polygon, const Polygon& clip, const Vector3d& clip_normal)
{
    for (std::size_t i = 0; i < clip.size() && polygon.size() >= 3; ++i) {
        const Vector3d& from = clip[i];
        const Vector3d outward = (clip[(i + 1) % clip.size()] - from).cross(clip_normal);
        Polygon kept;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vector3d &here = polygon[k], &next = polygon[(k + 1) % polygon.size()];
            const double d0 = outward.dot(here - from), d1 = outward.dot(next - from);
            if (d0 <= 0) kept.push_back(here);
            if ((d0 <= 0) != (d1 <= 0)) kept.push_back(here + d0 / (d0 - d1) * (next - here));
        }
        polygon = std::move(kept);
    }
    return polygon.size() < 3 ? 0 : area_of(polygon);
}

double covered_area(const std::vector<ConvexPolyhedron>& parts, std::size_t own, int face, double tolerance)
{
    const Polygon polygon = polygon_of(parts[own], face);
    const Vector3d normal = face_normal(parts[own], face);
    double covered = 0;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        if (p == own) continue;
        for (int f = 0; f < static_cast<int>(parts[p].faces.size()); ++f) {
            const Vector3d other = face_normal(parts[p], f);
            if (!parts[p].is_glued(f) || other.dot(normal) > -0.99) continue;
            const Polygon clip = polygon_of(parts[p], f);
            if (std::abs(normal.dot(clip.front() - polygon.front())) > 4 * tolerance) continue;
            covered += shared_area(polygon, clip, other);
        }
    }
    return covered;
}

}  // namespace

void free_uncovered_faces(std::vector<ConvexPolyhedron>& parts, double tolerance)
{
    std::vector<std::vector<bool>> glued;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        glued.push_back(parts[p].glued);
        for (int f = 0; f < static_cast<int>(parts[p].faces.size()); ++f)
            if (parts[p].is_glued(f))
                glued[p][f] = covered_area(parts, p, f, tolerance) >= 0.5 * area_of(polygon_of(parts[p], f));
    }
    for (std::size_t p = 0; p < parts.size(); ++p) parts[p].glued = std::move(glued[p]);
}

}  // namespace voussoir::importers::exact
