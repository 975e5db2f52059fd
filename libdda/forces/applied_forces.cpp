#include "libdda/forces/applied_forces.h"

#include <Eigen/LU>

#include "libdda/block/ground_velocity.h"
#include "libdda/forces/other_forces.h"
#include "libdda/forces/side_ties.h"
#include "libdda/forces/viscous_boundary.h"

namespace voussoir::step
{

namespace
{

/// a M (velocity relative to the ground), of one block.
template <class K>
AppliedForce<K> mass_damping(const Stage& stage, int block, double rate, double h,
                             const typename K::Vector& ground_start, const typename K::Vector& ground_end,
                             const BlockStep<K>& step)
{
    const double end = end_share(stage);
    AppliedForce<K> force;
    force.kind = AppliedForce<K>::Kind::damping;
    force.block = block;
    const typename K::Square mass = 0.5 * h * h * step.inertia;
    typename K::Unknowns ground = K::Unknowns::Zero();
    ground.template head<K::dimension>() = 0.5 * (1 - end) * (ground_start + ground_end) + end * ground_end;
    force.resistance = (1 + end) * rate / h * mass;
    force.constant = -rate * (mass * (blended_velocity(step, end, h) - ground));
    force.ground_move = 0.5 * h * (ground_start + ground_end);
    return force;
}

template <class K>
void add_mass_damping(const Model& model, const Stage& stage, double h, double end_time,
                      const std::vector<BlockStep<K>>& blocks, AppliedForces<K>& forces)
{
    if (!is_motion(stage)) return;
    bool any = false;
    for (const BlockMaterial& material : model.materials) any = any || material.rayleigh.of_mass != 0;
    if (!any) return;
    using Vector = typename K::Vector;
    const Vector start = from_space<K::dimension>(ground_velocity(model, stage, end_time - h));
    const Vector end = from_space<K::dimension>(ground_velocity(model, stage, end_time));
    for (int b = 0; b < static_cast<int>(blocks.size()); ++b) {
        const double rate = model.materials[model.blocks[b].material].rayleigh.of_mass;
        if (rate != 0 && blocks[b].row >= 0)
            forces.own.push_back(mass_damping<K>(stage, b, rate, h, start, end, blocks[b]));
    }
}

/// Work of a force on the way that its block went [J]: of the unknowns' last part on (A1 - A0) A^-1.
template <class K>
double work_of(const typename K::Unknowns& force, const State& state, int b, const BlockStep<K>& block,
               const typename K::Vector& centroid_moved, const typename K::Unknowns& path)
{
    double work = force.template head<K::dimension>().dot(centroid_moved);
    if constexpr (K::deformable) {
        const auto end = pose_in<K::dimension>(K::kinematics, state, b);
        const typename K::Matrix way = (end.map - block.start.map) * block.predicted.map.inverse();
        work += K::gradient(force).cwiseProduct(way).sum();
    } else {
        work += force.template tail<K::spins>().dot(path.template tail<K::spins>());
    }
    return work;
}

/// Calls visit(row, column, coupling) for what couples two blocks with unknowns symmetrically, once for each.
template <class K, class Visit>
void for_each_mutual(const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& applied, const Visit& visit)
{
    for (const Coupling<K>& coupling : applied.couplings) {
        const int row = blocks[coupling.block].row, column = blocks[coupling.other].row;
        if (coupling.mutual && row > column && column >= 0) visit(row, column, coupling);
    }
}

}  // namespace

template <class K>
void begin_forces(const Model& model, const Stage& stage, const State& state, double h, double end_time,
                  std::vector<BlockStep<K>>& blocks, AppliedForces<K>& forces)
{
    forces.own.clear();
    forces.couplings.clear();
    forces.ties.clear();
    add_boundary_forces(model, stage, state, h, end_time, blocks, forces);
    add_side_ties(model, stage, blocks, forces);
    add_mass_damping(model, stage, h, end_time, blocks, forces);
    for (const AppliedForce<K>& force : forces.own) blocks[force.block].base += force.resistance;
}

template <class K>
void add_pairs(const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& applied,
               std::vector<std::pair<int, int>>& pairs)
{
    for_each_mutual(blocks, applied, [&](int row, int column, const Coupling<K>& /*coupling*/) {
        pairs.emplace_back(row, column);
    });
}

template <class K>
void note_tied(const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& applied, std::vector<char>& tied)
{
    const auto tie = [&](int block) {
        if (const int row = blocks[block].row; row >= 0) tied[row] = true;
    };
    for (const AppliedForce<K>& force : applied.own) tie(force.block);
    for (const Coupling<K>& coupling : applied.couplings) tie(coupling.block), tie(coupling.other);
}

template <class K>
void add_forces(const Eigen::VectorXd& d, const std::vector<BlockStep<K>>& blocks, AppliedForces<K>& applied,
                Eigen::VectorXd& forces, std::vector<double>& load)
{
    constexpr int n = K::unknowns;
    for (const AppliedForce<K>& one : applied.own) {
        const int row = blocks[one.block].row;
        if (row < 0) continue;
        const typename K::Unknowns force = applied.at(one, blocks, d);
        forces.segment<n>(n * row) += force;
        load[row] += force.template head<K::dimension>().norm();
    }
}

template <class K>
void add_stiffness(const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& applied,
                   solve::BlockMatrix& matrix)
{
    for_each_mutual(blocks, applied, [&](int row, int column, const Coupling<K>& coupling) {
        Eigen::Map<typename K::Square>(matrix.block(matrix.position(row, column))) -= coupling.matrix;
    });
}

template <class K>
void book_forces(const State& state, const std::vector<BlockStep<K>>& blocks, const Eigen::VectorXd& d, double h,
                 const AppliedForces<K>& applied, EnergyLedger& energy)
{
    constexpr int n = K::unknowns;
    book_side_ties(state, blocks, applied, energy);
    for (const AppliedForce<K>& one : applied.own) {
        const BlockStep<K>& block = blocks[one.block];
        if (block.row < 0) continue;
        const typename K::Unknowns own = d.segment<n>(n * block.row), force = applied.at(one, blocks, d);
        const typename K::Unknowns path = h * block.velocity + own;
        const typename K::Vector moved =
            pose_in<K::dimension>(K::kinematics, state, one.block).centroid - block.start.centroid;
        const double work = work_of<K>(force, state, one.block, block, moved, path);
        (block.jumps ? energy.impact : energy.algorithmic_rotation) -= force.dot(path) - work;
        if (one.kind == AppliedForce<K>::Kind::boundary) {
            energy.boundary_work += work;
        } else if (one.kind == AppliedForce<K>::Kind::damping) {
            const double of_ground = force.template head<K::dimension>().dot(one.ground_move);
            energy.foundation_work += of_ground;
            energy.damping_material += of_ground - work;
        }
    }
}

template <class K>
void update_forces(const Model& model, const Stage& stage, const std::vector<BlockStep<K>>& blocks,
                   const AppliedForces<K>& /*applied*/, State& state)
{
    update_reactions(model, stage, blocks, state);
}

#define VOUSSOIR_INSTANTIATE(K) VOUSSOIR_INSTANTIATE_FORCES(AppliedForces, K)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
