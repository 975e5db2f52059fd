// What a bar resists with: along its axis, and across it.
#pragma once

#include <Eigen/Core>

#include "libdda/model/bar.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::step
{

/// The force of a bar in its own frame: the axis first, then what is across it.
template <int D>
struct BarForce {
    VectorIn<D> force = VectorIn<D>::Zero();    // N; along the axis > 0 pulls the ends together
    VectorIn<D> plastic = VectorIn<D>::Zero();  // m, what of the stretch does not come back
    MatrixIn<D> tangent = MatrixIn<D>::Zero();  // N/m, symmetric, >= 0
};

/// The force at a stretch, `plastic` that of before. Its work has a potential, which is convex.
template <int D>
BarForce<D> bar_force(const Bar& bar, const VectorIn<D>& stretch, const VectorIn<D>& plastic);

/// The force in a step: the share `end_share` of that at its end, and the rest of the mean over the way from the
/// one stretch to the other, which takes from the motion what the potential gains. Plastic is that at its end.
template <int D>
BarForce<D> bar_force_in_step(const Bar& bar, const VectorIn<D>& start, const VectorIn<D>& end,
                              const VectorIn<D>& plastic, double end_share);

/// What its springs store with a force [J].
template <int D>
double bar_energy(const Bar& bar, const VectorIn<D>& force);

/// A bar between two blocks somewhere.
template <int D>
struct PlacedBar {
    VectorIn<D> end_a = VectorIn<D>::Zero(), end_b = VectorIn<D>::Zero();  // m
    VectorIn<D> stretch = VectorIn<D>::Zero();                             // m, in its own frame
    MatrixIn<D> frame = MatrixIn<D>::Zero();  // its axis and what is across, in columns; of a rod the axis alone
};

/// @param a where block a is; @param b where block b is
template <int D>
PlacedBar<D> place_bar(const Bar& bar, const PoseIn<D>& a, const PoseIn<D>& b);

/// What the state has of each bar: its plastic stretch, and whether it has left its hole.
template <int D>
constexpr int numbers_per_bar = D + 1;

/// The plastic stretch that a state has of a bar [m].
template <int D>
VectorIn<D> plastic_stretch(const State& state, std::size_t bar)
{
    return VectorIn<D>(state.bars.data() + numbers_per_bar<D> * bar);
}

/// Whether a dowel has left its hole.
template <int D>
bool is_out(const State& state, std::size_t bar)
{
    return state.bars[numbers_per_bar<D> * bar + D] != 0;
}

/// The energy in the bars of a state [J].
double bars_energy(const Model& model, const State& state);

}  // namespace voussoir::step
