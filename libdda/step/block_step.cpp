#include "libdda/step/block_step.h"

#include <Eigen/LU>
#include <cmath>

namespace voussoir
{

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{

Quaterniond rotation_by(const Vector3d& vector)
{
    const double angle = vector.norm();
    if (angle == 0) return Quaterniond::Identity();
    const double half = 0.5 * angle;
    Quaterniond q;
    q.w() = std::cos(half);
    q.vec() = std::sin(half) / angle * vector;
    return q;
}

Matrix3d inertia_tensor(const Matrix3d& spread)
{
    return spread.trace() * Matrix3d::Identity() - spread;
}

Matrix3d spread_of(const Matrix3d& map, const Matrix3d& density_second)
{
    return map * density_second * map.transpose();
}

/// Mean angular velocity of the step for constant momentum H: the implicit midpoint rule
/// w = I(exp(h w / 2) A)^-1 H, symmetric in time, so that the kinetic energy of a free spin does not drift.
Vector3d midpoint_spin(const Matrix3d& map, const Matrix3d& density_second, const Vector3d& spin,
                       const Vector3d& momentum, double h)
{
    Vector3d w = spin;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const Matrix3d half = rotation_by(0.5 * h * w) * map;
        const Vector3d next = inertia_tensor(spread_of(half, density_second)).inverse() * momentum;
        const double change = h * (next - w).norm();
        w = next;
        if (change < 1e-16) break;
    }
    return w;
}

template <class K>
double kinetic_energy(const BlockStep<K>& step, const Vector3d& velocity, const Matrix3d& rate)
{
    double twice = 0;
    for (int k = 0; k < 3; ++k)
        if (!step.held[k]) twice += step.mass * velocity[k] * velocity[k];
    if (!step.held[3]) twice += (rate * step.density_second).cwiseProduct(rate).sum();
    return 0.5 * twice;
}

/// Places held components on the ground of the end of the step.
template <class K>
void follow_ground(const Model& model, const Stage& stage, const State& state, int block, double end_time,
                   BlockStep<K>& step)
{
    step.ground_velocity.setZero();
    for (std::size_t f = 0; f < model.foundations.size(); ++f) {
        const Foundation& foundation = model.foundations[f];
        if (foundation.block != block) continue;
        for (int k = 0; k < 3; ++k) {
            step.held[k] = foundation.translation_held[k];
            if (step.held[k]) step.predicted.centroid[k] = state.foundation_anchors[3 * f + k];
        }
        for (int k = 3; k < K::unknowns; ++k) step.held[k] = foundation.rotation_held;
        for (const FoundationMotion& motion : stage.motions) {
            if (motion.foundation != static_cast<int>(f) || !step.held[motion.component]) continue;
            step.predicted.centroid[motion.component] += motion.motion->displacement(end_time);
            step.ground_velocity[motion.component] = motion.motion->velocity(end_time);
        }
    }
}

/// Predicts the free flight of a block: q + h v, with the rotation done exactly and the momentum kept exactly.
/// Source: numerics note 2.6 (rotated predictor), here with an implicit midpoint spin.
template <class K>
void predict(const State& state, int block, double h, BlockStep<K>& step)
{
    const double* x = state.coordinates.data() + block * coordinates_per_block(K::kinematics);
    const double* v = state.velocities.data() + block * K::unknowns;
    step.start_velocity = Vector3d(v);
    step.predicted.centroid = step.start.centroid + h * step.start_velocity;
    const Matrix3d& map = step.start.map;
    const Matrix3d inertia = inertia_tensor(spread_of(map, step.density_second));
    Matrix3d rate = Matrix3d::Zero();
    if constexpr (K::deformable) {
        rate = Matrix3d(v + 3);
        step.momentum = axial(rate * step.density_second * map.transpose());
        step.start_spin = inertia.inverse() * step.momentum;
        step.stretching = rate - skew(step.start_spin) * map;
    } else {
        step.start_spin = Vector3d(v + 3);
        step.momentum = inertia * step.start_spin;
        step.stretching.setZero();
        rate = skew(step.start_spin) * map;
    }
    step.start_kinetic = kinetic_energy(step, step.start_velocity, rate);

    const Vector3d spin = midpoint_spin(map, step.density_second, step.start_spin, step.momentum, h);
    const Quaterniond turn = rotation_by(h * spin);
    step.step_rotation = turn.toRotationMatrix();
    if constexpr (K::deformable) {
        step.predicted.map = step.step_rotation * (map + h * step.stretching);
        step.stretching = step.step_rotation * step.stretching;
    } else {
        step.predicted_rotation = (turn * Quaterniond(x[3], x[4], x[5], x[6])).normalized();
        step.predicted.map = step.predicted_rotation.toRotationMatrix();
    }
    step.spread = spread_of(step.predicted.map, step.density_second);
    step.predicted_spin = inertia_tensor(step.spread).inverse() * step.momentum;
    step.predicted_velocity = step.start_velocity;
    const Matrix3d predicted_rate = skew(step.predicted_spin) * step.predicted.map + step.stretching;
    step.predicted_kinetic = kinetic_energy(step, step.predicted_velocity, predicted_rate);
    step.velocity.template head<3>() = step.predicted_velocity;
    if constexpr (K::deformable)
        Map<Matrix3d>{step.velocity.data() + 3} = predicted_rate * step.predicted.map.inverse();
    else
        step.velocity.template tail<3>() = step.predicted_spin;
}

/// V (1 + theta)/2 [lambda B:L B:L' + 2 mu sym(A^T L A):sym(A^T L' A)], B = A A^T: for components ij, kl
/// lambda B_ij B_kl + mu (B_ik B_jl + B_il B_jk). The geometric part is left out: it is smaller by stress /
/// modulus, and the residual is exact.
void add_elastic_stiffness(const Elasticity& e, const Matrix3d& map, double blend, SpatialDeformable::Square& k)
{
    const Matrix3d b = map * map.transpose();
    const double factor = e.volume * (1 + blend) / 2;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
            for (int n = 0; n < 3; ++n)
                for (int m = 0; m < 3; ++m)
                    k(3 + 3 * j + i, 3 + 3 * n + m) +=
                        factor * (e.lambda * b(i, j) * b(m, n) + e.mu * (b(i, m) * b(j, n) + b(i, n) * b(j, m)));
}

}  // namespace

template <class K>
void begin_block(const Model& model, const Stage& stage, const State& state, int block, double h, double end_time,
                 BlockStep<K>& step)
{
    const Block& shape = model.blocks[block];
    const BlockMaterial& material = model.materials[shape.material];
    step.held.fill(false);
    step.mass = model.mass(block);
    step.size = std::cbrt(shape.moments.volume);
    step.density_second = material.density * shape.moments.second;
    step.start = pose_of(K::kinematics, state, block);
    for (const Foundation& foundation : model.foundations)
        if (foundation.block == block)
            for (int k = 0; k < K::unknowns; ++k)
                step.held[k] = k < 3 ? foundation.translation_held[k] : foundation.rotation_held;
    predict(state, block, h, step);
    follow_ground(model, stage, state, block, end_time, step);

    const bool newmark = stage.control.integrator == Integrator::newmark || stage.type != StageType::dynamic;
    const double blend = newmark ? 1 : stage.control.dissipation;
    step.gravity = step.mass * stage.gravity;
    step.body_force = step.gravity;
    for (const BodyAcceleration& load : stage.body_accelerations) {
        if (load.block != block) continue;
        const double before = load.motion->acceleration(end_time - h), after = load.motion->acceleration(end_time);
        step.body_force[load.component] += step.mass * (0.5 * (1 - blend) * before + 0.5 * (1 + blend) * after);
    }
    step.steady.setZero();
    step.steady.template head<3>() = step.body_force;
    step.inertia = 2 / (h * h) * K::mass_matrix(step.mass, step.spread);
    step.base = step.inertia;
    if constexpr (K::deformable) {
        step.elasticity.lambda =
            material.young * material.poisson / ((1 + material.poisson) * (1 - 2 * material.poisson));
        step.elasticity.mu = material.young / (2 * (1 + material.poisson));
        step.elasticity.volume = shape.moments.volume;
        step.elastic_blend = blend;
        step.start_strain = 0.5 * (step.start.map.transpose() * step.start.map - Matrix3d::Identity());
        add_elastic_stiffness(step.elasticity, step.predicted.map, blend, step.base);
        // Centrifugal load on the strains; its antisymmetric part is already in the predicted spin.
        const Matrix3d w = skew(step.predicted_spin), pull = w * w * step.spread;
        Map<Matrix3d>(step.steady.data() + 3) = -0.5 * (pull + pull.transpose());
    }
    if (step.held[3]) step.steady.template tail<K::unknowns - 3>().setZero();
}

template <class K>
InternalForce<K> internal_force(const BlockStep<K>& step, const typename K::Unknowns& d)
{
    InternalForce<K> result;
    if constexpr (K::deformable) {
        // Work over the step of G = V A_mid S, A_mid the mean of R A_n and A, S the blend of the strains'
        // stresses: dPsi + theta V dE:C:dE / 2, exactly.
        const double theta = step.elastic_blend;
        const Matrix3d map = step.predicted.map + K::gradient(d) * step.predicted.map;
        result.admissible = map.determinant() > 0;
        const Matrix3d strain = 0.5 * (map.transpose() * map - Matrix3d::Identity());
        const Matrix3d middle = 0.5 * (step.step_rotation * step.start.map + map);
        const Matrix3d stress =
            step.elasticity.stress(0.5 * (1 - theta) * step.start_strain + 0.5 * (1 + theta) * strain);
        const Matrix3d g = step.elasticity.volume * middle * stress * step.predicted.map.transpose();
        Map<Matrix3d>(result.force.data() + 3) = g;
        result.energy = step.elasticity.energy(strain);
        result.loss = theta * step.elasticity.energy(strain - step.start_strain);
    }
    return result;
}

template <class K>
void update_block(const BlockStep<K>& step, const typename K::Unknowns& d, const Vector3d& moment, double h,
                  int block, State& state)
{
    double* x = state.coordinates.data() + block * coordinates_per_block(K::kinematics);
    double* v = state.velocities.data() + block * K::unknowns;
    const Vector3d centroid = step.predicted.centroid + d.template head<3>();
    Vector3d velocity = step.predicted_velocity + 2 / h * d.template head<3>();
    for (int k = 0; k < 3; ++k)
        if (step.held[k]) velocity[k] = step.ground_velocity[k];
    Map<Vector3d>{x} = centroid;
    Map<Vector3d>{v} = velocity;
    if (step.held[3]) return;

    // The angular momentum is known exactly: H + h moment. The spin is what carries it in the new configuration.
    const Vector3d momentum = step.momentum + h * moment;
    if constexpr (K::deformable) {
        const Matrix3d l = K::gradient(d), map = step.predicted.map + l * step.predicted.map;
        Matrix3d rate =
            skew(step.predicted_spin) * step.predicted.map + step.stretching + 2 / h * l * step.predicted.map;
        const Vector3d missing = momentum - axial(rate * step.density_second * map.transpose());
        const Matrix3d inertia = inertia_tensor(spread_of(map, step.density_second));
        rate += skew(inertia.inverse() * missing) * map;
        Map<Matrix3d>{x + 3} = map;
        Map<Matrix3d>{v + 3} = rate;
    } else {
        const Quaterniond q = (rotation_by(d.template tail<3>()) * step.predicted_rotation).normalized();
        const Matrix3d map = q.toRotationMatrix();
        const Vector3d spin = inertia_tensor(spread_of(map, step.density_second)).inverse() * momentum;
        const double coefficients[4] = {q.w(), q.x(), q.y(), q.z()};
        std::copy(coefficients, coefficients + 4, x + 3);
        Map<Vector3d>{v + 3} = spin;
    }
}

template <class K>
double kinetic_energy_of(const BlockStep<K>& step, const State& state, int block)
{
    const double* v = state.velocities.data() + block * K::unknowns;
    const Matrix3d map = pose_of(K::kinematics, state, block).map;
    if constexpr (K::deformable) return kinetic_energy(step, Vector3d(v), Matrix3d(v + 3));
    return kinetic_energy(step, Vector3d(v), skew(Vector3d(v + 3)) * map);
}

template <class K>
Matrix3d rotation_of_step(const BlockStep<K>& step, const typename K::Unknowns& d)
{
    const Vector3d turn = 0.5 * axial(K::gradient(d));
    return rotation_by(turn).toRotationMatrix() * step.step_rotation;
}

template struct BlockStep<SpatialDeformable>;
template struct BlockStep<SpatialRigid>;
template void begin_block(const Model&, const Stage&, const State&, int, double, double,
                          BlockStep<SpatialDeformable>&);
template void begin_block(const Model&, const Stage&, const State&, int, double, double, BlockStep<SpatialRigid>&);
template InternalForce<SpatialDeformable> internal_force(const BlockStep<SpatialDeformable>&,
                                                         const SpatialDeformable::Unknowns&);
template InternalForce<SpatialRigid> internal_force(const BlockStep<SpatialRigid>&, const SpatialRigid::Unknowns&);
template void update_block(const BlockStep<SpatialDeformable>&, const SpatialDeformable::Unknowns&,
                           const Vector3d&, double, int, State&);
template void update_block(const BlockStep<SpatialRigid>&, const SpatialRigid::Unknowns&, const Vector3d&, double,
                           int, State&);
template double kinetic_energy_of(const BlockStep<SpatialDeformable>&, const State&, int);
template double kinetic_energy_of(const BlockStep<SpatialRigid>&, const State&, int);
template Matrix3d rotation_of_step(const BlockStep<SpatialDeformable>&, const SpatialDeformable::Unknowns&);
template Matrix3d rotation_of_step(const BlockStep<SpatialRigid>&, const SpatialRigid::Unknowns&);

}  // namespace voussoir
