#include "libdda/block/block_step.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "libdda/block/held_components.h"
#include "libdda/block/prediction.h"

namespace voussoir::step
{

using Eigen::Map;

namespace
{

/// Places held components on the ground of the end of the step.
template <class K>
void follow_ground(const Model& model, const Stage& stage, const State& state, int block, double end_time,
                   BlockStep<K>& step)
{
    constexpr int dimension = K::dimension;
    step.ground_velocity.setZero();
    if (!step.is_foundation) return;
    for (std::size_t f = 0; f < model.foundations.size(); ++f) {
        if (model.foundations[f].block != block) continue;
        for (int k = 0; k < dimension; ++k) {
            if (!step.held[k]) continue;
            step.predicted.centroid[k] = state.foundation_anchors[dimension * f + k];
            for (const FoundationMotion& motion : stage.motions) {
                if (motion.foundation != static_cast<int>(f) || motion.component != axis_in_space<dimension>(k))
                    continue;
                step.predicted.centroid[k] += motion.motion->displacement(end_time);
                step.ground_velocity[k] = motion.motion->velocity(end_time);
            }
        }
    }
}

/// The b of the block's Rayleigh damping [s]; static stages have none.
double stiffness_damping(const Model& model, const Stage& stage, int block)
{
    if (!is_motion(stage)) return 0;
    return model.materials[model.blocks[block].material].rayleigh.of_stiffness;
}

/// How the prediction moves levers, for contacts: they act where they are in the middle of the step.
template <class K>
void find_flow(BlockStep<K>& step)
{
    using Matrix = typename K::Matrix;
    step.turns = !step.rotation_held();
    if (!step.turns) {
        step.flow.setIdentity();
        step.chord.setZero();
        step.half_rotation.setIdentity();
        return;
    }
    step.flow = step.predicted.map * step.start.map.inverse();
    step.chord = 2 * (step.flow - Matrix::Identity()) * Matrix(Matrix::Identity() + step.flow).inverse();
}

/// V (1 + theta)/2 [lambda B:L B:L' + 2 mu sym(A^T L A):sym(A^T L' A)], B = A A^T: for components ij, kl
/// lambda B_ij B_kl + mu (B_ik B_jl + B_il B_jk). The geometric part is left out: it is smaller by stress /
/// modulus, and the residual is exact. Source: docs/numerics.md 2.3.
template <int D>
void add_elastic_stiffness(const Elasticity& e, const MatrixIn<D>& map, double blend,
                           typename DeformableIn<D>::Square& k)
{
    const MatrixIn<D> b = map * map.transpose();
    const double factor = e.volume * (1 + blend) / 2;
    for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i)
            for (int n = 0; n < D; ++n)
                for (int m = 0; m < D; ++m)
                    k(D + D * j + i, D + D * n + m) +=
                        factor * (e.lambda * b(i, j) * b(m, n) + e.mu * (b(i, m) * b(j, n) + b(i, n) * b(j, m)));
}

}  // namespace

template <class K>
void begin_block(const Model& model, const Stage& stage, const State& state, int block, double h, double end_time,
                 std::span<const Jump<K>> jumps, BlockStep<K>& step)
{
    constexpr int dimension = K::dimension;
    step.mass = model.mass(block);
    if (step.size == 0) step.size = size_of(model, block);
    step.density_second = from_space<dimension>(model.mass_second(block));
    step.start = pose_in<dimension>(K::kinematics, state, block);
    const HeldComponents<K> components = held_components<K>(model, block, step.is_foundation);
    step.held = components.held;
    step.sides_tied = components.sides_tied;
    predict(state, block, h, jumps, step);
    follow_ground(model, stage, state, block, end_time, step);
    find_flow(step);

    const double blend = end_share(stage);
    step.gravity =
        step.mass * from_space<dimension>(mean_gravity(stage.gravity_ramp, stage.gravity, end_time - h, end_time));
    step.body_force = step.gravity;
    step.steady.setZero();
    step.steady.template head<dimension>() = step.body_force;
    step.inertia = 2 / (h * h) * K::mass_matrix(step.mass, step.spread);
    step.base = step.inertia;
    if constexpr (K::deformable) {
        step.elasticity = elasticity_of(model, block);
        step.damping_blend = 2 / h * stiffness_damping(model, stage, block);
        step.elastic_blend = blend + step.damping_blend;
        step.start_strain = green_strain_of(step.start.map);
        if (!state.branch_strains.empty()) {
            begin_memory(model, state, block, is_motion(stage), h, step.start_strain, step.memory);
            step.elastic_blend += step.memory.blend;
        }
        add_elastic_stiffness<dimension>(step.elasticity, step.predicted.map, step.elastic_blend, step.base);
        // Centrifugal load on the strains; its antisymmetric part is already in the predicted spin.
        const typename K::Matrix w = skew(step.predicted_spin), pull = w * w * step.spread;
        Map<typename K::Matrix>(step.steady.data() + dimension) = -0.5 * (pull + pull.transpose());
    }
    if (step.rotation_held()) step.steady.template tail<K::unknowns - dimension>().setZero();
}

template <class K>
void take_elasticity_at_end(BlockStep<K>& step)
{
    if constexpr (K::deformable) {
        const double blend = 1 + step.damping_blend + step.memory.blend;
        if (step.elastic_blend == blend) return;
        step.elastic_blend = blend;
        step.base = step.inertia;
        add_elastic_stiffness<K::dimension>(step.elasticity, step.predicted.map, blend, step.base);
    }
}

bool is_motion(const Stage& stage)
{
    return stage.type == StageType::dynamic && !stage.looks_for_rest;
}

double end_share(const Stage& stage)
{
    const bool at_end = stage.control.integrator == Integrator::newmark || stage.type != StageType::dynamic ||
                        stage.control.is_published();
    return at_end ? 1 : stage.control.dissipation_used();
}

template <class K>
void add_body_accelerations(const Stage& stage, double h, double end_time, std::vector<BlockStep<K>>& blocks)
{
    const bool at_end = end_share(stage) == 1;
    for (const BodyAcceleration& load : stage.body_accelerations) {
        BlockStep<K>& step = blocks[load.block];
        const GroundMotion& motion = *load.motion;
        const double acceleration = at_end ? motion.acceleration(end_time)
                                           : (motion.velocity(end_time) - motion.velocity(end_time - h)) / h;
        for (int k = 0; k < K::dimension; ++k)
            if (load.component == axis_in_space<K::dimension>(k)) step.body_force[k] += step.mass * acceleration;
        step.steady.template head<K::dimension>() = step.body_force;
    }
}

template <class K>
InternalForce<K> internal_force(const BlockStep<K>& step, const typename K::Unknowns& d)
{
    InternalForce<K> result;
    if constexpr (K::deformable) {
        using Matrix = typename K::Matrix;
        // Work over the step of G = V A_mid S, A_mid the mean of R A_n and A, S the blend of the strains'
        // stresses: dPsi + theta V dE:C:dE / 2, exactly. A stress b C dE/h beside it is another 2 b / h of theta.
        const double theta = step.elastic_blend;
        const Matrix map = step.predicted.map + K::gradient(d) * step.predicted.map;
        result.admissible = map.determinant() > 0;
        const Matrix strain = green_strain_of(map);
        const Matrix middle = 0.5 * (step.step_rotation * step.start.map + map);
        Matrix blended = 0.5 * (1 - theta) * step.start_strain + 0.5 * (1 + theta) * strain;
        if (!step.memory.branches.empty()) blended += step.memory.steady;
        const Matrix stress = step.elasticity.stress(blended);
        const Matrix g = step.elasticity.volume * middle * stress * step.predicted.map.transpose();
        Map<Matrix>(result.force.data() + K::dimension) = g;
        result.energy = step.elasticity.energy(strain);
        const double of_change = step.elasticity.energy(Matrix(strain - step.start_strain));
        result.loss = (theta - step.damping_blend - step.memory.blend) * of_change;
        result.damped = step.damping_blend * of_change;
        if (step.memory.branches.empty()) return result;
        const MemoryWork work = memory_work(step.memory, step.elasticity, Matrix(strain - step.start_strain));
        result.energy += work.stored;
        result.damped += work.lost;
    }
    return result;
}

template <class K>
typename K::Matrix ballistic_turn(const BlockStep<K>& step, double h)
{
    if (!step.turns) return K::Matrix::Zero();
    return h * K::gradient(step.velocity) - step.chord;
}

template <class K>
typename K::Unknowns blended_velocity(const BlockStep<K>& step, double end, double h)
{
    typename K::Unknowns result = step.velocity;
    if (!step.jumps) return result;
    result.template head<K::dimension>() -= (1 - end) / h * step.ballistic;
    const typename K::Matrix turn = (1 - end) / h * ballistic_turn(step, h);
    if constexpr (K::deformable)
        Eigen::Map<typename K::Matrix>(result.data() + K::dimension) -= turn;
    else
        result.template tail<K::spins>() -= 0.5 * axial(turn);
    return result;
}

template <class K>
void update_block(const BlockStep<K>& step, const typename K::Unknowns& d, const typename K::Spin& moment,
                  double h, int block, State& state)
{
    constexpr int dimension = K::dimension;
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    double* x = state.coordinates.data() + block * coordinates_per_block(K::kinematics);
    double* v = state.velocities.data() + block * K::unknowns;
    Vector velocity = step.predicted_velocity + 2 / h * d.template head<dimension>();
    for (int k = 0; k < dimension; ++k)
        if (step.held[k]) velocity[k] = step.ground_velocity[k];
    Map<Vector>{x} = step.predicted.centroid + d.template head<dimension>();
    Map<Vector>{v} = velocity;
    if (step.rotation_held()) return;

    // The angular momentum is known exactly: H + h moment. The spin is what carries it in the new configuration.
    const typename K::Spin momentum = step.momentum + h * moment;
    if constexpr (K::deformable) {
        const Matrix l = K::gradient(d), map = step.predicted.map + l * step.predicted.map;
        Matrix rate =
            skew(step.predicted_spin) * step.predicted.map + step.stretching + 2 / h * l * step.predicted.map;
        if (!step.sides_tied) {
            const typename K::Spin missing =
                momentum - axial(Matrix(rate * step.density_second * map.transpose()));
            rate += skew(spin_of<dimension>(spread_of(map, step.density_second), missing)) * map;
        }
        Map<Matrix>{x + dimension} = map;
        Map<Matrix>{v + dimension} = rate;
        if (!step.memory.branches.empty())
            update_memory(step.memory, step.start_strain, green_strain_of(map), block, state);
    } else {
        const OrientationIn<dimension> turned =
            step.predicted_orientation.turned_by(typename K::Spin(d.template tail<K::spins>()));
        turned.write(x + dimension);
        Map<typename K::Spin>{v + dimension} =
            spin_of<dimension>(spread_of(turned.matrix(), step.density_second), momentum);
    }
}

template <class K>
double kinetic_energy_of(const BlockStep<K>& step, const State& state, int block)
{
    const double* v = state.velocities.data() + block * K::unknowns;
    const typename K::Vector velocity(v);
    if constexpr (K::deformable) {
        return kinetic_energy(step, velocity, typename K::Matrix(v + K::dimension));
    } else {
        const typename K::Spin spin = Map<const typename K::Spin>(v + K::dimension);
        const typename K::Matrix map = pose_in<K::dimension>(K::kinematics, state, block).map;
        return kinetic_energy(step, velocity, typename K::Matrix(skew(spin) * map));
    }
}

template <class K>
typename K::Matrix rotation_of_step(const BlockStep<K>& step, const typename K::Unknowns& d)
{
    const typename K::Spin turn = 0.5 * axial(K::gradient(d));
    return rotation_by(turn) * step.step_rotation;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                               \
    template struct BlockStep<K>;                                                                             \
    template void take_elasticity_at_end(BlockStep<K>&);                                                      \
    template void begin_block(const Model&, const Stage&, const State&, int, double, double,                  \
                              std::span<const Jump<K>>, BlockStep<K>&);                                       \
    template void add_body_accelerations(const Stage&, double, double, std::vector<BlockStep<K>>&);           \
    template InternalForce<K> internal_force(const BlockStep<K>&, const K::Unknowns&);                        \
    template K::Matrix ballistic_turn(const BlockStep<K>&, double);                                           \
    template K::Unknowns blended_velocity(const BlockStep<K>&, double, double);                               \
    template void update_block(const BlockStep<K>&, const K::Unknowns&, const K::Spin&, double, int, State&); \
    template double kinetic_energy_of(const BlockStep<K>&, const State&, int);                                \
    template K::Matrix rotation_of_step(const BlockStep<K>&, const K::Unknowns&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
