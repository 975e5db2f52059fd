// All that changes: enough to restart bit for bit.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "libdda/geometry/plane.h"
#include "libdda/model/model.h"

namespace voussoir
{

/// What a contact point does.
enum class ContactStatus : std::uint8_t {
    open,     // carries nothing
    locked,   // its shear is below the friction bound, or it is bonded
    sliding,  // at the friction bound
};

/// In the feature of points inside a face.
constexpr std::uint32_t inner_feature = 0x80000000;

/// One corner of a contact polygon, one end of a contact segment (planar), the one point of an edge-edge contact,
/// or a point inside a face. Forces act on block a of the patch.
template <int D>
struct ContactPointIn {
    std::uint32_t feature = 0;  // which vertex, or which edge crosses which side: survives sliding
    ContactStatus status = ContactStatus::open;      // at the end of the step
    double gap = 0;                                  // m, > 0 open; from rest_gap on
    double rest_gap = 0;                             // m, without stress: drawn, bonded or forgiven
    double area = 0;                                 // m2, tributary
    double normal_force = 0;                         // N, > 0 pressing
    VectorIn<D> position = VectorIn<D>::Zero();      // m, on block a at the end of the step
    VectorIn<D> shear_force = VectorIn<D>::Zero();   // N, resisting: block a receives -shear_force
    VectorIn<D> elastic_slip = VectorIn<D>::Zero();  // m, of the shear springs at step end
    VectorIn<D> plastic_slip = VectorIn<D>::Zero();  // m, accumulated sliding of a over b
};

/// The contact of two convex parts: block b owns the reference face, block a is incident.
template <int D>
struct ContactPatchIn {
    int block_a = 0, block_b = 0;                // indices into Model::blocks
    int part_a = 0, part_b = 0;                  // of the blocks
    std::uint32_t feature_a = 0, feature_b = 0;  // incident face and reference face, or the two edges
    bool edge_edge = false;                      // else a face is clipped
    bool intact = false;                         // still has cohesion and tensile strength
    double stiffness = 0;                        // Pa/m, normal
    double bending_energy = 0;                   // J, in the stones beside it, which bend
    VectorIn<D> normal = VectorIn<D>::Zero();    // unit, outward from b, at the start of the step
    int first_point = 0, point_count = 0;        // in the points of its set
};

/// Patches ascend in (part of a or b with the lower index, other part).
template <int D>
struct ContactSetIn {
    std::vector<ContactPatchIn<D>> patches;  // ascending
    std::vector<ContactPointIn<D>>
        points;  // patch by patch, the corners of each in their order before what is inside
};

/// Whether a point lies inside its face: it is no corner.
template <int D>
bool is_inner(const ContactPointIn<D>& point)
{
    return (point.feature & inner_feature) != 0;
}

/// All points of a patch.
template <int D>
std::span<const ContactPointIn<D>> points_of(const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
{
    return std::span(contacts.points).subspan(patch.first_point, patch.point_count);
}

/// Those of them that bound it: gaps are widest and deepest there.
template <int D>
std::span<const ContactPointIn<D>> corners_of(std::span<const ContactPointIn<D>> points)
{
    std::size_t count = 0;
    while (count < points.size() && !is_inner(points[count])) ++count;
    return points.first(count);
}
/// The same of a patch of a set.
template <int D>
std::span<const ContactPointIn<D>> corners_of(const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
{
    return corners_of(points_of(contacts, patch));
}
/// Behind the last of them.
template <int D>
int end_of_corners(const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
{
    return patch.first_point + static_cast<int>(corners_of(contacts, patch).size());
}

using ContactPoint = ContactPointIn<3>;  ///< In space.
using ContactPatch = ContactPatchIn<3>;  ///< In space.
using ContactSet = ContactSetIn<3>;      ///< In space.

/// All that changes in a run.
struct State {
    double time = 0;                  // s since the run's start
    std::int64_t step = 0;            // accepted steps since the run's start
    int stage = 0;                    // the stage under way
    double stage_time = 0;            // s since the stage's start
    std::int64_t grid = 0;            // nominal steps of the stage that are complete
    double next_time_step = 0;        // s; 0: the nominal one
    std::vector<double> coordinates;  // (blocks x coordinates_per_block): centroid and map, quaternion or angle
    std::vector<double> velocities;   // (blocks x unknowns_per_block): dc/dt and dA/dt (column major), or omega
    std::vector<double> foundation_anchors;  // (foundations x dimension) m: centroid at the start of the stage
    // (faces of all boundaries x dimension x (1 + dimension)) N, Nm: the reaction of static stages, its integral
    // of t (1, X), t the traction and X the reference lever
    std::vector<double> boundary_reactions;
    // (blocks x the most branches of a material x dimension x dimension): strain of their dashpots (Green, column
    // major); empty without branches
    std::vector<double> branch_strains;
    std::vector<double>
        bars;  // (bars x (dimension + 1)) m: plastic stretch in the frame of each; 1: out of its hole
    ContactSetIn<3> contacts;         // of a spatial scene
    ContactSetIn<2> planar_contacts;  // of a planar one
};

/// The contacts of a scene of D dimensions.
template <int D>
ContactSetIn<D>& contacts_in(State& state)
{
    if constexpr (D == 3)
        return state.contacts;
    else
        return state.planar_contacts;
}
/// The same, not to be changed.
template <int D>
const ContactSetIn<D>& contacts_in(const State& state)
{
    return contacts_in<D>(const_cast<State&>(state));
}

/// Where a block is: x = centroid + map X, X the reference lever. The map is a rotation in rigid scenes.
template <int D>
struct PoseIn {
    VectorIn<D> centroid;  // m
    MatrixIn<D> map;       // -
};
using Pose = PoseIn<3>;  ///< In space.

/// Of a scene of D dimensions.
template <int D>
PoseIn<D> pose_in(Kinematics kinematics, const State& state, int block);

/// Strain of the dashpot of a branch of a block's material (Green), of a deformable scene with branches.
template <int D>
Eigen::Map<MatrixIn<D>> branch_strain_in(State& state, int block, int branch)
{
    constexpr std::size_t unknowns = D + D * D;
    const std::size_t slots = state.branch_strains.size() * unknowns / (state.velocities.size() * D * D),
                      at = static_cast<std::size_t>(block) * slots + static_cast<std::size_t>(branch);
    return Eigen::Map<MatrixIn<D>>(state.branch_strains.data() + at * D * D);
}
/// The same, not to be changed.
template <int D>
MatrixIn<D> branch_strain_in(const State& state, int block, int branch)
{
    return branch_strain_in<D>(const_cast<State&>(state), block, branch);
}

// In space, whatever the dimension of the scene:

/// Where a block is.
Pose pose_of(Kinematics kinematics, const State& state, int block);

/// Velocity of a block's centroid [m/s].
Eigen::Vector3d velocity_of(Kinematics kinematics, const State& state, int block);

/// dA/dt of a block [1/s].
Eigen::Matrix3d map_rate_of(Kinematics kinematics, const State& state, int block);

/// Angular velocity of a block [rad/s]: of the spin, or of the momentum-carrying part of dA/dt.
Eigen::Vector3d angular_velocity_of(const Model& model, const State& state, int block);

/// Cauchy stress of a block [Pa]; deformable scenes only. sigma = A S A^T / det A of a St Venant-Kirchhoff block.
/// In plane stress A and det A are those of the plane: the change of thickness is left out.
Eigen::Matrix3d stress_of(const Model& model, const State& state, int block);

/// All blocks where the model has them, and moving as Model::initial_motions says.
State initial_state(const Model& model);

/// Gives blocks the velocities of Model::initial_motions, whatever they had; the others keep theirs.
void set_in_motion(const Model& model, State& state);

/// Makes the state ready for a stage: remembers where the foundations stand, resets the stage clock.
void begin_stage(const Model& model, int stage_index, State& state);

/// FNV-1a over every bit that matters; equal states have equal hashes.
std::uint64_t hash_of(const State& state);

}  // namespace voussoir
