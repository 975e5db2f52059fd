// What boundaries and damping take, from the motion alone: the forces as they are defined, on the way that the
// blocks went. Nothing here is the engine's: it books what its own forces did, whatever they are.
#pragma once

#include <vector>

#include "tests/libdda/ground_scenes.h"

namespace voussoir::testing
{

/// Books a dynamic stage of deformable blocks step by step. One foundation at most may move.
/// Source: docs/method.md, Boundaries; Damping of blocks.
class MotionBook
{
 public:
    MotionBook(const Model& model, const Stage& stage, const State& start);
    /// Takes up where a step has left the scene. In the mean over a step a force is that of the mean velocity, and
    /// by the integrator's share that of the end.
    void add_step(const State& now);
    /// The engine's book with all that the motion gives: kinetic and strain energy, work of gravity and of
    /// boundaries, what dampings took. The rest (contacts, friction, losses of the integrator) stays the engine's.
    EnergyLedger ledger_with(EnergyLedger engine) const;

    double gravity_work = 0, boundary_work = 0;        // J, so far
    double damping_kinetic = 0, damping_mass = 0;      // J: the rate of the stage, Rayleigh's a
    double damping_stiffness = 0, damping_memory = 0;  // J: Rayleigh's b, branches
    double damping_contact = 0;                        // J: dashpots of joints
    double kinetic = 0, strain = 0;                    // J, now
    double material() const { return damping_mass + damping_stiffness + damping_memory; }

 private:
    /// A block at the start or at the end of the step, or what changes between them.
    struct Place {
        Eigen::Vector3d centroid;  // m
        Eigen::Matrix3d map;       // -
        Eigen::Vector3d at(const Eigen::Vector3d& lever) const { return centroid + map * lever; }
    };
    Place place_of(const State& state, int block) const;
    Place way_of(int block) const;
    Place blended_velocity(int block) const;
    Eigen::Matrix3d strain_at(const State& state, int block) const;
    Eigen::Matrix3d stress_in_step(int block) const;
    double elastic_energy(int block, const Eigen::Matrix3d& strain) const;
    void find_memory();
    void add_faces();
    void add_block_damping(int block);
    void add_joint_dashpots();
    double work_on(const BlockFace& face, int column, const double* reaction,
                   const ViscousBoundary& boundary) const;
    double stored_in_blocks() const;
    double stored_in_ties() const;

    const Model& model_;
    Stage stage_;
    double h_ = 0;                                    // s
    State before_, now_;                              // now_: its velocities are those before the kinetic damping
    std::vector<std::vector<Eigen::Matrix3d>> felt_;  // E - q of each block and branch, now
    std::vector<Eigen::Matrix3d> felt_stress_;        // Pa, what branches add in the mean over the step
};

}  // namespace voussoir::testing
