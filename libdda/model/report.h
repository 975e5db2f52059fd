// Passive results of a step and of a run. No later step reads them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "libdda/model/bar.h"
#include "libdda/model/diagnosis.h"
#include "libdda/model/verdict.h"

namespace voussoir
{

/// Energies [J]. Work terms and losses accumulate from the start of the run; every term comes from its own forces
/// and displacements, none as the difference of the others.
struct EnergyLedger {
    double kinetic = 0;               // now, of blocks that have unknowns
    double strain = 0;                // now
    double contact = 0;               // now, in normal and shear springs
    double gravity_work = 0;          // done by gravity
    double foundation_work = 0;       // done by prescribed motion on the structure
    double boundary_work = 0;         // by viscous boundaries
    double load_work = 0;             // by body accelerations
    double friction = 0;              // dissipated
    double damping_kinetic = 0;       // dissipated by the kinetic damping rate or factor
    double damping_static = 0;        // velocity removed in static stages, and springs of contacts found in them
    double damping_contact = 0;       // dissipated by contact dashpots
    double damping_material = 0;      // dissipated by the Rayleigh damping of blocks
    double fracture = 0;              // elastic energy lost when an intact joint breaks
    double yielding = 0;              // dissipated by bars that yield
    double impact = 0;                // taken by the impulses of landing stones
    double closing = 0;               // taken by contacts that close or open within a step
    double algorithmic = 0;           // loss of the integrator, from its own identity
    double algorithmic_rotation = 0;  // of the finite rotation and shape update
    double redetection = 0;           // spring energy that changed when contacts were found anew
    double start_kinetic = 0, start_strain = 0, start_contact = 0;  // at the start of the run
    // Largest kinetic + strain + contact so far: the scale when all has come to rest again.
    double peak_stored = 0;
    double peak_taken = 0;  // largest redetection so far
    double peak_given = 0;  // largest fall of redetection from there: what contacts took before is no credit

    /// Work done on the blocks [J].
    double input() const { return gravity_work + foundation_work + boundary_work + load_work; }
    /// All losses [J].
    double dissipated() const
    {
        return friction + damping_kinetic + damping_static + damping_contact + damping_material + fracture +
               yielding + impact + closing + algorithmic + algorithmic_rotation + redetection;
    }
    /// What kinetic, strain and contact energy have grown by since the start [J].
    double stored_change() const
    {
        return kinetic - start_kinetic + strain - start_strain + contact - start_contact;
    }
    /// What the terms leave unexplained [J].
    double residual() const { return input() - dissipated() - stored_change(); }
    /// Brings the three peaks up to what the other terms are now.
    void note_peaks();
    /// All that was put in, lost, stored or there at the start, whichever is largest [J].
    double scale() const;
    /// |residual| / scale: what share of the energy is unaccounted for. 0 for 0/0.
    double relative_residual() const;
};

/// EnergyLedger::relative_residual of which a run warns: energy has appeared or been lost.
constexpr double residual_worth_a_warning = 0.01;
/// That at which it stops.
constexpr double residual_worth_stopping = 0.1;

/// How a step ended; when it gave up the state is untouched.
enum class StepOutcome {
    converged,  // accepted
    gave_up,    // no step as long as min_time_step converges
};

/// What kept the last attempt at a step from converging.
enum class Trouble {
    none,                 // all went well
    inverted_block,       // the iterate turned a block inside out
    singular_system,      // the linear system could not be solved
    inaccurate_solution,  // its solution does not lead downhill: rounding ate it
    chatter,              // contacts kept switching until the iterations were used up
};

/// `open_close` is the whole iteration; `linear_solve` and the matrix part of `assembly` lie inside it.
enum class Part {
    contact_search,  // finding contacts
    assembly,        // blocks, contacts, matrix
    open_close,      // the iteration
    linear_solve,    // solving for directions
    update,          // blocks, contacts, energies
    output,          // writing results
    count,           // how many parts there are
};
/// The name of a part, as in results.
std::string_view name_of(Part part);

/// What of the open-close iteration acted, in times.
struct IterationCounts {
    std::int64_t relaxed = 0;         // stones were relaxed one by one
    std::int64_t whole_tangents = 0;  // a direction was that of the whole tangent
    std::int64_t shortened = 0;       // less than the whole of a direction was gone

    /// Adds those of another step.
    IterationCounts& operator+=(const IterationCounts& other);
};

/// Blows of stones that land.
struct BlowCounts {
    std::int64_t solved = 0;      // of all stones that land at once or together
    std::int64_t unfinished = 0;  // impulses were given up before they came to an end, or more blows would follow

    /// Adds those of another step.
    BlowCounts& operator+=(const BlowCounts& other);
};

/// What one step did.
struct StepReport {
    StepOutcome outcome = StepOutcome::converged;  // how it ended
    double time_step = 0;                          // s, of the accepted step
    int open_close_iterations = 0;                 // of all attempts
    IterationCounts acted;                         // in them
    BlowCounts blows;                              // of the accepted attempt
    int cuts = 0;                                  // attempts that failed
    int refused = 0;                               // attempts whose error was larger than step_error
    bool divided = false;                          // ended just before stones land
    int factorisations = 0;                        // of the linear systems
    int linear_iterations = 0;                     // of conjugate gradients
    std::int64_t factor_entries = 0;               // of the last factorisation
    Trouble trouble = Trouble::none;               // of the last attempt that failed
    double unbalanced = 0;                         // largest block residual / block load at acceptance
    int worst_block = -1;                          // the block of `unbalanced`, or the one that inverted
    double max_penetration = 0;                    // m, of the contact points at the end of the step
    double max_displacement = 0;                   // m, of a block centroid in this step
    double inertia_ratio = 0;                      // static: largest unbalanced force / load of a block
    bool contact_state_changed = false;            // of a point that carries more than the unbalanced tolerance
    int closed_points = 0;                         // contact points that are not open
    std::array<double, static_cast<int>(Part::count)> seconds{};  // wall time by part
};

/// How a run ended.
enum class Outcome {
    completed,    // all stages
    collapsed,    // blocks have fallen; a result like another
    gave_up,      // the numerics; the state is that of the last good step
    undecided,    // a static stage: two ways to rest disagree, so that it is not known whether stones fall
    interrupted,  // from outside; it can be resumed
};
/// The name of an outcome, as in results.
std::string_view name_of(Outcome outcome);
/// Whether a run ended without an answer, though nobody stopped it.
inline bool has_no_answer(Outcome outcome)
{
    return outcome == Outcome::gave_up || outcome == Outcome::undecided;
}

/// A block that has lost all support and fallen by more than its own size, or left the domain; or that a structure
/// has lost otherwise, as the verdict at the end of the run finds.
struct FallenBlock {
    int block = 0;      // index into Model::blocks
    double time = 0;    // s since the run's start; of the latter its end
    bool left = false;  // the domain, by now
};

/// A joint whose edge stress exceeded the compressive strength of its stones.
struct CrushedJoint {
    int block_a = 0, block_b = 0;             // a < b
    double strength = 0;                      // Pa, the smaller of the two
    double first_time = 0;                    // s since the run's start
    double worst_time = 0, worst_stress = 0;  // s, Pa
    double duration = 0;                      // s, of dynamic stages, above the strength
    double longest = 0;                       // s of it without a break
    double stretch = 0;                       // s without a break until now; 0: not above it now
    bool at_rest = false;                     // above it at the end of a static stage
};

/// Two blocks within one another, at a corner of their contact.
struct DeepestOverlap {
    double share = 0, depth = 0;     // -, of the thinner block's least width; m
    double forgiven = 0;             // m of the depth, without stress: of a contact found late or on another face
    double time = 0;                 // s since the run's start
    int block_a = -1, block_b = -1;  // indices into Model::blocks
    double drawn = 0;                // m of the depth, that the two share as drawn beyond the fit_tolerance
};

/// The most that a joint of the start of the run has done, since the first motion began if there is one: see
/// joint_openings.h.
struct JointPeaks {
    int block_a = 0, block_b = 0;        // a < b
    double opening = 0, slip = 0;        // m, the largest so far of a corner of its facing area
    std::optional<double> opened, slid;  // s since the run's start: the first time either was noteworthy
};

/// When the steps of a stage whose time_step is automatic became shorter.
struct ShorterSteps {
    int stage = 0;
    double time = 0;        // s since the run's start
    double time_step = 0;   // s, from then on
    bool at_start = false;  // of the stage
};

/// What a run did.
struct RunReport {
    Outcome outcome = Outcome::completed;                          // how it ended
    std::optional<Diagnosis> diagnosis;                            // why, when not completed
    std::int64_t steps = 0, step_cuts = 0, unconverged_steps = 0;  // counts
    std::int64_t divided_steps = 0;                                // that ended just before stones land
    std::int64_t refused_steps = 0;           // done again, their error larger than step_error
    std::vector<ShorterSteps> shorter_steps;  // in their order
    std::int64_t open_close_iterations = 0, factorisations = 0, linear_iterations = 0;  // counts
    std::int64_t factor_entries = 0;                              // of the last factorisation
    IterationCounts acted;                                        // in the open-close iterations
    BlowCounts blows;                                             // of stones that landed
    double simulated_time = 0;                                    // s, dynamic stages only
    double max_penetration = 0;                                   // m, as note_overlap counts it
    DeepestOverlap deepest;                                       // by its share
    double static_unbalanced = 0;                                 // of the last static stage
    EnergyLedger energy;                                          // at the end
    std::vector<FallenBlock> fallen;                              // in the order in which they fell
    std::vector<CrushedJoint> crushed;                            // in the order in which they were first crushed
    std::vector<JointPeaks> joints;                               // in ascending order of the pair
    std::vector<BarPeaks> bars;                                   // in the order of Model::bars
    std::array<double, static_cast<int>(Part::count)> seconds{};  // wall time by part
    std::vector<Diagnosis> warnings;                              // in the order in which they arose
    std::optional<Verdict> verdict;                               // once it was completed, or collapsed
};

}  // namespace voussoir
