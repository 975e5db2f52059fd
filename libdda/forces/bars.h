// Bars in a step: their forces, their stiffness, and what they store and lose.
// Source: docs/method.md, Bars.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "libdda/block/block_step.h"
#include "libdda/forces/bar_law.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/solve/block_matrix.h"

namespace voussoir::step
{

/// A bar in a step.
template <class K>
struct BarStep {
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;

    const Bar* bar = nullptr;                   // of the model
    std::size_t index = 0;                      // there
    Vector lever_a = Vector::Zero();            // m, in the middle of the step, of the points at which it pulls
    Vector lever_b = Vector::Zero();            // m
    Matrix frame = Matrix::Zero();              // of a dowel, there
    Vector stretch_start = Vector::Zero();      // m, in its frame
    Vector stretch_predicted = Vector::Zero();  // m, of a dowel if D = 0
    Vector line_start = Vector::Zero();         // m, of a rod from end to end
    Vector line_predicted = Vector::Zero();     // m, if D = 0
    Vector plastic = Vector::Zero();            // m, at the start of the step
    Vector force = Vector::Zero();    // N, in its frame, as the integrator blends it, at the last evaluation
    Vector pull = Vector::Zero();     // N, on block a
    Matrix springs = Matrix::Zero();  // N/m, of the pull
};

/// All of the model that hold. The verbs are those of other_forces.h.
template <class K>
struct Bars {
    std::vector<BarStep<K>> steps;
    double end_share = 0;  // of their forces, taken at the end of the step
};

template <class K>
void begin_forces(const Model& model, const Stage& stage, const State& state, double h, double end_time,
                  std::vector<BlockStep<K>>& blocks, Bars<K>& bars);
template <class K>
void add_pairs(const std::vector<BlockStep<K>>& blocks, const Bars<K>& bars,
               std::vector<std::pair<int, int>>& pairs);
template <class K>
void note_tied(const std::vector<BlockStep<K>>& blocks, const Bars<K>& bars, std::vector<char>& tied);
template <class K>
void add_forces(const Eigen::VectorXd& d, const std::vector<BlockStep<K>>& blocks, Bars<K>& bars,
                Eigen::VectorXd& forces, std::vector<double>& load);
template <class K>
void add_stiffness(const std::vector<BlockStep<K>>& blocks, const Bars<K>& bars, solve::BlockMatrix& matrix);
/// The bars of `state` are those of the start of the step.
template <class K>
void book_forces(const State& state, const std::vector<BlockStep<K>>& blocks, const Eigen::VectorXd& d, double h,
                 const Bars<K>& bars, EnergyLedger& energy);
/// What of bars is plastic, and which have left their holes.
template <class K>
void update_forces(const Model& model, const Stage& stage, const std::vector<BlockStep<K>>& blocks,
                   const Bars<K>& bars, State& state);

}  // namespace voussoir::step
