#include "importers/exact/surface_checks.h"

#ifdef NDEBUG
#error "CGAL's checks must be on: compile this file with -UNDEBUG"
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions_behaviour.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "libdda/errors.h"

namespace voussoir::importers::exact
{

namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FaceNumbers = Mesh::Property_map<Mesh::Face_index, int>;

/// CGAL prints before it throws; the exception says it all.
void quiet(const char*, const char*, const char*, int, const char*) {}

std::vector<Kernel::Point_3> points_of(const mesh::PolygonSurface& surface)
{
    std::vector<Kernel::Point_3> points;
    for (const Eigen::Vector3d& x : surface.vertices) points.emplace_back(x.x(), x.y(), x.z());
    return points;
}

std::vector<std::vector<std::size_t>> polygons_of(const mesh::PolygonSurface& surface)
{
    std::vector<std::vector<std::size_t>> polygons;
    for (const std::vector<int>& face : surface.faces) polygons.emplace_back(face.begin(), face.end());
    return polygons;
}

/// Hands the number of a face on to the triangles it is cut into.
struct NumberingVisitor {
    FaceNumbers numbers;
    int current = -1;

    void before_subface_creations(Mesh::Face_index face) { current = numbers[face]; }
    void after_subface_created(Mesh::Face_index face) { numbers[face] = current; }
    void after_subface_creations() {}
};

/// A face as a fan from its first corner, as most programs read it, so that a face that is not flat encloses the
/// volume it has elsewhere; one polygon when the fan would fold over.
std::vector<std::vector<int>> fan_of(const mesh::PolygonSurface& surface, const std::vector<int>& face)
{
    std::vector<std::vector<int>> triangles;
    std::vector<Eigen::Vector3d> normals;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const Eigen::Vector3d& first = surface.vertices[face[0]];
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        triangles.push_back({face[0], face[i], face[i + 1]});
        normals.emplace_back((surface.vertices[face[i]] - first).cross(surface.vertices[face[i + 1]] - first));
        sum += normals.back();
    }
    for (const Eigen::Vector3d& normal : normals)
        if (normal.dot(sum) <= 1e-6 * sum.squaredNorm()) return {face};
    return triangles;
}

Mesh to_mesh(const mesh::PolygonSurface& surface, FaceNumbers& numbers)
{
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (const Kernel::Point_3& point : points_of(surface)) vertices.push_back(mesh.add_vertex(point));
    numbers = mesh.add_property_map<Mesh::Face_index, int>("f:number", -1).first;
    for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f)
        for (const std::vector<int>& part : fan_of(surface, surface.faces[f])) {
            std::vector<Mesh::Vertex_index> loop;
            for (const int v : part) loop.push_back(vertices[v]);
            const Mesh::Face_index face = mesh.add_face(loop);
            if (face == Mesh::null_face())
                throw InputError(surface.name, "shells touch in an edge or a vertex only",
                                 "every vertex lies inside one fan of faces");
            numbers[face] = f;
        }
    return mesh;
}

void list_triangles(const Mesh& mesh, const FaceNumbers& numbers, SurfaceExamination& found)
{
    std::set<int> without_area;
    for (const Mesh::Face_index face : mesh.faces()) {
        Eigen::Vector3i corners;
        int i = 0;
        for (const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
            if (i < 3) corners[i++] = static_cast<int>(v.idx());
        found.triangles.push_back(corners);
        found.face_of_triangle.push_back(numbers[face]);
        if (PMP::is_degenerate_triangle_face(face, mesh)) without_area.insert(numbers[face]);
    }
    found.faces_without_area.assign(without_area.begin(), without_area.end());
}

void list_crossings(const Mesh& mesh, const FaceNumbers& numbers, SurfaceExamination& found)
{
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    PMP::self_intersections(mesh, std::back_inserter(pairs));
    std::set<std::pair<int, int>> unique;
    for (const auto& [a, b] : pairs) unique.insert(std::minmax<int>(int{numbers[a]}, int{numbers[b]}));
    found.crossing_faces.assign(unique.begin(), unique.end());
}

SurfaceExamination examine_unguarded(const mesh::PolygonSurface& surface)
{
    FaceNumbers numbers;
    Mesh mesh = to_mesh(surface, numbers);
    const bool cut = PMP::triangulate_faces(mesh, PMP::parameters::visitor(NumberingVisitor{numbers}));
    if (!cut || !CGAL::is_triangle_mesh(mesh))
        throw InputError(surface.name, "a face cannot be cut into triangles",
                         "the corners of a face lie in a plane and its sides do not cross");
    SurfaceExamination found;
    list_triangles(mesh, numbers, found);
    if (!found.faces_without_area.empty()) return found;
    list_crossings(mesh, numbers, found);
    return found;
}

}  // namespace

bool orient_consistently(mesh::PolygonSurface& surface)
{
    std::vector<Kernel::Point_3> points = points_of(surface);
    std::vector<std::vector<std::size_t>> polygons = polygons_of(surface);
    if (!PMP::orient_polygon_soup(points, polygons) || points.size() != surface.vertices.size()) return false;
    for (std::size_t f = 0; f < polygons.size(); ++f)
        surface.faces[f].assign(polygons[f].begin(), polygons[f].end());
    return true;
}

SurfaceExamination examine(const mesh::PolygonSurface& surface)
{
    CGAL::set_error_handler(quiet);
    CGAL::set_warning_handler(quiet);
    try {
        return examine_unguarded(surface);
    } catch (const CGAL::Failure_exception& failure) {
        throw InputError(surface.name, "the exact geometry library refuses the surface: " + failure.expression(),
                         "look for faces without area or intersecting faces");
    }
}

}  // namespace voussoir::importers::exact
