#include "libdda/forces/bars.h"

#include <algorithm>
#include <limits>

#include "libdda/block/orthonormal.h"
#include "libdda/forces/other_forces.h"

namespace voussoir::step
{

namespace
{

template <class K>
typename K::Vector moved(const Eigen::VectorXd& d, const BlockStep<K>& block, const typename K::Vector& lever)
{
    if (block.row < 0) return K::Vector::Zero();
    return K::displacement(d.segment<K::unknowns>(K::unknowns * block.row), lever);
}

/// What the momentum balance takes for the way of a point of a block [m].
template <class K>
typename K::Vector balanced_way(const Eigen::VectorXd& d, double h, const BlockStep<K>& block,
                                const typename K::Vector& lever)
{
    typename K::Vector centroid = block.predicted.centroid - block.start.centroid;
    if (block.row < 0) return centroid;
    typename K::Unknowns path = h * block.velocity + d.segment<K::unknowns>(K::unknowns * block.row);
    path.template head<K::dimension>() =
        centroid + block.ballistic + d.segment<K::dimension>(K::unknowns * block.row);
    return K::displacement(path, lever);
}

/// A bar at the end of an accepted step.
template <class K>
struct BarEnd {
    PlacedBar<K::dimension> placed;
    BarForce<K::dimension> force;
    bool is_out = false;
};

template <class K>
BarEnd<K> end_of(const BarStep<K>& step, const State& state)
{
    constexpr int D = K::dimension;
    const Bar& bar = *step.bar;
    BarEnd<K> end;
    end.placed = place_bar<D>(bar, pose_in<D>(K::kinematics, state, bar.block_a),
                              pose_in<D>(K::kinematics, state, bar.block_b));
    end.force = bar_force<D>(bar, end.placed.stretch, step.plastic);
    end.is_out = end.placed.stretch[0] > bar.hold;
    return end;
}

/// A rod pulls along the line between its ends, wherever they go. Its direction is such that it times the way of
/// the ends is exactly what the mean force works on: the change of the length.
template <class K>
void pull_rod(const typename K::Vector& apart, double end_share, BarStep<K>& step)
{
    constexpr int D = K::dimension;
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    const Vector line = step.line_predicted + apart;
    Vector stretch = Vector::Zero();
    stretch[0] = line.norm() - step.bar->length;
    const BarForce<D> force =
        bar_force_in_step<D>(*step.bar, step.stretch_start, stretch, step.plastic, end_share);
    // Where forces are those of the end of the step, so is their direction; else the share that damps the length
    // would damp the swinging too.
    const double from_start = end_share == 1 ? 0 : 1;
    const double lengths = from_start * step.line_start.norm() + line.norm();
    const Vector axis =
        (from_start * step.line_start + line) / std::max(lengths, std::numeric_limits<double>::min());
    const Matrix along = axis * axis.transpose();
    step.force = force.force;
    step.pull = force.force[0] * axis;
    step.springs = force.tangent(0, 0) * along;
    if (force.force[0] > 0) step.springs += force.force[0] / lengths * (Matrix::Identity() - along);
}

template <class K>
void pull_dowel(const typename K::Vector& apart, double end_share, BarStep<K>& step)
{
    constexpr int D = K::dimension;
    const typename K::Vector stretch = step.stretch_predicted + step.frame.transpose() * apart;
    const BarForce<D> force =
        bar_force_in_step<D>(*step.bar, step.stretch_start, stretch, step.plastic, end_share);
    step.force = force.force;
    step.pull = step.frame * force.force;
    step.springs = step.frame * force.tangent * step.frame.transpose();
}

}  // namespace

template <class K>
void begin_forces(const Model& model, const Stage& stage, const State& state, double /*h*/, double /*end_time*/,
                  std::vector<BlockStep<K>>& blocks, Bars<K>& bars)
{
    constexpr int D = K::dimension;
    using Vector = typename K::Vector;
    bars.end_share = end_share(stage);
    bars.steps.clear();
    for (std::size_t i = 0; i < model.bars.size(); ++i) {
        if (is_out<D>(state, i)) continue;
        const Bar& bar = model.bars[i];
        const BlockStep<K>&a = blocks[bar.block_a], &b = blocks[bar.block_b];
        const PlacedBar<D> start = place_bar<D>(bar, a.start, b.start),
                           predicted = place_bar<D>(bar, a.predicted, b.predicted);
        BarStep<K>& step = bars.steps.emplace_back();
        step.bar = &bar;
        step.index = i;
        if (!bar.is_rod) step.frame = orthonormal<D>(typename K::Matrix(0.5 * (start.frame + predicted.frame)));
        // The frame of a dowel turns with block a: its force there is at the point of a that the other end is at.
        const Vector middle_b = 0.5 * (start.end_b + predicted.end_b),
                     middle_a = bar.is_rod ? Vector(0.5 * (start.end_a + predicted.end_a)) : middle_b;
        step.lever_a = middle_a - 0.5 * (a.start.centroid + a.predicted.centroid);
        step.lever_b = middle_b - 0.5 * (b.start.centroid + b.predicted.centroid);
        step.stretch_start = start.stretch;
        step.stretch_predicted = predicted.stretch;
        step.line_start = start.end_b - start.end_a;
        step.line_predicted = predicted.end_b - predicted.end_a;
        step.plastic = plastic_stretch<D>(state, i);
    }
}

template <class K>
void add_forces(const Eigen::VectorXd& d, const std::vector<BlockStep<K>>& blocks, Bars<K>& bars,
                Eigen::VectorXd& forces, std::vector<double>& load)
{
    constexpr int n = K::unknowns;
    using Vector = typename K::Vector;
    for (BarStep<K>& step : bars.steps) {
        const BlockStep<K>&a = blocks[step.bar->block_a], &b = blocks[step.bar->block_b];
        const Vector apart = moved(d, b, step.lever_b) - moved(d, a, step.lever_a);
        if (step.bar->is_rod)
            pull_rod(apart, bars.end_share, step);
        else
            pull_dowel(apart, bars.end_share, step);
        const auto add = [&](const BlockStep<K>& block, const Vector& lever, const Vector& force) {
            if (block.row < 0) return;
            typename K::Unknowns on = K::Unknowns::Zero();
            K::add_force(on, lever, force);
            forces.segment<n>(n * block.row) += on;
            load[block.row] += force.norm();
        };
        add(a, step.lever_a, step.pull);
        add(b, step.lever_b, Vector(-step.pull));
    }
}

template <class K>
void note_tied(const std::vector<BlockStep<K>>& blocks, const Bars<K>& bars, std::vector<char>& tied)
{
    for (const BarStep<K>& step : bars.steps)
        for (const int block : {step.bar->block_a, step.bar->block_b})
            if (blocks[block].row >= 0) tied[blocks[block].row] = true;
}

template <class K>
void add_pairs(const std::vector<BlockStep<K>>& blocks, const Bars<K>& bars,
               std::vector<std::pair<int, int>>& pairs)
{
    for (const BarStep<K>& step : bars.steps) {
        const int a = blocks[step.bar->block_a].row, b = blocks[step.bar->block_b].row;
        if (a >= 0 && b >= 0) pairs.emplace_back(std::max(a, b), std::min(a, b));
    }
}

template <class K>
void add_stiffness(const std::vector<BlockStep<K>>& blocks, const Bars<K>& bars, solve::BlockMatrix& matrix)
{
    using Matrix = typename K::Matrix;
    using Vector = typename K::Vector;
    for (const BarStep<K>& step : bars.steps) {
        const int a = blocks[step.bar->block_a].row, b = blocks[step.bar->block_b].row;
        const auto add = [&](int row, int column, const Vector& on, const Vector& from, const Matrix& with) {
            const int at = row == column ? matrix.diagonal(row) : matrix.position(row, column);
            typename K::Square block = K::Square::Zero();
            K::add_stiffness(block, on, from, with);
            Eigen::Map<typename K::Square>(matrix.block(at)) += block;
        };
        if (a >= 0) add(a, a, step.lever_a, step.lever_a, step.springs);
        if (b >= 0) add(b, b, step.lever_b, step.lever_b, step.springs);
        if (a < 0 || b < 0) continue;
        if (a > b)
            add(a, b, step.lever_a, step.lever_b, Matrix(-step.springs));
        else
            add(b, a, step.lever_b, step.lever_a, Matrix(-step.springs));
    }
}

template <class K>
void book_forces(const State& state, const std::vector<BlockStep<K>>& blocks, const Eigen::VectorXd& d, double h,
                 const Bars<K>& bars, EnergyLedger& energy)
{
    constexpr int D = K::dimension;
    using Vector = typename K::Vector;
    for (const BarStep<K>& step : bars.steps) {
        const Bar& bar = *step.bar;
        const BlockStep<K>&a = blocks[bar.block_a], &b = blocks[bar.block_b];
        const BarEnd<K> end = end_of(step, state);
        const double before = bar_energy<D>(bar, bar_force<D>(bar, step.stretch_start, step.plastic).force),
                     stored = bar_energy<D>(bar, end.force.force);
        const double taken = bar.is_rod ? step.pull.dot(end.placed.end_b - end.placed.end_a - step.line_start)
                                        : step.force.dot(end.placed.stretch - step.stretch_start);
        const double yielding = end.force.force.dot(end.force.plastic - step.plastic);
        (end.is_out ? energy.fracture : energy.strain) += stored;
        energy.yielding += yielding;
        energy.algorithmic += taken - (stored - before) - yielding;
        const Vector way_a = balanced_way(d, h, a, step.lever_a), way_b = balanced_way(d, h, b, step.lever_b);
        (a.jumps || b.jumps ? energy.impact : energy.algorithmic_rotation) -= step.pull.dot(way_a - way_b) + taken;
        if (a.row < 0) energy.foundation_work -= step.pull.dot(way_a);
        if (b.row < 0) energy.foundation_work += step.pull.dot(way_b);
    }
}

template <class K>
void update_forces(const Model& /*model*/, const Stage& /*stage*/, const std::vector<BlockStep<K>>& /*blocks*/,
                   const Bars<K>& bars, State& state)
{
    constexpr int D = K::dimension;
    for (const BarStep<K>& step : bars.steps) {
        const BarEnd<K> end = end_of(step, state);
        double* stored = state.bars.data() + numbers_per_bar<D> * step.index;
        for (int k = 0; k < D; ++k) stored[k] = end.force.plastic[k];
        stored[D] = end.is_out ? 1 : 0;
    }
}

#define VOUSSOIR_INSTANTIATE(K) VOUSSOIR_INSTANTIATE_FORCES(Bars, K)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
