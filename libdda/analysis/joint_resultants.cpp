#include "libdda/analysis/joint_resultants.h"

#include <Eigen/Geometry>
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
