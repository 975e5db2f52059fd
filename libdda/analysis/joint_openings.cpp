#include "libdda/analysis/joint_openings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "libdda/model/parallel.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

Eigen::Matrix3d cofactors(const Eigen::Matrix3d& map)
{
    Eigen::Matrix3d turn;
    turn << map.col(1).cross(map.col(2)), map.col(2).cross(map.col(0)), map.col(0).cross(map.col(1));
    return turn;
}

/// Mean of the normals of two faces that looked at each other, outward from b; that of b once both look the same
/// way.
Vector3d mean_normal(const FacingPatch& patch, const PlacedBlock& a, const PlacedBlock& b)
{
    const Vector3d of_a = (a.turn * patch.normal_a).normalized(), of_b = (b.turn * patch.normal_b).normalized();
    const Vector3d sum = of_b - of_a;
    const double length = sum.norm();
    constexpr double least = 1e-6;
    return length > least ? Vector3d(sum / length) : of_b;
}

}  // namespace

std::vector<PlacedBlock> placed_blocks(const Model& model, const State& state, int threads)
{
    std::vector<PlacedBlock> blocks(model.blocks.size());
    in_parallel(blocks.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t b = first; b < end; ++b) {
            const Pose pose = pose_of(model.kinematics, state, static_cast<int>(b));
            blocks[b] = {pose, is_deformable(model.kinematics) ? cofactors(pose.map) : pose.map};
        }
    });
    return blocks;
}

JointMotion motion_of(const WatchedJoint& joint, std::span<const PlacedBlock> blocks)
{
    const PlacedBlock &a = blocks[static_cast<std::size_t>(joint.block_a)],
                      &b = blocks[static_cast<std::size_t>(joint.block_b)];
    JointMotion motion;
    for (const FacingPatch& patch : joint.patches) {
        const Vector3d normal = mean_normal(patch, a, b);
        for (const FacingPoint& point : patch.points) {
            const Vector3d apart =
                a.pose.centroid - b.pose.centroid + a.pose.map * point.on_a - b.pose.map * point.on_b;
            const double along = normal.dot(apart);
            const double opening = along - point.start, slip = (apart - along * normal).norm();
            motion.opening = std::max(motion.opening, opening);
            motion.largest_slip = std::max(motion.largest_slip, slip);
            motion.mean_opening += point.area * opening;
            motion.slip += point.area * slip;
        }
    }
    motion.mean_opening /= joint.facing_area;
    motion.slip /= joint.facing_area;
    return motion;
}

JointMotion since(const JointMotion& rest, JointMotion now)
{
    now.opening = std::max(0.0, now.opening - rest.opening);
    now.mean_opening -= rest.mean_opening;  // negative where it is pressed
    now.slip = std::max(0.0, now.slip - rest.slip);
    now.largest_slip = std::max(0.0, now.largest_slip - rest.largest_slip);
    return now;
}

std::vector<JointPeaks> no_peaks(const std::vector<WatchedJoint>& joints)
{
    std::vector<JointPeaks> peaks;
    peaks.reserve(joints.size());
    for (const WatchedJoint& joint : joints) peaks.push_back({joint.block_a, joint.block_b, 0, 0, {}, {}});
    return peaks;
}

void count_from(const Model& model, const std::vector<double>& coordinates, std::vector<WatchedJoint>& joints)
{
    State rest;
    rest.coordinates = coordinates;
    const std::vector<PlacedBlock> blocks = placed_blocks(model, rest);
    for (WatchedJoint& joint : joints) joint.at_rest = motion_of(joint, blocks);
}

void note_joints(const Model& model, const std::vector<WatchedJoint>& joints, const State& state,
                 RunReport& report, int threads)
{
    if (joints.empty()) return;
    const std::vector<PlacedBlock> blocks = placed_blocks(model, state, threads);
    in_parallel(joints.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const JointMotion motion = since(joints[i].at_rest, motion_of(joints[i], blocks));
            JointPeaks& peaks = report.joints[i];
            peaks.opening = std::max(peaks.opening, motion.opening);
            peaks.slip = std::max(peaks.slip, motion.largest_slip);
            if (!peaks.opened && motion.opening > noteworthy_opening) peaks.opened = state.time;
            if (!peaks.slid && motion.largest_slip > noteworthy_opening) peaks.slid = state.time;
        }
    });
}

}  // namespace voussoir
