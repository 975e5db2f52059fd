#include "libdda/step/advance.h"

#include <optional>
#include <variant>

#include "libdda/step/accept_step.h"
#include "libdda/step/missed_contacts.h"
#include "libdda/step/newton.h"
#include "libdda/step/part_timer.h"
#include "libdda/step/policy.h"
#include "libdda/step/published.h"
#include "libdda/step/reach.h"
#include "libdda/step/reversal.h"
#include "libdda/step/work.h"

namespace voussoir
{

namespace
{

constexpr double cut_factor = 0.3;

/// Finds the contacts that a step of at most `time_step` may need.
template <class K>
void look_for_contacts(const Model& model, const Stage& stage, const State& state, double time_step, Work<K>& work,
                       StepReport& report)
{
    const step::PartTimer timer(report.seconds, Part::contact_search);
    if (work.radii.empty()) work.radii = step::radii_of<K::dimension>(model);
    step::find_reach<K>(model, stage, state, time_step, work.radii, work.reach);
    contact::find_contacts(model, state, work.reach, stage.control.threads, work.parts, work.contacts,
                           step::new_overlaps_in(model, stage, state));
}

template <class K>
bool iterate_open_close(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                        step::StepSystem<K>& system, StepReport& report)
{
    const step::PartTimer timer(report.seconds, Part::open_close);
    if (stage.control.open_close == OpenClose::published) return step::iterate_published(stage, system, report);
    return step::iterate_newton(model, stage, contacts, system, report);
}

/// Solves a step of length h [s]. @returns whether it converged
template <class K>
bool attempt(const Model& model, const Stage& stage, const State& state, double h, Work<K>& work,
             StepReport& report)
{
    {
        const step::PartTimer timer(report.seconds, Part::assembly);
        step::assemble_blocks(model, stage, state, work.contacts, h, work.system);
    }
    return iterate_open_close(model, stage, work.contacts, work.system, report);
}

/// The shorter step to redo a converged one with when a sliding joint turned round in it [s], where steps may be
/// divided.
template <class K>
std::optional<double> divided_step(const Stage& stage, const Work<K>& work, step::ReversalSearch& reversal)
{
    if (!step::may_divide(stage, static_cast<int>(work.system.block_of_row.size()))) return std::nullopt;
    return step::step_to_reversal(work.contacts, work.system, reversal);
}

/// Whether a converged step knew of all the contacts that it came upon.
template <class K>
bool knew_its_contacts(const Model& model, const Stage& stage, const State& state, const Work<K>& work)
{
    return !step::misses_a_contact(model, state, work.system, work.contacts, work.radii, work.reach,
                                   stage.control.threads);
}

/// Shortens a step that does not hold. @returns false when there is nothing left to cut
bool cut(const StepControl& control, double& h, step::ReversalSearch& reversal, StepReport& report)
{
    ++report.cuts;
    reversal = {};
    h *= cut_factor;
    return h >= control.min_time_step;
}

StepReport give_up(StepReport& report)
{
    report.outcome = StepOutcome::gave_up;
    return report;
}

template <class K>
StepReport advance_with(const Model& model, const Stage& stage, double time_step, State& state,
                        EnergyLedger& energy, Work<K>& work)
{
    StepReport report;
    step::ReversalSearch reversal;
    double h = time_step;
    look_for_contacts(model, stage, state, h, work, report);
    while (true) {
        const bool converged = attempt(model, stage, state, h, work, report);
        const std::optional<double> shorter = converged ? divided_step(stage, work, reversal) : std::nullopt;
        if (shorter) {
            h = *shorter;
            continue;
        }
        if (converged && knew_its_contacts(model, stage, state, work)) break;
        if (!cut(stage.control, h, reversal, report)) return give_up(report);
    }
    report.divided = reversal.passes > 0;
    step::accept_step(model, stage, work, state, energy, report);
    return report;
}

}  // namespace

StepReport advance(const Model& model, const Stage& stage, double time_step, State& state, EnergyLedger& energy,
                   Workspace& work)
{
    return std::visit([&](auto& of) { return advance_with(model, stage, time_step, state, energy, of); },
                      work.implementation->work);
}

}  // namespace voussoir
