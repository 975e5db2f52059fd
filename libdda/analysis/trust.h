// How much to trust a run: what its integrator, its joints and its dashpots do to the vibrations that matter,
// where the energy went, and which of it is beyond the stated limits. Facts alone; docs/method.md has the
// formulas.
#pragma once

#include <vector>

#include "libdda/analysis/modes.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"

namespace voussoir
{

// The limits:
constexpr double most_unasked_damping = 0.002;     // of critical, of a mode where no damping was asked for
constexpr double most_share_of_asked = 0.1;        // of the damping that was asked for
constexpr double most_damping_elsewhere = 0.012;   // of critical, at 10 Hz, where no mode is slow enough to matter
constexpr double most_period_error = 0.01;         // of the first mode
constexpr double most_lowering = 0.02;             // of a frequency, by joints whose stiffness is a rule
constexpr double most_raising = 0.5;               // of a frequency, by stones that do not bend
constexpr double most_taken_by_integrator = 0.05;  // of the energy put in
constexpr double most_taken_by_closing = 0.05;     // the same
constexpr double fastest_that_matters = 33;        // Hz: beyond it a structure follows the ground as a rigid one
constexpr double least_mass_share = 0.05;          // of a mode that matters, along some axis; the first one always

/// What was noted when the motion began, or would begin.
struct TrustStart {
    bool at_rest = false;  // after a static stage; else in the state the run began with
    NaturalModes modes;    // of the structure as it stood
    EnergyLedger energy;   // what had been booked by then
};

/// What is done to a vibration, as shares of critical damping.
struct DampingAt {
    double frequency = 0;     // Hz
    double algorithmic = 0;   // by the integrator
    double dashpots = 0;      // by the relaxation time of joints
    double asked = 0;         // by the damping of the stage and of materials
    double period_error = 0;  // -, > 0: too long
    bool matters = false;     // is judged
};

/// Where the energy went that was put in while the structure moved. Shares of `put_in`.
struct EnergyShares {
    double put_in = 0;      // J: the work done on the blocks, what they lost, or what they had stored: the largest
    double integrator = 0;  // algorithmic and algorithmic_rotation, each by its size
    double closing = 0;     // by contacts that close or open within a step
    double contacts = 0;    // redetection, by its size
    double friction = 0;    // in joints
    double impact = 0;      // of stones that land
    double damping = 0;     // of the stage and of materials
    double dashpots = 0;    // of joints
    double fracture = 0;    // of joints
    double yielding = 0;    // of bars
};

/// A limit that is exceeded.
struct TrustFinding {
    /// What is beyond its limit.
    enum class Kind {
        algorithmic_damping,  // of a vibration
        dashpots,             // the same
        period,               // of the first mode
        soft_joints,          // that follow from a rule
        stiff_stones,         // that do not bend
        integrator_energy,    // taken
        closing_energy,       // taken by contacts that close or open within a step
    };
    Kind kind = Kind::algorithmic_damping;  // of limit
    double frequency = 0;  // Hz, of the slowest vibration that is beyond the limit, if it is about vibrations
    double value = 0;      // what is too much of that one
    double limit = 0;      // of it
    double worst = 1;      // value / limit of the worst one
};

/// How much to trust a run.
struct Trust {
    TrustStart start;  // when the motion began
    int stage = -1;    // the dynamic stage that damps most; -1 in a case without
    std::vector<DampingAt>
        damping;                // of every mode; at 1, 5 and 10 Hz where no mode matters; empty without a stage
    bool of_modes = false;      // the damping is that of the modes
    bool steps_follow = false;  // their error: the damping is that of the longest, and no finding
    EnergyShares shares;        // of what has been run so far
    std::vector<TrustFinding> findings;  // what is beyond its limit; empty: nothing is
};

/// Where the energy went since `then`. @param at_rest the structure came to rest by then
EnergyShares shares_of(const EnergyLedger& now, const EnergyLedger& then, bool at_rest);

/// The stages with the steps that they began with.
std::vector<Stage> as_begun(std::vector<Stage> stages, const std::vector<ShorterSteps>& shorter);

/// Judges a run. @param stages as_begun(); @param now its ledger; that of `start` if it has not run yet
Trust trust_in(const TrustStart& start, const std::vector<Stage>& stages, const EnergyLedger& now);

}  // namespace voussoir
