// What must hold in any scene, reference or not: energy is accounted for and does not appear, what stands stays
// where it is and carries its weight, no block passes through another.
#pragma once

#include "app/studies/stability/cell.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::app::studies::stability
{

/// Brings the scene to rest, keeps it there for `duration` [s] with no damping but the integrator's, and sets the
/// error: the largest of
/// - |pressure on the ground - weight| / weight after the static stage,
/// - largest displacement of a block in the dynamic stage / size of the smallest block.
/// and infinity when blocks are more than half the smallest block deep in one another. The ground is whatever is
/// held; all of it is under the structure, and nothing else touches it from the side.
void run_at_rest(const Model& model, double time_step, double duration, double g, CellRun& cell);

/// Moves the scene from `state` through `motion` and sets the error: the largest of
/// - share of the energy that is unaccounted for (the audit's residual),
/// - energy that appeared: the largest fall below nothing of what was dissipated, as a share of the energy put in
///   or there at the start,
/// - energy that contacts gave when they were found anew, between steps and with no force to account for it: the
///   same share. The integrator may well take it again; the blocks were thrown about by it all the same,
/// and infinity when blocks are more than half the smallest block deep in one another.
/// @param lowest no centroid of a block that has unknowns may fall below this height [m]
void run_audited(const Model& model, const Stage& motion, double lowest, State& state, CellRun& cell);

/// Sets the error of a cell whose blocks went more than half the smallest block into one another to infinity: the
/// nearest way out is then no longer the way in, and what came out means nothing.
void refuse_interpenetration(const Model& model, CellRun& cell);

/// size_of the smallest block that has unknowns [m].
double smallest_size(const Model& model);

}  // namespace voussoir::app::studies::stability
