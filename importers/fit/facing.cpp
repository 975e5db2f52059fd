#include "importers/fit/facing.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "libdda/geometry/box_tree.h"

namespace voussoir::importers::fit
{

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

const double opposite = -std::cos(25 * EIGEN_PI / 180);  // of normals
constexpr double least_share = 0.05;                     // of the smaller side's area
// Shares of the smaller side's size:
constexpr double mean_off = 0.06;       // sides further apart on average do not lie on each other
constexpr double touching = 2e-3;       // sides nearer than this somewhere touch
constexpr double wedge_opening = 0.01;  // a wedge that opens by less is the noise of a survey

/// A triangle seen along the joint's normal: its corners on the plane, and its height over it.
struct Shadow {
    std::array<Vector2d, 3> corners;  // counter-clockwise
    Eigen::Vector3d height;           // (c, a, b): c + a x + b y
    int face = 0;                     // of the surface
};

std::optional<Shadow> shadow_of(const Eigen::Matrix3d& triangle, const Frame& frame)
{
    Shadow shadow;
    Eigen::Matrix3d places;
    Vector3d heights;
    for (int k = 0; k < 3; ++k) {
        const Vector3d arm = triangle.col(k) - frame.centre;
        shadow.corners[k] = {frame.u.dot(arm), frame.v.dot(arm)};
        places.row(k) << 1, shadow.corners[k].transpose();
        heights[k] = frame.normal.dot(arm);
    }
    const double twice = places.determinant();
    const double extent = (shadow.corners[1] - shadow.corners[0]).squaredNorm() +
                          (shadow.corners[2] - shadow.corners[0]).squaredNorm();
    if (std::abs(twice) <= 1e-9 * extent) return std::nullopt;  // seen from the side
    shadow.height = places.partialPivLu().solve(heights);
    if (twice < 0) std::swap(shadow.corners[1], shadow.corners[2]);
    return shadow;
}

double cross(const Vector2d& a, const Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// The common polygon of two triangles. Source: [SutherlandHodgman1974].
std::vector<Vector2d> common_polygon(const Shadow& a, const Shadow& b)
{
    std::vector<Vector2d> polygon(a.corners.begin(), a.corners.end()), kept;
    for (int k = 0; k < 3 && polygon.size() >= 3; ++k) {
        const Vector2d& from = b.corners[k];
        const Vector2d along = b.corners[(k + 1) % 3] - from;
        kept.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vector2d &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
            const double d0 = cross(along, here - from), d1 = cross(along, next - from);
            if (d0 >= 0) kept.push_back(here);
            if ((d0 >= 0) != (d1 >= 0)) kept.push_back(here + d0 / (d0 - d1) * (next - here));
        }
        polygon.swap(kept);
    }
    return polygon;
}

double area_of(const std::vector<Vector2d>& polygon)
{
    double twice = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    return twice / 2;
}

std::vector<Shadow> shadows_of(const SidedStone& stone, const Side& side, const Frame& frame)
{
    std::vector<Shadow> shadows;
    for (const int face : side.faces)
        for (const Eigen::Matrix3d& triangle : triangles_of(*stone.surface, face))
            if (const auto shadow = shadow_of(triangle, frame)) {
                shadows.push_back(*shadow);
                shadows.back().face = face;
            }
    return shadows;
}

void add_points(const Shadow& a, const Shadow& b, const Frame& frame, Facing& facing)
{
    const std::vector<Vector2d> polygon = common_polygon(a, b);
    if (polygon.size() < 3) return;
    const double area = area_of(polygon);
    if (area <= 0) return;
    for (const Vector2d& x : polygon) {
        const Vector3d terms(1, x.x(), x.y());
        const double of_a = a.height.dot(terms), of_b = b.height.dot(terms);
        const Vector3d place = frame.centre + x.x() * frame.u + x.y() * frame.v;
        facing.points.push_back(
            {place + 0.5 * (of_a + of_b) * frame.normal, of_b - of_a, area / static_cast<double>(polygon.size())});
    }
    facing.area += area;
    facing.area_of_face_a[a.face] += area;
    facing.area_of_face_b[b.face] += area;
}

/// Whether the gap is a wedge: linear over the joint, closed at one end and open at the other.
bool opens_as_wedge(const Facing& facing, const Frame& frame, double size)
{
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Vector3d load = Vector3d::Zero();
    const auto terms_at = [&](const FacingPoint& point) {
        const Vector3d arm = (point.place - frame.centre) / size;
        return Vector3d(1, frame.u.dot(arm), frame.v.dot(arm));
    };
    for (const FacingPoint& point : facing.points) {
        const Vector3d terms = terms_at(point);
        matrix += point.area * terms * terms.transpose();
        load += point.area * point.gap * terms;
    }
    const Vector3d linear = matrix.ldlt().solve(load);
    double widest = 0, narrowest = 0, bent = 0;
    for (const FacingPoint& point : facing.points) {
        const double here = linear.dot(terms_at(point));
        widest = std::max(widest, here);
        narrowest = std::min(narrowest, here);
        bent = std::max(bent, std::abs(point.gap - here));
    }
    return widest > wedge_opening * size && -narrowest < widest / 4 && bent < widest / 4;
}

std::optional<Facing> facing_of(const std::vector<SidedStone>& stones, int a, int side_a, int b, int side_b)
{
    const Side &first = stones[a].sides[side_a], &second = stones[b].sides[side_b];
    if (first.plane.normal.dot(second.plane.normal) > opposite) return std::nullopt;
    const double size = std::min(first.size, second.size);
    const Vector3d normal = (first.plane.normal - second.plane.normal).normalized();
    const double apart = normal.dot(second.plane.centre - first.plane.centre);
    if (std::abs(apart) > 0.5 * (first.size + second.size)) return std::nullopt;
    const Frame frame = frame_of(first.plane.centre, normal);
    Facing facing{a, side_a, b, side_b, normal, {}, {}, {}, 0, false, 0, 0};
    const std::vector<Shadow> of_second = shadows_of(stones[b], second, frame);
    for (const Shadow& one : shadows_of(stones[a], first, frame))
        for (const Shadow& other : of_second) add_points(one, other, frame, facing);
    if (facing.area < least_share * std::min(first.area, second.area)) return std::nullopt;
    double mean = 0;
    facing.smallest_gap = facing.largest_gap = facing.points.front().gap;
    for (const FacingPoint& point : facing.points) {
        mean += point.area * std::abs(point.gap) / facing.area;
        facing.smallest_gap = std::min(facing.smallest_gap, point.gap);
        facing.largest_gap = std::max(facing.largest_gap, point.gap);
    }
    if (mean > mean_off * size || facing.smallest_gap > touching * size) return std::nullopt;
    if (opens_as_wedge(facing, frame, size)) return std::nullopt;
    return facing;
}

}  // namespace

std::vector<Facing> find_facing(const std::vector<SidedStone>& stones)
{
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const SidedStone& stone : stones) {
        Eigen::AlignedBox3d box;
        for (const Vector3d& x : stone.surface->vertices) box.extend(x);
        const Vector3d margin = Vector3d::Constant(0.02 * stone.size);
        boxes.push_back({box.min() - margin, box.max() + margin});
    }
    std::vector<Facing> all;
    if (boxes.empty()) return all;
    const BoxTree tree(std::move(boxes));
    for (int a = 0; a < static_cast<int>(stones.size()); ++a)
        for (const int b : tree.neighbours_behind(a))
            for (int i = 0; i < static_cast<int>(stones[a].sides.size()); ++i)
                for (int j = 0; j < static_cast<int>(stones[b].sides.size()); ++j)
                    if (auto facing = facing_of(stones, a, i, b, j)) all.push_back(std::move(*facing));
    return all;
}

}  // namespace voussoir::importers::fit
