// The factor of a live load at which rigid blocks become a mechanism.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "libdda/limit/balance.h"
#include "libdda/limit/limit_problem.h"

namespace voussoir::limit
{

/// What becomes of blocks under a live load that grows.
enum class UnderLoad {
    limited,       // they bear it up to a factor
    falls_before,  // they do not stand under the dead load alone
    bears_all,     // no factor that was tried moves them
    unknown,       // an iteration did not end
};

struct CollapseLoad {
    UnderLoad outcome = UnderLoad::unknown;
    double factor = 0;                      // -, of the live load; of `limited` alone
    std::vector<BlockVelocity> velocities;  // (blocks) of the mechanism: m/s and rad/s of a size without meaning
};

/// The greatest factor for which forces within the cones of friction balance dead + factor x live on every block,
/// to some 1e-5 of itself: the limit if joints that slide open by the angle of friction; no factor beyond it has
/// an equilibrium.
///
/// Each mechanism names the factor at which the loads do no more work on it than it takes, and the next is sought
/// there: the factors fall until blocks stand.
/// @param before_each called before each search for a balance; what it throws ends this
CollapseLoad collapse_load(
    const LimitProblem& problem, const std::function<void()>& before_each = [] {});

/// The factor alone, if there is one.
std::optional<double> limit_factor(const LimitProblem& problem);

/// Factors between which blocks begin to slide whose joints do not open while they slide.
struct SlidingBracket {
    double stands_at = 0, slides_at = 0;  // -; of the live load
};

/// Where a state of equilibrium of standing_without_dilatancy is no longer found, by bisection to 0.2 % of the
/// associated factor; slides_at is that factor itself where one is found up to there. None where none is found
/// under the dead load alone, or where joints are bonded.
/// @param problem with all points of its faces @param associated of collapse_load
/// @param before_each as above
std::optional<SlidingBracket> sliding_bracket(
    const LimitProblem& problem, double associated, const std::function<void()>& before_each = [] {});

}  // namespace voussoir::limit
