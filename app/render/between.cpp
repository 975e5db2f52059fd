#include "app/render/between.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>

namespace voussoir::app::render
{

namespace
{

using Values = Eigen::Map<Eigen::VectorXd>;
using ConstValues = Eigen::Map<const Eigen::VectorXd>;

double mixed(double a, double b, double share)
{
    return a + share * (b - a);
}

template <int D>
struct Parts {
    Eigen::Matrix<double, D, D> turn, stretch;  // map = turn * stretch
};

template <int D>
Parts<D> polar(const Eigen::Matrix<double, D, D>& map)
{
    const Eigen::JacobiSVD<Eigen::Matrix<double, D, D>> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.matrixU() * svd.matrixV().transpose(),
            svd.matrixV() * svd.singularValues().asDiagonal() * svd.matrixV().transpose()};
}

Eigen::Matrix3d turned(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b, double share)
{
    return Eigen::Quaterniond(a).slerp(share, Eigen::Quaterniond(b)).toRotationMatrix();
}

Eigen::Matrix2d turned(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b, double share)
{
    return a * Eigen::Rotation2Dd(share * Eigen::Rotation2Dd(a.transpose() * b).smallestAngle());
}

/// Maps that hardly differ are mixed as they are: a chord instead of an arc, wrong by the square of the angle.
template <int D>
void mix_maps(const double* a, const double* b, double share, double* out)
{
    using Map = Eigen::Matrix<double, D, D>;
    const Eigen::Map<const Map> from(a), to(b);
    Eigen::Map<Map> result(out);
    constexpr double hardly = 1e-3;
    if ((to - from).norm() < hardly) {
        result = from + share * (to - from);
        return;
    }
    const Parts<D> first = polar<D>(from), last = polar<D>(to);
    result =
        turned(first.turn, last.turn, share) * (first.stretch + share * (last.stretch - first.stretch)).eval();
}

void mix_quaternions(const double* a, const double* b, double share, double* out)
{
    const Eigen::Quaterniond from(a[0], a[1], a[2], a[3]), to(b[0], b[1], b[2], b[3]);
    const Eigen::Quaterniond result = from.slerp(share, to);
    out[0] = result.w();
    out[1] = result.x();
    out[2] = result.y();
    out[3] = result.z();
}

/// Of one block.
void mix_coordinates(Kinematics kinematics, const double* a, const double* b, double share, double* out)
{
    const int dimension = is_planar(kinematics) ? 2 : 3, count = coordinates_per_block(kinematics);
    Values(out, count) = ConstValues(a, count) + share * (ConstValues(b, count) - ConstValues(a, count));
    if (kinematics == Kinematics::spatial_rigid) mix_quaternions(a + 3, b + 3, share, out + 3);
    if (!is_deformable(kinematics)) return;
    if (dimension == 2)
        mix_maps<2>(a + 2, b + 2, share, out + 2);
    else
        mix_maps<3>(a + 3, b + 3, share, out + 3);
}

void mix(const JointNow& other, double share, JointNow& joint)
{
    joint.motion.opening = mixed(joint.motion.opening, other.motion.opening, share);
    joint.motion.mean_opening = mixed(joint.motion.mean_opening, other.motion.mean_opening, share);
    joint.motion.slip = mixed(joint.motion.slip, other.motion.slip, share);
    joint.motion.largest_slip = mixed(joint.motion.largest_slip, other.motion.largest_slip, share);
    joint.normal_force = mixed(joint.normal_force, other.normal_force, share);
    joint.shear_force = mixed(joint.shear_force, other.shear_force, share);
    joint.area_in_use = mixed(joint.area_in_use, other.area_in_use, share);
}

}  // namespace

results::RecordedFrame between(Kinematics kinematics, const results::RecordedFrame& before,
                               const results::RecordedFrame& after, double time)
{
    if (after.time <= before.time) return before;
    const double share = std::clamp((time - before.time) / (after.time - before.time), 0.0, 1.0);
    results::RecordedFrame frame = before;
    if (after.in_motion) results::begin_motion(frame);
    frame.time = frame.state.time = time;
    frame.ground = before.ground + share * (after.ground - before.ground);
    const auto count = static_cast<std::size_t>(coordinates_per_block(kinematics));
    for (std::size_t i = 0; i < frame.state.coordinates.size(); i += count)
        mix_coordinates(kinematics, before.state.coordinates.data() + i, after.state.coordinates.data() + i, share,
                        frame.state.coordinates.data() + i);
    for (std::size_t i = 0; i < frame.state.velocities.size(); ++i)
        frame.state.velocities[i] = mixed(before.state.velocities[i], after.state.velocities[i], share);
    for (std::size_t i = 0; i < frame.stresses.size(); ++i)
        frame.stresses[i] += share * (after.stresses[i] - before.stresses[i]);
    for (std::size_t i = 0; i < frame.joints.size(); ++i) mix(after.joints[i], share, frame.joints[i]);
    return frame;
}

}  // namespace voussoir::app::render
