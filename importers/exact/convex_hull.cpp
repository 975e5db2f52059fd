#ifdef NDEBUG
#error "CGAL's checks must be on: compile this file with -UNDEBUG"
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::exact
{

TriangleSurface convex_hull(const std::vector<Eigen::Vector3d>& points)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    TriangleSurface result;
    if (points.size() < 4) return result;
    std::vector<Kernel::Point_3> input;
    for (const Eigen::Vector3d& x : points) input.emplace_back(x.x(), x.y(), x.z());
    CGAL::Surface_mesh<Kernel::Point_3> hull;
    CGAL::convex_hull_3(input.begin(), input.end(), hull);
    if (hull.number_of_faces() < 4) return result;  // the points lie in a plane
    for (const auto v : hull.vertices())
        result.vertices.emplace_back(hull.point(v).x(), hull.point(v).y(), hull.point(v).z());
    for (const auto face : hull.faces()) {
        Eigen::Vector3i corners;
        int i = 0;
        for (const auto v : CGAL::vertices_around_face(hull.halfedge(face), hull))
            if (i < 3) corners[i++] = static_cast<int>(v.idx());
        result.triangles.push_back(corners);
    }
    return result;
}

}  // namespace voussoir::importers::exact
