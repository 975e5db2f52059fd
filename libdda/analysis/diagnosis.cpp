#include "libdda/analysis/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace voussoir
{

namespace
{

using Eigen::Vector3d;

// Contacts are found from faces that overlap a little; deeper than this share of a block's width the nearest face
// may be the wrong one, and the block goes out on the other side.
constexpr double deepest_share = 0.1;
// Contacts that yield by more than this share of a block's width are part of the answer.
constexpr double visible_share = 0.01;
constexpr double good_share = 0.001;     // what the remedies aim at
constexpr double unnoticed_jump = 1e-3;  // m/s of the ground: what 0.1 m/s2 do in a step of 10 ms

std::string name_of(const Model& model, int block)
{
    return "'" + model.blocks[block].name + "'";
}

int fastest_block(const Model& model, const State& state)
{
    int fastest = 0;
    double most = -1;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        const double speed = velocity_of(model.kinematics, state, b).norm();
        if (speed > most) {
            most = speed;
            fastest = b;
        }
    }
    return fastest;
}

/// "blocks 'a' and 'b' overlap by 0.02 m, 4 % of the thinner one's width", and the remedy: a stiffer contact, or,
/// where contacts were forgiven most of it, a shorter step and a look at them.
/// @param why of contacts that are too soft
std::string overlap_in_words(const Model& model, const DeepestOverlap& overlap, const std::string& what,
                             const std::string& why)
{
    std::ostringstream words;
    words << "blocks " << name_of(model, overlap.block_a) << " and " << name_of(model, overlap.block_b) << " "
          << what << " by " << overlap.depth << " m, " << 100 * overlap.share
          << " % of the thinner one's width, at "
          << "t = " << overlap.time << " s: ";
    if (2 * overlap.forgiven > overlap.depth)
        words << overlap.forgiven
              << " m of it is without stress, because their contact was found late or goes to and "
              << "fro between two faces; try a smaller time_step, and look at edges and corners that bear";
    else
        words << why << "; give the joint a contact_stiffness " << std::ceil(overlap.share / good_share)
              << " times as large";
    return words.str();
}

/// The most that contacts gave, on balance, between any two moments of the run: what they took before or after
/// makes no blow softer.
double given_share(const EnergyLedger& energy)
{
    const double scale = energy.scale();
    return scale > 0 ? energy.peak_given / scale : 0;
}

std::string given_in_words(double share)
{
    std::ostringstream words;
    words << 100 * share << " % of the energy came from contacts whose area grew, or that were found late, while "
          << "they were pressed together: blocks were thrown harder than they should be; try a smaller time_step, "
          << "and look for edges and corners that carry blows";
    return words.str();
}

std::string energy_in_words(const Model& model, const State& state, const EnergyLedger& energy)
{
    const int block = fastest_block(model, state);
    std::ostringstream words;
    words << 100 * energy.relative_residual() << " % of the energy has "
          << (energy.residual() < 0 ? "appeared from nowhere" : "vanished") << "; the fastest block is "
          << name_of(model, block) << " with " << velocity_of(model.kinematics, state, block).norm()
          << " m/s: the forces are not solved well enough for the step; try a smaller time_step or a smaller "
             "force_tolerance";
    return words.str();
}

bool all_finite(const std::vector<double>& numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

std::string cause_of(Trouble trouble)
{
    switch (trouble) {
        case Trouble::inverted_block:
            return "would be turned inside out: its stone is too soft for its load, or the step too long for the "
                   "blow it gets; try a smaller time_step, a higher modulus or a rigid scene";
        case Trouble::singular_system:
            return "is in a system of equations that cannot be solved: stiffnesses or masses differ by too many "
                   "orders of magnitude; look at the contact_stiffness and the size of that block's neighbours";
        case Trouble::inaccurate_solution:
            return "has forces that rounding drowns: its contacts or its stone are too stiff for its mass and the "
                   "step, or the coordinates too large; try a lower contact_stiffness or a larger time_step, and "
                   "coordinates near the origin";
        case Trouble::chatter:
            return "has contacts that keep switching between open, sticking and sliding; try a larger "
                   "force_tolerance, a smaller time_step or a dashpot in its joints, and look for overlapping or "
                   "extremely stiff neighbours";
        case Trouble::none:
            break;
    }
    return "keeps an unbalanced force; try a smaller time_step or a larger force_tolerance";
}

}  // namespace

std::optional<std::string> diagnose(const Model& model, const State& state, const RunReport& report)
{
    if (!all_finite(state.coordinates) || !all_finite(state.velocities))
        return "block " + name_of(model, fastest_block(model, state)) +
               " has a place or velocity that is no number; look at its mass, its joints and its motion";
    if (report.deepest.share > deepest_share)
        return overlap_in_words(model, report.deepest, "overlap",
                                "the contact is too soft for its load or its impact");
    const double share = report.energy.relative_residual();
    if (!std::isfinite(share))
        return "an energy is no number; the fastest block is " + name_of(model, fastest_block(model, state)) +
               "; look at its joints' stiffness and its motion";
    if (share > residual_worth_stopping) return energy_in_words(model, state, report.energy);
    const double given = given_share(report.energy);
    if (given > residual_worth_stopping) return given_in_words(given);
    return std::nullopt;
}

std::optional<std::string> energy_warning(const EnergyLedger& energy)
{
    const double share = energy.relative_residual(), given = given_share(energy);
    if (share > residual_worth_a_warning) {
        std::ostringstream words;
        words << 100 * share << " % of the energy is unaccounted for: do not trust this run; try a smaller "
              << "time_step or force_tolerance";
        return words.str();
    }
    if (given > residual_worth_a_warning) return given_in_words(given);
    return std::nullopt;
}

std::optional<std::string> overlap_warning(const Model& model, const RunReport& report)
{
    if (!(report.deepest.share > visible_share)) return std::nullopt;
    return overlap_in_words(model, report.deepest, "overlapped",
                            "contacts so soft are part of the answer, and the integrator damps their vibration, "
                            "newmark most");
}

std::optional<std::string> ground_jump_warning(const Model& model, const Stage& stage, const State& state)
{
    double largest = unnoticed_jump;
    int block = -1;
    for (std::size_t f = 0; f < model.foundations.size(); ++f) {
        const Foundation& foundation = model.foundations[f];
        Vector3d jump = -velocity_of(model.kinematics, state, foundation.block);
        for (const FoundationMotion& motion : stage.motions)
            if (motion.foundation == static_cast<int>(f)) jump[motion.component] += motion.motion->velocity(0);
        for (int k = 0; k < 3; ++k)
            if (!foundation.translation_held[k]) jump[k] = 0;
        if (jump.norm() <= largest) continue;
        largest = jump.norm();
        block = foundation.block;
    }
    if (block < 0) return std::nullopt;
    std::ostringstream words;
    words << "stage '" << stage.name << "' starts with a blow: the ground of block " << name_of(model, block)
          << " changes its velocity by " << largest
          << " m/s at once; let motions start and end at rest (taper, end_correction), or make one stage of two";
    return words.str();
}

std::string explain(const Model& model, const Stage& stage, const State& state, const StepReport& step)
{
    std::ostringstream message;
    message << "stage '" << stage.name << "' gave up at t = " << state.time << " s: the time step was cut "
            << step.cuts << " times to below " << stage.control.min_time_step << " s";
    if (step.worst_block < 0) return message.str() + "; try a smaller time_step";
    message << "; block " << name_of(model, step.worst_block);
    if (step.trouble != Trouble::inverted_block)
        message << " keeps an unbalanced force of " << step.unbalanced << " of its load and";
    message << " " << cause_of(step.trouble);
    return message.str();
}

}  // namespace voussoir
