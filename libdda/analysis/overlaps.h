// How far blocks are within one another, against how thick they are: as drawn and in a run.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Contacts are found from faces that overlap a little; deeper than this share of a block's width the nearest face
/// may be the wrong one, and the block goes out on the other side. A run stops there, and does not begin.
constexpr double deepest_share = 0.1;

/// Least width of every block over the directions of its faces [m]: the thickness of a slab, the shorter side of a
/// slender stone. Of glued parts that of the whole stone, over the directions of its own faces: how it was cut
/// into parts is no property of it.
std::vector<double> least_widths(const Model& model);

/// Two blocks within one another where the model has them.
struct DrawnOverlap {
    int block_a = 0, block_b = 0;  // indices into Model::blocks, a < b
    double depth = 0;              // m, beyond the model's fit_tolerance
    double share = 0;              // -, of the thinner block's least width
};

/// What overlaps are judged by in a run.
struct OverlapWatch {
    OverlapWatch() = default;
    /// As the model is drawn.
    explicit OverlapWatch(const Model& model);
    /// @param start state at the start of the run
    OverlapWatch(const Model& model, State start);

    std::vector<double> widths;                   // least_widths
    std::map<std::pair<int, int>, double> drawn;  // m, of pairs a < b that overlap at the start
};

/// All pairs of blocks that overlap as drawn by more than the model's fit_tolerance, ascending.
std::vector<DrawnOverlap> drawn_overlaps(const OverlapWatch& watch);

/// Keeps the deepest overlaps of the run in `report.deepest` and `report.max_penetration`.
/// A stone that slides over the edge of another is found on the side of that edge before it is above it, and goes
/// on within the step: where contact is a strip between an edge of either stone, the overlap is no deeper than the
/// strip is wide, for by that shift the stones would part.
void note_overlap(const Model& model, const OverlapWatch& watch, const State& state, RunReport& report);

}  // namespace voussoir
