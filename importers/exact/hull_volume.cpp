#include "importers/exact/hull_volume.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

class QuickHull
{
 public:
    explicit QuickHull(const std::vector<Vector3d>& points) : points_(points) {}

    double volume()
    {
        if (points_.size() < 4 || !start()) return 0;
        while (!open_.empty()) {
            const int f = open_.back();
            open_.pop_back();
            if (facets_[f].alive && !facets_[f].above.empty()) raise(f);
        }
        double sixfold = 0;
        for (const Facet& facet : facets_)
            if (facet.alive) sixfold += facet.normal.dot(at(facet.corner[0]) - origin_) * facet.twice_area;
        return sixfold / 6;
    }

 private:
    struct Facet {
        std::array<int, 3> corner{}, neighbour{};  // the neighbour k lies across the side from corner k to k + 1
        Vector3d normal = Vector3d::Zero();
        double twice_area = 0;
        std::vector<int> above;  // points
        int farthest = -1;
        double height = 0;
        bool alive = true;
        int seen = 0;
    };
    struct Side {
        int from, to, facet, place;  // of the facet that stays
    };

    const Vector3d& at(int point) const { return points_[point]; }
    double height(const Facet& facet, int point) const
    {
        return facet.normal.dot(at(point) - at(facet.corner[0]));
    }

    int add(int a, int b, int c)
    {
        Facet facet;
        facet.corner = {a, b, c};
        const Vector3d twice = (at(b) - at(a)).cross(at(c) - at(a));
        facet.twice_area = twice.norm();
        facet.normal = facet.twice_area > 0 ? Vector3d(twice / facet.twice_area) : Vector3d::Zero();
        facets_.push_back(std::move(facet));
        return static_cast<int>(facets_.size()) - 1;
    }

    template <class Measure>
    int extreme(const Measure& measure) const
    {
        int best = 0;
        double most = -1;
        for (int i = 0; i < static_cast<int>(points_.size()); ++i)
            if (const double m = measure(at(i)); m > most) {
                most = m;
                best = i;
            }
        return best;
    }

    /// The first tetrahedron. @returns false when the points lie in a plane
    bool start()
    {
        const Vector3d first = points_.front();
        const int a = extreme([&](const Vector3d& x) { return (x - first).norm(); });
        const int b = extreme([&](const Vector3d& x) { return (x - at(a)).norm(); });
        const double size = (at(b) - at(a)).norm();
        const Vector3d along = (at(b) - at(a)) / (size > 0 ? size : 1);
        const int c = extreme([&](const Vector3d& x) { return (x - at(a)).cross(along).norm(); });
        const Vector3d normal = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
        int d = extreme([&](const Vector3d& x) { return std::abs(normal.dot(x - at(a))); });
        tolerance_ = 1e-9 * size;
        origin_ = at(a);
        if (!(std::abs(normal.dot(at(d) - at(a))) > tolerance_)) return false;
        const bool below = normal.dot(at(d) - at(a)) < 0;
        const int p = a, q = below ? b : c, r = below ? c : b;
        add(p, q, r);
        add(p, r, d);
        add(r, q, d);
        add(q, p, d);
        facets_[0].neighbour = {3, 2, 1};
        facets_[1].neighbour = {0, 2, 3};
        facets_[2].neighbour = {0, 3, 1};
        facets_[3].neighbour = {0, 1, 2};
        std::vector<int> all(points_.size());
        for (int i = 0; i < static_cast<int>(all.size()); ++i) all[i] = i;
        share_out(all, {0, 1, 2, 3});
        return true;
    }

    void share_out(const std::vector<int>& points, const std::vector<int>& facets)
    {
        for (const int point : points)
            for (const int f : facets) {
                Facet& facet = facets_[f];
                const double h = height(facet, point);
                if (h <= tolerance_) continue;
                facet.above.push_back(point);
                if (h > facet.height) {
                    facet.height = h;
                    facet.farthest = point;
                }
                break;
            }
        for (const int f : facets)
            if (!facets_[f].above.empty()) open_.push_back(f);
    }

    /// Replaces all facets that the farthest point above a facet sees by facets from their rim to it.
    void raise(int f)
    {
        const int top = facets_[f].farthest;
        std::vector<int> visible{f}, orphans;
        std::vector<Side> rim;
        facets_[f].seen = ++round_;
        for (std::size_t i = 0; i < visible.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const int n = facets_[visible[i]].neighbour[k];
                if (facets_[n].seen == round_) continue;
                const std::array<int, 3>& corner = facets_[visible[i]].corner;
                if (height(facets_[n], top) > tolerance_) {
                    facets_[n].seen = round_;
                    visible.push_back(n);
                } else {
                    const auto& back = facets_[n].neighbour;
                    const auto place = std::find(back.begin(), back.end(), visible[i]) - back.begin();
                    rim.push_back({corner[k], corner[(k + 1) % 3], n, static_cast<int>(place)});
                }
            }
        for (const int v : visible) {
            facets_[v].alive = false;
            for (const int point : facets_[v].above)
                if (point != top) orphans.push_back(point);
            facets_[v].above.clear();
        }
        share_out(orphans, cone(rim, top));
    }

    std::vector<int> cone(const std::vector<Side>& rim, int top)
    {
        std::vector<int> fresh;
        for (const Side& side : rim) {
            fresh.push_back(add(side.from, side.to, top));
            if (starts_.size() < points_.size()) starts_.resize(points_.size(), -1);
            starts_[side.from] = fresh.back();
        }
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const int next = starts_[rim[i].to];
            facets_[fresh[i]].neighbour[0] = rim[i].facet;
            if (rim[i].place < 3) facets_[rim[i].facet].neighbour[rim[i].place] = fresh[i];
            facets_[fresh[i]].neighbour[1] = next;
            facets_[next].neighbour[2] = fresh[i];
        }
        return fresh;
    }

    const std::vector<Vector3d>& points_;
    std::vector<Facet> facets_;
    std::vector<int> open_, starts_;
    double tolerance_ = 0;
    Vector3d origin_ = Vector3d::Zero();
    int round_ = 0;
};

}  // namespace

double hull_volume(const std::vector<Vector3d>& points)
{
    return QuickHull(points).volume();
}

}  // namespace voussoir::importers::exact
