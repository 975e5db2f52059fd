// What a run says of itself: why it ended before its end, and how far its figures can be trusted. Facts alone: the
// sentences, and what to do about it in the words of the user's own input, are the caller's.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace voussoir
{

/// What can be found; each kind with the blocks and values that form_of names.
enum class DiagnosisKind : std::uint8_t {
    // Why a run ended before its end:
    interrupted,           // on request
    fallen,                // so many blocks have fallen; a warning where the run went on
    inverted_block,        // a step was cut down to the least: a block would be turned inside out
    singular_system,       // the same: the linear system cannot be solved
    inaccurate_solution,   // the same: its solution does not lead downhill
    chatter,               // the same: contacts keep switching
    unbalanced,            // the same, of no such cause
    too_many_cuts,         // a nominal step needed more cut ones than are worth computing
    no_equilibrium,        // of a static stage
    mechanism,             // the same, because blocks are falling
    undecided,             // of a static stage: two ways to rest end differently
    deep_overlap,          // blocks so deep within one another that the nearest face would soon be the wrong one
    no_number,             // a place or a velocity
    energy_no_number,      // an energy
    energy_from_nowhere,   // energy has appeared that nothing accounts for
    energy_vanished,       // energy has gone that nothing accounts for
    energy_from_contacts,  // contacts gave energy when they were found anew
    // Warnings:
    energy_unaccounted,  // a little of it
    energy_given,        // by contacts that were found anew, a little
    overlap,             // so deep that the softness of contacts is part of the answer
    ground_jump,         // the ground changes its velocity at once when a stage starts
    dry_joints,          // joints that were given strength gape, and have none
    crushed_joints,      // joints exceed their compressive strength
    friction_open,       // at rest: whether stones stand depends on normal forces that statics does not determine;
                         // balanced: Coulomb friction has some with which they do
};
/// Number of kinds.
constexpr int diagnosis_kinds = static_cast<int>(DiagnosisKind::friction_open) + 1;

/// One finding. Which blocks and values a kind has: form_of.
struct Diagnosis {
    DiagnosisKind kind = DiagnosisKind::interrupted;  // what was found
    int stage = -1;              // index of the stage it happened in; -1: it is said of the whole run
    std::vector<int> blocks;     // indices
    std::vector<double> values;  // SI

    /// Of all members.
    bool operator==(const Diagnosis&) const = default;
};

/// What the blocks and values of a kind are.
struct DiagnosisForm {
    std::string_view name;                 // "deep_overlap"
    bool has_stage = false;                // else it is said of the whole run
    std::size_t fewest_blocks = 0;         // one may be unknown
    std::size_t blocks = 0;                // at most; of `fallen` and `mechanism` as many as fall
    std::vector<std::string_view> values;  // "depth_m"; of `fallen` and `mechanism` once for each block
};
/// What the blocks and values of this kind are.
const DiagnosisForm& form_of(DiagnosisKind kind);

/// The value of that name in the form of its kind. The diagnosis must be whole and have it.
double value_of(const Diagnosis& diagnosis, std::string_view name);

/// Whether it has a kind that exists, and the stage, blocks and values of its form.
bool is_whole(const Diagnosis& diagnosis);

/// "deep_overlap: stage 0, blocks 1 0, time_s 0.25, depth_m 0.1, ...", for logs and tests.
std::ostream& operator<<(std::ostream& stream, const Diagnosis& diagnosis);

}  // namespace voussoir
