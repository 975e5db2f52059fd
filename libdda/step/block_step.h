// One block within one step: where it would go without forces, its inertia, its elasticity, and its update.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"
#include "libdda/step/kinematics_traits.h"

namespace voussoir
{

/// Lame's constants of a block and its volume.
struct Elasticity {
    double lambda = 0, mu = 0;  // Pa
    double volume = 0;          // m3, reference

    Eigen::Matrix3d stress(const Eigen::Matrix3d& green_strain) const
    {
        return lambda * green_strain.trace() * Eigen::Matrix3d::Identity() + 2 * mu * green_strain;
    }
    double energy(const Eigen::Matrix3d& green_strain) const
    {
        const double trace = green_strain.trace();
        return volume * (0.5 * lambda * trace * trace + mu * green_strain.squaredNorm());
    }
};

/// A block in a step of length h. "Predicted" is where it comes to rest relative to the step: q^ = q + h v with
/// the rotation done exactly, so that the unknowns D measure only what forces do.
template <class K>
struct BlockStep {
    using Unknowns = typename K::Unknowns;
    using Square = typename K::Square;

    int row = -1;  // of its unknowns in the system; -1: fully held
    std::array<bool, K::unknowns> held{};
    double mass = 0, size = 0;                                 // kg; m, cube root of the volume
    Eigen::Matrix3d density_second = Eigen::Matrix3d::Zero();  // kg m2, reference configuration
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();          // kg m2, predicted configuration
    Pose start, predicted;
    Eigen::Matrix3d step_rotation = Eigen::Matrix3d::Identity();          // of the prediction
    Eigen::Quaterniond predicted_rotation;                                // rigid
    Eigen::Vector3d start_velocity, predicted_velocity, ground_velocity;  // m/s
    Eigen::Vector3d start_spin, predicted_spin, momentum;                 // rad/s, Nms
    Eigen::Matrix3d stretching = Eigen::Matrix3d::Zero();  // dA/dt without the spin, turned to the prediction
    double start_kinetic = 0, predicted_kinetic = 0;       // J, of components that are not held
    Eigen::Vector3d body_force = Eigen::Vector3d::Zero();  // N, gravity and body accelerations
    Eigen::Vector3d gravity = Eigen::Vector3d::Zero();     // N, the gravity part of it
    Elasticity elasticity;
    Eigen::Matrix3d start_strain = Eigen::Matrix3d::Zero();  // Green
    double elastic_blend = 1;                                // theta of the integrator
    Unknowns steady = Unknowns::Zero();    // forces that do not depend on D: body forces, centrifugal load
    Square base = Square::Zero();          // 2 M / h^2 plus elastic stiffness
    Square inertia = Square::Zero();       // 2 M / h^2
    Unknowns velocity = Unknowns::Zero();  // predicted velocity in terms of the unknowns

    /// Velocity of the point at `lever` relative to the centroid, in the prediction [m/s].
    Eigen::Vector3d spin_velocity(const Eigen::Vector3d& lever) const { return K::gradient(velocity) * lever; }
};

/// What the block's own deformation does at the iterate D.
template <class K>
struct InternalForce {
    typename K::Unknowns force = K::Unknowns::Zero();  // elastic resistance conjugate to D
    double energy = 0;                                 // J, stored
    double loss = 0;                                   // J, algorithmic, >= 0
    bool admissible = true;                            // false when the block would turn inside out
};

/// Prepares one block for a step of length h. @param end_time stage time at the end of the step [s]
template <class K>
void begin_block(const Model& model, const Stage& stage, const State& state, int block, double h, double end_time,
                 BlockStep<K>& step);

template <class K>
InternalForce<K> internal_force(const BlockStep<K>& step, const typename K::Unknowns& d);

/// Puts the accepted unknowns into the state. @param moment of the external forces about the centroid [Nm]
template <class K>
void update_block(const BlockStep<K>& step, const typename K::Unknowns& d, const Eigen::Vector3d& moment, double h,
                  int block, State& state);

/// Kinetic energy of the components of a block that are not held [J].
template <class K>
double kinetic_energy_of(const BlockStep<K>& step, const State& state, int block);

/// R_b of this step: the block's whole rotation, for vectors that turn with it.
template <class K>
Eigen::Matrix3d rotation_of_step(const BlockStep<K>& step, const typename K::Unknowns& d);

extern template struct BlockStep<SpatialDeformable>;
extern template struct BlockStep<SpatialRigid>;

}  // namespace voussoir
