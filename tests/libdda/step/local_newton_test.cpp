// Few stones out of balance among many: what is done among them leaves everything known, and the others where they
// are.
#include "libdda/step/local_newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libdda/step/newton.h"
#include "libdda/step/unbalance.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

constexpr double tolerance = 1e-6;  // of a stone's load

// Less than what would change the state of a contact: elastic stones have stiffer joints [m].
template <class K>
constexpr double slightly = K::deformable ? 1e-11 : 1e-9;

/// A wall under its weight in the first step of a motion, in equilibrium but for some stones that were moved.
template <class K>
class DisturbedWall
{
 public:
    DisturbedWall(int courses, int stones, double moved)
        : model_(running_bond(K::kinematics, courses, stones)), stage_(dynamic_stage(1, 2e-3))
    {
        stage_.control.force_tolerance = 1e-3 * tolerance;
        State state = initial_state(model_);
        StepReport report;
        contact::SearchMemory<K::dimension> search;
        contact::find_contacts(model_, state, std::vector<double>(model_.blocks.size(), 0.05), 1, search,
                               contacts_, contact::NewOverlap::presses);
        step::assemble_blocks<K>(model_, stage_, state, contacts_, stage_.control.time_step, {}, system);
        EXPECT_TRUE(step::iterate_newton(model_, stage_, contacts_, system, report));
        // One in three hundred, along the wall and down.
        for (std::size_t row = 150; row < system.block_of_row.size(); row += 300) {
            system.d[K::unknowns * row] += moved;
            system.d[K::unknowns * row + K::dimension - 1] -= moved;
        }
        evaluate();
    }

    void evaluate()
    {
        step::evaluate_contacts(system.d, step::FrictionBound::exact, 1, system.contacts);
        step::evaluate_residual(system.d, system);
    }

    double worst() const { return step::unbalance(system, tolerance).worst; }

    step::StepSystem<K> system;

 private:
    Model model_;
    Stage stage_;
    ContactSetIn<K::dimension> contacts_;
};

}  // namespace

template <class K>
class LocalNewton : public ::testing::Test
{
};

using AllKinematics =
    ::testing::Types<step::RigidIn<2>, step::RigidIn<3>, step::DeformableIn<2>, step::DeformableIn<3>>;
TYPED_TEST_SUITE(LocalNewton, AllKinematics);

TYPED_TEST(LocalNewton, BringsFewStonesOfManyIntoBalance)
{
    DisturbedWall<TypeParam> wall(24, 46, slightly<TypeParam>);
    const double before = wall.worst();
    ASSERT_GT(before, 100);
    ASSERT_TRUE(wall.system.local.improve(tolerance, wall.system));
    EXPECT_LT(wall.worst(), 0.05 * before);
}

TYPED_TEST(LocalNewton, LeavesContactsAndResidualAsTheyAreThere)
{
    DisturbedWall<TypeParam> wall(24, 46, slightly<TypeParam>);
    ASSERT_TRUE(wall.system.local.improve(tolerance, wall.system));
    const Eigen::VectorXd residual = wall.system.residual;
    const std::vector<double> load = wall.system.load;
    wall.evaluate();
    const double scale = *std::max_element(load.begin(), load.end());
    EXPECT_LT((residual - wall.system.residual).cwiseAbs().maxCoeff(), 1e-9 * scale) << "N";
    for (std::size_t row = 0; row < load.size(); ++row)
        EXPECT_NEAR(load[row], wall.system.load[row], 1e-9 * scale);
}

TYPED_TEST(LocalNewton, MovesNoStonesFarFromThoseOutOfBalance)
{
    DisturbedWall<TypeParam> wall(24, 46, slightly<TypeParam>);
    const Eigen::VectorXd before = wall.system.d;
    ASSERT_TRUE(wall.system.local.improve(tolerance, wall.system));
    int still = 0;
    for (std::size_t row = 0; row < wall.system.block_of_row.size(); ++row) {
        constexpr int n = TypeParam::unknowns;
        if ((wall.system.d - before).segment(n * row, n).isZero(0)) ++still;
    }
    EXPECT_GT(still, 200);
    EXPECT_LT(still, 1100);
}

TYPED_TEST(LocalNewton, LeavesAlone)
{
    // A wall that is not large.
    DisturbedWall<TypeParam> small(8, 12, slightly<TypeParam>);
    const Eigen::VectorXd of_small = small.system.d;
    EXPECT_FALSE(small.system.local.improve(tolerance, small.system));
    EXPECT_EQ(small.system.d, of_small);
    // One that is in balance.
    DisturbedWall<TypeParam> still(24, 46, 0);
    const Eigen::VectorXd of_still = still.system.d;
    ASSERT_LT(still.worst(), 0.3);
    EXPECT_FALSE(still.system.local.improve(tolerance, still.system));
    EXPECT_EQ(still.system.d, of_still);
    // One of which more than a twentieth is out of balance.
    DisturbedWall<TypeParam> loose(24, 46, 0);
    loose.system.d.setZero();
    loose.evaluate();
    const Eigen::VectorXd of_loose = loose.system.d;
    EXPECT_FALSE(loose.system.local.improve(tolerance, loose.system));
    EXPECT_EQ(loose.system.d, of_loose);
}

// Stones that were moved so far that their joints slide are not where a whole step leads to; it is taken back.
TYPED_TEST(LocalNewton, TakesBackWhatLeavesMoreThanThereWas)
{
    DisturbedWall<TypeParam> wall(24, 46, 1e-7);
    const Eigen::VectorXd before = wall.system.d, residual = wall.system.residual;
    EXPECT_FALSE(wall.system.local.improve(tolerance, wall.system));
    EXPECT_EQ(wall.system.d, before);
    EXPECT_EQ(wall.system.residual, residual);
}

// What inverts a block leaves no number behind that is none.
TYPED_TEST(LocalNewton, TakesBackWhatIsNoNumber)
{
    DisturbedWall<TypeParam> wall(24, 46, slightly<TypeParam>);
    const Eigen::VectorXd before = wall.system.d;
    // Nothing but this says how far a step goes.
    for (auto& block : wall.system.blocks) block.base *= 1e-30;
    for (auto& point : wall.system.contacts.points) point.normal_tangent = point.shear_stiffness = 0;
    EXPECT_FALSE(wall.system.local.improve(tolerance, wall.system));
    EXPECT_EQ(wall.system.d, before);
    EXPECT_TRUE(wall.system.residual.allFinite());
}

}  // namespace voussoir::testing
