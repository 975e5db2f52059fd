// Forces on blocks that are linear in their unknowns and no contacts: what viscous boundaries and tied sides do,
// and damping that grows with mass. A scene without them has none.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "libdda/block/block_step.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/solve/block_matrix.h"

namespace voussoir::step
{

/// constant - resistance D, on one block; and what the unknowns of another one add.
template <class K>
struct AppliedForce {
    /// In which term of the energy it goes.
    enum class Kind { boundary, damping, tie };
    Kind kind = Kind::boundary;                           // its own
    int block = 0;                                        // index into Model::blocks
    typename K::Unknowns constant = K::Unknowns::Zero();  // N, Nm, conjugate to D
    typename K::Square resistance = K::Square::Zero();    // N per unit of D, symmetric, >= 0
    typename K::Vector ground_move = K::Vector::Zero();   // m, of what the force is fixed to; of damping only
    int coupling = -1;                                    // index into AppliedForces::couplings; -1: none
    typename K::Unknowns at(const typename K::Unknowns& d) const { return constant - resistance * d; }
};

/// matrix x unknowns of another block, added to a force.
template <class K>
struct Coupling {
    int block = 0, other = 0;  // indices into Model::blocks: that the force is on, that it comes from
    bool mutual = false;       // the other one feels the transpose: the system stays symmetric
    typename K::Square matrix = K::Square::Zero();  // N per unit of D
};

/// A tie of two faces in a step: points of both as they are drawn, and the springs of each.
template <int D>
struct TieIn {
    /// A point of the one face, and the same of the other.
    struct Point {
        VectorIn<D> lever_a, lever_b;  // m, from the centroids
        MatrixIn<D> springs;           // N/m
    };
    int block_a = 0, block_b = 0;  // indices into Model::blocks
    std::vector<Point> points;
    VectorIn<D> period = VectorIn<D>::Zero();  // m, from a to b
};

/// All of a step. The verbs are those of other_forces.h.
template <class K>
struct AppliedForces {
    std::vector<AppliedForce<K>> own;
    std::vector<Coupling<K>> couplings;
    std::vector<TieIn<K::dimension>> ties;
    double end_share = 0;  // of the ties' forces, taken at the end of the step

    /// A force at the unknowns d of all rows.
    typename K::Unknowns at(const AppliedForce<K>& force, const std::vector<BlockStep<K>>& blocks,
                            const Eigen::VectorXd& d) const
    {
        constexpr int n = K::unknowns;
        typename K::Unknowns sum = force.at(d.segment<n>(n * blocks[force.block].row));
        if (force.coupling < 0) return sum;
        const Coupling<K>& coupling = couplings[force.coupling];
        if (blocks[coupling.other].row >= 0) sum += coupling.matrix * d.segment<n>(n * blocks[coupling.other].row);
        return sum;
    }
};

/// Their resistance is in the `base` of their blocks then, and no part of add_stiffness().
template <class K>
void begin_forces(const Model& model, const Stage& stage, const State& state, double h, double end_time,
                  std::vector<BlockStep<K>>& blocks, AppliedForces<K>& forces);
template <class K>
void add_pairs(const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& applied,
               std::vector<std::pair<int, int>>& pairs);
template <class K>
void note_tied(const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& applied, std::vector<char>& tied);
template <class K>
void add_forces(const Eigen::VectorXd& d, const std::vector<BlockStep<K>>& blocks, AppliedForces<K>& applied,
                Eigen::VectorXd& forces, std::vector<double>& load);
/// What is mutual; the rest is not symmetric.
template <class K>
void add_stiffness(const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& applied,
                   solve::BlockMatrix& matrix);
template <class K>
void book_forces(const State& state, const std::vector<BlockStep<K>>& blocks, const Eigen::VectorXd& d, double h,
                 const AppliedForces<K>& applied, EnergyLedger& energy);
/// The reactions of faces that are carried: State::boundary_reactions.
template <class K>
void update_forces(const Model& model, const Stage& stage, const std::vector<BlockStep<K>>& blocks,
                   const AppliedForces<K>& applied, State& state);

}  // namespace voussoir::step
