// Every stiffness against differences of its force, every force against its energy.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "libdda/block/block_step.h"
#include "libdda/forces/contact_stiffness.h"
#include "libdda/iterate/friction_coupling.h"
#include "libdda/model/parallel.h"
#include "libdda/problem/step_problem.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double young = 1e9;

/// Two free boxes pressed into each other a little askew, in the middle of a step.
template <class K>
struct ContactScene {
    static constexpr int n = K::unknowns;
    Model model;
    Stage stage = dynamic_stage(1, 1e-3);
    State state;
    ContactSet found;
    std::vector<step::BlockStep<K>> blocks;
    step::ContactStep<K> contacts;

    /// @param motion times the velocities of the step
    ContactScene(double friction, double dashpot, Integrator integrator, double motion = 1,
                 FaceLaw face = FaceLaw::points)
    {
        JointMaterial joint = dry(0);
        joint.friction_angle = std::atan(friction);
        joint.relaxation_time = dashpot;
        joint.stiffness = {ContactStiffness::Kind::per_area, 1e9};
        joint.face = face;
        model = make_model(K::kinematics, stone(young), joint);
        add_box(model, "below", {-1, -1, -1}, {1, 1, 0});
        add_box(model, "above", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
        stage.control.integrator = integrator;
        state = initial_state(model);
        set_pose(model, state, 1, {0.2, 0.1, 0.5 - 1e-3}, turned(5e-4, {1, 0.5, 0.2}));
        set_velocity(model, state, 1, motion * Vector3d(0.1, -0.05, -0.3), motion * Vector3d(0.2, 0.1, -0.1));
        contact::SearchMemory<3> search;
        contact::find_contacts(model, state, {1e-2, 1e-2}, 1, search, found);
        for (ContactPoint& p : found.points) {
            p.status = ContactStatus::locked;
            p.elastic_slip = 1e-4 * found.patches[0].normal.cross(Vector3d(1, 2, 0));
        }
        blocks.resize(2);
        for (int b = 0; b < 2; ++b) {
            step::begin_block(model, stage, state, b, 1e-3, 1e-3, blocks[b]);
            blocks[b].row = b;
        }
        step::begin_contacts(model, stage, 1e-3, found, blocks, contacts);
    }
    /// Generalised contact forces on both blocks at D.
    VectorXd force(const VectorXd& d)
    {
        step::evaluate_contacts(d, 1, contacts);
        VectorXd sum = VectorXd::Zero(2 * n);
        for (const step::PatchStep<K>& patch : contacts.patches) {
            sum.segment<n>(n * patch.row_a) += patch.force_a;
            sum.segment<n>(n * patch.row_b) += patch.force_b;
        }
        return sum;
    }
    MatrixXd differences(const VectorXd& d)
    {
        MatrixXd k(2 * n, 2 * n);
        const double step = 1e-7;
        for (int i = 0; i < 2 * n; ++i) {
            VectorXd more = d, less = d;
            more[i] += step;
            less[i] -= step;
            k.col(i) = -(force(more) - force(less)) / (2 * step);
        }
        return k;
    }
    MatrixXd stiffness(const VectorXd& d)
    {
        step::evaluate_contacts(d, 1, contacts);
        step::contact_stiffness(false, 1, contacts);
        MatrixXd k = MatrixXd::Zero(2 * n, 2 * n);
        for (const step::PatchStep<K>& patch : contacts.patches) {
            k.block<n, n>(n * patch.row_a, n * patch.row_a) += patch.aa;
            k.block<n, n>(n * patch.row_b, n * patch.row_b) += patch.bb;
            k.block<n, n>(n * patch.row_a, n * patch.row_b) += patch.ab;
            k.block<n, n>(n * patch.row_b, n * patch.row_a) += patch.ab.transpose();
        }
        return k;
    }
    /// A force at a point, on one block and against the other, as generalised forces.
    static VectorXd spread(const Vector3d& force, const step::PointStep<3>& p, const step::PatchStep<K>& patch)
    {
        typename K::Unknowns a = K::Unknowns::Zero(), b = K::Unknowns::Zero();
        K::add_force(a, p.lever, force);
        K::add_force(b, patch.lever_b(p), -force);
        VectorXd row = VectorXd::Zero(2 * n);
        row.segment<n>(n * patch.row_a) = a;
        row.segment<n>(n * patch.row_b) = b;
        return row;
    }
    /// Sum over the sliding points at D.
    template <class Share>
    MatrixXd of_sliding(const VectorXd& d, const Share& share)
    {
        step::evaluate_contacts(d, 1, contacts);
        MatrixXd k = MatrixXd::Zero(2 * n, 2 * n);
        for (const step::PatchStep<K>& patch : contacts.patches)
            for (int i = patch.first; i < patch.first + patch.count; ++i)
                if (contacts.points[i].status == ContactStatus::sliding) k += share(contacts.points[i], patch);
        return k;
    }
    /// -mu d (dN/dg) n^T of the sliding points: what the symmetric stiffness leaves out.
    MatrixXd normal_coupling(const VectorXd& d)
    {
        return of_sliding(d, [](const step::PointStep<3>& p, const step::PatchStep<K>& patch) -> MatrixXd {
            const VectorXd tangent = spread(p.trial.normalized(), p, patch);
            return -patch.friction.at_rest * p.normal_tangent * tangent *
                   spread(patch.normal, p, patch).transpose();
        });
    }
    int count(ContactStatus status) const
    {
        int sum = 0;
        for (const step::PointStep<3>& p : contacts.points) sum += p.status == status;
        return sum;
    }
};

VectorXd small_unknowns(int size, unsigned seed)
{
    Random random(seed);
    VectorXd d(size);
    random.fill(d, 5e-5);
    return d;
}

double relative(const MatrixXd& a, const MatrixXd& b)
{
    return (a - b).norm() / b.norm();
}

template <class K>
class Derivatives : public ::testing::Test
{
};
using AllKinematics = ::testing::Types<step::SpatialDeformable, step::SpatialRigid>;
TYPED_TEST_SUITE(Derivatives, AllKinematics);

struct Variant {
    double dashpot;
    Integrator integrator;
};
constexpr Variant variants[] = {
    {0, Integrator::newmark}, {0, Integrator::energy_decaying}, {1e-3, Integrator::newmark}};

/// What the stiffness leaves out of the tangent, in a scene of so many rows, all of one block but the second.
template <class K>
MatrixXd whole_tangent(const ContactScene<K>& scene, int rows, int threads)
{
    constexpr int size = 2 * K::unknowns;
    step::StepProblem<K> system;
    system.threads = threads;
    system.blocks = scene.blocks;
    system.block_of_row.assign(rows, 0);
    system.block_of_row[1] = 1;
    system.contacts = scene.contacts;
    step::FrictionCoupling<K> whole;
    whole.gather(system);
    const int unknowns = rows * K::unknowns;
    MatrixXd found = MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i) {
        VectorXd column = VectorXd::Zero(unknowns);
        whole.add_product(system, VectorXd::Unit(unknowns, i), column);
        found.col(i) = column.head(size);
        EXPECT_EQ(column.tail(unknowns - size).norm(), 0);
    }
    return found;
}

/// Gaps are second order in the motion of a step, the stiffness is that of the start: it leaves out what is
/// proportional to the motion, here 3e-4 of the blocks' size, and nothing else.
constexpr double motions[] = {0, 0.5, 1};
void expect_left_out(const double (&errors)[3])
{
    EXPECT_LT(errors[0], 1e-6);
    EXPECT_NEAR(errors[2], 2 * errors[1], 0.1 * errors[2]);
    EXPECT_LT(errors[2], 3e-4);
}

}  // namespace

TYPED_TEST(Derivatives, StickingContactHasTheStiffnessOfItsForce)
{
    for (const FaceLaw face : {FaceLaw::points, FaceLaw::corners})
        for (const Variant& variant : variants) {
            double errors[3];
            for (int i = 0; i < 3; ++i) {
                ContactScene<TypeParam> scene(100, variant.dashpot, variant.integrator, motions[i], face);
                const VectorXd d = motions[i] * small_unknowns(2 * TypeParam::unknowns, 3);
                const MatrixXd k = scene.stiffness(d);
                ASSERT_EQ(scene.count(ContactStatus::locked), face == FaceLaw::points ? 12 : 4);
                errors[i] = relative(scene.differences(d), k);
                EXPECT_LT(relative(k, k.transpose()), 1e-14);
            }
            expect_left_out(errors);
        }
}

TYPED_TEST(Derivatives, SlidingContactHasItUpToTheNormalCoupling)
{
    for (const Variant& variant : variants) {
        double errors[3];
        for (int i = 0; i < 3; ++i) {
            // Of stones that do not bend: as they do, the bound follows a little less, which the coupling leaves
            // out.
            const bool bends = TypeParam::deformable;
            ContactScene<TypeParam> scene(0.01, variant.dashpot, variant.integrator, motions[i],
                                          bends ? FaceLaw::corners : FaceLaw::points);
            const VectorXd d = motions[i] * small_unknowns(2 * TypeParam::unknowns, 4);
            const MatrixXd k = scene.stiffness(d), coupling = scene.normal_coupling(d);
            ASSERT_EQ(scene.count(ContactStatus::sliding), bends ? 4 : 12);
            EXPECT_GT(coupling.norm(), 1e-3 * k.norm());
            errors[i] = relative(scene.differences(d), k + coupling);
        }
        expect_left_out(errors);
    }
}

TYPED_TEST(Derivatives, WholeTangentHasTheNormalCoupling)
{
    ContactScene<TypeParam> scene(0.01, 0, Integrator::newmark, 0, FaceLaw::corners);  // as above
    constexpr int size = 2 * TypeParam::unknowns;
    const VectorXd d = VectorXd::Zero(size);
    const MatrixXd k = scene.stiffness(d), coupling = scene.normal_coupling(d);
    const MatrixXd found = whole_tangent(scene, 2, 1);
    EXPECT_LT(relative(found, coupling), 1e-12);
    EXPECT_LT(relative(scene.differences(d), k + found), 1e-6);
    // As stones bend, the bound follows what is left of the gap; how they twist under that is left out.
    ContactScene<TypeParam> bent(0.01, 0, Integrator::newmark, 0);
    const MatrixXd held = bent.stiffness(d), followed = whole_tangent(bent, 2, 1);
    EXPECT_LT(relative(bent.differences(d), held + followed), 3e-5);
}

// Two threads add it up row by row: here of many that touch nothing but two. All four corners slide, or three;
// both blocks are free, one is the ground, or one is held in part.
TYPED_TEST(Derivatives, WholeTangentIsTheSameInALargeScene)
{
    constexpr int n = TypeParam::unknowns;
    for (const int left_out : {-1, 0}) {
        for (const bool ground_a : {false, true})
            for (const bool ground_b : {false, true}) {
                ContactScene<TypeParam> scene(0.01, 0, Integrator::newmark, 0);
                scene.stiffness(VectorXd::Zero(2 * n));
                if (left_out >= 0) scene.contacts.points[left_out].status = ContactStatus::locked;
                if (ground_a) scene.contacts.patches[0].row_a = -1;
                if (ground_b) scene.contacts.patches[0].row_b = -1;
                scene.blocks[1].held[1] = true;
                if (ground_a && ground_b) {
                    EXPECT_EQ(whole_tangent(scene, blocks_worth_threads, 1).norm(), 0);
                    continue;
                }
                const MatrixXd small = whole_tangent(scene, 2, 1);
                const MatrixXd large = whole_tangent(scene, blocks_worth_threads, 1);
                EXPECT_LT(relative(large, small), 1e-12) << left_out << ground_a << ground_b;
                EXPECT_EQ(large.row(n + 1).norm(), 0);
                EXPECT_EQ(large, whole_tangent(scene, blocks_worth_threads, 2));
            }
    }
}

TYPED_TEST(Derivatives, ContactForcesAreInBalance)
{
    ContactScene<TypeParam> scene(0.05, 1e-3, Integrator::newmark);
    const VectorXd d = small_unknowns(2 * TypeParam::unknowns, 4);
    constexpr int n = TypeParam::unknowns;
    const VectorXd f = scene.force(d);
    const Vector3d on_a = f.head<3>(), on_b = f.segment<3>(n);
    EXPECT_GT(on_a.norm(), 1e4);
    EXPECT_LT((on_a + on_b).norm(), 1e-12 * on_a.norm());
    // Moments about the origin, each from the place its force was evaluated at: levers are of the prediction.
    const typename TypeParam::Unknowns fa = f.template head<n>(), fb = f.template tail<n>();
    const Vector3d moment = TypeParam::moment_of(fa) + TypeParam::moment_of(fb) +
                            scene.blocks[0].predicted.centroid.cross(on_a) +
                            scene.blocks[1].predicted.centroid.cross(on_b);
    // The two levers differ by what the predicted motions of the bodies differ: 1 ms of 0.3 m/s.
    EXPECT_LT(moment.norm(), 1e-3 * on_a.norm());
}

// At an unstrained start the elastic force has no geometric part and its differences are the stiffness.
TEST(Elasticity, ForceHasTheStiffnessOfTheBlock)
{
    for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying}) {
        Model model = make_model(Kinematics::spatial_deformable, stone(young), dry(30));
        add_box(model, "box", {-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2});
        State state = initial_state(model);
        set_pose(model, state, 0, {0, 0, 0}, Random(5).rotation());
        Stage stage = dynamic_stage(1, 1e-3);
        stage.control.integrator = integrator;
        step::BlockStep<step::SpatialDeformable> block;
        step::begin_block(model, stage, state, 0, 1e-3, 1e-3, block);
        const MatrixXd elastic = block.base - block.inertia;
        MatrixXd k(12, 12);
        for (int i = 0; i < 12; ++i) {
            step::SpatialDeformable::Unknowns more = step::SpatialDeformable::Unknowns::Zero(), less = more;
            more[i] = 1e-6;
            less[i] = -1e-6;
            k.col(i) = (step::internal_force(block, more).force - step::internal_force(block, less).force) / 2e-6;
        }
        EXPECT_LT(relative(k, elastic), 1e-8);
        // Six rigid modes: translation and rotation cost nothing.
        const Eigen::FullPivLU<MatrixXd> lu(elastic / elastic.norm());
        EXPECT_EQ(lu.rank(), 6);
    }
}

// Work over the step = growth of the stored energy + the integrator's loss, to rounding, for any strain.
TEST(Elasticity, WorkOfTheForceIsEnergyPlusLoss)
{
    for (const double theta : {1.0, 0.1}) {
        Random random(6);
        Model model = make_model(Kinematics::spatial_deformable, stone(young), dry(30));
        add_box(model, "box", {-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2});
        State state = initial_state(model);
        const Matrix3d turn = random.rotation();
        Matrix3d strain = Matrix3d::Identity();
        for (int k = 0; k < 9; ++k) strain.data()[k] += random.between(-0.02, 0.02);
        set_pose(model, state, 0, {0, 0, 0}, turn * strain);
        set_velocity(model, state, 0, {0, 0, 0}, {0.5, -0.2, 0.3});
        Stage stage = dynamic_stage(1, 1e-3);
        stage.control.integrator = theta == 1 ? Integrator::newmark : Integrator::energy_decaying;
        step::BlockStep<step::SpatialDeformable> block;
        step::begin_block(model, stage, state, 0, 1e-3, 1e-3, block);
        step::SpatialDeformable::Unknowns d;
        random.fill(d, 0.02);
        const step::InternalForce<step::SpatialDeformable> internal = step::internal_force(block, d);
        // The path the strain takes: from the start turned by the prediction, to the end.
        const Matrix3d end = (Matrix3d::Identity() + step::SpatialDeformable::gradient(d)) * block.predicted.map;
        const Matrix3d path = end - block.step_rotation * block.start.map;
        const Matrix3d g =
            step::SpatialDeformable::gradient(internal.force) * block.predicted.map.inverse().transpose();
        const double work = g.cwiseProduct(path).sum();
        const double gained = internal.energy - block.elasticity.energy(block.start_strain);
        EXPECT_NEAR(work, gained + internal.loss, 1e-12 * (internal.energy + std::abs(work)));
        EXPECT_GT(internal.loss, 0);
        const Matrix3d green = 0.5 * (end.transpose() * end - Matrix3d::Identity());
        EXPECT_NEAR(internal.energy, block.elasticity.energy(green), 1e-12 * internal.energy);
    }
}

TEST(Elasticity, EnergyAndForceTurnWithTheBlock)
{
    const Matrix3d turn = Random(8).rotation();
    step::BlockStep<step::SpatialDeformable> blocks[2];
    step::SpatialDeformable::Unknowns d[2];
    Random(9).fill(d[0], 0.01);
    const Matrix3d gradient = step::SpatialDeformable::gradient(d[0]);
    d[1].head<3>() = turn * d[0].head<3>();
    Eigen::Map<Matrix3d>(d[1].data() + 3) = turn * gradient * turn.transpose();
    step::InternalForce<step::SpatialDeformable> internal[2];
    for (int i = 0; i < 2; ++i) {
        Model model = make_model(Kinematics::spatial_deformable, stone(young), dry(30));
        add_box(model, "box", {-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2});
        State state = initial_state(model);
        const Matrix3d stretched = Vector3d(1.01, 0.98, 1.005).asDiagonal();
        set_pose(model, state, 0, {0, 0, 0}, i ? Matrix3d(turn * stretched) : stretched);
        step::begin_block(model, dynamic_stage(1, 1e-3), state, 0, 1e-3, 1e-3, blocks[i]);
        internal[i] = step::internal_force(blocks[i], d[i]);
    }
    EXPECT_NEAR(internal[1].energy, internal[0].energy, 1e-13 * internal[0].energy);
    const Matrix3d first = step::SpatialDeformable::gradient(internal[0].force),
                   second = step::SpatialDeformable::gradient(internal[1].force);
    EXPECT_LT((turn * first * turn.transpose() - second).norm(), 1e-12 * first.norm());
}

TEST(Elasticity, ABlockTurnedInsideOutIsRefused)
{
    Model model = make_model(Kinematics::spatial_deformable, stone(young), dry(30));
    add_box(model, "box", {-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2});
    step::BlockStep<step::SpatialDeformable> block;
    step::begin_block(model, dynamic_stage(1, 1e-3), initial_state(model), 0, 1e-3, 1e-3, block);
    step::SpatialDeformable::Unknowns d = step::SpatialDeformable::Unknowns::Zero();
    EXPECT_TRUE(step::internal_force(block, d).admissible);
    d[3] = -1.1;  // x -> -0.1 x
    EXPECT_FALSE(step::internal_force(block, d).admissible);
}

}  // namespace voussoir::testing
