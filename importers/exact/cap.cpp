#include "importers/exact/cap.h"

#ifdef NDEBUG
#error "CGAL's checks must be on: compile this file with -UNDEBUG"
#endif

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

class Cap
{
 public:
    Cap(const std::vector<Vector3d>& points, const Vector3d& normal) : points_(points)
    {
        normal.cwiseAbs().maxCoeff(&dropped_);
        turned_ = normal[dropped_] < 0;
    }

    bool fill(const DirectedEdges& edges, std::vector<Eigen::Vector3i>& triangles)
    {
        for (const auto& [edge, count] : edges)
            if (!add_point(edge.first) || !add_point(edge.second)) return false;
        for (const auto& [edge, count] : edges) {
            triangulation_.insert_constraint(vertices_.at(edge.first), vertices_.at(edge.second));
            net_[edge] += count;
            net_[{edge.second, edge.first}] -= count;
        }
        return triangulation_.dimension() < 2 || collect(triangles);
    }

 private:
    bool add_point(int index)
    {
        if (vertices_.contains(index)) return true;
        const Vector3d& p = points_[index];
        const double u = p[(dropped_ + 1) % 3], v = p[(dropped_ + 2) % 3];
        const std::size_t before = triangulation_.number_of_vertices();
        const auto handle = triangulation_.insert(turned_ ? Kernel::Point_2(v, u) : Kernel::Point_2(u, v));
        if (triangulation_.number_of_vertices() == before) return false;
        handle->info() = index;
        vertices_.emplace(index, handle);
        return true;
    }

    /// What the winding number loses from a face to its neighbour across the edge opposite to corner i.
    int drop_across(const Triangulation::Face_handle& face, int i) const
    {
        const auto p = face->vertex(Triangulation::ccw(i)), q = face->vertex(Triangulation::cw(i));
        if (triangulation_.is_infinite(p) || triangulation_.is_infinite(q)) return 0;
        const auto net = net_.find({p->info(), q->info()});
        return net == net_.end() ? 0 : net->second;
    }

    /// Walks over the triangulation from its outside, where the winding number is 0.
    bool collect(std::vector<Eigen::Vector3i>& triangles) const
    {
        std::map<Triangulation::Face_handle, int> winding{{triangulation_.infinite_face(), 0}};
        std::vector<Triangulation::Face_handle> open{triangulation_.infinite_face()};
        while (!open.empty()) {
            const auto face = open.back();
            open.pop_back();
            for (int i = 0; i < 3; ++i) {
                const auto next = face->neighbor(i);
                const int here = winding.at(face) - drop_across(face, i);
                if (!winding.emplace(next, here).second) continue;
                open.push_back(next);
                if (here < 0 || here > 1 || (here == 1 && triangulation_.is_infinite(next))) return false;
                if (here == 1)
                    triangles.emplace_back(next->vertex(0)->info(), next->vertex(1)->info(),
                                           next->vertex(2)->info());
            }
        }
        return true;
    }

    const std::vector<Vector3d>& points_;
    int dropped_ = 0;
    bool turned_ = false;
    Triangulation triangulation_;
    std::map<int, Triangulation::Vertex_handle> vertices_;
    DirectedEdges net_;
};

}  // namespace

bool fill_cap(const std::vector<Vector3d>& points, const Vector3d& normal, const DirectedEdges& edges,
              std::vector<Eigen::Vector3i>& triangles)
{
    try {
        return Cap(points, normal).fill(edges, triangles);
    } catch (const CGAL::Failure_exception&) {
        return false;
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        return false;
    }
}

}  // namespace voussoir::importers::exact
