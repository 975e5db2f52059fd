// Whether rigid blocks stand: whether forces within friction can balance their loads, or along which mechanism
// they begin to move.
#pragma once

#include <vector>

#include "libdda/limit/limit_problem.h"
#include "libdda/limit/springs.h"

namespace voussoir::limit
{

/// Whether blocks stand under their dead load.
enum class Standing {
    balanced,   // forces within friction balance it
    mechanism,  // none do: whatever the history of the joints, blocks begin to move
    unknown,    // the iteration did not end
};

/// Of blocks under their dead load.
struct Balance {
    Standing standing = Standing::unknown;
    double acceleration = 0;                // -, of the block that gains speed fastest, over that of its own load
    std::vector<BlockVelocity> velocities;  // (blocks) of a mechanism: m/s and rad/s of a size without meaning
    double dissipation = 0;                 // W, of the velocities, by friction, strength and bars that yield
    int iterations = 0;                     // of Newton
};

/// Whether forces within the cones of friction balance the dead load of every block. If none do, blocks move, even
/// if joints that slide open by the angle of friction; where some do, blocks may move all the same, for friction
/// of real joints does not depend on whether they open [Drucker1954].
///
/// Sought is the motion of least energy of blocks on springs that never bear more than friction allows: a convex
/// problem whose one answer Newton's method finds in some ten systems of equations, each of six unknowns a block.
/// What the springs cannot balance moves the blocks against a mass that falls to a billionth of the springs.
Balance balance_of(const LimitProblem& problem);

/// The same of joints that slide without opening: their friction does no work against normal forces, it acts as a
/// cohesion, mu times the normal force of the state sought [GilbertCasapullaAhmed2006]. Normal forces follow each
/// other, averaged, from those of balance_of on. `balanced`: they came to a state of equilibrium within Coulomb's
/// friction. `mechanism`: they did not, so that stones may slide under a load that balance_of balances; statics
/// does not determine their normal forces, and other ones may stand. `unknown` of bonded joints, which are
/// brittle.
/// @param problem with all points of its faces: springs press on a face as an elastic bed does, so that it turns
/// under the couple that such a pressure allows
Standing standing_without_dilatancy(const LimitProblem& problem);

}  // namespace voussoir::limit
