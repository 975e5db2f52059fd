// How a cluster moves its blocks: along the unknowns of one body, and its transpose.
#include "libdda/solve/cluster_shapes.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "libdda/block/kinematics_traits.h"
#include "tests/libdda/solve/lattice.h"

namespace voussoir::testing
{

namespace
{

template <class K>
class ClusterShapes : public ::testing::Test
{
 public:
    static constexpr int D = K::dimension, n = K::unknowns;
    using Shape = std::conditional_t<K::deformable, solve::AffineShape<D>, solve::RigidShape<D>>;
    using Segment = Eigen::Matrix<double, n, 1>;
    using Square = Eigen::Matrix<double, n, n>;

    Random random = Random(11);

    typename K::Vector lever()
    {
        typename K::Vector y;
        random.fill(y, 2);
        return y;
    }
    Segment segment()
    {
        Segment c;
        random.fill(c, 1);
        return c;
    }
    Square square()
    {
        Square b;
        for (int k = 0; k < n; ++k) b.col(k) = segment();
        return b;
    }
};
using All =
    ::testing::Types<step::SpatialDeformable, step::SpatialRigid, step::PlanarDeformable, step::PlanarRigid>;
TYPED_TEST_SUITE(ClusterShapes, All);

}  // namespace

TYPED_TEST(ClusterShapes, BlocksMoveAsPointsOfOneBody)
{
    using Test = ClusterShapes<TypeParam>;
    for (int trial = 0; trial < 10; ++trial) {
        const auto y = this->lever();
        const typename Test::Segment motion = this->segment();
        typename Test::Segment expected = motion, moved = motion, moved_quickly = motion;
        expected.template head<Test::D>() = TypeParam::displacement(motion, y);
        Test::Shape::spread(y, moved);
        Test::Shape::spread_quickly(y, moved_quickly);
        EXPECT_LT((moved - expected).norm(), 1e-14);
        EXPECT_LT((moved_quickly - expected).norm(), 1e-14);
    }
}

// f . P c = P^T f . c, and B P c is B times P c.
TYPED_TEST(ClusterShapes, LoadsAreGatheredByTheTranspose)
{
    using Test = ClusterShapes<TypeParam>;
    for (int trial = 0; trial < 10; ++trial) {
        const auto y = this->lever();
        const typename Test::Segment motion = this->segment(), force = this->segment();
        typename Test::Segment moved = motion, load = force, load_quickly = force;
        Test::Shape::spread(y, moved);
        Test::Shape::left(y, load);
        Test::Shape::left_quickly(y, load_quickly);
        EXPECT_NEAR(load.dot(motion), force.dot(moved), 1e-13);
        EXPECT_LT((load_quickly - load).norm(), 1e-14);

        const typename Test::Square block = this->square();
        typename Test::Square times_p = block, p_times = block;
        Test::Shape::right(y, times_p);
        Test::Shape::left(y, p_times);
        EXPECT_LT((times_p * motion - block * moved).norm(), 1e-13);
        EXPECT_NEAR(motion.dot(p_times * force), moved.dot(block * force), 1e-13);
    }
}

}  // namespace voussoir::testing
