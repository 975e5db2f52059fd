#include "importers/exact/cut_choice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;
using std::numbers::pi;

namespace
{

constexpr double shares[] = {0.5, 0.35, 0.65, 0.2, 0.8};  // of the range of angles that resolve an edge
constexpr std::size_t max_edges = 256;                    // that are looked at
constexpr double least_angle = 0.03;                      // rad, between a cut and a face at its edge
constexpr double crossing_penalty = 0.75;                 // an edge that is crossed has to be resolved twice
constexpr double ridge_penalty = 0.1;                     // a convex edge in the cut is lost to edge contacts

struct Neighbours {
    int first = -1, second = -1;                    // triangles; the first runs along the edge from `from` to `to`
    int opposite_first = -1, opposite_second = -1;  // vertices
};

std::map<std::pair<int, int>, Neighbours> neighbours_of(const TriangleSurface& surface)
{
    std::map<std::pair<int, int>, Neighbours> all;
    for (int f = 0; f < static_cast<int>(surface.triangles.size()); ++f)
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3i& t = surface.triangles[f];
            const int from = t[k], to = t[(k + 1) % 3], opposite = t[(k + 2) % 3];
            Neighbours& edge = all[std::minmax(from, to)];
            (from < to ? edge.first : edge.second) = f;
            (from < to ? edge.opposite_first : edge.opposite_second) = opposite;
        }
    return all;
}

/// The half plane at the angle `a` from the first face, through the solid.
Vector3d direction_at(const ReentrantEdge& edge, double a)
{
    return std::cos(a) * edge.into_first - std::sin(a) * edge.first_normal;
}

bool resolves(const ReentrantEdge& edge, double a, double margin)
{
    return a >= edge.angle - pi + margin && a <= pi - margin;
}

struct Candidate {
    CutPlane plane;
    double score = 0;
};

CutPlane plane_through(const ReentrantEdge& edge, const Vector3d& direction)
{
    return {edge.from, (edge.to - edge.from).cross(direction).normalized()};
}

class Judge
{
 public:
    Judge(const TriangleSurface& surface, const std::vector<ReentrantEdge>& edges, double tolerance)
        : surface_(surface), edges_(edges), tolerance_(tolerance)
    {
        for (const auto& [ends, sides] : neighbours_of(surface)) {
            if (sides.first < 0 || sides.second < 0) continue;
            const Vector3d n1 = normal_of(surface, surface.triangles[sides.first]),
                           n2 = normal_of(surface, surface.triangles[sides.second]);
            const double bend = n1.normalized().dot(n2.normalized());
            if (bend < 1 - 1e-6) ridges_.push_back(ends);
        }
    }

    /// False when the plane lies in a face.
    bool judge(Candidate& candidate) const
    {
        const CutPlane& plane = candidate.plane;
        if (lies_in_a_face(plane)) return false;
        candidate.score = 0;
        for (const ReentrantEdge& edge : edges_) {
            const double from = plane.distance(edge.from), to = plane.distance(edge.to);
            if (std::abs(from) <= tolerance_ && std::abs(to) <= tolerance_)
                candidate.score += edge.weight;  // whatever the angle: all sectors it leaves are at most flat
            else if (std::min(from, to) < -tolerance_ && std::max(from, to) > tolerance_)
                candidate.score -= crossing_penalty * edge.weight;
        }
        int ridges = 0;
        for (const auto& [from, to] : ridges_)
            ridges += std::abs(plane.distance(surface_.vertices[from])) <= tolerance_ &&
                      std::abs(plane.distance(surface_.vertices[to])) <= tolerance_;
        candidate.score -= ridge_penalty * ridges;
        return true;
    }

 private:
    bool lies_in_a_face(const CutPlane& plane) const
    {
        return std::any_of(surface_.triangles.begin(), surface_.triangles.end(), [&](const Eigen::Vector3i& t) {
            for (int k = 0; k < 3; ++k)
                if (std::abs(plane.distance(surface_.vertices[t[k]])) > tolerance_) return false;
            const Vector3d n = normal_of(surface_, t);
            const double longest = std::max({(surface_.vertices[t[1]] - surface_.vertices[t[0]]).norm(),
                                             (surface_.vertices[t[2]] - surface_.vertices[t[1]]).norm(),
                                             (surface_.vertices[t[0]] - surface_.vertices[t[2]]).norm()});
            return n.norm() > tolerance_ * longest;  // needles along an edge of the cut do not count
        });
    }

    const TriangleSurface& surface_;
    const std::vector<ReentrantEdge>& edges_;
    double tolerance_;
    std::vector<std::pair<int, int>> ridges_;
};

/// Planes through one edge: at some angles, and through every other edge in a common plane with it.
std::vector<Candidate> candidates_at(const ReentrantEdge& edge, const std::vector<ReentrantEdge>& edges,
                                     double tolerance)
{
    std::vector<Candidate> found;
    const double lowest = edge.angle - pi, range = pi - lowest;
    for (const double share : shares)
        found.push_back({plane_through(edge, direction_at(edge, lowest + share * range))});
    const Vector3d along = (edge.to - edge.from).normalized();
    for (const ReentrantEdge& other : edges) {
        const Vector3d arm = other.from - edge.from, across = arm - along.dot(arm) * along;
        if (across.norm() <= 1e3 * tolerance) continue;
        const CutPlane plane = plane_through(edge, across);
        if (std::abs(plane.distance(other.to)) > tolerance) continue;
        double a = std::atan2(-edge.first_normal.dot(across), edge.into_first.dot(across));
        if (a < 0) a += pi;
        if (resolves(edge, a, least_angle)) found.push_back({plane});
    }
    return found;
}

}  // namespace

std::vector<ReentrantEdge> reentrant_edges(const TriangleSurface& surface, double tolerance)
{
    std::vector<ReentrantEdge> found;
    for (const auto& [ends, sides] : neighbours_of(surface)) {
        if (sides.first < 0 || sides.second < 0) continue;
        const Vector3d from = surface.vertices[ends.first], to = surface.vertices[ends.second];
        const Vector3d n1 = normal_of(surface, surface.triangles[sides.first]).normalized();
        const Vector3d n2 = normal_of(surface, surface.triangles[sides.second]).normalized();
        const double over_first = n1.dot(surface.vertices[sides.opposite_second] - from);
        const double over_second = n2.dot(surface.vertices[sides.opposite_first] - from);
        if (std::min(over_first, over_second) <= tolerance) continue;
        const Vector3d along = (to - from).normalized();
        ReentrantEdge edge{from, to, n1.cross(along), n1, 0, 1};
        const Vector3d into_second = along.cross(n2);
        edge.angle = std::atan2(-n1.dot(into_second), edge.into_first.dot(into_second));
        if (edge.angle < 0) edge.angle += 2 * pi;
        found.push_back(edge);
    }
    return found;
}

void weight_by_depth(std::vector<ReentrantEdge>& edges, const TriangleSurface& hull)
{
    for (ReentrantEdge& edge : edges) {
        const Vector3d middle = 0.5 * (edge.from + edge.to);
        double depth = 1e300;
        for (const Eigen::Vector3i& t : hull.triangles)
            depth = std::min(depth, normal_of(hull, t).normalized().dot(hull.vertices[t[0]] - middle));
        edge.weight = (edge.to - edge.from).norm() * (edge.angle - pi) * std::max(depth, 0.0);
    }
}

std::vector<CutPlane> cutting_planes(const TriangleSurface& surface, const std::vector<ReentrantEdge>& edges,
                                     double tolerance, std::size_t count)
{
    // Of a rough stone only the edges that are worth most propose planes and judge them.
    std::vector<ReentrantEdge> worth = edges;
    if (worth.size() > max_edges) {
        std::stable_sort(worth.begin(), worth.end(),
                         [](const ReentrantEdge& a, const ReentrantEdge& b) { return a.weight > b.weight; });
        worth.resize(max_edges);
    }
    const Judge judge(surface, worth, tolerance);
    std::vector<Candidate> good;
    for (const ReentrantEdge& edge : worth)
        for (Candidate& candidate : candidates_at(edge, worth, tolerance))
            if (judge.judge(candidate)) good.push_back(candidate);
    std::stable_sort(good.begin(), good.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    std::vector<CutPlane> planes;
    for (std::size_t i = 0; i < std::min(count, good.size()); ++i) planes.push_back(good[i].plane);
    return planes;
}

}  // namespace voussoir::importers::exact
