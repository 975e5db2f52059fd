#include "libdda/analysis/joint_resultants.h"

#include <Eigen/Geometry>
#include <map>

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

struct JointPoint {
    const ContactPoint* point;
    Vector3d normal, force;  // on the block with the lower index
};

JointResultant resultant(int block_a, int block_b, const std::vector<JointPoint>& points)
{
    JointResultant joint;
    joint.block_a = block_a;
    joint.block_b = block_b;
    for (const JointPoint& p : points) {
        joint.area += p.point->area;
        joint.centre += p.point->area * p.point->position;
        joint.normal += p.point->area * p.normal;
        joint.slip += p.point->area * p.point->plastic_slip.norm();
    }
    joint.centre /= joint.area;
    joint.slip /= joint.area;
    joint.normal.normalize();
    joint.pressure_centre.setZero();
    for (const JointPoint& p : points) {
        joint.force += p.force;
        joint.moment += (p.point->position - joint.centre).cross(p.force);
        joint.normal_force += p.point->normal_force;
        joint.pressure_centre += p.point->normal_force * p.point->position;
        if (p.point->status != ContactStatus::open) joint.closed_area += p.point->area;
        joint.max_opening = std::max(joint.max_opening, p.point->gap);
    }
    joint.pressure_centre =
        joint.normal_force > 0 ? Vector3d(joint.pressure_centre / joint.normal_force) : joint.centre;
    return joint;
}

}  // namespace

std::vector<JointResultant> joint_resultants(const Model& model, const State& state)
{
    static_cast<void>(model);
    std::map<std::pair<int, int>, std::vector<JointPoint>> joints;
    for (const ContactPatch& patch : state.patches) {
        // The patch's forces act on its block a; ours on the block with the lower index.
        const double sign = patch.block_a < patch.block_b ? 1 : -1;
        auto& points = joints[{std::min(patch.block_a, patch.block_b), std::max(patch.block_a, patch.block_b)}];
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPoint& point = state.contact_points[i];
            const Vector3d force = point.normal_force * patch.normal - point.shear_force;
            points.push_back({&point, sign * patch.normal, sign * force});
        }
    }
    std::vector<JointResultant> result;
    for (const auto& [pair, points] : joints) result.push_back(resultant(pair.first, pair.second, points));
    return result;
}

}  // namespace voussoir
