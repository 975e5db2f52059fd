// Limit analysis of rigid blocks by linear programming: the factor of a live load at which they become a
// mechanism.
#pragma once

#include <vector>

#include "libdda/limit/limit_problem.h"

namespace voussoir::limit
{

/// A state of equilibrium in which the blocks begin to move.
struct LimitState {
    bool found =
        false;  // else the blocks do not stand under the dead load, or under any factor, or nothing converged
    double factor = 0;                    // -, of the live load
    std::vector<Eigen::Vector3d> forces;  // (contacts) N, on block a
    double beyond_friction = 0;           // largest |shear| - friction x normal force of a contact / the dead load
    int programs = 0;                     // linear programs solved on the way
};

/// The greatest factor for which contact forces within the cones of friction balance dead + factor x live on every
/// block: the limit if joints that slide open by the angle of friction, and with Coulomb's friction no factor
/// beyond it has an equilibrium. Source: [Livesley1978].
LimitState associated_limit(const LimitProblem& problem);

/// A factor at which blocks begin to move that slide without opening.
///
/// A joint that slides at a constant distance does no work against its normal force: its friction acts as a
/// cohesion, mu times the normal force of the state sought. So linear programs with the cohesion of the last
/// normal forces, averaged, follow each other until the factor stays. Source: [GilbertCasapullaAhmed2006]. There
/// may be several such factors, for statics does not determine the normal forces of joints that rub on all sides;
/// this is the lowest of those that the iteration finds from the normal forces of the associated limit and from
/// `starts` random states of equilibrium under four fifths of it. Bonded joints are taken as dry.
LimitState non_associated_limit(const LimitProblem& problem, int starts = 20);

}  // namespace voussoir::limit
