#include "libdda/forces/viscous_boundary.h"

#include <Eigen/LU>
#include <cmath>

#include "libdda/block/block_face.h"
#include "libdda/forces/free_field.h"

namespace voussoir::step
{

using Eigen::Map;

namespace
{

// Springs that carry a face at rest: so many times what a block as deep as it is wide resists with.
constexpr double rest_stiffness = 1000;

template <int D>
MatrixIn<D> impedance_of(const Model& model, int block, const VectorIn<D>& normal)
{
    const Elasticity e = elasticity_of(model, block);
    const double density = model.materials[model.blocks[block].material].density;
    return along_and_across<D>(std::sqrt(density * (e.lambda + 2 * e.mu)), std::sqrt(density * e.mu), normal);
}

/// Integral of T^T C T over a face.
template <class K>
typename K::Square integral_of(const FaceIn<K::dimension>& face, const typename K::Matrix& c)
{
    typename K::Square sum = K::Square::Zero();
    for (const auto& point : face.points)
        K::add_stiffness(sum, point.lever, point.lever, typename K::Matrix(point.weight * c));
    return sum;
}

template <class K>
typename K::Matrix springs_of(const Model& model, const ViscousBoundary& boundary, int block,
                              const typename K::Vector& normal)
{
    const Elasticity e = elasticity_of(model, block);
    const double along =
        boundary.at_rest == RestSupport::none ? 0 : rest_stiffness * (e.lambda + 2 * e.mu) / size_of(model, block);
    return along_and_across<K::dimension>(along, boundary.at_rest == RestSupport::full ? along : 0, normal);
}

/// Velocity of what comes in through a face in the step, blended as the dashpots' own [m/s].
template <int D>
VectorIn<D> incoming(const Model& model, const Stage& stage, int boundary, const BlockFace& face, double h,
                     double end_time)
{
    const double end = end_share(stage);
    VectorIn<D> velocity = VectorIn<D>::Zero();
    for (const IncomingWave& wave : stage.incoming_waves) {
        if (wave.boundary != boundary) continue;
        double time = end_time;
        if (!wave.slowness.isZero(0)) time -= wave.slowness.dot(middle_of<D>(model, face) - wave.origin);
        const double mean = (wave.motion->displacement(time) - wave.motion->displacement(time - h)) / h;
        const double blended = (1 - end) * mean + end * wave.motion->velocity(time);
        for (int k = 0; k < D; ++k)
            if (wave.component == axis_in_space<D>(k)) velocity[k] += wave.share * blended;
    }
    return velocity;
}

/// Reactions of one face as the state has them: integrals of t (1, X).
template <int D>
Map<Eigen::Matrix<double, D, D + 1>> reaction_in(State& state, int face)
{
    return Map<Eigen::Matrix<double, D, D + 1>>(state.boundary_reactions.data() + face * D * (D + 1));
}

/// The same as a force on the unknowns of the block. @param map of its prediction
template <class K>
typename K::Unknowns reaction_of(const State& state, int face, const typename K::Matrix& map)
{
    constexpr int dimension = K::dimension;
    const auto reaction = reaction_in<dimension>(const_cast<State&>(state), face);
    typename K::Unknowns force = K::Unknowns::Zero();
    force.template head<dimension>() = reaction.col(0);
    if constexpr (K::deformable)
        Map<typename K::Matrix>(force.data() + dimension) =
            reaction.template rightCols<dimension>() * map.transpose();
    return force;
}

/// Force of the springs that carry a face at rest.
template <class K>
AppliedForce<K> carrying_force(const typename K::Square& springs, const BlockFace& face, double h,
                               const BlockStep<K>& block)
{
    AppliedForce<K> force;
    force.block = face.block;
    force.resistance = springs;
    force.constant = -h * (force.resistance * block.velocity);
    return force;
}

/// Force of dashpots of the mean velocity v^ + D/h, and by the integrator's share of that at the end, v^ + 2 D/h.
template <class K>
AppliedForce<K> dashpot_force(const typename K::Square& dashpots, const BlockFace& face, double end, double h,
                              const BlockStep<K>& block)
{
    AppliedForce<K> force;
    force.block = face.block;
    force.resistance = (1 + end) / h * dashpots;
    force.constant = -(dashpots * blended_velocity(block, end, h));
    return force;
}

/// Adds the force of a face of a boundary. @param number of the face in the boundary
template <class K>
void add_face_force(const Model& model, const Stage& stage, int index, std::size_t number, double h,
                    double end_time, const std::vector<BlockStep<K>>& blocks, AppliedForces<K>& forces)
{
    const ViscousBoundary& boundary = model.boundaries[index];
    const BlockFace& face = boundary.faces[number];
    const BlockStep<K>& block = blocks[face.block];
    const FaceIn<K::dimension> shape = face_of(model, face, block.predicted.map);
    typename K::Matrix impedance = K::Matrix::Zero();  // none at rest
    AppliedForce<K> force;
    if (boundaries_carry(stage)) {
        force = carrying_force<K>(integral_of<K>(shape, springs_of<K>(model, boundary, face.block, shape.normal)),
                                  face, h, block);
    } else {
        impedance = impedance_of<K::dimension>(model, face.block, shape.normal);
        force = dashpot_force<K>(integral_of<K>(shape, impedance), face, end_share(stage), h, block);
        const typename K::Vector pull =
            2 * (impedance * incoming<K::dimension>(model, stage, index, face, h, end_time));
        for (const auto& point : shape.points)
            K::add_force(force.constant, point.lever, typename K::Vector(point.weight * pull));
    }
    if (!boundary.free_field.empty()) {
        const int column = boundary.free_field[number];
        force.coupling = static_cast<int>(forces.couplings.size());
        const typename K::Square matrix =
            add_free_field<K>(model, shape, column, impedance, end_share(stage), h, blocks, force);
        forces.couplings.push_back({face.block, column, false, matrix});
    }
    forces.own.push_back(force);
}

}  // namespace

bool boundaries_carry(const Stage& stage)
{
    return stage.type == StageType::static_equilibrium || stage.looks_for_rest;
}

template <class K>
typename K::Square dashpots_of(const Model& model, const BlockFace& face, const typename K::Matrix& map)
{
    const FaceIn<K::dimension> shape = face_of(model, face, map);
    return integral_of<K>(shape, impedance_of<K::dimension>(model, face.block, shape.normal));
}

template <class K>
void add_boundary_forces(const Model& model, const Stage& stage, const State& state, double h, double end_time,
                         const std::vector<BlockStep<K>>& blocks, AppliedForces<K>& forces)
{
    int index = 0;
    for (std::size_t b = 0; b < model.boundaries.size(); ++b) {
        for (std::size_t i = 0; i < model.boundaries[b].faces.size(); ++i) {
            add_face_force<K>(model, stage, static_cast<int>(b), i, h, end_time, blocks, forces);
            AppliedForce<K>& force = forces.own.back();
            force.constant += reaction_of<K>(state, index++, blocks[force.block].predicted.map);
        }
    }
}

template <class K>
void update_reactions(const Model& model, const Stage& stage, const std::vector<BlockStep<K>>& blocks,
                      State& state)
{
    using Vector = typename K::Vector;
    constexpr int dimension = K::dimension;
    if (!boundaries_carry(stage)) return;
    int index = 0;
    for (const ViscousBoundary& boundary : model.boundaries) {
        for (const BlockFace& face : boundary.faces) {
            const BlockStep<K>& block = blocks[face.block];
            const FaceIn<dimension> shape = face_of(model, face, block.predicted.map);
            const auto springs = springs_of<K>(model, boundary, face.block, shape.normal);
            const typename K::Matrix back = block.predicted.map.inverse();
            const auto end = pose_in<dimension>(K::kinematics, state, face.block);
            auto reaction = reaction_in<dimension>(state, index++);
            for (const auto& point : shape.points) {
                const Vector lever = back * point.lever;
                const Vector moved = end.centroid - block.start.centroid + (end.map - block.start.map) * lever;
                const Vector pull = -point.weight * (springs * moved);
                reaction.col(0) += pull;
                reaction.template rightCols<dimension>() += pull * lever.transpose();
            }
        }
    }
}

#define VOUSSOIR_INSTANTIATE(K)                                                                 \
    template K::Square dashpots_of<K>(const Model&, const BlockFace&, const K::Matrix&);        \
    template void add_boundary_forces(const Model&, const Stage&, const State&, double, double, \
                                      const std::vector<BlockStep<K>>&, AppliedForces<K>&);     \
    template void update_reactions(const Model&, const Stage&, const std::vector<BlockStep<K>>&, State&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
