#include "importers/exact/exact_solid.h"

#ifdef NDEBUG
#error "CGAL's checks must be on: compile this file with -UNDEBUG"
#endif

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/assertions_behaviour.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>

#include "importers/exact/shell.h"
#include "libdda/geometry/moments.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::Exact_predicates_tag>;
using DirectedEdge = std::pair<int, int>;

Point exact(const Vector3d& x)
{
    return {x.x(), x.y(), x.z()};
}

Vector3d rounded_point(const Point& p)
{
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

struct ExactSurface {
    std::vector<Point> points;
    std::vector<Eigen::Vector3i> triangles;
};

/// Fills the flat region that is bounded by directed edges, on their left; edges that occur in both directions
/// bound nothing. @returns false when edges cross or points coincide: no cap of a solid
class Cap
{
 public:
    /// @param normal out of the solid
    Cap(const std::vector<Point>& points, const Vector3d& normal) : points_(points)
    {
        normal.cwiseAbs().maxCoeff(&dropped_);
        turned_ = normal[dropped_] < 0;
    }

    bool fill(const std::map<DirectedEdge, int>& edges, std::vector<Eigen::Vector3i>& triangles)
    {
        for (const auto& [edge, count] : edges) {
            const auto a = vertex(edge.first), b = vertex(edge.second);
            if (a == nullptr || b == nullptr) return false;
            triangulation_.insert_constraint(a, b);
            net_[edge] += count;
            net_[{edge.second, edge.first}] -= count;
        }
        if (triangulation_.number_of_vertices() != vertices_.size()) return false;
        return triangulation_.dimension() < 2 || collect(triangles);
    }

 private:
    Triangulation::Vertex_handle vertex(int index)
    {
        const auto [entry, is_new] = vertices_.try_emplace(index, nullptr);
        if (!is_new) return entry->second;
        const Point& p = points_[index];
        const std::array<Kernel::FT, 3> x{p.x(), p.y(), p.z()};
        const auto &u = x[(dropped_ + 1) % 3], &v = x[(dropped_ + 2) % 3];
        const std::size_t before = triangulation_.number_of_vertices();
        const auto handle = triangulation_.insert(turned_ ? Kernel::Point_2(v, u) : Kernel::Point_2(u, v));
        if (triangulation_.number_of_vertices() == before) return nullptr;
        handle->info() = index;
        return entry->second = handle;
    }

    /// Walks over the triangulation from its outside, where the winding number is 0.
    bool collect(std::vector<Eigen::Vector3i>& triangles)
    {
        std::map<Triangulation::Face_handle, int> winding{{triangulation_.infinite_face(), 0}};
        std::vector<Triangulation::Face_handle> open{triangulation_.infinite_face()};
        while (!open.empty()) {
            const auto face = open.back();
            open.pop_back();
            for (int i = 0; i < 3; ++i) {
                const auto next = face->neighbor(i);
                const auto p = face->vertex(Triangulation::ccw(i)), q = face->vertex(Triangulation::cw(i));
                int across = winding.at(face);
                if (!triangulation_.is_infinite(p) && !triangulation_.is_infinite(q))
                    if (const auto net = net_.find({p->info(), q->info()}); net != net_.end())
                        across -= net->second;
                if (!winding.emplace(next, across).second) continue;
                open.push_back(next);
                if (across < 0 || across > 1) return false;
                if (across == 1 && triangulation_.is_infinite(next)) return false;
                if (across == 1)
                    triangles.emplace_back(next->vertex(0)->info(), next->vertex(1)->info(),
                                           next->vertex(2)->info());
            }
        }
        return true;
    }

    const std::vector<Point>& points_;
    int dropped_ = 0;
    bool turned_ = false;
    Triangulation triangulation_;
    std::map<int, Triangulation::Vertex_handle> vertices_;
    std::map<DirectedEdge, int> net_;
};

/// One side of a plane.
class Half
{
 public:
    Half(const ExactSurface& solid, const Kernel::Plane_3& plane, const std::vector<int>& sides, int kept)
        : solid_(solid), plane_(plane), sides_(sides), kept_(kept), place_(solid.points.size(), -1)
    {
    }

    /// @param front normal of the plane
    bool make(const Vector3d& front, ExactSurface& half)
    {
        for (const Eigen::Vector3i& triangle : solid_.triangles) add(clipped(triangle));
        std::map<DirectedEdge, int> rim;  // of the cap: against the direction of the faces at the cut
        for (const auto& [edge, count] : at_cut_) {
            const auto back = at_cut_.find({edge.second, edge.first});
            const int net = count - (back == at_cut_.end() ? 0 : back->second);
            if (net > 0) rim[{edge.second, edge.first}] = net;
        }
        Cap cap(half_.points, kept_ < 0 ? front : Vector3d(-front));
        if (!cap.fill(rim, half_.triangles)) return false;
        half = std::move(half_);
        return !half.triangles.empty();
    }

 private:
    int keep(int vertex)
    {
        if (place_[vertex] < 0) place_[vertex] = add_point(solid_.points[vertex], sides_[vertex] == 0);
        return place_[vertex];
    }

    int cut(int a, int b)
    {
        const auto [entry, is_new] = cuts_.try_emplace(std::minmax(a, b), -1);
        if (is_new) {
            const auto& [low, high] = entry->first;
            const auto crossing =
                CGAL::intersection(plane_, Kernel::Line_3(solid_.points[low], solid_.points[high]));
            entry->second = add_point(boost::get<Point>(*crossing), true);
        }
        return entry->second;
    }

    int add_point(const Point& point, bool at_cut)
    {
        half_.points.push_back(point);
        in_plane_.push_back(at_cut);
        return static_cast<int>(half_.points.size()) - 1;
    }

    std::vector<int> clipped(const Eigen::Vector3i& t)
    {
        std::vector<int> loop;
        if (sides_[t[0]] == 0 && sides_[t[1]] == 0 && sides_[t[2]] == 0) return loop;  // the cap has it again
        for (int k = 0; k < 3; ++k) {
            const int from = t[k], to = t[(k + 1) % 3];
            if (sides_[from] * kept_ >= 0) loop.push_back(keep(from));
            if (sides_[from] * sides_[to] < 0) loop.push_back(cut(from, to));
        }
        return loop;
    }

    void add(const std::vector<int>& loop)
    {
        if (loop.size() < 3) return;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            half_.triangles.emplace_back(loop[0], loop[i], loop[i + 1]);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int from = loop[i], to = loop[(i + 1) % loop.size()];
            if (in_plane_[from] && in_plane_[to]) ++at_cut_[{from, to}];
        }
    }

    const ExactSurface& solid_;
    const Kernel::Plane_3& plane_;
    const std::vector<int>& sides_;
    int kept_;
    ExactSurface half_;
    std::vector<int> place_;      // of the solid's vertices in the half
    std::vector<bool> in_plane_;  // of the half's vertices
    std::map<std::pair<int, int>, int> cuts_;
    std::map<DirectedEdge, int> at_cut_;
};

PolygonSurface rounded_surface(const ExactSurface& surface)
{
    PolygonSurface result;
    for (const Point& p : surface.points) result.vertices.push_back(rounded_point(p));
    for (const Eigen::Vector3i& t : surface.triangles) result.faces.push_back({t[0], t[1], t[2]});
    return result;
}

std::vector<ExactSurface> shells_of(const ExactSurface& surface)
{
    const std::vector<int> shell = shell_of_faces(rounded_surface(surface), TouchingEdges::part);
    std::vector<ExactSurface> shells;
    std::map<std::pair<int, int>, int> place;  // by shell and vertex
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const int s = shell[t];
        if (s >= static_cast<int>(shells.size())) shells.resize(s + 1);
        Eigen::Vector3i corners;
        for (int k = 0; k < 3; ++k) {
            const int vertex = surface.triangles[t][k];
            const auto [entry, is_new] = place.try_emplace({s, vertex}, static_cast<int>(shells[s].points.size()));
            if (is_new) shells[s].points.push_back(surface.points[vertex]);
            corners[k] = entry->second;
        }
        shells[s].triangles.push_back(corners);
    }
    return shells;
}

void append(const ExactSurface& shell, ExactSurface& to)
{
    const auto first = static_cast<int>(to.points.size());
    to.points.insert(to.points.end(), shell.points.begin(), shell.points.end());
    for (const Eigen::Vector3i& t : shell.triangles) to.triangles.emplace_back(t.array() + first);
}

/// Shells that point outward, each with the cavities in it.
std::vector<ExactSurface> connected_pieces(const ExactSurface& surface)
{
    std::vector<ExactSurface> outer, cavities;
    for (ExactSurface& shell : shells_of(surface)) {
        const PolygonSurface plain = rounded_surface(shell);
        const double volume = moments_of_surface(plain.vertices, shell.triangles).volume;
        (volume < 0 ? cavities : outer).push_back(std::move(shell));
    }
    if (cavities.empty()) return outer;
    std::vector<PolygonSurface> plain;
    for (const ExactSurface& shell : outer) plain.push_back(rounded_surface(shell));
    for (const ExactSurface& cavity : cavities) {
        const Vector3d inside = rounded_point(cavity.points.front());
        for (std::size_t o = 0; o < outer.size(); ++o)
            if (winding_number(plain[o], inside) > 0.5) {
                append(cavity, outer[o]);
                break;
            }
    }
    return outer;
}

}  // namespace

struct ExactSolid::Content {
    ExactSurface surface;
};

ExactSolid::ExactSolid(const TriangleSurface& surface) : content_(std::make_unique<Content>())
{
    for (const Vector3d& x : surface.vertices) content_->surface.points.push_back(exact(x));
    content_->surface.triangles = surface.triangles;
}

ExactSolid::ExactSolid(std::unique_ptr<Content> content) : content_(std::move(content)) {}
ExactSolid::~ExactSolid() = default;
ExactSolid::ExactSolid(ExactSolid&&) noexcept = default;
ExactSolid& ExactSolid::operator=(ExactSolid&&) noexcept = default;

TriangleSurface ExactSolid::rounded() const
{
    TriangleSurface result;
    for (const Point& p : content_->surface.points) result.vertices.push_back(rounded_point(p));
    result.triangles = content_->surface.triangles;
    return result;
}

std::optional<ExactSolid::Halves> ExactSolid::cut(const ExactPlane& through) const
{
    const Kernel::Plane_3 plane(exact(through[0]), exact(through[1]), exact(through[2]));
    const Vector3d front = (through[1] - through[0]).cross(through[2] - through[0]);
    std::vector<int> sides;
    for (const Point& p : content_->surface.points) sides.push_back(plane.oriented_side(p));
    const auto half = [&](int kept, std::vector<ExactSolid>& pieces) {
        ExactSurface surface;
        if (std::count(sides.begin(), sides.end(), kept) == 0) return false;
        if (!Half(content_->surface, plane, sides, kept).make(front, surface)) return false;
        for (ExactSurface& piece : connected_pieces(surface)) {
            auto content = std::make_unique<Content>();
            content->surface = std::move(piece);
            pieces.push_back(ExactSolid(std::move(content)));
        }
        return true;
    };
    Halves halves;
    try {
        if (!half(-1, halves.behind) || !half(1, halves.before)) return std::nullopt;
    } catch (const CGAL::Failure_exception&) {  // a configuration it cannot handle: another plane may do
        return std::nullopt;
    }
    return halves;
}

}  // namespace voussoir
