#ifdef NDEBUG
#error "CGAL's checks must be on: compile this file with -UNDEBUG"
#endif

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::exact
{

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hull = CGAL::Surface_mesh<Kernel::Point_3>;
using Loop = std::vector<int>;  // of vertices of the hull

/// The facets of a hull. CGAL's algorithm keeps its horizon in an order of addresses: which triangles a flat facet
/// is made of, which needless vertices it has, and the order of all of them differ from one process to the next.
/// The facets themselves are those of exact predicates, and do not.
class Facets
{
 public:
    explicit Facets(const Hull& hull) : hull_(hull), leader_(hull.number_of_faces())
    {
        std::iota(leader_.begin(), leader_.end(), 0);
        for (const auto edge : hull.edges()) {
            const auto h = hull.halfedge(edge), back = hull.opposite(h);
            if (CGAL::coplanar(at(hull.source(h)), at(hull.target(h)), at(hull.target(hull.next(h))),
                               at(hull.target(hull.next(back)))))
                leader_[find(face(h))] = find(face(back));
        }
    }

    /// Their outlines without corners on straight edges.
    std::vector<Loop> loops()
    {
        std::vector<Loop> found;
        std::vector<bool> done(hull_.number_of_halfedges(), false);
        for (const auto first : hull_.halfedges()) {
            if (is_inner(first)) continue;
            Loop loop;
            for (auto h = first; !done[h]; h = after(h)) {
                done[h] = true;
                if (!CGAL::collinear(at(hull_.source(h)), at(hull_.target(h)), at(hull_.target(after(h)))))
                    loop.push_back(static_cast<int>(hull_.target(h).idx()));
            }
            if (!loop.empty()) found.push_back(std::move(loop));
        }
        return found;
    }

 private:
    using Halfedge = Hull::Halfedge_index;
    const Kernel::Point_3& at(Hull::Vertex_index v) const { return hull_.point(v); }
    std::size_t face(Halfedge h) const { return hull_.face(h).idx(); }
    std::size_t find(std::size_t f)
    {
        while (leader_[f] != f) f = leader_[f] = leader_[leader_[f]];
        return f;
    }
    bool is_inner(Halfedge h) { return find(face(h)) == find(face(hull_.opposite(h))); }
    /// The next side of the facet.
    Halfedge after(Halfedge h)
    {
        for (h = hull_.next(h); is_inner(h);) h = hull_.next(hull_.opposite(h));
        return h;
    }

    const Hull& hull_;
    std::vector<std::size_t> leader_;
};

/// Vertices in the order of the points they came from, facets as fans from their first vertex, in order.
TriangleSurface in_order(const Hull& hull, const std::vector<Eigen::Vector3d>& points)
{
    std::vector<Loop> loops = Facets(hull).loops();
    std::map<std::array<double, 3>, int> first;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
        first.try_emplace({points[i].x(), points[i].y(), points[i].z()}, i);
    std::map<int, int> place;  // in the result, by number of the point
    for (Loop& loop : loops) {
        for (int& v : loop) {
            const Kernel::Point_3& p = hull.point(Hull::Vertex_index(static_cast<Hull::size_type>(v)));
            v = first.at({p.x(), p.y(), p.z()});
            place.emplace(v, 0);
        }
        std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    }
    std::sort(loops.begin(), loops.end());
    TriangleSurface result;
    for (auto& [point, number] : place) {
        number = static_cast<int>(result.vertices.size());
        result.vertices.push_back(points[point]);
    }
    for (const Loop& loop : loops)
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            result.triangles.emplace_back(place.at(loop[0]), place.at(loop[i]), place.at(loop[i + 1]));
    return result;
}

}  // namespace

TriangleSurface convex_hull(const std::vector<Eigen::Vector3d>& points)
{
    if (points.size() < 4) return {};
    std::vector<Kernel::Point_3> input;
    for (const Eigen::Vector3d& x : points) input.emplace_back(x.x(), x.y(), x.z());
    Hull hull;
    CGAL::convex_hull_3(input.begin(), input.end(), hull);
    if (hull.number_of_faces() < 4 || !CGAL::is_closed(hull)) return {};  // the points lie in a plane
    return in_order(hull, points);
}

}  // namespace voussoir::importers::exact
