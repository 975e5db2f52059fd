#include "importers/exact/triangle_surface.h"

#include <Eigen/Geometry>

#include "libdda/geometry/moments.h"

namespace voussoir
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

double diagonal_of(const TriangleSurface& surface)
{
    Vector3d lower = surface.vertices.front(), upper = lower;
    for (const Vector3d& x : surface.vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return (upper - lower).norm();
}

}  // namespace voussoir
