// All that changes: enough to restart bit for bit.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "libdda/model/model.h"

namespace voussoir
{

enum class ContactStatus : std::uint8_t { open, locked, sliding };

/// One corner of a contact polygon (or the one point of an edge-edge contact). Forces act on block a of the patch.
struct ContactPoint {
    std::uint32_t feature = 0;  // which vertex, or which edge crosses which side: survives sliding
    ContactStatus status = ContactStatus::open;
    double gap = 0;                                          // m, > 0 open
    double area = 0;                                         // m2, tributary
    double normal_force = 0;                                 // N, > 0 pressing
    Eigen::Vector3d position = Eigen::Vector3d::Zero();      // m, on block a at the end of the step
    Eigen::Vector3d shear_force = Eigen::Vector3d::Zero();   // N, resisting: block a receives -shear_force
    Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();  // m, shear_force / shear stiffness at step end
    Eigen::Vector3d plastic_slip = Eigen::Vector3d::Zero();  // m, accumulated sliding of a over b
};

/// The contact of two convex parts: block b owns the reference face, block a is incident.
struct ContactPatch {
    int block_a = 0, block_b = 0;
    int part_a = 0, part_b = 0;
    std::uint32_t feature_a = 0, feature_b = 0;  // incident face and reference face, or the two edges
    bool edge_edge = false;
    bool intact = false;                               // still has cohesion and tensile strength
    double stiffness = 0;                              // Pa/m, normal
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, outward from b, at the start of the step
    int first_point = 0, point_count = 0;              // in State::contact_points
};

struct State {
    double time = 0;                  // s since the run's start
    std::int64_t step = 0;            // accepted steps since the run's start
    int stage = 0;                    // the stage under way
    double stage_time = 0;            // s since the stage's start
    std::int64_t grid = 0;            // nominal steps of the stage that are complete
    double next_time_step = 0;        // s; 0: the nominal one
    std::vector<double> coordinates;  // (blocks x coordinates_per_block): centroid and map, or quaternion
    std::vector<double> velocities;   // (blocks x unknowns_per_block): dc/dt and dA/dt (column major), or omega
    std::vector<double> foundation_anchors;  // (foundations x 3) m: centroid at the start of the stage
    std::vector<ContactPatch> patches;
    std::vector<ContactPoint> contact_points;
};

/// Where a block is: x = centroid + map X, X the reference lever. The map is a rotation in rigid scenes.
struct Pose {
    Eigen::Vector3d centroid;
    Eigen::Matrix3d map;
};

Pose pose_of(Kinematics kinematics, const State& state, int block);

/// Velocity of a block's centroid [m/s].
Eigen::Vector3d velocity_of(Kinematics kinematics, const State& state, int block);

/// Angular velocity of a block [rad/s]: of the spin, or of the momentum-carrying part of dA/dt.
Eigen::Vector3d angular_velocity_of(const Model& model, const State& state, int block);

/// Cauchy stress of a block [Pa]; deformable scenes only. sigma = A S A^T / det A of a St Venant-Kirchhoff block.
Eigen::Matrix3d stress_of(const Model& model, const State& state, int block);

/// All blocks at rest where the model has them.
State initial_state(const Model& model);

/// Makes the state ready for a stage: remembers where the foundations stand, resets the stage clock.
void begin_stage(const Model& model, int stage_index, State& state);

/// FNV-1a over every bit that matters; equal states have equal hashes.
std::uint64_t hash_of(const State& state);

}  // namespace voussoir
