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

/// Sets up the bars of the model that hold; the blocks are prepared.
template <class K>
void begin_bars(const Model& model, const State& state, const std::vector<BlockStep<K>>& blocks,
                std::vector<BarStep<K>>& bars);

/// Adds their forces at the iterate d. @param forces (rows x unknowns); @param load N per row
template <class K>
void add_bar_forces(const Eigen::VectorXd& d, double end_share, const std::vector<BlockStep<K>>& blocks,
                    std::vector<BarStep<K>>& bars, Eigen::VectorXd& forces, std::vector<double>& load);

/// Rows that bars couple, the larger one first.
template <class K>
void add_bar_pairs(const std::vector<BlockStep<K>>& blocks, const std::vector<BarStep<K>>& bars,
                   std::vector<std::pair<int, int>>& pairs);

/// Adds their stiffness at the last evaluation.
template <class K>
void add_bar_stiffness(const std::vector<BlockStep<K>>& blocks, const std::vector<BarStep<K>>& bars,
                       solve::BlockMatrix& matrix);

/// Books what bars did in an accepted step; the blocks of `state` are where the step left them, its bars are not.
/// @param d all unknowns of the step
template <class K>
void book_bars(const State& state, const std::vector<BlockStep<K>>& blocks, const std::vector<BarStep<K>>& bars,
               const Eigen::VectorXd& d, double h, EnergyLedger& energy);

/// What of bars is plastic at the end of the step, and which have left their holes, into the state.
template <class K>
void update_bars(const std::vector<BarStep<K>>& bars, State& state);

}  // namespace voussoir::step
