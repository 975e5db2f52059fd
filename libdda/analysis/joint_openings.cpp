#include "libdda/analysis/joint_openings.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <map>

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

/// The material point of a block that is now at `place`.
MaterialPoint point_at(const Pose& pose, int block, const Vector3d& place)
{
    return {block, pose.map.inverse() * (place - pose.centroid)};
}

template <int D>
void collect(const Model& model, const State& state, std::map<std::pair<int, int>, WatchedJoint>& joints)
{
    const ContactSetIn<D>& contacts = contacts_in<D>(state);
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const Pose a = pose_of(model.kinematics, state, patch.block_a);
        const Pose b = pose_of(model.kinematics, state, patch.block_b);
        const auto [first, second] = std::minmax(patch.block_a, patch.block_b);
        WatchedJoint& joint = joints[{first, second}];
        joint.block_a = first;
        joint.block_b = second;
        const Vector3d normal = to_space(patch.normal);
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts.points[i];
            const Vector3d place = to_space(point.position);
            joint.corners.push_back({point_at(a, patch.block_a, place),
                                     point_at(b, patch.block_b, place - point.gap * normal),
                                     (b.map.inverse() * normal).normalized()});
        }
    }
}

Vector3d place_of(const Pose& pose, const MaterialPoint& point)
{
    return pose.centroid + pose.map * point.lever;
}

}  // namespace

std::vector<WatchedJoint> joints_of(const Model& model, const State& state)
{
    std::map<std::pair<int, int>, WatchedJoint> joints;
    if (is_planar(model.kinematics))
        collect<2>(model, state, joints);
    else
        collect<3>(model, state, joints);
    std::vector<WatchedJoint> result;
    result.reserve(joints.size());
    for (auto& [pair, joint] : joints) result.push_back(std::move(joint));
    return result;
}

double opening_of(const WatchedJoint& joint, const Model& model, const State& state)
{
    const Pose first = pose_of(model.kinematics, state, joint.block_a);
    const Pose second = pose_of(model.kinematics, state, joint.block_b);
    double opening = -std::numeric_limits<double>::infinity();
    for (const JointCorner& corner : joint.corners) {
        const Pose& a = corner.on_a.block == joint.block_a ? first : second;
        const Pose& b = corner.on_b.block == joint.block_a ? first : second;
        const Vector3d normal = (b.map * corner.normal).normalized();
        opening = std::max(opening, normal.dot(place_of(a, corner.on_a) - place_of(b, corner.on_b)));
    }
    return opening;
}

}  // namespace voussoir
