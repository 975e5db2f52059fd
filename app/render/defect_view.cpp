#include "app/render/defect_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace voussoir::app::render
{

namespace
{

using Eigen::Vector3d;

constexpr std::size_t max_samples = 60, max_triangles = 20000;
constexpr double flat_view = 0.4;   // a mark seen face on is worth this share of its samples
constexpr double from_below = 0.3;  // buildings are seen from above
constexpr double better_by = 0.12;  // a view further from the usual one must be clearly better

struct Corners {
    Vector3d a, b, c;
};

/// Triangles of the stones that hide what is behind them.
std::vector<Corners> hiding_triangles(const std::vector<PictureShape>& shapes, const DefectPicture& picture)
{
    std::vector<Corners> triangles;
    for (const PictureStone& stone : picture.stones) {
        if (stone.look == StoneLook::ghost) continue;
        const PictureShape& shape = shapes[stone.shape];
        for (const std::vector<int>& face : shape.faces)
            for (std::size_t i = 1; i + 1 < face.size(); ++i)
                triangles.push_back(
                    {shape.vertices[face[0]], shape.vertices[face[i]], shape.vertices[face[i + 1]]});
    }
    return triangles;
}

/// Does a ray that starts a little in front of `from` meet the triangle? Source: [MoellerTrumbore1997].
bool hides(const Corners& t, const Vector3d& from, const Vector3d& direction, double clear)
{
    const Vector3d e1 = t.b - t.a, e2 = t.c - t.a, p = direction.cross(e2);
    const double determinant = e1.dot(p);
    if (std::abs(determinant) < 1e-14 * e1.norm() * e2.norm()) return false;
    const Vector3d s = from - t.a, q = s.cross(e1);
    const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && e2.dot(q) / determinant > clear;
}

std::vector<Vector3d> directions()
{
    std::vector<Vector3d> list;
    constexpr double degree = std::numbers::pi / 180;
    for (const double elevation : {18.0, 38.0, -18.0, -42.0})
        for (const double azimuth : {-65.0, -115.0, -25.0, -155.0, 25.0, 65.0, 115.0, 155.0})
            list.emplace_back(std::cos(elevation * degree) * std::cos(azimuth * degree),
                              std::cos(elevation * degree) * std::sin(azimuth * degree),
                              std::sin(elevation * degree));
    return list;
}

/// A measure of the area over which points spread, seen from a direction [m2].
double seen_area(const std::vector<Vector3d>& points, const Vector3d& direction)
{
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& x : points) mean += x / static_cast<double>(points.size());
    const Vector3d right = Vector3d::UnitZ().cross(direction).normalized(), up = direction.cross(right);
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vector3d& x : points) {
        const Eigen::Vector2d seen(right.dot(x - mean), up.dot(x - mean));
        spread += seen * seen.transpose() / static_cast<double>(points.size());
    }
    return std::sqrt(std::max(0.0, spread.determinant()));
}

std::vector<Vector3d> samples_of_all(const DefectPicture& picture)
{
    std::vector<Vector3d> all;
    for (const PictureMark& mark : picture.marks) {
        const std::vector<Vector3d> samples = samples_of(mark.feature);
        all.insert(all.end(), samples.begin(), samples.end());
    }
    if (all.size() <= max_samples) return all;
    std::vector<Vector3d> some;
    for (std::size_t i = 0; i < max_samples; ++i) some.push_back(all[i * all.size() / max_samples]);
    return some;
}

}  // namespace

std::vector<Vector3d> samples_of(const importers::mesh::MarkedFeature& feature)
{
    std::vector<Vector3d> samples = feature.points;
    for (const auto& [from, to] : feature.lines) samples.insert(samples.end(), {0.5 * (from + to), from, to});
    for (const std::vector<Vector3d>& polygon : feature.polygons) {
        Vector3d middle = Vector3d::Zero();
        for (const Vector3d& x : polygon) middle += x / static_cast<double>(polygon.size());
        samples.push_back(middle);
        samples.insert(samples.end(), polygon.begin(), polygon.end());
    }
    return samples;
}

std::vector<Vector3d> points_to_see(const std::vector<PictureShape>& shapes, const DefectPicture& picture)
{
    std::vector<Vector3d> points;
    for (const PictureStone& stone : picture.stones) {
        if (stone.look == StoneLook::ghost && !picture.frame_ghosts) continue;
        const std::vector<Vector3d>& vertices = shapes[stone.shape].vertices;
        points.insert(points.end(), vertices.begin(), vertices.end());
    }
    for (const PictureMark& mark : picture.marks) {
        const std::vector<Vector3d> samples = samples_of(mark.feature);
        points.insert(points.end(), samples.begin(), samples.end());
    }
    return points;
}

Vector3d best_direction(const std::vector<PictureShape>& shapes, const DefectPicture& picture)
{
    const std::vector<Vector3d> around = directions(), samples = samples_of_all(picture);
    const std::vector<Corners> triangles = hiding_triangles(shapes, picture);
    if (samples.empty() || triangles.size() > max_triangles) return around.front();
    Vector3d low = samples.front(), high = low;
    for (const Corners& t : triangles) {
        low = low.cwiseMin(t.a);
        high = high.cwiseMax(t.a);
    }
    const double clear = 1e-4 * (high - low).norm();
    const double count = static_cast<double>(samples.size());
    std::vector<double> areas;
    for (const Vector3d& direction : around) areas.push_back(seen_area(samples, direction));
    const double largest = std::max(*std::max_element(areas.begin(), areas.end()), 1e-300);
    Vector3d best = around.front();
    double least = 1e300;
    for (std::size_t i = 0; i < around.size(); ++i) {
        double hidden = 0;
        for (const Vector3d& sample : samples)
            hidden += std::any_of(triangles.begin(), triangles.end(), [&](const Corners& triangle) {
                return hides(triangle, sample, around[i], clear);
            });
        const double cost = hidden / count - flat_view * areas[i] / largest + (around[i].z() < 0 ? from_below : 0);
        if (cost < least - better_by) {
            least = cost;
            best = around[i];
        }
    }
    return best;
}

}  // namespace voussoir::app::render
