#include "libdda/analysis/edge_stress.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

constexpr double least_bearing = 0.1;     // of its area: [EN1996-1-1-2005], annex C (4), for e > 0.45 t
constexpr double same_direction = 0.985;  // cosine of 10 degrees
constexpr double same_plane = 0.01;       // of the smaller block's size

struct Bed {
    const BedPatch* first = nullptr;
    Vector3d normal = Vector3d::Zero(), centre = Vector3d::Zero(), pressure_centre = Vector3d::Zero();
    double area = 0, normal_force = 0;
    std::vector<BedPoint> points;
    std::vector<Vector3d> sides;  // of the polygons, from corner to corner

    void add(const BedPatch& patch)
    {
        if (!first) first = &patch;
        const std::size_t corners = patch.points.size() - patch.inner;
        for (std::size_t i = 0; i < corners; ++i)
            sides.emplace_back(patch.points[(i + 1) % corners].position - patch.points[i].position);
        for (const BedPoint& p : patch.points) {
            points.push_back(p);
            area += p.area;
            centre += p.area * p.position;
            normal += p.area * patch.normal;
            normal_force += p.normal_force;
            pressure_centre += p.normal_force * p.position;
        }
    }
    void finish()
    {
        centre /= area;
        normal.normalize();
        pressure_centre = normal_force > 0 ? Vector3d(pressure_centre / normal_force) : centre;
    }
};

/// Where the corners of a bed lie along an axis, from its centre [m].
struct Range {
    double low = 0, high = 0;
    double extent() const { return high - low; }
};

Range range_along(const Vector3d& axis, const Bed& bed)
{
    Range range;
    for (const BedPoint& p : bed.points) {
        range.low = std::min(range.low, axis.dot(p.position - bed.centre));
        range.high = std::max(range.high, axis.dot(p.position - bed.centre));
    }
    return range;
}

/// The sides of the smallest rectangle around the corners: one lies along a side of a patch. (2), unit
std::array<Vector3d, 2> sides_of(const Bed& bed)
{
    std::array<Vector3d, 2> sides = {bed.normal.unitOrthogonal(), {}};
    sides[1] = bed.normal.cross(sides[0]);
    double smallest = std::numeric_limits<double>::infinity();
    for (const Vector3d& side : bed.sides) {
        const Vector3d along = side - side.dot(bed.normal) * bed.normal;
        if (!(along.squaredNorm() > 1e-18 * bed.area)) continue;
        const Vector3d u = along.normalized(), v = bed.normal.cross(u);
        const double area = range_along(u, bed).extent() * range_along(v, bed).extent();
        if (!(area < (1 - 1e-9) * smallest)) continue;
        smallest = area;
        sides = {u, v};
    }
    return sides;
}

/// The bed's area times (1 - 2 e / extent) along both sides, at least least_bearing of it.
double effective_area(const Bed& bed)
{
    double share = 1;
    for (const Vector3d& axis : sides_of(bed)) {
        const Range range = range_along(axis, bed);
        if (!(range.extent() > 1e-9 * std::sqrt(bed.area))) continue;  // planar scenes have no extent across
        const double eccentricity = axis.dot(bed.pressure_centre - bed.centre);
        const double to_edge = eccentricity > 0 ? range.high - eccentricity : eccentricity - range.low;
        share *= std::clamp(2 * to_edge / range.extent(), 0.0, 1.0);
    }
    return bed.area * std::max(share, least_bearing);
}

bool in_one_plane(const BedPatch& a, const BedPatch& b, double size)
{
    for (int side = 0; side < 2; ++side) {
        const FacePlane &of_a = a.faces[side], &of_b = b.faces[side];
        if (of_a.normal.dot(of_b.normal) > same_direction &&
            std::abs(of_a.normal.dot(of_b.middle - of_a.middle)) < same_plane * size)
            return true;
    }
    return false;
}

/// The patches sorted by the planes of their faces. Where two edges cross there is no face: they go with the bed
/// that looks most their way, and where there is none they bear on no area that a stress could be judged by.
std::vector<Bed> beds_of(const std::vector<BedPatch>& patches, double size)
{
    std::vector<Bed> beds;
    for (const BedPatch& patch : patches) {
        if (patch.edge_edge) continue;
        auto bed = std::find_if(beds.begin(), beds.end(),
                                [&](const Bed& each) { return in_one_plane(*each.first, patch, size); });
        if (bed == beds.end()) bed = beds.insert(bed, Bed());
        bed->add(patch);
    }
    for (const BedPatch& patch : patches) {
        if (!patch.edge_edge) continue;
        auto bed = std::max_element(beds.begin(), beds.end(), [&](const Bed& a, const Bed& b) {
            return a.first->normal.dot(patch.normal) < b.first->normal.dot(patch.normal);
        });
        if (bed != beds.end()) bed->add(patch);
    }
    for (Bed& bed : beds) bed.finish();
    return beds;
}

}  // namespace

Bearing hardest_bearing(const std::vector<BedPatch>& patches, double size)
{
    Bearing hardest;
    for (const Bed& bed : beds_of(patches, size)) {
        const double area = effective_area(bed);
        if (area > 0 && bed.normal_force > hardest.stress * area) hardest = {bed.normal_force / area, area};
    }
    return hardest;
}

}  // namespace voussoir
