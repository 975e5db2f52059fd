#include "libdda/analysis/bar_forces.h"

#include <algorithm>

#include "libdda/forces/bar_law.h"

namespace voussoir
{

namespace
{

template <int D>
BarNow bar_now(const Model& model, const State& state, std::size_t index)
{
    const Bar& bar = model.bars[index];
    const step::PlacedBar<D> placed = step::place_bar<D>(bar, pose_in<D>(model.kinematics, state, bar.block_a),
                                                         pose_in<D>(model.kinematics, state, bar.block_b));
    const VectorIn<D> plastic = step::plastic_stretch<D>(state, index);
    const VectorIn<D> force = step::bar_force<D>(bar, placed.stretch, plastic).force;
    VectorIn<D> at_start = VectorIn<D>::Zero();
    if (bar.prestress != 0) at_start[0] = -bar.prestress / bar.axial;
    BarNow now;
    now.is_out = step::is_out<D>(state, index);
    if (!now.is_out) {
        now.axial = force[0];
        now.shear = force.template tail<D - 1>().norm();
    }
    now.elongation = placed.stretch[0];
    now.slide = placed.stretch.template tail<D - 1>().norm();
    now.yielded = (plastic - at_start).norm();
    return now;
}

}  // namespace

std::vector<BarNow> bars_now(const Model& model, const State& state)
{
    std::vector<BarNow> bars;
    bars.reserve(model.bars.size());
    for (std::size_t i = 0; i < model.bars.size(); ++i)
        bars.push_back(is_planar(model.kinematics) ? bar_now<2>(model, state, i) : bar_now<3>(model, state, i));
    return bars;
}

void note_bars(const Model& model, const State& state, RunReport& report)
{
    if (model.bars.empty()) return;
    report.bars.resize(model.bars.size());
    const std::vector<BarNow> bars = bars_now(model, state);
    for (std::size_t i = 0; i < bars.size(); ++i) {
        BarPeaks& peaks = report.bars[i];
        peaks.tension = std::max(peaks.tension, bars[i].axial);
        peaks.compression = std::max(peaks.compression, -bars[i].axial);
        peaks.shear = std::max(peaks.shear, bars[i].shear);
        if (!peaks.out && bars[i].is_out) peaks.out = state.time;
        if (!peaks.yielded && bars[i].yielded > 0) peaks.yielded = state.time;
    }
}

}  // namespace voussoir
