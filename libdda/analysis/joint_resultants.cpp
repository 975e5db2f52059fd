#include "libdda/analysis/joint_resultants.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

struct JointPoint {
    Vector3d normal, force;   // on the block with the lower index
    Vector3d position, foot;  // on the two faces
    double area, slip, normal_force, gap;
    bool open;
};

constexpr double least_bearing = 0.1;  // of the joint's extent: EN 1996-1-1, annex C (4), for e > 0.45 t

constexpr double same_direction = 0.985;  // cosine of 10 degrees
constexpr double same_plane = 0.05;       // of the root of the joint's area

/// What of a joint lies in one plane.
struct Bed {
    Vector3d normal = Vector3d::Zero(), centre = Vector3d::Zero(), pressure_centre = Vector3d::Zero();
    double area = 0, normal_force = 0;
    std::vector<JointPoint> points;
};

/// Where the corners of a bed lie along an axis, from its centre [m].
struct Range {
    double low = 0, high = 0;
    double extent() const { return high - low; }
};

Range range_along(const Vector3d& axis, const Bed& bed)
{
    Range range;
    for (const JointPoint& p : bed.points) {
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
    for (std::size_t i = 0; i < bed.points.size(); ++i) {  // the corners of a patch follow one another
        Vector3d along = bed.points[i].position - bed.points[(i + 1) % bed.points.size()].position;
        along -= along.dot(bed.normal) * bed.normal;
        if (!(along.squaredNorm() > 1e-18 * bed.area)) continue;
        const Vector3d u = along.normalized(), v = bed.normal.cross(u);
        const double area = range_along(u, bed).extent() * range_along(v, bed).extent();
        if (!(area < (1 - 1e-9) * smallest)) continue;
        smallest = area;
        sides = {u, v};
    }
    return sides;
}

/// The bed's area times (1 - 2 e / extent), at least least_bearing, along both sides.
double effective_area(const Bed& bed)
{
    double area = bed.area;
    for (const Vector3d& axis : sides_of(bed)) {
        const Range range = range_along(axis, bed);
        if (!(range.extent() > 1e-9 * std::sqrt(bed.area))) continue;  // planar scenes have no extent across
        const double eccentricity = axis.dot(bed.pressure_centre - bed.centre);
        const double to_edge = eccentricity > 0 ? range.high - eccentricity : eccentricity - range.low;
        area *= std::clamp(2 * to_edge / range.extent(), least_bearing, 1.0);
    }
    return area;
}

/// The points sorted by the planes they lie in, in the order in which those come.
std::vector<Bed> beds_of(const std::vector<JointPoint>& points, double joint_area)
{
    std::vector<Bed> beds;
    for (const JointPoint& p : points) {
        const auto in_plane = [&](const Bed& bed) {
            const JointPoint& first = bed.points.front();
            return first.normal.dot(p.normal) > same_direction &&
                   std::abs(first.normal.dot(p.foot - first.foot)) < same_plane * std::sqrt(joint_area);
        };
        auto bed = std::find_if(beds.begin(), beds.end(), in_plane);
        if (bed == beds.end()) bed = beds.insert(bed, Bed());
        bed->points.push_back(p);
        bed->area += p.area;
        bed->centre += p.area * p.position;
        bed->normal += p.area * p.normal;
        bed->normal_force += p.normal_force;
        bed->pressure_centre += p.normal_force * p.position;
    }
    for (Bed& bed : beds) {
        bed.centre /= bed.area;
        bed.normal.normalize();
        bed.pressure_centre = bed.normal_force > 0 ? Vector3d(bed.pressure_centre / bed.normal_force) : bed.centre;
    }
    return beds;
}

using PointsOfJoints = std::map<std::pair<int, int>, std::vector<JointPoint>>;

JointResultant resultant(int block_a, int block_b, const std::vector<JointPoint>& points)
{
    JointResultant joint;
    joint.block_a = block_a;
    joint.block_b = block_b;
    for (const JointPoint& p : points) {
        joint.area += p.area;
        joint.centre += p.area * p.position;
        joint.normal += p.area * p.normal;
        joint.slip += p.area * p.slip;
    }
    joint.centre /= joint.area;
    joint.slip /= joint.area;
    joint.normal.normalize();
    joint.pressure_centre.setZero();
    for (const JointPoint& p : points) {
        joint.force += p.force;
        joint.moment += (p.position - joint.centre).cross(p.force);
        joint.normal_force += p.normal_force;
        joint.pressure_centre += p.normal_force * p.position;
        if (!p.open) joint.closed_area += p.area;
        joint.max_opening = std::max(joint.max_opening, p.gap);
    }
    joint.pressure_centre =
        joint.normal_force > 0 ? Vector3d(joint.pressure_centre / joint.normal_force) : joint.centre;
    for (const Bed& bed : beds_of(points, joint.area)) {
        const double bears = effective_area(bed);
        joint.effective_area += bears;
        if (bears > 0) joint.edge_stress = std::max(joint.edge_stress, bed.normal_force / bears);
    }
    return joint;
}

template <int D>
void collect(const ContactSetIn<D>& contacts, PointsOfJoints& joints)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        // The patch's forces act on its block a; ours on the block with the lower index.
        const double sign = patch.block_a < patch.block_b ? 1 : -1;
        auto& points = joints[{std::min(patch.block_a, patch.block_b), std::max(patch.block_a, patch.block_b)}];
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts.points[i];
            const VectorIn<D> force = sign * (point.normal_force * patch.normal - point.shear_force);
            points.push_back(
                {to_space(VectorIn<D>(sign * patch.normal)), to_space(force), to_space(point.position),
                 to_space(VectorIn<D>(point.position - point.gap * patch.normal)), point.area,
                 point.plastic_slip.norm(), point.normal_force, point.gap, point.status == ContactStatus::open});
        }
    }
}

}  // namespace

std::vector<JointResultant> joint_resultants(const Model& model, const State& state)
{
    PointsOfJoints joints;
    if (is_planar(model.kinematics))
        collect(state.planar_contacts, joints);
    else
        collect(state.contacts, joints);
    std::vector<JointResultant> result;
    for (const auto& [pair, points] : joints) result.push_back(resultant(pair.first, pair.second, points));
    return result;
}

}  // namespace voussoir
