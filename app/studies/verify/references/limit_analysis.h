// Limit analysis of rigid blocks: the factor of a live load at which they become a mechanism, by linear programming.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voussoir::app::studies::verify::references
{

/// A point at which two blocks may press and rub. It takes no tension.
struct LimitContact {
    int block_a = 0, block_b = 0;                            // indices into LimitProblem::blocks
    Eigen::Vector3d position = Eigen::Vector3d::Zero();      // m
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();        // unit, from b to a
    double friction = 0;                                     // -, coefficient
};

/// A rigid block. Both loads act at its centroid.
struct LimitBlock {
    bool held = false;                                       // takes any force: it has no equations
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();      // m
    Eigen::Vector3d dead = Eigen::Vector3d::Zero();          // N, the load that stays
    Eigen::Vector3d live = Eigen::Vector3d::Zero();          // N, what the factor multiplies
};

/// Blocks as they stand; displacements are small.
struct LimitProblem {
    bool planar = false;  // in x and z: nothing moves along y, nothing turns but about y
    std::vector<LimitBlock> blocks;
    std::vector<LimitContact> contacts;
    // In space the friction cone is an inscribed pyramid of so many sides, two of its edges in the plane of the
    // normal and the live load: at the worst it lacks 1 - cos(pi/sides) of the friction.
    int sides = 16;
};

/// How sliding contacts dilate.
enum class Flow {
    associated,      // by the angle of friction: the lower bound theorem holds, the factor is the greatest of all
    non_associated,  // not at all: Coulomb's friction
};

/// What limit analysis says.
struct LimitState {
    bool found = false;                   // else the blocks do not stand under the dead load, or no factor is too much
    double factor = 0;                    // -, of the live load at which the blocks move
    std::vector<double> normal_forces;    // (contacts) N, of one of the states of equilibrium at that factor
    std::vector<Eigen::Vector3d> forces;  // (contacts) N, on block a
    double beyond_friction = 0;           // of these forces: largest sum over a joint of |shear| - mu N / total dead load
    int programs = 0;                     // linear programs solved
};

/// The greatest factor for which contact forces within the cones of friction balance dead + factor x live on every
/// block (associated). Source: [Livesley1978].
///
/// Without dilatancy a contact that slides does no work against its normal force: its friction acts as a cohesion,
/// mu times the normal force of the state of collapse. This force is not known before, so programs with the
/// cohesion of the last normal forces follow each other until the factor stays. Source: [GilbertCasapullaAhmed2006].
/// The factor is that of a state that satisfies friction and moves without dilating; there may be several.
LimitState limit_state(const LimitProblem& problem, Flow flow);

}  // namespace voussoir::app::studies::verify::references
