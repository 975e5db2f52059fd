// Steps that become shorter where they take too much of the energy that is put in.
#pragma once

#include <vector>

#include "libdda/run/progress.h"

namespace voussoir::driver
{

/// Half the mass of all that moves times the square of the fastest velocity of the stage's motions [J]: what they
/// put in is of this size in the end.
double energy_of_motions(const Model& model, const Stage& stage);

/// Halves the steps of a stage whose time_step is automatic before it begins, where the structure as it has come
/// to rest vibrates otherwise than as it was drawn.
void suit_to_vibrations(const std::vector<Stage>& stages, int stage, RunProgress& progress);

/// Halves the steps of a stage whose time_step is automatic as soon as what the integrator, the joints that close
/// within steps or contacts found anew have taken is half of its limit of trust, and again when half of what is
/// left of the limit then has been taken. Before a tenth of what the motions will put in is there, that counts as
/// put in.
/// @param motions energy_of_motions() [J]
void shorten_where_steps_take_much(const Stage& stage, double motions, RunProgress& progress);

/// How long the steps of a stage are at most by now [s].
double longest_so_far(const Stage& stage, const RunPosition& position);

}  // namespace voussoir::driver
