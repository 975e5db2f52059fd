#include "libdda/step/bold_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdda/step/unbalance.h"

namespace voussoir::step
{

namespace
{

constexpr int patience = 3;              // steps that may be on trial
constexpr double enough = 0.5;           // of the residual at the start of the trial
constexpr double too_much = 10;          // times the residual: a step that leaves more is relaxed first
constexpr double no_less = 1;            // times the residual, that it may leave then; else it is not taken
constexpr std::size_t few_changes = 8;   // points
constexpr double some_changes = 0.005;   // of the points, as long as no trial has failed
constexpr int longer_pause = 2;          // times the pause before
constexpr double wanted_residual = 0.5;  // of the tolerance: what the linear solver is asked for
constexpr double finest = 1e-2, coarsest = 0.1;  // of that residual
// In a large scene, where another linear solve is dearer than to look at several places along a step:
constexpr double changes_in_large = 0.02;  // of the points, whatever has failed
constexpr double fall = 0.8;               // times the residual, that a part of a step may leave
constexpr int most_halvings = 3;           // of a step

/// Worst residual / tolerance, of what was evaluated last.
template <class K>
double worst_residual(double tolerance, const StepSystem<K>& system)
{
    return system.residual.allFinite() ? unbalance(system, tolerance).worst
                                       : std::numeric_limits<double>::infinity();
}

/// The same with the exact bound at system.d; infinite where a block inverts.
template <class K>
double evaluate_worst(int threads, double tolerance, StepSystem<K>& system)
{
    evaluate_contacts(system.d, FrictionBound::exact, threads, system.contacts);
    if (!evaluate_residual(system.d, system)) return std::numeric_limits<double>::infinity();
    return worst_residual(tolerance, system);
}

}  // namespace

template <class K>
bool BoldSteps<K>::have_failed(double worst, StepSystem<K>& system)
{
    if (on_trial_ == 0) return false;
    if (worst < enough * worst_at_start_) {
        on_trial_ = 0;
        return false;
    }
    if (on_trial_ < patience) return false;
    system.d = start_;
    refuse();
    return true;
}

template <class K>
bool BoldSteps<K>::are_due(std::size_t changes, const StepSystem<K>& system)
{
    if (pause_ > 0) {
        --pause_;
        return false;
    }
    const double share = is_large(system) ? changes_in_large : all_held_ ? some_changes : 0;
    const double allowed =
        static_cast<double>(few_changes) + share * static_cast<double>(system.contacts.points.size());
    return on_trial_ > 0 || static_cast<double>(changes) <= allowed;
}

template <class K>
bool BoldSteps<K>::go(double share, const StepControl& control, double tolerance, double worst,
                      StepSystem<K>& system)
{
    system.d = system.trial + share * system.direction;
    const double allowed = (share < 1 ? fall : no_less) * worst;
    const double left = evaluate_worst(control.threads, tolerance, system);
    if (left <= (is_large(system) ? allowed : too_much * worst)) return true;
    if (!std::isfinite(left)) return false;
    system.relaxation.sweep(tolerance, left, system);
    system.local.improve(tolerance, system);
    return worst_residual(tolerance, system) <= allowed;
}

template <class K>
bool BoldSteps<K>::take(const StepControl& control, double tolerance, double worst, bool many_changes,
                        StepSystem<K>& system, StepReport& report)
{
    if (on_trial_ == 0) {
        start_ = system.d;
        worst_at_start_ = worst;
    }
    if (on_trial_ > 0 || many_changes) system.relaxation.sweep(tolerance, worst, system);
    if (!system.coupling.gather(system)) return false;
    ++report.open_close_iterations;
    const double linear = std::clamp(wanted_residual / worst, finest, coarsest);
    if (system.coupling.solve_direction(control, linear, system, report)) {
        system.trial = system.d;
        const int halvings = is_large(system) ? most_halvings : 0;
        double share = 1;
        for (int i = 0; i <= halvings; ++i, share /= 2) {
            if (!go(share, control, tolerance, worst, system)) continue;
            ++on_trial_;
            return true;
        }
        system.d = system.trial;
        evaluate_worst(control.threads, tolerance, system);
    }
    refuse();
    return false;
}

// What was on trial stays as it is: the potential leads on from anywhere.
template <class K>
void BoldSteps<K>::refuse()
{
    on_trial_ = 0;
    pause_ = next_pause_;
    next_pause_ *= longer_pause;
    all_held_ = false;
}

#define VOUSSOIR_INSTANTIATE(K) template class BoldSteps<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
