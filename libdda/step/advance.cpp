#include "libdda/step/advance.h"

#include <optional>
#include <variant>

#include "libdda/impact/landing.h"
#include "libdda/iterate/newton.h"
#include "libdda/iterate/plain.h"
#include "libdda/iterate/published.h"
#include "libdda/problem/part_timer.h"
#include "libdda/step/accept_step.h"
#include "libdda/step/missed_contacts.h"
#include "libdda/step/policy.h"
#include "libdda/step/reach.h"
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
    if (work.extents.empty()) work.extents = step::extents_of<K::dimension>(model);
    step::find_reach<K>(model, stage, state, time_step, work.extents, work.reach);
    contact::find_contacts(model, state, work.reach, stage.control.threads, work.search, work.contacts,
                           step::new_overlaps_in(model, stage, state));
}

template <class K>
bool iterate_open_close(const Model& model, const Stage& stage, Work<K>& work, StepReport& report)
{
    const step::PartTimer timer(report.seconds, Part::open_close);
    switch (stage.control.open_close) {
        case OpenClose::published:
            return step::iterate_published(work.problem, work.iteration.directions, report);
        case OpenClose::plain:
            return step::iterate_plain(model, stage, work.contacts, work.problem, report);
        case OpenClose::newton:
            break;
    }
    return step::iterate_newton(model, stage, work.contacts, work.problem, work.iteration, report);
}

/// Solves a step of length h [s] with the jumps of what lands in it. @returns whether it converged
template <class K>
bool solve(const Model& model, const Stage& stage, const State& state, double h, Work<K>& work, StepReport& report)
{
    {
        const step::PartTimer timer(report.seconds, Part::assembly);
        step::assemble_blocks(model, stage, state, work.contacts, h, work.jumps, work.problem);
        work.iteration.begin(stage.control, work.problem);
    }
    return iterate_open_close(model, stage, work, report);
}

/// The same, landings looked for; once more where one showed only in the step.
/// @param h shortened where the step is to end before them
template <class K>
bool attempt(const Model& model, const Stage& stage, const State& state, double& h, Work<K>& work,
             StepReport& report)
{
    report.divided = false;
    work.jumps.clear();
    if (!step::stones_land(stage)) return solve(model, stage, state, h, work, report);
    std::optional<step::Landings<K>> landings(std::in_place, model, stage, state, work.contacts, h);
    work.jumps = landings->find();
    const int moving = static_cast<int>(model.blocks.size() - model.foundations.size());
    if (step::may_divide(stage, moving))
        if (const std::optional<double> before = step::step_to_landing(stage, work.jumps, h)) {
            h = *before;
            report.divided = true;
            work.jumps.clear();  // what lands before that, more slowly, is left to the springs
            landings.emplace(model, stage, state, work.contacts, h);
        }
    if (!solve(model, stage, state, h, work, report)) return false;
    report.blows = landings->counts();
    std::vector<step::ClosingPoint> missed =
        step::missed_landings(model, stage, state, work.contacts, work.problem);
    std::erase_if(missed, [&](const step::ClosingPoint& closing) { return landings->has_landed(closing); });
    if (missed.empty()) return true;
    work.jumps = landings->find_also(missed);
    report.blows = landings->counts();
    return solve(model, stage, state, h, work, report);
}

/// Whether a converged step knew of all the contacts that it came upon.
template <class K>
bool knew_its_contacts(const Model& model, const Stage& stage, const State& state, const Work<K>& work)
{
    return !step::misses_a_contact(model, state, work.problem, work.contacts, work.extents, work.reach,
                                   stage.control.threads);
}

/// Shortens a step that does not hold. @returns false when there is nothing left to cut
bool cut(const StepControl& control, double& h, StepReport& report)
{
    ++report.cuts;
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
    double h = time_step;
    look_for_contacts(model, stage, state, h, work, report);
    while (!attempt(model, stage, state, h, work, report) || !knew_its_contacts(model, stage, state, work))
        if (!cut(stage.control, h, report)) return give_up(report);
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
