#include "app/words/trust_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/words/figures_in_words.h"
#include "app/words/shorter_step.h"

namespace voussoir::app::words
{

namespace
{

constexpr std::size_t most_modes_named = 4;
constexpr double worth_saying_of_corners = 0.05;  // of a frequency
constexpr double worth_naming = 1e-4;             // of the energy put in

/// The smallest whole number of one or two digits and zeros that is no smaller.
double rounded_up(double value)
{
    const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(value)) - 1));
    return unit * std::ceil(value / unit - 1e-9);
}

/// And may be something else: the published iteration knows no other.
bool is_newmark(const Stage& stage)
{
    return !stage.control.is_published() && stage.control.integrator == Integrator::newmark;
}

/// "give integrator: energy_decaying, or time_step: 0.1 ms".
std::string remedy_of_damping(const TrustFinding& finding, const Stage& stage)
{
    const std::string step = shorter_step(stage, 1 / finding.worst);
    if (is_newmark(stage)) return "give integrator: energy_decaying, or " + step;
    return "give " + step;
}

/// How many times as stiff joints must be for the lowering to be the limit.
/// @param rigid stones: joints are all that yields
double stiffer_by(const TrustFinding& finding, bool rigid)
{
    const auto softness = [&](double lowered) {
        const double stiff = std::pow(1 - std::min(lowered, 0.999), 2);
        return (rigid ? 1 : 1 - stiff) / stiff;
    };
    return rounded_up(softness(finding.worst * finding.limit) / softness(finding.limit));
}

std::string in_words(const TrustFinding& finding, const Trust& trust, const std::vector<Stage>& stages)
{
    using Kind = TrustFinding::Kind;
    const std::string limit = fmt::format("(limit {})", percent_in_words(finding.limit));
    const std::string vibration =
        fmt::format("{} of {:.3g} Hz", trust.of_modes ? "the vibration" : "vibrations", finding.frequency);
    switch (finding.kind) {
        case Kind::algorithmic_damping:
            return fmt::format("the integrator damps {} by {} of critical {}: {}", vibration,
                               percent_in_words(finding.value), limit,
                               remedy_of_damping(finding, stages[trust.stage]));
        case Kind::dashpots:
            return fmt::format(
                "the dashpots of joints (relaxation_time) damp {} by {} of critical {}: give a relaxation_time "
                "{:.2g} times as long",
                vibration, percent_in_words(finding.value), limit, rounded_down(1 / finding.worst));
        case Kind::period:
            return fmt::format("the computed period of {} is {} too long {}: give {}", vibration,
                               percent_in_words(finding.value), limit,
                               shorter_step(stages[trust.stage], std::sqrt(1 / finding.worst)));
        case Kind::soft_joints:
            return fmt::format(
                "joints lower the frequency of {:.3g} Hz by {} against that of the stones {}: their stiffness is "
                "a "
                "rule, no measurement; give the measured contact_stiffness in Pa/m, or a "
                "contact_stiffness_factor {:g} times as large",
                finding.frequency, percent_in_words(finding.value), limit,
                stiffer_by(finding, trust.start.modes.rigid));
        case Kind::stiff_stones:
            return fmt::format(
                "on face: corners stones do not bend: if these did, the vibration of {:.3g} Hz would have some "
                "{:.2g} "
                "Hz; give the joints face: points, or take no frequency from this run",
                finding.frequency, finding.frequency / (1 + finding.value));
        case Kind::closing_energy:
            return fmt::format(
                "joints that closed or opened within a step took {} of the energy put in {}: what impacts loses "
                "too much; give {}",
                percent_in_words(finding.value), limit, shorter_step(stages[trust.stage], 1 / finding.worst));
        case Kind::integrator_energy:
            break;
    }
    // What impacts excite newmark damps at any step, and takes the more of it the shorter they are.
    const Stage& stage = stages[trust.stage];
    return fmt::format("the integrator took {} of the energy put in {}: what vibrates loses too much; give {}",
                       percent_in_words(finding.value), limit,
                       is_newmark(stage) ? "integrator: energy_decaying" : shorter_step(stage, 1 / finding.worst));
}

std::string frequencies_in_words(const Trust& trust)
{
    const std::vector<NaturalMode>& modes = trust.start.modes.modes;
    std::string words;
    for (std::size_t i = 0; i < std::min(most_modes_named, modes.size()); ++i)
        words += fmt::format("{}{:.3g}", i > 0 ? ", " : "", modes[i].frequency);
    return words + (modes.size() > most_modes_named ? ", ..." : "") + " Hz";
}

std::string modes_in_words(const Trust& trust)
{
    switch (trust.start.modes.outcome) {
        case ModesOutcome::found:
            return "first modes " + frequencies_in_words(trust);
        case ModesOutcome::nothing_closed:
            return "no joint is closed, so there are no natural modes";
        case ModesOutcome::too_costly:
            return "natural modes were not sought, for their cost (output: {trust: always})";
        case ModesOutcome::failed:
            break;
    }
    return "natural modes were not found";
}

/// Of the vibration that is damped most among those that are judged.
std::string damping_in_words(const Trust& trust)
{
    const DampingAt* worst = nullptr;
    for (const DampingAt& at : trust.damping)
        if (at.matters && (!worst || at.algorithmic > worst->algorithmic)) worst = &at;
    if (!worst) return "";
    const std::string which = trust.of_modes ? "them" : fmt::format("{:g} Hz", worst->frequency);
    return fmt::format("; the integrator damps {} by {}{} of critical", which,
                       trust.of_modes || trust.steps_follow ? "at most " : "",
                       percent_in_words(worst->algorithmic));
}

/// What springs at the corners do to the first mode, where it is worth a word. Stones beside them do not bend.
std::string corners_in_words(const std::vector<NaturalMode>& modes)
{
    if (modes.empty() || modes.front().raised_by_corners < worth_saying_of_corners) return "";
    const NaturalMode& first = modes.front();
    const double times = (1 + first.raised_by_corners) * (1 + first.raised_by_stones);
    return fmt::format(
        "; faces on springs at their corners{} raise the first by {}, with face: points it is some {:.3g} Hz",
        first.raised_by_stones > worth_saying_of_corners ? ", beside which stones do not bend," : "",
        percent_in_words(times - 1), first.frequency / times);
}

}  // namespace

std::string vibrations_in_words(const Trust& trust)
{
    std::string words = modes_in_words(trust) + damping_in_words(trust);
    double lowered = 0;
    for (const NaturalMode& mode : trust.start.modes.modes) lowered = std::max(lowered, mode.lowered_by_joints);
    if (lowered > 0) words += fmt::format("; joints lower them by at most {}", percent_in_words(lowered));
    return words + corners_in_words(trust.start.modes.modes);
}

std::string shares_in_words(const EnergyShares& shares)
{
    if (!(shares.put_in > 0)) return "";
    std::string words = fmt::format("of {:.4g} kJ put in by the motion:", shares.put_in / 1e3);
    const std::pair<const char*, double> terms[] = {{"integrator", shares.integrator},
                                                    {"closing joints", shares.closing},
                                                    {"friction", shares.friction},
                                                    {"impacts", shares.impact},
                                                    {"damping", shares.damping},
                                                    {"dashpots", shares.dashpots},
                                                    {"fracture", shares.fracture},
                                                    {"yielding", shares.yielding},
                                                    {"contacts found anew", shares.contacts}};
    for (const auto& [name, share] : terms)
        if (share >= worth_naming || name == terms[0].first)
            words += fmt::format(" {} {},", name, share >= worth_naming ? percent_in_words(share) : "< 0.01 %");
    words.pop_back();
    return words;
}

std::vector<std::string> warnings_of(const Trust& trust, const std::vector<Stage>& stages)
{
    std::vector<std::string> warnings;
    for (const TrustFinding& finding : trust.findings) warnings.push_back(in_words(finding, trust, stages));
    return warnings;
}

}  // namespace voussoir::app::words
