#include <Eigen/Geometry>
#include <cmath>

#include "importers/assembly/assembly.h"

namespace voussoir::importers::assembly
{
namespace
{

using Eigen::Vector3d;
using Polygon = std::vector<Vector3d>;

/// What of a polygon lies below a plane. Source: [SutherlandHodgman1974].
Polygon cut(const Polygon& polygon, const Vector3d& normal, double offset)
{
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector3d& here = polygon[i];
        const Vector3d& next = polygon[(i + 1) % polygon.size()];
        const double d0 = normal.dot(here) - offset, d1 = normal.dot(next) - offset;
        if (d0 <= 0) kept.push_back(here);
        if ((d0 <= 0) != (d1 <= 0)) kept.push_back(here + d0 / (d0 - d1) * (next - here));
    }
    return kept;
}

/// Does a face of `other` lie in the same plane as a face of `shape` and look the same way?
bool has_same_face(const ConvexPolyhedron& other, const Vector3d& normal, const Vector3d& point, double tolerance)
{
    for (int face = 0; face < static_cast<int>(other.faces.size()); ++face)
        if (face_normal(other, face).dot(normal) > 1 - 1e-9 &&
            std::abs(normal.dot(other.vertices[other.faces[face].front()] - point)) < tolerance)
            return true;
    return false;
}

/// The faces of `shape` as far as they lie inside `other`.
/// @param once leave out faces that lie in a face of `other`, which has given them
void add_faces_inside(const ConvexPolyhedron& shape, const ConvexPolyhedron& other, bool once,
                      std::vector<Polygon>& region)
{
    const double tolerance = 1e-9 * (shape.vertices.front() - shape.vertices.back()).norm();
    for (int own = 0; own < static_cast<int>(shape.faces.size()); ++own) {
        Polygon polygon;
        for (const int v : shape.faces[own]) polygon.push_back(shape.vertices[v]);
        if (once && has_same_face(other, face_normal(shape, own), polygon.front(), tolerance)) continue;
        for (int face = 0; face < static_cast<int>(other.faces.size()) && polygon.size() >= 3; ++face) {
            const Vector3d normal = face_normal(other, face);
            polygon = cut(polygon, normal, normal.dot(other.vertices[other.faces[face].front()]) + tolerance);
        }
        if (polygon.size() >= 3) region.push_back(std::move(polygon));
    }
}

}  // namespace

std::vector<std::vector<Eigen::Vector3d>> shared_region(const ConvexPolyhedron& a, const ConvexPolyhedron& b)
{
    std::vector<Polygon> region;
    add_faces_inside(a, b, false, region);
    add_faces_inside(b, a, true, region);
    return region;
}

double volume_inside(const std::vector<std::vector<Eigen::Vector3d>>& region)
{
    double volume = 0;
    for (const Polygon& polygon : region)  // tetrahedra from one point of the region, so that nothing cancels
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
            const Vector3d from = region.front().front();
            volume += (polygon[0] - from).dot((polygon[i] - from).cross(polygon[i + 1] - from)) / 6;
        }
    return volume;
}

}  // namespace voussoir::importers::assembly
