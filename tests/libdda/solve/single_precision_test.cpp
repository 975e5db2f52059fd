// Blocks in single precision: what their products are, and that a large scene's iteration does not notice.
#include "libdda/solve/single_precision.h"

#include <gtest/gtest.h>

#include "libdda/solve/conjugate_gradients.h"
#include "tests/libdda/solve/lattice.h"

namespace voussoir::testing
{

namespace
{

template <class K>
class SinglePrecision : public ::testing::Test
{
};
using All =
    ::testing::Types<step::SpatialDeformable, step::SpatialRigid, step::PlanarDeformable, step::PlanarRigid>;
TYPED_TEST_SUITE(SinglePrecision, All);

/// Iterations of conjugate gradients with all that preconditions them.
template <class K>
int iterations(const Lattice<K>& lattice, VectorXd& x)
{
    const auto solver = solve::make_conjugate_gradient_solver(1e-9);
    solver->place(lattice.places);
    const solve::LinearReport report =
        solver->solve(lattice.matrix, numbers(K::unknowns * lattice.matrix.rows()), x);
    EXPECT_TRUE(report.solved);
    return report.iterations;
}

}  // namespace

TYPED_TEST(SinglePrecision, ProductsAreThoseOfDoublesToSixDigits)
{
    constexpr int n = TypeParam::unknowns;
    using Single = solve::SinglePrecision<n>;
    const VectorXd values = numbers(3 * n * n), x = numbers(n);
    std::vector<float> blocks;
    Single::resize(3, blocks);
    for (int i = 0; i < 3; ++i)
        Single::put(Eigen::Map<const typename TypeParam::Square>(values.data() + i * n * n), i, blocks);
    for (int i = 0; i < 3; ++i) {
        const VectorXd expected = Eigen::Map<const typename TypeParam::Square>(values.data() + i * n * n) * x;
        const auto product = Single::product(blocks, i, x.data());
        EXPECT_LT((product.template head<n>().matrix().template cast<double>() - expected).norm(),
                  1e-6 * expected.norm());
    }
}

// 1,023 rows are preconditioned in double precision and in one piece, 1,024 in single and in domains. Without
// ground nothing but its inertia holds the whole, a ten-thousandth to a million millionth of what the springs
// hold.
TYPED_TEST(SinglePrecision, CostsNoIterationsHoweverStiffTheJoints)
{
    for (const bool has_ground : {true, false})
        for (const double stiffness : {1e4, 1e8, 1e12}) {
            SCOPED_TRACE(::testing::PrintToString(has_ground) + ", " + std::to_string(stiffness));
            const Lattice<TypeParam> in_double(31, 33, stiffness, has_ground),
                in_single(32, 32, stiffness, has_ground);
            VectorXd x;
            const int expected = iterations(in_double, x);
            EXPECT_NEAR(iterations(in_single, x), expected, std::max(2.0, 0.15 * expected));
            VectorXd load;
            solve::multiply(in_single.matrix, x, load);
            const VectorXd b = numbers(load.size());
            // Beyond what is asked for, what rounding in double precision makes of the product: 50 eps of each
            // spring.
            EXPECT_LT((load - b).norm(), 1e-9 * b.norm() + 1e-14 * stiffness * x.norm());
        }
}

}  // namespace voussoir::testing
