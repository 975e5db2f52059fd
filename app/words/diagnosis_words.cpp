#include "app/words/diagnosis_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/words/shorter_step.h"
#include "libdda/run/static_course.h"

namespace voussoir::app::words
{

namespace
{

constexpr double good_share = 0.001;  // overlap by a block's width that a stiffer contact is to bring about

/// A diagnosis and the names of what it speaks of.
struct Subject {
    const Diagnosis& diagnosis;
    const Model& model;
    const std::vector<Stage>& stages;

    double value(std::string_view name) const { return value_of(diagnosis, name); }
    std::string block(std::size_t i) const { return "'" + model.blocks[diagnosis.blocks[i]].name + "'"; }
    std::string stage() const { return "stage '" + stages[diagnosis.stage].name + "'"; }
    /// "stage 'motion' stopped at t = 0.25 s: "
    std::string stopped() const { return fmt::format("{} stopped at t = {:g} s: ", stage(), value("time_s")); }
};

/// "time_step: 1 ms", half of that of the dynamic stage with the longest one.
std::string half_the_step(const std::vector<Stage>& stages)
{
    const Stage* longest = longest_step(stages);
    return longest ? shorter_step(*longest, 0.5) : "half the time_step";
}

/// ", or force_tolerance: 1e-06": a tenth of it.
std::string tighter_forces(const std::vector<Stage>& stages)
{
    const Stage* longest = longest_step(stages);
    return longest ? fmt::format(", or force_tolerance: {:g}", 0.1 * longest->control.force_tolerance) : "";
}

std::string fallen(const Subject& subject)
{
    constexpr std::size_t most = 5;
    const Diagnosis& diagnosis = subject.diagnosis;
    const std::size_t count = diagnosis.blocks.size();
    std::string words = fmt::format("{} of {} blocks have fallen: ", count, subject.model.blocks.size());
    for (std::size_t i = 0; i < std::min(most, count); ++i)
        words += fmt::format("{}{} at {:g} s", i > 0 ? ", " : "", subject.block(i), diagnosis.values[i]);
    return count > most ? words + ", ..." : words;
}

std::string cause_of(DiagnosisKind kind)
{
    switch (kind) {
        case DiagnosisKind::inverted_block:
            return "would be inverted: its stone is too soft for its load, or the step too long for the impact; "
                   "try a smaller time_step, a higher modulus or a rigid scene";
        case DiagnosisKind::singular_system:
            return "is in a system of equations that cannot be solved: stiffnesses or masses differ by too many "
                   "orders of magnitude; look at the contact_stiffness and the size of that block's neighbours";
        case DiagnosisKind::inaccurate_solution:
            return "has forces below the rounding error: its contacts or its stone are too stiff for its mass and "
                   "the step, or the coordinates too large; try a lower contact_stiffness or a larger time_step, "
                   "and coordinates near the origin";
        case DiagnosisKind::chatter:
            return "has contacts that keep switching between open, sticking and sliding; try a larger "
                   "force_tolerance, a smaller time_step or a relaxation_time in its joints, and look for "
                   "overlapping or extremely stiff neighbours";
        default:
            return "keeps an unbalanced force; try a smaller time_step or a larger force_tolerance";
    }
}

std::string cut_to_the_least(const Subject& subject)
{
    const std::string words = fmt::format(
        "{} failed to converge at t = {:g} s: the time step was cut {:.0f} times to below {:g} s", subject.stage(),
        subject.value("time_s"), subject.value("cuts"), subject.value("min_time_step_s"));
    const DiagnosisKind kind = subject.diagnosis.kind;
    if (subject.diagnosis.blocks.empty()) return words + "; try a smaller time_step";
    const std::string force =
        kind == DiagnosisKind::inverted_block
            ? ""
            : fmt::format(" keeps an unbalanced force of {:g} of its load and", subject.value("unbalanced"));
    return fmt::format("{}; block {}{} {}", words, subject.block(0), force, cause_of(kind));
}

std::string too_many_cuts(const Subject& subject)
{
    std::string words = fmt::format(
        "{}a nominal step of {:g} s needed more than {:.0f} cut ones, the last of {:g} s", subject.stopped(),
        subject.value("time_step_s"), subject.value("cut_steps"), subject.value("last_step_s"));
    if (subject.diagnosis.blocks.empty()) return words;
    return fmt::format(
        "{}; block {} converges worst: look at its joints; a lower contact_stiffness, a relaxation_time or a "
        "larger force_tolerance may help",
        words, subject.block(0));
}

constexpr std::size_t most_named = 5;  // stones, or joints

/// "'a', 0.02 m towards [0, 0, -1]"
std::string moving_block(const Subject& subject, std::size_t i)
{
    const double* values = subject.diagnosis.values.data() + 4 * i;                   // moved_m and the direction
    const auto short_one = [](double x) { return std::round(100 * x) / 100 + 0.0; };  // no negative nought
    return fmt::format("{}, {:.3g} m towards [{:g}, {:g}, {:g}]", subject.block(i), values[0],
                       short_one(values[1]), short_one(values[2]), short_one(values[3]));
}

/// "stage 'self-weight' finds no equilibrium: 2 of 10 blocks are falling: 'a', 0.02 m towards [0, 0, -1]; 'b',
/// ..."
std::string mechanism(const Subject& subject)
{
    const std::size_t count = subject.diagnosis.blocks.size();
    std::string words = fmt::format("{} finds no equilibrium: {} of {} blocks {} falling: ", subject.stage(),
                                    count, subject.model.blocks.size(), count == 1 ? "is" : "are");
    for (std::size_t i = 0; i < std::min(most_named, count); ++i)
        words += (i > 0 ? "; " : "") + moving_block(subject, i);
    const std::string them = count == 1 ? "it" : "them";
    return words + (count > most_named ? "; ...; " : "; ") +
           fmt::format("look at what should carry {}, or add {} to the foundation", them, them);
}

/// "; joints opened: 'a' on 'b' by 0.01 m, ... (7 in all)": the widest first; empty where there are none.
std::string joints_in_words(const RunReport& report, const Model& model, const std::string& what,
                            double JointPeaks::*size, std::optional<double> JointPeaks::*time)
{
    std::vector<const JointPeaks*> joints;
    for (const JointPeaks& joint : report.joints)
        if ((joint.*time).has_value()) joints.push_back(&joint);
    if (joints.empty()) return "";
    std::stable_sort(joints.begin(), joints.end(),
                     [&](const JointPeaks* one, const JointPeaks* other) { return one->*size > other->*size; });
    std::string words = "; joints " + what + ": ";
    for (std::size_t i = 0; i < std::min(most_named, joints.size()); ++i)
        words +=
            fmt::format("{}'{}' on '{}' by {:.3g} m", i > 0 ? ", " : "", model.blocks[joints[i]->block_a].name,
                        model.blocks[joints[i]->block_b].name, joints[i]->*size);
    return joints.size() > most_named ? words + fmt::format(", ... ({} in all)", joints.size()) : words;
}

std::string no_equilibrium(const Subject& subject)
{
    return fmt::format(
        "{} found no equilibrium in {:.0f} steps: the unbalanced force is still {:g} of a block's load, though no "
        "block falls; try gravity_increments, a larger unbalanced_tolerance or max_static_steps, or a "
        "contact_stiffness nearer to that of the stones",
        subject.stage(), subject.value("steps"), subject.value("unbalanced"));
}

/// "it falls", of a way to rest.
const char* end_of_way(double end)
{
    switch (static_cast<WayEnd>(static_cast<int>(end))) {
        case WayEnd::rested:
            return "it comes to rest";
        case WayEnd::fell:
            return "it falls";
        default:
            return "the computation gives up";
    }
}

std::string undecided(const Subject& subject)
{
    return fmt::format(
        "whether the structure stands in {} is undecided: with steps of {:g} s {}, with steps of {:g} s and the "
        "weight in "
        "increments {}, and limit analysis does not agree with both; it is near its limit, or the answer depends "
        "on how "
        "it was built: vary friction and load a little, or load it in stages",
        subject.stage(), subject.value("time_step_s"), end_of_way(subject.value("end")),
        subject.value("second_time_step_s"), end_of_way(subject.value("second_end")));
}

std::string friction_open(const Subject& subject)
{
    if (subject.value("balanced") != 0)
        return fmt::format(
            "friction leaves open whether the structure stands in {}: forces within friction balance its stones "
            "as "
            "rigid ones, but here {}; how it was built and loaded, or how far stones and joints give way, decides",
            subject.stage(), end_of_way(subject.value("end")));
    return fmt::format(
        "friction leaves open whether the structure stands in {}: here {}, but its joints can press in ways with "
        "which "
        "it stands, and in others with which it slides; how it was built and loaded decides",
        subject.stage(), end_of_way(subject.value("end")));
}

/// "blocks 'a' and 'b' overlap by 0.02 m, 4 % of the thinner one's width", and the remedy: a stiffer contact;
/// where most of it is drawn, other geometry; where contacts were forgiven most of it, a shorter step and a look
/// at them.
/// @param why of contacts that are too soft
std::string overlap(const Subject& subject, const std::string& what, const std::string& why)
{
    const double depth = subject.value("depth_m"), share = subject.value("share");
    const double forgiven = subject.value("forgiven_m"), drawn = subject.value("drawn_m");
    const std::string words = fmt::format(
        "blocks {} and {} {} by {:g} m, {:g} % of the thinner one's width, at t = {:g} s: ", subject.block(0),
        subject.block(1), what, depth, 100 * share, subject.value("overlap_time_s"));
    if (2 * forgiven > depth)
        return fmt::format(
            "{}{:g} m of it is free of stress, because their contact was detected late or alternates between two "
            "faces; try {}, and look at bearing edges and corners",
            words, forgiven, half_the_step(subject.stages));
    if (2 * drawn > depth)
        return fmt::format(
            "{}{:g} m of it is drawn, beyond the fit_tolerance of {:g} m; trim or move one of them by this, or "
            "give a "
            "larger fit_tolerance if it is an error of the survey",
            words, drawn, subject.model.fit_tolerance);
    return fmt::format("{}{}; give the joint a contact_stiffness {:g} times as large", words, why,
                       std::ceil(share / good_share));
}

std::string energy_unaccounted(const Subject& subject)
{
    return fmt::format("{:g} % of the energy is unaccounted for (limit {:g} %): do not trust this run; try {}{}",
                       100 * subject.value("share"), 100 * residual_worth_a_warning, half_the_step(subject.stages),
                       tighter_forces(subject.stages));
}

/// @param made whether the step was made that brought it so far
std::string energy_from_contacts(const Subject& subject, bool made)
{
    const double share = subject.value("share");
    return fmt::format(
        "{}{:g} % of the energy {} from contacts whose area grew or that were detected late under "
        "compression: impacts are too strong; try {}, and look for impacts on edges and corners",
        made ? "" : "after the next step, however short, ", 100 * share, made ? "came" : "would have come",
        half_the_step(subject.stages));
}

/// @param what became of the energy
std::string wrong_energy(const Subject& subject, const std::string& what)
{
    return fmt::format(
        "{:g} % of the energy {}; the fastest block is {} with {:g} m/s: the forces are not solved well enough "
        "for the step; try {}{}",
        100 * subject.value("share"), what, subject.block(0), subject.value("speed_m_s"),
        half_the_step(subject.stages), tighter_forces(subject.stages));
}

std::string ground_jump(const Subject& subject)
{
    return fmt::format(
        "{} starts with a velocity jump of the ground: {:g} m/s at block {}; let motions start and end at rest "
        "(taper, end_correction), or make one stage of two",
        subject.stage(), subject.value("velocity_jump_m_s"), subject.block(0));
}

std::string dry_joints(const Subject& subject)
{
    return fmt::format(
        "{:.0f} contacts have cohesion or tensile strength but are open at a corner, the widest by {:g} m between "
        "{} and {}: they are dry from the start; close them in the model to within a ten-thousandth of the "
        "stones' size",
        subject.value("joints"), subject.value("widest_gap_m"), subject.block(0), subject.block(1));
}

std::string crushed_joints(const Subject& subject)
{
    const double duration = subject.value("duration_s"), brief = subject.value("brief_joints");
    return fmt::format(
        "{:.0f} joints exceed their compressive strength, longest {} on {}: {}, up to {:g} times at {:g} s{}",
        subject.value("joints"), subject.block(0), subject.block(1),
        duration > 0 ? fmt::format("for {:.3g} s in all", duration) : "at rest",
        subject.value("stress_to_strength"), subject.value("time_s"),
        brief > 0 ? fmt::format("; {:.0f} more only as briefly as impacts last", brief) : "");
}

/// Why a step was taken back that had converged.
std::string stop_in_words(const Subject& subject)
{
    switch (subject.diagnosis.kind) {
        case DiagnosisKind::deep_overlap:
            return overlap(subject, "overlap", "the contact is too soft for its load or its impact");
        case DiagnosisKind::no_number:
            return fmt::format(
                "block {} has a position or velocity that is not a finite number; look at its mass, its joints "
                "and its motion",
                subject.block(0));
        case DiagnosisKind::energy_no_number:
            return fmt::format(
                "an energy is not a finite number; the fastest block is {}; look at its joints' stiffness and its "
                "motion",
                subject.block(0));
        case DiagnosisKind::energy_from_nowhere:
            return wrong_energy(subject, "is unaccounted for (a gain)");
        case DiagnosisKind::energy_vanished:
            return wrong_energy(subject, "is unaccounted for (a loss)");
        default:
            return energy_from_contacts(subject, false);
    }
}

std::string end_in_words(const Subject& subject)
{
    switch (subject.diagnosis.kind) {
        case DiagnosisKind::interrupted:
            return "stopped on request";
        case DiagnosisKind::fallen:
            return fallen(subject);
        case DiagnosisKind::mechanism:
            return mechanism(subject);
        case DiagnosisKind::undecided:
            return undecided(subject);
        case DiagnosisKind::inverted_block:
        case DiagnosisKind::singular_system:
        case DiagnosisKind::inaccurate_solution:
        case DiagnosisKind::chatter:
        case DiagnosisKind::unbalanced:
            return cut_to_the_least(subject);
        case DiagnosisKind::too_many_cuts:
            return too_many_cuts(subject);
        case DiagnosisKind::no_equilibrium:
            return no_equilibrium(subject);
        default:
            return subject.stopped() + stop_in_words(subject);
    }
}

std::string warning_in_words(const Subject& subject)
{
    switch (subject.diagnosis.kind) {
        case DiagnosisKind::energy_unaccounted:
            return energy_unaccounted(subject);
        case DiagnosisKind::energy_given:
            return energy_from_contacts(subject, true);
        case DiagnosisKind::overlap:
            return overlap(subject, "overlapped",
                           "contacts this soft influence the results, and the integrator damps their vibration, "
                           "most strongly with newmark");
        case DiagnosisKind::ground_jump:
            return ground_jump(subject);
        case DiagnosisKind::dry_joints:
            return dry_joints(subject);
        case DiagnosisKind::friction_open:
            return friction_open(subject);
        default:
            return crushed_joints(subject);
    }
}

}  // namespace

std::string in_words(const Diagnosis& diagnosis, const Model& model, const std::vector<Stage>& stages)
{
    const Subject subject{diagnosis, model, stages};
    const bool is_end = diagnosis.kind <= DiagnosisKind::energy_from_contacts;
    return is_end ? end_in_words(subject) : warning_in_words(subject);
}

std::string message_of(const RunReport& report, const Model& model, const std::vector<Stage>& stages)
{
    if (!report.diagnosis) return "";
    std::string words = in_words(*report.diagnosis, model, stages);
    if (report.diagnosis->kind != DiagnosisKind::mechanism) return words;
    return words + joints_in_words(report, model, "opened", &JointPeaks::opening, &JointPeaks::opened) +
           joints_in_words(report, model, "slid", &JointPeaks::slip, &JointPeaks::slid);
}

std::vector<std::string> warnings_of(const RunReport& report, const Model& model, const std::vector<Stage>& stages)
{
    std::vector<std::string> warnings;
    for (const Diagnosis& warning : report.warnings) warnings.push_back(in_words(warning, model, stages));
    return warnings;
}

}  // namespace voussoir::app::words
