#include "libdda/analysis/trust.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdda/analysis/integrator_accuracy.h"
#include "libdda/block/block_step.h"

namespace voussoir
{

namespace
{

constexpr double usual_frequencies[] = {1, 5, 10};  // Hz, where the structure names none
// Of the energy stored at rest: below it nothing moved but rounding.
constexpr double rest_is_quiet = 1e-6;

/// The dynamic stage whose integrator damps most; -1 when none is dynamic.
int coarsest(const std::vector<Stage>& stages)
{
    int worst = -1;
    const auto damps = [&](int i) { return step::end_share(stages[i]) * stages[i].control.time_step; };
    for (int i = 0; i < static_cast<int>(stages.size()); ++i)
        if (stages[i].type == StageType::dynamic && (worst < 0 || damps(i) > damps(worst))) worst = i;
    return worst;
}

DampingAt damping_at(double frequency, const NaturalMode& mode, const Stage& stage)
{
    const double omega = 2 * std::numbers::pi * frequency, h = stage.control.time_step;
    const IntegratorAccuracy accuracy = integrator_accuracy(omega * h, step::end_share(stage));
    const double rate = stage.damping.rate - std::log(stage.damping.factor_per_step) / h;
    return {
        frequency,
        accuracy.damping,
        0.5 * omega * mode.dashpot_time,
        0.5 * (rate + mode.rayleigh.of_mass) / omega + 0.5 * mode.rayleigh.of_stiffness * omega + mode.hysteretic,
        accuracy.period_error,
        false};
}

/// Fills in the damping of the modes, or at the usual frequencies where none of them matters.
void find_damping(const Stage& stage, Trust& trust)
{
    for (const NaturalMode& mode : trust.start.modes.modes) {
        DampingAt at = damping_at(mode.frequency, mode, stage);
        const bool moves = trust.damping.empty() || mode.mass_share.maxCoeff() >= least_mass_share;
        at.matters = moves && mode.frequency <= fastest_that_matters;
        trust.damping.push_back(at);
    }
    trust.of_modes =
        std::any_of(trust.damping.begin(), trust.damping.end(), [](const auto& at) { return at.matters; });
    if (trust.of_modes) return;
    trust.damping.clear();
    for (const double frequency : usual_frequencies) trust.damping.push_back(damping_at(frequency, {}, stage));
    trust.damping.back().matters = true;
}

/// How much damping beside the one asked for a vibration may have.
double limit_of(const DampingAt& at, const Trust& trust)
{
    const double of_asked = most_share_of_asked * at.asked;
    if (!trust.of_modes) return std::max(of_asked, most_damping_elsewhere);
    const bool is_first = at.frequency == trust.damping.front().frequency;
    // Damping by a rate falls with the frequency; it is that of the first mode which was chosen.
    return is_first && at.asked > 0 ? of_asked : std::max(of_asked, most_unasked_damping);
}

/// Adds a vibration to a finding. They come in the order of their frequencies.
void note(double frequency, double value, double limit, TrustFinding& finding)
{
    if (!(value > limit)) return;
    if (finding.value == 0) {
        finding.frequency = frequency;
        finding.value = value;
        finding.limit = limit;
    }
    finding.worst = std::max(finding.worst, value / limit);
}

void add_if_found(const TrustFinding& finding, Trust& trust)
{
    if (finding.value > 0) trust.findings.push_back(finding);
}

/// Of steps that follow their error: a vibration that one of them damps is no larger than its error may be.
void judge_damping(Trust& trust)
{
    TrustFinding algorithmic{TrustFinding::Kind::algorithmic_damping}, dashpots{TrustFinding::Kind::dashpots};
    TrustFinding period{TrustFinding::Kind::period};
    for (const DampingAt& at : trust.damping) {
        if (!at.matters) continue;
        if (!trust.steps_follow) note(at.frequency, at.algorithmic, limit_of(at, trust), algorithmic);
        note(at.frequency, at.dashpots, limit_of(at, trust), dashpots);
    }
    const DampingAt& first = trust.damping.front();
    if (first.matters && !trust.steps_follow) note(first.frequency, first.period_error, most_period_error, period);
    for (const TrustFinding& finding : {algorithmic, dashpots, period}) add_if_found(finding, trust);
}

void judge_joints(Trust& trust)
{
    TrustFinding finding{TrustFinding::Kind::soft_joints};
    for (const NaturalMode& mode : trust.start.modes.modes)
        note(mode.frequency, mode.lowered_by_joints, most_lowering, finding);
    add_if_found(finding, trust);
}

/// Where the modes are judged: a structure that is stiff enough not to vibrate may be stiffer still.
void judge_stones(Trust& trust)
{
    TrustFinding finding{TrustFinding::Kind::stiff_stones};
    for (std::size_t i = 0; trust.of_modes && i < trust.damping.size(); ++i)
        if (trust.damping[i].matters)
            note(trust.damping[i].frequency, trust.start.modes.modes[i].raised_by_stones, most_raising, finding);
    add_if_found(finding, trust);
}

double stored(const EnergyLedger& energy)
{
    return energy.kinetic + energy.strain + energy.contact;
}

}  // namespace

EnergyShares shares_of(const EnergyLedger& now, const EnergyLedger& then, bool at_rest)
{
    EnergyShares shares;
    const double resting = at_rest ? stored(then) : 0;
    shares.put_in = std::max(
        {std::abs(now.input() - then.input()), now.dissipated() - then.dissipated(), now.peak_stored - resting});
    if (!(shares.put_in > rest_is_quiet * resting)) return shares;
    const auto share = [&](double EnergyLedger::*term) { return (now.*term - then.*term) / shares.put_in; };
    shares.integrator =
        std::abs(share(&EnergyLedger::algorithmic)) + std::abs(share(&EnergyLedger::algorithmic_rotation));
    shares.closing = std::abs(share(&EnergyLedger::closing));
    shares.contacts = std::abs(share(&EnergyLedger::redetection));
    shares.friction = share(&EnergyLedger::friction);
    shares.impact = share(&EnergyLedger::impact);
    shares.damping = share(&EnergyLedger::damping_kinetic) + share(&EnergyLedger::damping_material);
    shares.dashpots = share(&EnergyLedger::damping_contact);
    shares.fracture = share(&EnergyLedger::fracture);
    shares.yielding = share(&EnergyLedger::yielding);
    return shares;
}

std::vector<Stage> as_begun(std::vector<Stage> stages, const std::vector<ShorterSteps>& shorter)
{
    for (const ShorterSteps& step : shorter)
        if (step.at_start) stages[step.stage].control.time_step = step.time_step;
    return stages;
}

Trust trust_in(const TrustStart& start, const std::vector<Stage>& stages, const EnergyLedger& now)
{
    Trust trust;
    trust.start = start;
    trust.stage = coarsest(stages);
    if (trust.stage >= 0) {
        find_damping(stages[trust.stage], trust);
        trust.steps_follow = stages[trust.stage].control.step_error > 0;
        judge_damping(trust);
        trust.shares = shares_of(now, start.energy, start.at_rest);
    }
    judge_joints(trust);
    judge_stones(trust);
    TrustFinding taken{TrustFinding::Kind::integrator_energy}, closing{TrustFinding::Kind::closing_energy};
    note(0, trust.shares.integrator, most_taken_by_integrator, taken);
    note(0, trust.shares.closing, most_taken_by_closing, closing);
    for (const TrustFinding& finding : {taken, closing}) add_if_found(finding, trust);
    return trust;
}

}  // namespace voussoir
