#include "importers/exact/clipped_volume.h"

#include <algorithm>
#include <array>
#include <map>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

/// What lies behind a plane, and the fan that closes it.
class Behind
{
 public:
    Behind(const TriangleSurface& whole, const std::vector<double>& distance, const Vector3d& hub)
        : whole_(whole), distance_(distance), place_(whole.vertices.size(), -1)
    {
        kept.vertices.push_back(hub);
        for (const Eigen::Vector3i& t : whole.triangles) clip(t);
    }

    TriangleSurface kept;

 private:
    int add(const Vector3d& x)
    {
        kept.vertices.push_back(x);
        return static_cast<int>(kept.vertices.size()) - 1;
    }
    int keep(int v)
    {
        if (place_[v] < 0) place_[v] = add(whole_.vertices[v]);
        return place_[v];
    }
    int cut(int a, int b)
    {
        const auto [entry, is_new] = cuts_.try_emplace(std::minmax(a, b), -1);
        if (is_new) {
            const auto& [low, high] = entry->first;
            const double share = distance_[low] / (distance_[low] - distance_[high]);
            entry->second = add(whole_.vertices[low] + share * (whole_.vertices[high] - whole_.vertices[low]));
        }
        return entry->second;
    }
    /// A vertex in the plane counts as behind it: a triangle is cut where it crosses only.
    void clip(const Eigen::Vector3i& t)
    {
        std::array<int, 4> loop{};
        int count = 0, leaves = -1, enters = -1;
        for (int k = 0; k < 3; ++k) {
            const int from = t[k], to = t[(k + 1) % 3];
            const bool from_in = distance_[from] <= 0, to_in = distance_[to] <= 0;
            if (from_in) loop[count++] = keep(from);
            if (from_in == to_in) continue;
            (from_in ? leaves : enters) = loop[count++] = cut(from, to);
        }
        for (int i = 1; i + 1 < count; ++i) kept.triangles.emplace_back(loop[0], loop[i], loop[i + 1]);
        if (leaves >= 0) kept.triangles.emplace_back(0, enters, leaves);
    }

    const TriangleSurface& whole_;
    const std::vector<double>& distance_;
    std::vector<int> place_;
    std::map<std::pair<int, int>, int> cuts_;
};

}  // namespace

double clipped_volume(TriangleSurface surface, const std::vector<CutPlane>& planes)
{
    std::vector<double> distance;
    for (const CutPlane& plane : planes) {
        distance.clear();
        for (const Vector3d& x : surface.vertices) distance.push_back(plane.distance(x));
        if (std::none_of(distance.begin(), distance.end(), [](double d) { return d > 0; })) continue;
        surface = Behind(surface, distance, plane.anchor).kept;
    }
    return volume_of(surface);
}

}  // namespace voussoir::importers::exact
