#include "importers/exact/convexity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

/// A plane through the first corner of a loop, with Newell's normal.
struct FacePlane {
    Vector3d anchor, normal;

    FacePlane(const std::vector<Vector3d>& vertices, const std::vector<int>& loop) : anchor(vertices[loop.front()])
    {
        Vector3d sum = Vector3d::Zero();
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            sum += (vertices[loop[i]] - anchor).cross(vertices[loop[i + 1]] - anchor);
        normal = sum.normalized();
    }
    double distance(const Vector3d& x) const { return normal.dot(x - anchor); }
};

}  // namespace

Outlier worst_outlier(const mesh::PolygonSurface& surface)
{
    Outlier worst;
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
        const FacePlane plane(surface.vertices, surface.faces[f]);
        for (std::size_t v = 0; v < surface.vertices.size(); ++v)
            if (const double distance = plane.distance(surface.vertices[v]); distance > worst.distance)
                worst = {static_cast<int>(v), static_cast<int>(f), distance};
    }
    return worst;
}

double bulge_of(const mesh::PolygonSurface& surface, const std::vector<Vector3d>& points)
{
    std::vector<FacePlane> planes;
    double bulge = 0;
    for (const std::vector<int>& face : surface.faces) {
        FacePlane plane(surface.vertices, face);
        Vector3d middle = Vector3d::Zero();
        for (const int v : face) middle += surface.vertices[v] / static_cast<double>(face.size());
        plane.anchor = middle;
        for (const int v : face) bulge = std::max(bulge, std::abs(plane.distance(surface.vertices[v])));
        planes.push_back(plane);
    }
    for (const Vector3d& point : points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const FacePlane& plane : planes) nearest = std::min(nearest, std::abs(plane.distance(point)));
        if (!planes.empty()) bulge = std::max(bulge, nearest);
    }
    return bulge;
}

std::vector<Outlier> cut_bent_faces(mesh::PolygonSurface& surface, const SurfaceExamination& examination,
                                    double tolerance)
{
    std::vector<Outlier> bent;
    std::vector<bool> is_bent(surface.faces.size(), false);
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
        const FacePlane plane(surface.vertices, surface.faces[f]);
        Outlier worst{-1, static_cast<int>(f), tolerance};
        for (const int v : surface.faces[f])
            if (const double distance = std::abs(plane.distance(surface.vertices[v])); distance > worst.distance)
                worst = {v, static_cast<int>(f), distance};
        is_bent[f] = worst.vertex >= 0;
        if (is_bent[f]) bent.push_back(worst);
    }
    if (bent.empty()) return bent;

    std::vector<std::vector<int>> faces;
    for (std::size_t f = 0; f < surface.faces.size(); ++f)
        if (!is_bent[f]) faces.push_back(surface.faces[f]);
    for (std::size_t t = 0; t < examination.triangles.size(); ++t)
        if (is_bent[examination.face_of_triangle[t]]) {
            const Eigen::Vector3i& corners = examination.triangles[t];
            faces.push_back({corners[0], corners[1], corners[2]});
        }
    surface.faces = std::move(faces);
    return bent;
}

}  // namespace voussoir::importers::exact
