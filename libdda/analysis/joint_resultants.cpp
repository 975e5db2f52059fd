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
    Vector3d normal, force;  // on the block with the lower index
    Vector3d position;
    double area, slip, normal_force, gap;
    bool open;
};

constexpr double least_bearing = 0.1;  // of the joint's extent: EN 1996-1-1, annex C (4), for e > 0.45 t

/// Where the corners of a joint lie along an axis, from its centre [m].
struct Range {
    double low = 0, high = 0;
    double extent() const { return high - low; }
};

Range range_along(const Vector3d& axis, const JointResultant& joint, const std::vector<JointPoint>& points)
{
    Range range;
    for (const JointPoint& p : points) {
        range.low = std::min(range.low, axis.dot(p.position - joint.centre));
        range.high = std::max(range.high, axis.dot(p.position - joint.centre));
    }
    return range;
}

/// The sides of the smallest rectangle around the corners: one lies along a side of a patch. (2), unit
std::array<Vector3d, 2> sides_of(const JointResultant& joint, const std::vector<JointPoint>& points)
{
    std::array<Vector3d, 2> sides = {joint.normal.unitOrthogonal(), {}};
    sides[1] = joint.normal.cross(sides[0]);
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {  // the corners of a patch follow one another
        Vector3d along = points[i].position - points[(i + 1) % points.size()].position;
        along -= along.dot(joint.normal) * joint.normal;
        if (!(along.squaredNorm() > 1e-18 * joint.area)) continue;
        const Vector3d u = along.normalized(), v = joint.normal.cross(u);
        const double area = range_along(u, joint, points).extent() * range_along(v, joint, points).extent();
        if (!(area < (1 - 1e-9) * smallest)) continue;
        smallest = area;
        sides = {u, v};
    }
    return sides;
}

/// The joint's area times (1 - 2 e / extent), at least least_bearing, along both sides.
double effective_area(const JointResultant& joint, const std::vector<JointPoint>& points)
{
    double area = joint.area;
    for (const Vector3d& axis : sides_of(joint, points)) {
        const Range range = range_along(axis, joint, points);
        if (!(range.extent() > 1e-9 * std::sqrt(joint.area))) continue;  // planar scenes have no extent across
        const double eccentricity = axis.dot(joint.pressure_centre - joint.centre);
        const double to_edge = eccentricity > 0 ? range.high - eccentricity : eccentricity - range.low;
        area *= std::clamp(2 * to_edge / range.extent(), least_bearing, 1.0);
    }
    return area;
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
    joint.effective_area = effective_area(joint, points);
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
            points.push_back({to_space(VectorIn<D>(sign * patch.normal)), to_space(force),
                              to_space(point.position), point.area, point.plastic_slip.norm(), point.normal_force,
                              point.gap, point.status == ContactStatus::open});
        }
    }
}

}  // namespace

double edge_stress(const JointResultant& joint)
{
    return joint.effective_area > 0 ? joint.normal_force / joint.effective_area : 0;
}

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
