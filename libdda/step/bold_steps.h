// Whole steps along the whole tangent, the part that is not symmetric included: Newton's own, which nothing
// shortens.
//
// No potential falls along them, and the residual may rise before it falls: where a stone comes to slide or to
// part a few are left far out of balance, of thousands that have found theirs. So a bold step is taken on trust,
// and only if some together have not brought the residual down does the iteration return to where they began: a
// watchdog ([ChamberlainPowell1982]). In a large scene, where the few that lead astray are few among thousands, a
// step that was too bold is not thrown away with its linear solve: half of it, or less, may do, and none is taken
// that leaves more than there was. Source: docs/numerics.md 3.
#pragma once

#include <Eigen/Core>

#include "libdda/model/report.h"
#include "libdda/model/step_control.h"
#include "libdda/step/step_system.h"

namespace voussoir::step
{

/// The bold steps of one iteration, and whether they may be trusted.
template <class K>
class BoldSteps
{
 public:
    /// Judges what bold steps on trial have brought. @param worst residual / tolerance where they led
    /// @returns true if they have failed: system.d is then where they began, and nothing is evaluated there
    bool have_failed(double worst, StepSystem<K>& system);

    /// Whether one is due. To be asked once in an iteration.
    /// @param changes contact points that have changed their state in the last one
    bool are_due(std::size_t changes, const StepSystem<K>& system);

    /// Takes one, or in a large scene a part of one, from a residual with the exact bound, stones that are far out
    /// of balance relaxed first where many points change. @param worst residual / tolerance there, before that
    /// @returns whether it did; contacts and residual are exact at system.d in either case
    bool take(const StepControl& control, double tolerance, double worst, bool many_changes, StepSystem<K>& system,
              StepReport& report);

 private:
    /// Goes a share of system.direction from system.trial; what is far out of balance there is relaxed.
    /// @param worst residual / tolerance before stones were relaxed on the way to system.trial
    /// @returns whether it may stay there
    bool go(double share, const StepControl& control, double tolerance, double worst, StepSystem<K>& system);
    void refuse();

    int on_trial_ = 0;    // steps since start_
    int pause_ = 1;       // iterations until one may be tried
    int next_pause_ = 2;  // after steps that failed
    bool all_held_ = true;
    double worst_at_start_ = 0;
    Eigen::VectorXd start_;  // d
};

}  // namespace voussoir::step
