// Mosca's bridge under its own weight: statics of the half arch, limit analysis, independence of the static step.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/studies/verify/references/thrust_line.h"
#include "libdda/analysis/joint_resultants.h"
#include "tests/verification/bridge_model.h"

namespace voussoir::verification
{

namespace
{

using app::studies::verify::references::HalfArchJoint;
using app::studies::verify::references::thrust_range;
using app::studies::verify::references::ThrustRange;
using Eigen::Vector3d;
using testing::gravity;

struct Solved {
    Model model;
    State state;
    RunReport report;
    std::vector<JointResultant> joints;  // joints[i] between stones i and i + 1 in the order of the arch
};

/// The stones in the order of the arch: abutment_left, voussoir_01 ... voussoir_93, abutment_right.
std::vector<int> order_of_arch(const Model& model)
{
    std::vector<int> order(model.blocks.size());
    for (std::size_t b = 0; b < order.size(); ++b) order[b] = static_cast<int>(b);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return model.blocks[a].moments.centroid.x() < model.blocks[b].moments.centroid.x();
    });
    return order;
}

Solved solve_self_weight(double static_step)
{
    Solved solved{bridge_model({}), {}, {}, {}};
    solved.state = initial_state(solved.model);
    solved.report = testing::run_quietly(solved.model, {testing::static_stage(static_step)}, solved.state);
    const std::vector<int> order = order_of_arch(solved.model);
    const std::vector<JointResultant> all = joint_resultants(solved.model, solved.state);
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const auto joint = std::find_if(all.begin(), all.end(), [&](const JointResultant& j) {
            return std::minmax(j.block_a, j.block_b) == std::minmax(order[i], order[i + 1]);
        });
        if (joint != all.end()) solved.joints.push_back(*joint);
    }
    return solved;
}

/// Force and moment about the origin that the joint exerts on `block`.
void add_joint(const JointResultant& joint, int block, Vector3d& force, Vector3d& moment)
{
    const double sign = joint.block_a == block ? 1 : -1;
    force += sign * joint.force;
    moment += sign * (joint.moment + joint.centre.cross(joint.force));
}

double thrust(const Solved& solved)
{
    return std::abs(solved.joints[46].force.x());
}

/// Joints of the left half mirrored to x >= 0, from the crown to the springing, with the weight they carry.
std::vector<HalfArchJoint> half_arch(const Model& model)
{
    const std::vector<int> order = order_of_arch(model);
    std::vector<HalfArchJoint> joints;
    // Half the keystone is a trapezoid of half widths a (intrados) and b (extrados): its centre of gravity lies at
    // (a^2 + a b + b^2) / (3 (a + b)) from the axis.
    const std::vector<Vector3d>& key = model.blocks[order[47]].parts[0].vertices;
    const auto lower = [](const Vector3d& p, const Vector3d& q) { return p.z() < q.z(); };
    const double a = std::abs(std::min_element(key.begin(), key.end(), lower)->x());
    const double b = std::abs(std::max_element(key.begin(), key.end(), lower)->x());
    double weight = 0.5 * model.mass(order[47]) * testing::gravity;
    double first_moment = weight * (a * a + a * b + b * b) / (3 * (a + b));
    for (int i = 46; i >= 1; --i) {
        const Block& stone = model.blocks[order[i]];
        const Block& inner = model.blocks[order[i + 1]];
        // Corners that the stone shares with its neighbour towards the crown.
        HalfArchJoint joint;
        double low = INFINITY, high = -INFINITY;
        for (const Vector3d& x : stone.parts[0].vertices)
            for (const Vector3d& y : inner.parts[0].vertices) {
                const Vector3d p = x + stone.moments.centroid;
                if ((p - y - inner.moments.centroid).norm() > 1e-9) continue;
                if (p.z() < low) joint.intrados = {-p.x(), p.z()}, low = p.z();
                if (p.z() > high) joint.extrados = {-p.x(), p.z()}, high = p.z();
            }
        joint.weight = weight;
        joint.weight_arm = first_moment / weight;
        joints.push_back(joint);
        weight += model.mass(order[i]) * testing::gravity;
        first_moment -= model.mass(order[i]) * testing::gravity * stone.moments.centroid.x();
    }
    return joints;
}

}  // namespace

TEST(BridgeStatics, EveryJointOfTheHalfArchIsInEquilibrium)
{
    const Solved solved = solve_self_weight(1);
    ASSERT_EQ(solved.report.outcome, Outcome::completed) << ::testing::PrintToString(solved.report.diagnosis);
    ASSERT_EQ(solved.joints.size(), 94U);
    const std::vector<int> order = order_of_arch(solved.model);
    double arch_weight = 0, worst = 0;
    for (std::size_t i = 1; i + 1 < order.size(); ++i)
        arch_weight += solved.model.mass(order[i]) * testing::gravity;

    // From the crown joint outwards: crown joint, weights, joint i.
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    add_joint(solved.joints[46], order[46], force, moment);
    for (int i = 46; i >= 1; --i) {
        const Vector3d weight(0, 0, -solved.model.mass(order[i]) * testing::gravity);
        force += weight;
        moment += testing::centroid(solved.model, solved.state, order[i]).cross(weight);
        Vector3d whole_force = force, whole_moment = moment;
        add_joint(solved.joints[i - 1], order[i], whole_force, whole_moment);
        worst = std::max({worst, whole_force.norm() / arch_weight, whole_moment.norm() / (arch_weight * 45)});
    }
    Vector3d reactions = Vector3d::Zero(), unused = Vector3d::Zero();
    add_joint(solved.joints.front(), order[1], reactions, unused);
    add_joint(solved.joints.back(), order[93], reactions, unused);
    const double reaction_error = std::abs(reactions.z() / arch_weight - 1);
    std::printf("self-weight: worst of the three equations over 46 joints %.1e, reactions against weight %.1e\n",
                worst, reaction_error);
    EXPECT_LT(worst, 1e-6);
    EXPECT_LT(reaction_error, 1e-6);
    EXPECT_LT(std::hypot(reactions.x(), reactions.y()) / arch_weight, 1e-6);
}

TEST(BridgeStatics, ThrustDoesNotDependOnTheStaticStepAndLiesInTheRangeOfLimitAnalysis)
{
    const Solved coarse = solve_self_weight(1), fine = solve_self_weight(0.1);
    ASSERT_EQ(coarse.report.outcome, Outcome::completed);
    ASSERT_EQ(fine.report.outcome, Outcome::completed);
    const ThrustRange range = thrust_range(half_arch(coarse.model));
    const double width = 12;
    std::printf(
        "crown thrust per metre: %.6f MN (1 s), %.6f MN (0.1 s); limit analysis %.4f to %.4f MN; q L^2 / 8 f with "
        "the mean weight %.2f MN\n",
        thrust(coarse) / width / 1e6, thrust(fine) / width / 1e6, range.least / width / 1e6,
        range.greatest / width / 1e6, 1.75 * 2400 * testing::gravity * 45 * 45 / (8 * 5.5) / 1e6);
    // Joints that close late remember less shear, those that slide in part the way they went: with friction of 30
    // to 80 degrees and steps of 3 to 0.05 s the thrust is the same within 6e-4, and rounding decides what of it
    // is had.
    EXPECT_NEAR(thrust(fine) / thrust(coarse), 1, 1e-3);
    ASSERT_TRUE(range.exists);
    EXPECT_GT(thrust(coarse), range.least);
    EXPECT_LT(thrust(coarse), range.greatest);
}

TEST(BridgeStatics, LineOfThrustLiesInsideEveryJoint)
{
    const Solved solved = solve_self_weight(1);
    for (const JointResultant& joint : solved.joints) {
        // Extent of the joint along its radial direction, from its contact points.
        const Vector3d radial = Vector3d::UnitY().cross(joint.normal).normalized();
        double low = INFINITY, high = -INFINITY;
        for (const ContactPatch& patch : solved.state.contacts.patches) {
            if (std::minmax(patch.block_a, patch.block_b) != std::minmax(joint.block_a, joint.block_b)) continue;
            for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
                const double s = radial.dot(solved.state.contacts.points[i].position - joint.centre);
                low = std::min(low, s);
                high = std::max(high, s);
            }
        }
        // The pressure centre, and where the whole resultant (force and moment) cuts the joint plane through the
        // joint's centre. At a hinge the centre stands off by half the opening: the two differ by shear / normal
        // force times that.
        const double s = radial.dot(joint.pressure_centre - joint.centre);
        const double cut = radial.dot(joint.normal.cross(joint.moment)) / joint.normal.dot(joint.force);
        EXPECT_GE(s, low - 1e-12);
        EXPECT_LE(s, high + 1e-12);
        EXPECT_GT(high - low, 1.4);
        EXPECT_NEAR(cut, s, joint.widest_gap + 1e-5);
    }
}

}  // namespace voussoir::verification
