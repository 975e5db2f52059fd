#include "importers/exact/best_cut.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

constexpr int offsets = 7;               // of parallel planes across the content
constexpr int deep_points = 3;           // through which planes are laid
constexpr int large_faces = 4;           // whose directions are tried
constexpr int refined = 3;               // candidates that are tilted and moved
constexpr int halvings = 4;              // of the steps by which they are
constexpr double first_tilt = 0.15;      // rad
constexpr double first_move = 1.0 / 16;  // of the extent across the plane
constexpr double infinity = std::numeric_limits<double>::infinity();

class Search
{
 public:
    Search(const Cell& cell, const TriangleSurface& solid, double tolerance, double least)
        : cell_(cell), solid_(solid), tolerance_(tolerance), least_(least), hull_(hull_of(cell))
    {
        directions_ = symmetric_directions();
        for (const Vector3d& n : directions_of_large_faces()) directions_.push_back(n);
    }

    std::optional<BestCut> best()
    {
        if (hull_.triangles.empty()) return std::nullopt;
        std::vector<BestCut> tried;
        for (const CutPlane& plane : candidates()) tried.push_back({plane, volume_after(plane)});
        std::stable_sort(tried.begin(), tried.end(),
                         [](const BestCut& a, const BestCut& b) { return a.volume < b.volume; });
        tried.resize(std::min<std::size_t>(refined, tried.size()));
        for (BestCut& cut : tried) refine(cut);
        const auto best = std::min_element(tried.begin(), tried.end(),
                                           [](const BestCut& a, const BestCut& b) { return a.volume < b.volume; });
        if (best == tried.end() || !(best->volume < volume_of(hull_))) return std::nullopt;
        return *best;
    }

 private:
    /// The principal axes and the diagonals between two and three of them.
    std::vector<Vector3d> symmetric_directions() const
    {
        Vector3d mean = Vector3d::Zero();
        for (const Vector3d& x : cell_.surface.vertices) mean += x;
        mean /= static_cast<double>(cell_.surface.vertices.size());
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (const Vector3d& x : cell_.surface.vertices) spread += (x - mean) * (x - mean).transpose();
        const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
        std::vector<Vector3d> directions;
        for (int i = 0; i < 27; ++i) {  // one of each pair of opposite ones
            const Vector3d share(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (i > 13) directions.push_back((axes * share).normalized());
        }
        return directions;
    }

    std::vector<Vector3d> directions_of_large_faces() const
    {
        std::vector<std::pair<double, Vector3d>> groups;  // area, normal
        for (const Eigen::Vector3i& t : cell_.surface.triangles) {
            const Vector3d twice = normal_of(cell_.surface, t);
            if (twice.norm() == 0) continue;
            const Vector3d n = twice.normalized();
            const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
                return std::abs(group.second.dot(n)) > 0.999;
            });
            if (same != groups.end())
                same->first += twice.norm();
            else if (groups.size() < 200)
                groups.emplace_back(twice.norm(), n);
        }
        std::stable_sort(groups.begin(), groups.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        std::vector<Vector3d> normals;
        for (std::size_t i = 0; i < std::min<std::size_t>(large_faces, groups.size()); ++i)
            normals.push_back(groups[i].second);
        return normals;
    }

    /// Vertices that lie deepest below the hull, a quarter of its extent from one another at least.
    std::vector<Vector3d> deepest() const
    {
        std::vector<CutPlane> faces;
        for (const Eigen::Vector3i& t : hull_.triangles)
            faces.push_back({hull_.vertices[t[0]], normal_of(hull_, t).normalized()});
        std::vector<std::pair<double, int>> depths;
        for (std::size_t v = 0; v < cell_.surface.vertices.size(); ++v) {
            double depth = infinity;
            for (const CutPlane& face : faces) depth = std::min(depth, -face.distance(cell_.surface.vertices[v]));
            depths.emplace_back(-depth, static_cast<int>(v));
        }
        std::sort(depths.begin(), depths.end());
        const double apart = 0.25 * diagonal_of(hull_.vertices);
        std::vector<Vector3d> found;
        for (const auto& [depth, v] : depths) {
            const Vector3d& x = cell_.surface.vertices[v];
            if (static_cast<int>(found.size()) == deep_points || depth > -tolerance_) break;
            if (std::all_of(found.begin(), found.end(), [&](const Vector3d& y) { return (x - y).norm() > apart; }))
                found.push_back(x);
        }
        return found;
    }

    std::pair<double, double> extent(const Vector3d& direction) const
    {
        double lower = infinity, upper = -infinity;
        for (const Vector3d& x : hull_.vertices) {
            lower = std::min(lower, direction.dot(x));
            upper = std::max(upper, direction.dot(x));
        }
        return {lower, upper};
    }

    std::vector<CutPlane> candidates() const
    {
        std::vector<CutPlane> planes;
        const std::vector<Vector3d> deep = deepest();
        Vector3d middle = Vector3d::Zero();
        for (const Vector3d& x : hull_.vertices) middle += x / static_cast<double>(hull_.vertices.size());
        for (const Vector3d& n : directions_) {
            const auto [lower, upper] = extent(n);
            for (int i = 1; i <= offsets; ++i) {
                const double at = lower + (upper - lower) * i / (offsets + 1);
                planes.push_back({middle + (at - n.dot(middle)) * n, n});
            }
            for (const Vector3d& x : deep) planes.push_back({x, n});
        }
        return planes;
    }

    bool has_faces_in(const CutPlane& plane) const
    {
        return std::any_of(solid_.triangles.begin(), solid_.triangles.end(), [&](const Eigen::Vector3i& t) {
            for (int k = 0; k < 3; ++k)
                if (std::abs(plane.distance(solid_.vertices[t[k]])) > tolerance_) return false;
            return true;
        });
    }

    double volume_after(const CutPlane& plane) const
    {
        const auto [lower, upper] = std::minmax_element(
            hull_.vertices.begin(), hull_.vertices.end(),
            [&](const Vector3d& a, const Vector3d& b) { return plane.distance(a) < plane.distance(b); });
        if (plane.distance(*lower) > -tolerance_ || plane.distance(*upper) < tolerance_) return infinity;
        if (has_faces_in(plane)) return infinity;
        const auto [behind, before] = divided(cell_, plane, solid_);
        const double first = hull_volume_of(behind), second = hull_volume_of(before);
        return std::min(first, second) < least_ ? infinity : first + second;
    }

    /// Tilts and moves a plane as long as that helps, by ever smaller steps.
    void refine(BestCut& cut) const
    {
        const auto [lower, upper] = extent(cut.plane.normal);
        double tilt = first_tilt, move = first_move * (upper - lower);
        for (int halving = 0; halving < halvings; ++halving, tilt /= 2, move /= 2) {
            const Vector3d n = cut.plane.normal, u = n.unitOrthogonal(), v = n.cross(u);
            BestCut best = cut;
            for (const auto& [du, dv, dn] : {std::array{1., 0., 0.},
                                             {-1., 0., 0.},
                                             {0., 1., 0.},
                                             {0., -1., 0.},
                                             {0., 0., 1.},
                                             {0., 0., -1.}}) {
                const CutPlane plane{cut.plane.anchor + dn * move * n,
                                     (n + tilt * du * u + tilt * dv * v).normalized()};
                if (const double volume = volume_after(plane); volume < best.volume) best = {plane, volume};
            }
            cut = best;
        }
    }

    const Cell& cell_;
    const TriangleSurface& solid_;
    double tolerance_, least_;
    TriangleSurface hull_;
    std::vector<Vector3d> directions_;
};

}  // namespace

std::optional<BestCut> best_cut(const Cell& cell, const TriangleSurface& solid, double tolerance, double least)
{
    if (cell.surface.vertices.size() < 4) return std::nullopt;
    return Search(cell, solid, tolerance, least).best();
}

}  // namespace voussoir::importers::exact
