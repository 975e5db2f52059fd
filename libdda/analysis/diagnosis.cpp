#include "libdda/analysis/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "libdda/analysis/overlaps.h"

namespace voussoir
{

namespace
{

using Eigen::Vector3d;

// Contacts that yield by more than this share of a block's width are part of the answer.
constexpr double visible_share = 0.01;
constexpr double unnoticed_jump = 1e-3;  // m/s of the ground: what 0.1 m/s2 do in a step of 10 ms

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

/// The most that contacts gave, on balance, between any two moments of the run: what they took before or after
/// makes no blow softer.
double given_share(const EnergyLedger& energy)
{
    const double scale = energy.scale();
    return scale > 0 ? energy.peak_given / scale : 0;
}

bool all_finite(const std::vector<double>& numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

Diagnosis deep_overlap(const State& state, const DeepestOverlap& deepest)
{
    return {DiagnosisKind::deep_overlap,
            state.stage,
            {deepest.block_a, deepest.block_b},
            {state.time, deepest.depth, deepest.share, deepest.forgiven, deepest.time, deepest.drawn}};
}

Diagnosis wrong_energy(const Model& model, const State& state, const EnergyLedger& energy)
{
    const int block = fastest_block(model, state);
    return {energy.residual() < 0 ? DiagnosisKind::energy_from_nowhere : DiagnosisKind::energy_vanished,
            state.stage,
            {block},
            {state.time, energy.relative_residual(), velocity_of(model.kinematics, state, block).norm()}};
}

DiagnosisKind kind_of(Trouble trouble)
{
    switch (trouble) {
        case Trouble::inverted_block:
            return DiagnosisKind::inverted_block;
        case Trouble::singular_system:
            return DiagnosisKind::singular_system;
        case Trouble::inaccurate_solution:
            return DiagnosisKind::inaccurate_solution;
        case Trouble::chatter:
            return DiagnosisKind::chatter;
        case Trouble::none:
            break;
    }
    return DiagnosisKind::unbalanced;
}

}  // namespace

std::optional<Diagnosis> diagnose(const Model& model, const State& state, const RunReport& report)
{
    if (!all_finite(state.coordinates) || !all_finite(state.velocities))
        return Diagnosis{DiagnosisKind::no_number, state.stage, {fastest_block(model, state)}, {state.time}};
    if (report.deepest.share > deepest_share) return deep_overlap(state, report.deepest);
    const double share = report.energy.relative_residual();
    if (!std::isfinite(share))
        return Diagnosis{
            DiagnosisKind::energy_no_number, state.stage, {fastest_block(model, state)}, {state.time}};
    if (share > residual_worth_stopping) return wrong_energy(model, state, report.energy);
    const double given = given_share(report.energy);
    if (given > residual_worth_stopping)
        return Diagnosis{DiagnosisKind::energy_from_contacts, state.stage, {}, {state.time, given}};
    return std::nullopt;
}

std::optional<Diagnosis> start_diagnosis(const std::vector<DrawnOverlap>& overlaps)
{
    const auto worst = std::max_element(overlaps.begin(), overlaps.end(), [](const auto& one, const auto& other) {
        return one.share < other.share;
    });
    if (worst == overlaps.end() || worst->share <= deepest_share) return std::nullopt;
    return Diagnosis{DiagnosisKind::deep_overlap,
                     0,
                     {worst->block_a, worst->block_b},
                     {0, worst->depth, worst->share, 0, 0, worst->depth}};
}

std::optional<Diagnosis> energy_warning(const EnergyLedger& energy)
{
    const double share = energy.relative_residual(), given = given_share(energy);
    if (share > residual_worth_a_warning) return Diagnosis{DiagnosisKind::energy_unaccounted, -1, {}, {share}};
    if (given > residual_worth_a_warning) return Diagnosis{DiagnosisKind::energy_given, -1, {}, {given}};
    return std::nullopt;
}

std::optional<Diagnosis> overlap_warning(const RunReport& report)
{
    const DeepestOverlap& deepest = report.deepest;
    if (!(deepest.share > visible_share)) return std::nullopt;
    return Diagnosis{DiagnosisKind::overlap,
                     -1,
                     {deepest.block_a, deepest.block_b},
                     {deepest.depth, deepest.share, deepest.forgiven, deepest.time, deepest.drawn}};
}

std::optional<Diagnosis> ground_jump_warning(const Model& model, const Stage& stage, const State& state)
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
    return Diagnosis{DiagnosisKind::ground_jump, state.stage, {block}, {largest}};
}

Diagnosis explain(const Stage& stage, const State& state, const StepReport& step)
{
    Diagnosis diagnosis{kind_of(step.trouble), state.stage, {}, {}};
    if (step.worst_block >= 0) diagnosis.blocks = {step.worst_block};
    diagnosis.values = {state.time, static_cast<double>(step.cuts), stage.control.min_time_step, step.unbalanced};
    return diagnosis;
}

}  // namespace voussoir
