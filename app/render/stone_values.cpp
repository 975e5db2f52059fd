#include "app/render/stone_values.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/results/friction_use.h"

namespace voussoir::app::render
{

namespace
{

/// Of one block, of the quantities that belong to blocks themselves.
double value_of(const results::RecordedModel& model, const results::RecordedFrame& frame, SnapshotColor color,
                std::size_t block)
{
    switch (color) {
        case SnapshotColor::principal_stress:
            return largest_compression(frame.stresses[block]);
        case SnapshotColor::principal_strain:
            return largest_compression(strain_of(model, frame, static_cast<int>(block)));
        case SnapshotColor::velocity:
            return velocity_of(model.kinematics, frame.state, static_cast<int>(block)).norm();
        case SnapshotColor::friction:
            return std::numeric_limits<double>::quiet_NaN();
        case SnapshotColor::displacement:
        case SnapshotColor::opening:
        case SnapshotColor::slip:
        case SnapshotColor::group:
            break;
    }
    return 0;
}

/// Of one joint, of the quantities that belong to joints; NaN when it has none.
double value_of(const results::RecordedModel& model, const results::RecordedFrame& frame, SnapshotColor color,
                const WatchedJoint& joint, std::size_t index)
{
    const JointNow& now = frame.joints[index];
    if (color == SnapshotColor::opening) return now.motion.opening;
    if (color == SnapshotColor::slip) return now.motion.largest_slip;
    return results::friction_use(model.bounds[index], joint.bonded, now)
        .value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

std::vector<double> stone_values(const results::RecordedModel& model, const results::RecordedFrame& frame,
                                 SnapshotColor color, const LookOfRun& look)
{
    if (!look.group_names.empty()) return {look.group.begin(), look.group.end()};
    std::vector<double> values(model.block_names.size());
    for (std::size_t b = 0; b < values.size(); ++b) values[b] = value_of(model, frame, color, b);
    if (color != SnapshotColor::opening && color != SnapshotColor::slip && color != SnapshotColor::friction)
        return values;
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
        const WatchedJoint& joint = model.joints[i];
        const double value = value_of(model, frame, color, joint, i);
        for (const int block : {joint.block_a, joint.block_b}) {
            double& largest = values[static_cast<std::size_t>(block)];
            if (!std::isnan(value)) largest = std::isnan(largest) ? value : std::max(largest, value);
        }
    }
    return values;
}

double largest_compression(const Eigen::Matrix3d& tensor)
{
    return -Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

Eigen::Matrix3d strain_of(const results::RecordedModel& model, const results::RecordedFrame& frame, int block)
{
    if (!is_deformable(model.kinematics)) return Eigen::Matrix3d::Zero();
    const Eigen::Matrix3d map = pose_of(model.kinematics, frame.state, block).map;
    return 0.5 * (map.transpose() * map - Eigen::Matrix3d::Identity());
}

}  // namespace voussoir::app::render
