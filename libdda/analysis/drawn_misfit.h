// How well stones fit as drawn, and how soft their joints are: what can be said of a model before it is run.
#pragma once

#include <vector>

#include "libdda/analysis/overlaps.h"
#include "libdda/model/model.h"

namespace voussoir
{

/// What two stones share or lack where their faces touch.
struct Misfit {
    double depth = 0;                // m, of the overlap or gap
    int block_a = -1, block_b = -1;  // whose it is; -1: stones fit
};

/// Largest misfits of a model's joints as drawn.
struct DrawnMisfit {
    Misfit overlap, gap;  // the deepest and the widest

    /// Tolerance within which all stones fit [m]: the larger of the two, rounded up to two digits. 0: they do fit.
    double tolerance() const;
};

/// Largest overlap and gap at the corners of joints. A joint is a contact of two faces of which a quarter or more
/// is as near as the contact search calls touching (1e-3 of either stone's size): two faces at an angle are a
/// wedge. A corner that misses by more than 1 % of the smaller stone's size, or by more than 5 % of its least
/// width, is no error of a survey and is left out; so are misfits below 1e-6 of the size.
DrawnMisfit drawn_misfit(const Model& model);

/// A stone that sinks too deep into what it stands on.
struct SoftStone {
    int block = 0;      // which it is
    double depth = 0;   // m, on the mean over its joints
    double share = 0;   // -, of the least width of the thinner of the two stones
    double factor = 0;  // by which its joints must be stiffer to be accepted
};

/// A mean settlement of more than this share of a stone's width is refused: a stone that lies askew sinks deeper
/// at its edge, where a run stops at deepest_share. On its corners a bed turns a third as much as on all of its
/// face.
constexpr double softest_share(FaceLaw face)
{
    return face == FaceLaw::corners ? deepest_share / 4 : deepest_share / 12;
}

/// Stones whose joints are too soft for self-weight under a gravity [m/s2], the highest first. Every stone is set
/// on those below it as a rigid plate on springs, from the top down: its weight and its load go to its supports as
/// their stiffnesses. Stones that hang or are wedged between others have no such supports and are not judged.
std::vector<SoftStone> too_soft_stones(const Model& model, const Eigen::Vector3d& gravity);

}  // namespace voussoir
