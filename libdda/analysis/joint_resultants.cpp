#include "libdda/analysis/joint_resultants.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace voussoir
{

using Eigen::Matrix3d;
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

/// The joint's area times (1 - 2 e / extent), at least least_bearing, along both principal axes of its corners.
double effective_area(const JointResultant& joint, const std::vector<JointPoint>& points)
{
    Matrix3d spread = Matrix3d::Zero();
    for (const JointPoint& p : points) {
        const Vector3d lever = p.position - joint.centre;
        spread += lever * lever.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(spread);
    double area = joint.area;
    for (int k = 1; k < 3; ++k) {  // the least spread is across the joint
        const Vector3d axis = axes.eigenvectors().col(k);
        double low = 0, high = 0;
        for (const JointPoint& p : points) {
            low = std::min(low, axis.dot(p.position - joint.centre));
            high = std::max(high, axis.dot(p.position - joint.centre));
        }
        if (!(high - low > 1e-9 * std::sqrt(joint.area))) continue;  // planar scenes have no extent across
        const double eccentricity = axis.dot(joint.pressure_centre - joint.centre);
        const double to_edge = eccentricity > 0 ? high - eccentricity : eccentricity - low;
        area *= std::clamp(2 * to_edge / (high - low), least_bearing, 1.0);
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
