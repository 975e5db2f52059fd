#include "importers/exact/decimate.h"

#ifdef NDEBUG
#error "CGAL's checks must be on: compile this file with -UNDEBUG"
#endif

// g++ 12 cannot see that CGAL looks at a placement only where there is one.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <vector>

#include "libdda/errors.h"

namespace voussoir::importers::exact
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh mesh_of(const TriangleSurface& surface, const std::string& name)
{
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (const Eigen::Vector3d& x : surface.vertices)
        vertices.push_back(mesh.add_vertex(Kernel::Point_3(x.x(), x.y(), x.z())));
    for (const Eigen::Vector3i& t : surface.triangles)
        if (mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]) == Mesh::null_face())
            throw InputError(name, "shells touch in an edge or a vertex only",
                             "every vertex lies inside one fan of faces");
    return mesh;
}

}  // namespace

TriangleSurface decimated(const TriangleSurface& surface, int triangles, const std::string& name)
{
    if (static_cast<int>(surface.triangles.size()) <= triangles) return surface;
    Mesh mesh = mesh_of(surface, name);
    // A closed surface has three edges for two triangles; the predicate stops below its count.
    const auto edges = static_cast<std::size_t>(triangles) * 3 / 2 + 1;
    CGAL::Surface_mesh_simplification::edge_collapse(
        mesh, CGAL::Surface_mesh_simplification::Count_stop_predicate<Mesh>(edges));
    mesh.collect_garbage();
    TriangleSurface result;
    for (const Mesh::Vertex_index v : mesh.vertices())
        result.vertices.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    for (const Mesh::Face_index face : mesh.faces()) {
        Eigen::Vector3i corners;
        int i = 0;
        for (const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
            corners[i++] = static_cast<int>(v.idx());
        result.triangles.push_back(corners);
    }
    return result;
}

}  // namespace voussoir::importers::exact
