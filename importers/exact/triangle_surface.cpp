#include "importers/exact/triangle_surface.h"

#include <Eigen/Geometry>

#include "libdda/geometry/moments.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

Vector3d normal_of(const TriangleSurface& surface, const Eigen::Vector3i& t)
{
    return (surface.vertices[t[1]] - surface.vertices[t[0]])
        .cross(surface.vertices[t[2]] - surface.vertices[t[0]]);
}

double volume_of(const TriangleSurface& surface)
{
    return surface.triangles.empty() ? 0 : moments_of_surface(surface.vertices, surface.triangles).volume;
}

double area_of(const TriangleSurface& surface)
{
    double twice = 0;
    for (const Eigen::Vector3i& t : surface.triangles) twice += normal_of(surface, t).norm();
    return twice / 2;
}

double diagonal_of(const std::vector<Vector3d>& vertices)
{
    if (vertices.empty()) return 0;
    Vector3d lower = vertices.front(), upper = lower;
    for (const Vector3d& x : vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return (upper - lower).norm();
}

}  // namespace voussoir::importers::exact
