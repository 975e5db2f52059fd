// One block: its mass, its momentum.
#include "libdda/block/block_step.h"

#include <gtest/gtest.h>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

template <class K>
class BlockStepping : public ::testing::Test
{
};
using AllKinematics = ::testing::Types<step::SpatialDeformable, step::SpatialRigid>;
TYPED_TEST_SUITE(BlockStepping, AllKinematics);

/// Kinetic energy of a box whose points move at T(y) V, by two Gauss points an axis: exact for quadratics.
template <class K>
double energy_of_points(const Vector3d& size, double density, const Matrix3d& map,
                        const typename K::Unknowns& rates)
{
    double sum = 0;
    const double at = 0.5 / std::sqrt(3);
    for (const double x : {-at, at})
        for (const double y : {-at, at})
            for (const double z : {-at, at}) {
                const Vector3d lever = map * size.cwiseProduct(Vector3d(x, y, z));
                sum += K::displacement(rates, lever).squaredNorm() / 8;
            }
    return 0.5 * density * size.prod() * sum;
}

}  // namespace

TYPED_TEST(BlockStepping, MassMatrixIsTheKineticEnergyOfThePoints)
{
    Random random(4);
    for (int trial = 0; trial < 20; ++trial) {
        const Vector3d size(random.between(0.1, 2), random.between(0.1, 2), random.between(0.1, 2));
        Model model = make_model(TypeParam::kinematics, stone(), dry(30));
        add_box(model, "box", {3, 4, 5}, Vector3d(3, 4, 5) + size);
        State state = initial_state(model);
        Matrix3d map = random.rotation();
        set_pose(model, state, 0, {7, 8, 9}, map);
        step::BlockStep<TypeParam> block;
        const double h = 0.01;
        step::begin_block(model, dynamic_stage(1, h), state, 0, h, h, block);
        typename TypeParam::Unknowns rates;
        random.fill(rates, 1);
        const double quadratic = 0.5 * rates.dot(h * h / 2 * block.inertia * rates);
        const double points = energy_of_points<TypeParam>(size, stone().density, map, rates);
        EXPECT_NEAR(quadratic, points, 1e-12 * points);
    }
}

// T(y)^T f does the work f . T(y) D, and T(y)^T C T(y) is its stiffness.
TYPED_TEST(BlockStepping, ForcesAreConjugateToTheUnknowns)
{
    Random random(5);
    typename TypeParam::Unknowns d, forces = TypeParam::Unknowns::Zero(), other;
    random.fill(d, 1);
    random.fill(other, 1);
    const Vector3d ya = random.vector(), yb = random.vector(), f = random.vector();
    TypeParam::add_force(forces, ya, f);
    EXPECT_NEAR(forces.dot(d), f.dot(TypeParam::displacement(d, ya)), 1e-14);
    EXPECT_LT((TypeParam::moment_of(forces) - ya.cross(f)).norm(), 1e-14);
    Matrix3d c;
    for (int k = 0; k < 9; ++k) c.data()[k] = random.between(-1, 1);
    typename TypeParam::Square stiffness = TypeParam::Square::Zero();
    TypeParam::add_stiffness(stiffness, ya, yb, c);
    const double work = TypeParam::displacement(d, ya).dot(c * TypeParam::displacement(other, yb));
    EXPECT_NEAR(d.dot(stiffness * other), work, 1e-13);
}

// Whatever the unknowns, the update keeps linear momentum m v + (2 m / h) u and angular momentum H + h moment.
TYPED_TEST(BlockStepping, UpdateKeepsTheMomentum)
{
    Random random(6);
    for (int trial = 0; trial < 20; ++trial) {
        Model model = make_model(TypeParam::kinematics, stone(), dry(30));
        add_box(model, "box", {-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2});
        State state = initial_state(model);
        Matrix3d map = random.rotation();
        if (TypeParam::deformable) map = map * Vector3d(1.01, 0.99, 1.02).asDiagonal();
        set_pose(model, state, 0, random.vector(10), map);
        const Vector3d velocity = random.vector(5);
        set_velocity(model, state, 0, velocity, random.vector(10));
        const Vector3d before = angular_momentum(model, state, 0), place = centroid(model, state, 0);
        const double h = 0.01;
        step::BlockStep<TypeParam> block;
        step::begin_block(model, dynamic_stage(1, h), state, 0, h, h, block);
        typename TypeParam::Unknowns d;
        random.fill(d, 1e-2);
        const Vector3d moment = random.vector(1e3);
        step::update_block(block, d, moment, h, 0, state);
        const Vector3d after = angular_momentum(model, state, 0), expected = before + h * moment;
        EXPECT_LT((after - expected).norm(), 1e-13 * (before.norm() + expected.norm()));
        const Vector3d u = d.template head<3>();
        EXPECT_LT((velocity_of(model.kinematics, state, 0) - velocity - 2 / h * u).norm(), 1e-13);
        EXPECT_LT((centroid(model, state, 0) - place - h * velocity - u).norm(), 1e-13);
    }
}

// A free step of a strained, spinning block keeps its angular momentum, and its shape but for the vibration.
TYPED_TEST(BlockStepping, PredictionCarriesTheMomentum)
{
    Random random(7);
    Model model = make_model(TypeParam::kinematics, stone(), dry(30));
    add_box(model, "box", {-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2});
    State state = initial_state(model);
    set_pose(model, state, 0, {0, 0, 0}, random.rotation());
    set_velocity(model, state, 0, {1, 2, 3}, {4, -5, 6});
    step::BlockStep<TypeParam> block;
    step::begin_block(model, dynamic_stage(1, 0.01), state, 0, 0.01, 0.01, block);
    const Vector3d momentum = angular_momentum(model, state, 0);
    const Matrix3d inertia = block.spread.trace() * Matrix3d::Identity() - block.spread;
    EXPECT_LT((inertia * block.predicted_spin - momentum).norm(), 1e-13 * momentum.norm());
    EXPECT_NEAR(block.predicted.map.determinant(), 1, 1e-14);
    EXPECT_NEAR(block.predicted_kinetic, block.start_kinetic, 1e-4 * block.start_kinetic);
    EXPECT_NEAR(block.start_kinetic, kinetic_energy(model, state), 1e-12 * block.start_kinetic);
}

}  // namespace voussoir::testing
