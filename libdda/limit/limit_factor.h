// The factor of a live load at which rigid blocks become a mechanism.
#pragma once

#include <optional>

#include "libdda/limit/limit_problem.h"

namespace voussoir::limit
{

/// The greatest factor for which forces within the cones of friction balance dead + factor x live on every block,
/// to some 1e-5 of itself: the limit if joints that slide open by the angle of friction; no factor beyond it has
/// an equilibrium. None where blocks do not stand under the dead load, or under any factor.
///
/// Each mechanism names the factor at which the loads do no more work on it than it takes, and the next is sought
/// there: the factors fall until blocks stand.
std::optional<double> limit_factor(const LimitProblem& problem);

}  // namespace voussoir::limit
