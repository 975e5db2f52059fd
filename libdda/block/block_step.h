// One block within one step: where it would go without forces, its inertia, its elasticity, and its update.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "libdda/block/kinematics_traits.h"
#include "libdda/block/material_memory.h"
#include "libdda/model/elasticity.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::step
{

/// What landing does to a block within a step.
template <class K>
struct Jump {
    int block = 0;                                    // index into Model::blocks
    typename K::Vector velocity = K::Vector::Zero();  // m/s, change
    typename K::Spin momentum = K::Spin::Zero();      // Nms, change of the angular momentum about its centroid
    double fraction = 0;                              // of the step, when it happens
    double approach = 0;                              // m/s, of the fastest landing that makes it
    double ground_work = 0;                           // J, done by moving foundations through its impulses
};

/// A block in a step of length h. "Predicted" is where it comes to rest relative to the step: q^ = q + h v with
/// the rotation done exactly, so that the unknowns D measure only what forces do.
template <class K>
struct BlockStep {
    static constexpr int dimension = K::dimension;
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    using Spin = typename K::Spin;
    using Unknowns = typename K::Unknowns;
    using Square = typename K::Square;

    int row = -1;               // of its unknowns in the system; -1: fully held
    bool is_foundation = true;  // false: foundations need not be looked through for it
    std::array<bool, K::unknowns> held{};
    bool sides_tied = false;                 // it neither turns nor stretches sideways
    double mass = 0;                         // kg
    double size = 0;                         // m, D-th root of volume or area; kept from step to step
    Matrix density_second = Matrix::Zero();  // kg m2, reference configuration
    Matrix spread = Matrix::Zero();          // kg m2, predicted configuration
    PoseIn<dimension> start, predicted;
    Matrix step_rotation = Matrix::Identity();  // of the prediction
    Matrix half_rotation = Matrix::Identity();  // its half: to the middle of the step
    bool turns = false;                         // the prediction is no mere translation
    Matrix flow = Matrix::Identity();           // F of the prediction: the lever y of the start goes to F y
    Matrix chord = Matrix::Zero();  // C with (F - 1) y = C (y + F y)/2: of a rotation, 2 tan(angle/2) axis x
    OrientationIn<dimension> predicted_orientation;              // rigid
    Vector start_velocity, predicted_velocity, ground_velocity;  // m/s
    Spin start_spin, predicted_spin, momentum;                   // rad/s, Nms
    Matrix stretching = Matrix::Zero();               // dA/dt without the spin, turned to the prediction
    double start_kinetic = 0, predicted_kinetic = 0;  // J, of components that are not held
    bool jumps = false;                               // it lands, or is struck by what does
    double impact = 0;                                // J, taken by that
    double ground_work = 0;                           // J, done by moving foundations in it
    Vector ballistic = Vector::Zero();   // m, h v^ minus the predicted move of the centroid: of a jump
    Vector body_force = Vector::Zero();  // N, gravity and body accelerations
    Vector gravity = Vector::Zero();     // N, the gravity part of it
    Elasticity elasticity;
    Matrix start_strain = Matrix::Zero();  // Green
    double elastic_blend = 1;              // theta of the integrator, and what damps by stiffness
    double damping_blend = 0;              // the latter, 2 b / h: stress b dE/dt beside that of E
    MemoryStep<Matrix> memory;             // of a material that has branches; its blend is in elastic_blend too
    Unknowns steady = Unknowns::Zero();    // forces that do not depend on D: body forces, centrifugal load
    Square base = Square::Zero();          // 2 M / h^2 plus elastic stiffness
    Square inertia = Square::Zero();       // 2 M / h^2
    Unknowns velocity = Unknowns::Zero();  // predicted velocity in terms of the unknowns

    bool rotation_held() const { return held.back(); }

    /// Velocity of the point at `lever` relative to the centroid, in the prediction [m/s].
    Vector spin_velocity(const Vector& lever) const { return K::gradient(velocity) * lever; }
};

/// What the block's own deformation does at the iterate D.
template <class K>
struct InternalForce {
    typename K::Unknowns force = K::Unknowns::Zero();  // elastic resistance conjugate to D
    double energy = 0;                                 // J, stored; by branches, what they stored more
    double loss = 0;                                   // J, algorithmic, >= 0
    double damped = 0;                                 // J, by damping that grows with stiffness, >= 0
    bool admissible = true;                            // false when the block would turn inside out
};

/// Whether a stage seeks motion in time, in which blocks are damped, and not rest: stones that are let go on the
/// way to rest do not.
bool is_motion(const Stage& stage);

/// Share of the forces of the end of the step that is taken beyond the mean: theta of the integrator. Newmark,
/// static stages and the published springs know the end of the step only.
double end_share(const Stage& stage);

/// Prepares one block for a step of length h, body accelerations aside. @param end_time stage time at its end [s];
/// @param jumps its own in this step, ascending in time
template <class K>
void begin_block(const Model& model, const Stage& stage, const State& state, int block, double h, double end_time,
                 std::span<const Jump<K>> jumps, BlockStep<K>& step);

/// The same for a block that does not land.
template <class K>
void begin_block(const Model& model, const Stage& stage, const State& state, int block, double h, double end_time,
                 BlockStep<K>& step)
{
    begin_block<K>(model, stage, state, block, h, end_time, std::span<const Jump<K>>(), step);
}

/// Adds the body accelerations of the stage to the blocks, which are prepared; each once, however many blocks.
template <class K>
void add_body_accelerations(const Stage& stage, double h, double end_time, std::vector<BlockStep<K>>& blocks);

/// Makes the elastic force of a block that of the end of the step, whatever the integrator blends.
template <class K>
void take_elasticity_at_end(BlockStep<K>& step);

template <class K>
InternalForce<K> internal_force(const BlockStep<K>& step, const typename K::Unknowns& d);

/// The rotation of a block that nothing turns, as its velocity has it less as it is done: relative to a lever [-].
template <class K>
typename K::Matrix ballistic_turn(const BlockStep<K>& step, double h);

/// Velocity of a block that nothing moves, of the mean of the step and by a share of its end; the two differ where
/// it jumps. @param end share
template <class K>
typename K::Unknowns blended_velocity(const BlockStep<K>& step, double end, double h);

/// Puts the accepted unknowns into the state. @param moment of the external forces about the centroid [Nm]
template <class K>
void update_block(const BlockStep<K>& step, const typename K::Unknowns& d, const typename K::Spin& moment,
                  double h, int block, State& state);

/// Kinetic energy of the components of a block that are not held [J].
template <class K>
double kinetic_energy_of(const BlockStep<K>& step, const State& state, int block);

/// R_b of this step: the block's whole rotation, for vectors that turn with it.
template <class K>
typename K::Matrix rotation_of_step(const BlockStep<K>& step, const typename K::Unknowns& d);

}  // namespace voussoir::step
