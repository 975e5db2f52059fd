#include "importers/exact/part_of_hull.h"

#include <algorithm>
#include <cmath>

#include "importers/exact/weld.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

/// The hull of the corners that are further than `distance` from one another: where a cut passes close by a corner
/// there are two. The hull itself if nothing would be left of it.
TriangleSurface without_near_corners(const TriangleSurface& hull, double distance)
{
    std::vector<Vector3d> kept;
    for (const Vector3d& x : hull.vertices)
        if (std::none_of(kept.begin(), kept.end(), [&](const Vector3d& k) { return (k - x).norm() <= distance; }))
            kept.push_back(x);
    if (kept.size() == hull.vertices.size()) return hull;
    TriangleSurface thinned = convex_hull(kept);
    return thinned.triangles.empty() ? hull : thinned;
}

}  // namespace

ConvexPolyhedron part_of_hull(const TriangleSurface& whole, const std::vector<CutPlane>& cuts, double planarity,
                              double diagonal, const std::string& name)
{
    const TriangleSurface hull = without_near_corners(whole, planarity * diagonal);
    mesh::PolygonSurface merged{name, hull.vertices, {}};
    for (const Eigen::Vector3i& t : hull.triangles) merged.faces.push_back({t[0], t[1], t[2]});
    merged.faces = merge_coplanar_faces(merged.vertices, merged.faces, planarity / 4);
    drop_unused_vertices(merged);
    ConvexPolyhedron part = make_convex_polyhedron(merged.vertices, merged.faces, name, planarity);
    for (const std::vector<int>& face : part.faces)
        part.glued.push_back(std::any_of(cuts.begin(), cuts.end(), [&](const CutPlane& cut) {
            return std::all_of(face.begin(), face.end(), [&](int v) {
                return std::abs(cut.distance(part.vertices[v])) <= planarity * diagonal;
            });
        }));
    return part;
}

}  // namespace voussoir::importers::exact
