// How a structure vibrates about a state at rest.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// One natural vibration. Shares are of 1.
struct NaturalMode {
    double frequency = 0;                                  // Hz
    Eigen::Vector3d mass_share = Eigen::Vector3d::Zero();  // effective mass along x, y, z / mass of all that moves
    double joint_share = 0;                                // of the strain energy, in joints
    // By how much joints whose stiffness is a rule, not a measurement, lower the frequency against that of stones
    // and measured joints. Of deformable stones they add to the compliance, of rigid ones they are all of it.
    double lowered_by_joints = 0;
    // Deformable scenes: by how much elastic stones would lower it, for those of uniform strain do not bend;
    // roughly.
    double raised_by_stones = 0;
    // By how much faces that turn on springs at their corners raise it against faces that turn as their area does;
    // roughly.
    double raised_by_corners = 0;
    double dashpot_time = 0;        // s, mean relaxation time: dashpots damp it with omega x this / 2 of critical
    RayleighDamping rayleigh = {};  // means of the blocks', of mass by kinetic and of stiffness by strain energy
    double hysteretic = 0;  // damping ratio: mean of the blocks' branches' at its frequency, by strain energy
};

/// What became of a search for modes.
enum class ModesOutcome {
    found,           // at least one
    nothing_closed,  // no joint is closed, or what stands is loose: there is nothing that vibrates
    too_costly,      // more work than allowed
    failed,          // no convergence, or a stiffness that is not positive
};

/// The modes found, and what became of the search.
struct NaturalModes {
    ModesOutcome outcome = ModesOutcome::nothing_closed;  // of the search
    std::vector<NaturalMode> modes;                       // rising frequencies, none of them 0
    int loose = 0;       // modes of frequency 0 that were met: stones that nothing holds
    bool rigid = false;  // the stones are: joints stand for their elasticity
};

/// How many modes are wanted, and what they may cost.
struct ModesSearch {
    int count = 6;                                          // modes wanted
    double most_work = std::numeric_limits<double>::max();  // floating-point operations
};

/// The lowest modes of the structure as it stands: the elasticity of its stones, the springs of its closed joints
/// (all of them sticking), what holds its foundations, and no motion of the ground. After a step a joint is closed
/// where it presses or is bonded; in a state before any step, where it is drawn closed. The stress in the
/// structure does not count: its geometric stiffness is smaller by stress / modulus, that of rocking stones aside.
NaturalModes natural_modes(const Model& model, const State& state, const ModesSearch& search = {});

}  // namespace voussoir
