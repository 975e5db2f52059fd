// The shear force of a point that turns round within a step.
#include "libdda/forces/turning.h"

#include <gtest/gtest.h>

#include "tests/libdda/poses.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;
using step::SpatialRigid;

constexpr double h = 1e-3, stiffness = 1e8;

struct Joint {
    step::PatchStep<SpatialRigid> patch;
    step::PointStep<3> point;

    /// @param speed m/s; @param stretched m, by the spring at the start; @param bound N
    Joint(double speed, const Vector3d& stretched, double bound)
    {
        patch.normal = Vector3d::UnitZ();
        patch.h = h;
        patch.braking = 2e-3;
        point.heading = Vector3d::UnitX();
        point.speed = speed;
        point.slip_start = stretched;
        point.shear_stiffness = stiffness;
        point.lever.setZero();
        point.bound = bound;
    }
    /// As the step evaluates it: a joint that does not turn round slides on.
    Vector3d force(const Vector3d& move, double bound)
    {
        point.bound = bound;
        patch.displacement = {move, Eigen::Matrix3d::Zero()};
        if (point.heading.dot(move) < step::half_way(point, h)) {
            step::turn_round(move, patch, point);
        } else {
            const Vector3d trial = stiffness * (point.slip_start + move);
            point.shear = bound / trial.norm() * trial;
        }
        return point.shear;
    }
};

/// Joints whose spring is at the bound at the start of the step, below it, and far below it; slow and fast ones.
std::vector<Joint> joints()
{
    std::vector<Joint> all;
    for (const double speed : {2.5e-4, 1e-3, 6e-3})
        for (const Vector3d& stretched : {Vector3d(1e-6, 0, 0), Vector3d(4e-7, 9e-7, 0), Vector3d(2e-7, -1e-7, 0)})
            for (const double bound : {20.0, 110.0, 430.0}) all.emplace_back(speed, stretched, bound);
    return all;
}

}  // namespace

TEST(Turning, ForceIsContinuous)
{
    for (Joint& joint : joints()) {
        const double rest = step::half_way(joint.point, h), bound = joint.point.bound;
        // From sliding on, through sticking, to sliding back; the bound changes on the way, as N does.
        const int samples = 40000;
        Vector3d last = joint.force({2 * rest + 1e-6, 3e-7, 0}, bound);
        double jump = 0;
        for (int i = 1; i <= samples; ++i) {
            const double s = static_cast<double>(i) / samples;
            const Vector3d move(2 * rest + 1e-6 - s * (4 * rest + 6e-6), 3e-7 - 8e-7 * s, 0);
            const Vector3d now = joint.force(move, bound * (1 + 0.5 * s));
            jump = std::max(jump, (now - last).norm());
            last = now;
        }
        EXPECT_LT(jump, 0.01 * bound) << "speed " << joint.point.speed << ", bound " << bound << ", stretched "
                                      << joint.point.slip_start.transpose();
    }
}

TEST(Turning, ForceIsThatOfAJointThatSlidesOnWhereItJustComesToRest)
{
    for (Joint& joint : joints()) {
        const double rest = step::half_way(joint.point, h), bound = joint.point.bound;
        const Vector3d on = joint.force({rest * (1 + 1e-12), 2e-7, 0}, bound);
        const Vector3d back = joint.force({rest * (1 - 1e-12), 2e-7, 0}, bound);
        EXPECT_LT((on - back).norm(), 1e-6 * bound);
    }
}

TEST(Turning, ChangeIsThatOfTheForce)
{
    int checked = 0;
    Random random(5);
    for (Joint& joint : joints()) {
        const double rest = step::half_way(joint.point, h), bound = joint.point.bound;
        for (int trial = 0; trial < 40; ++trial) {
            Eigen::Vector2d at;
            random.fill(at, 1);
            const Vector3d move(rest + (at[0] - 1) * (rest + 2e-6), 1e-6 * at[1], 0);
            const double small = 1e-11;
            // Forces have kinks, where no change is defined: left and right differ there.
            const auto slope = [&](const Vector3d& direction) {
                const Vector3d here = joint.force(move, bound);
                const Vector3d more = (joint.force(move + small * direction, bound) - here) / small;
                const Vector3d less = (here - joint.force(move - small * direction, bound)) / small;
                return std::pair<Vector3d, bool>((more + less) / 2, (more - less).norm() < 1e-3 * stiffness);
            };
            const auto [along, smooth_along] = slope(Vector3d::UnitX());
            const auto [across, smooth_across] = slope(Vector3d::UnitY());
            const Vector3d by_bound =
                (joint.force(move, bound * (1 + 1e-6)) - joint.force(move, bound * (1 - 1e-6))) / (2e-6 * bound);
            joint.force(move, bound);
            if (!joint.point.turns_round || !smooth_along || !smooth_across) continue;
            const step::TurningChange<SpatialRigid> change(joint.patch, joint.point);
            EXPECT_LT((change.by_move.col(0) - along).norm(), 2e-3 * stiffness);
            EXPECT_LT((change.by_move.col(1) - across).norm(), 2e-3 * stiffness);
            EXPECT_LT((change.by_bound - by_bound).norm(), 2e-3);
            ++checked;
        }
    }
    EXPECT_GT(checked, 700);
}

}  // namespace voussoir::testing
