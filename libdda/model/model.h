// What stays constant in a run: blocks, what they are made of, what holds them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libdda/geometry/convex_polygon.h"
#include "libdda/geometry/convex_polyhedron.h"
#include "libdda/geometry/moments.h"
#include "libdda/model/bar.h"
#include "libdda/model/boundary.h"
#include "libdda/model/hysteresis.h"
#include "libdda/model/kinematics.h"

namespace voussoir
{

/// Damping that grows with mass and with stiffness: ratio a / (2 omega) + b omega / 2 at the angular frequency
/// omega.
struct RayleighDamping {
    double of_mass = 0;       // 1/s, a
    double of_stiffness = 0;  // s, b

    /// Whether there is any.
    bool any() const { return of_mass != 0 || of_stiffness != 0; }
};

/// What blocks are made of: linear elastic, of one density.
struct BlockMaterial {
    std::string name;                 // as in the case file
    double density = 0;               // kg/m3
    double young = 0;                 // Pa; a rigid scene uses it for the default contact stiffness only
    double poisson = 0;               // -
    double compressive_strength = 0;  // Pa, by which joints are judged; 0: not given. No block ever breaks
    RayleighDamping rayleigh = {};    // in dynamic stages; none by default
    // In dynamic stages; `young` is then that at rest, to which static ones come. Empty by default
    std::vector<MaxwellBranch> branches = {};
};

/// How stiff a contact is, in the spellings that are used.
struct ContactStiffness {
    /// The spellings.
    enum class Kind {
        from_modulus,  // series modulus / mean depth of the two blocks, E/L, so many times
        per_area,      // as joints are measured, Pa/m
        per_point,     // Shi's g0, N/m per contact point, spread over a face contact as value x corners / area
    };
    Kind kind = Kind::from_modulus;  // which of them
    double value = 0;                // E/L (0: as many as the documented rule says), Pa/m, or N/m
    double factor = 1;  // -, times what the spelling gives: how studies vary the stiffness of every spelling
};

/// Where the springs of a face act.
enum class FaceLaw : std::uint8_t {
    corners,  // at its corners, as the papers have it: three times too stiff in bending, too strong in torsion
    points,   // at its corners and at points inside: as stiff as its area, and as strong against turning on it
    linear,   // at such points of the part that presses: as an elastic joint that opens, whose edge yields
};

/// Friction of a joint at one speed of slip.
struct FrictionAtSpeed {
    double speed = 0;  // m/s, > 0
    double angle = 0;  // rad
};

/// How two groups of blocks touch.
struct JointMaterial {
    std::string name;                                // as in the case file
    double friction_angle = 0;                       // rad; of a joint at rest when there is a table
    std::vector<FrictionAtSpeed> friction_at_speed;  // ascending speeds; empty: the same at every speed
    double cohesion = 0;                     // Pa; only joints that are closed at the start of the run have it
    double tensile_strength = 0;             // Pa; a dry joint has neither
    ContactStiffness stiffness;              // normal
    double shear_to_normal_stiffness = 0.5;  // -; Shi's 1/h2
    FaceLaw face = FaceLaw::points;          // where its springs act
    double relaxation_time = 0;  // s, stiffness-proportional contact damping (eta of N = -k(g + eta dg/dt))
    // -, 0..1, of the approach speed where stones land on one another; none: impacts are left to the springs, as
    // in the papers. A dashpot takes its place
    std::optional<double> restitution = 0.0;

    /// Whether stones that land on one another do it by an impulse, and not by springs and dashpots.
    bool has_landing_law() const { return restitution && relaxation_time == 0; }
    /// Whether joints of it may be bonded.
    bool has_strength() const { return cohesion > 0 || tensile_strength > 0; }
};

/// A block: one or more glued convex parts with one set of unknowns.
struct Block {
    std::string name;                     // unique in a model
    int group = 0;                        // index into Model::groups
    int material = 0;                     // index into Model::materials
    std::vector<ConvexPolyhedron> parts;  // spatial scenes; vertices relative to the block's centroid, m
    std::vector<ConvexPolygon> outlines;  // planar scenes; the same
    Moments moments;  // of the stone; centroid in model coordinates, m: the block's reference point
    // What attach_mass added; the reference point is then the common centre of mass.
    double attached_mass = 0;                                   // kg: floor, roof, fill
    Eigen::Matrix3d attached_second = Eigen::Matrix3d::Zero();  // kg m2, on top of the stone's own
    double friction_factor = 1;  // -, times tan(friction angle); a joint takes the mean of its two blocks
};

/// A block that follows the ground. Each component is held (it follows the motion given for it, or stays) or free.
struct Foundation {
    int block = 0;                                           // index into Model::blocks
    std::array<bool, 3> translation_held{true, true, true};  // along x, y, z
    bool rotation_held = true;                               // a foundation block is rigid whatever the scene
    /// Whether the block has no unknowns.
    bool fully_held() const
    {
        return translation_held[0] && translation_held[1] && translation_held[2] && rotation_held;
    }
};

/// How a block moves when motion begins. Held components have no motion of their own.
struct InitialMotion {
    int block = 0;                                       // index into Model::blocks
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m/s, of the centre of mass
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();      // rad/s; in a planar scene along y only
};

/// What holds a planar scene across its plane: nothing moves that way, or nothing pushes.
enum class PlaneCondition { strain, stress };

/// Constant during a run.
struct Model {
    Kinematics kinematics = Kinematics::spatial_deformable;  // of every block
    double thickness = 1;                                    // m, planar scenes only
    PlaneCondition plane = PlaneCondition::strain;           // planar deformable scenes only
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();        // m, subtracted from the user's coordinates on input
    std::vector<std::string> groups;                         // names
    std::vector<BlockMaterial> materials;                    // that blocks refer to
    std::vector<JointMaterial> joints;                       // that pairs of groups refer to
    std::vector<int> joint_of_groups;                        // (groups x groups) row major: index into joints
    std::vector<Block> blocks;                               // in the order of the state
    std::vector<Foundation> foundations;                     // one per held block
    std::vector<InitialMotion> initial_motions;              // at most one per block; the others start at rest
    std::vector<ViscousBoundary> boundaries;                 // where the model ends in the ground
    // Ascending: deformable blocks whose opposite sides move alike, so that they are ground that goes on for ever
    // sideways. Neither their horizontal lines nor they themselves turn or stretch; what is left is c and dx/dZ.
    std::vector<int> tied_sides;
    std::vector<Bar> bars;           // tie rods, cramps, dowels
    std::vector<SideTie> side_ties;  // sides of the model that are one and the same: it goes on for ever
    // m: what two stones share or lack at a corner of their contact when the run begins, up to this much, is the
    // error of the drawing and the zero of their contact. 0: stones are what is drawn
    double fit_tolerance = 0;

    /// Mass of a block, what is attached included [kg].
    double mass(int block) const
    {
        return materials[blocks[block].material].density * blocks[block].moments.volume +
               blocks[block].attached_mass;
    }
    /// Integral of (x-c)(x-c)^T dm about the block's centre of mass [kg m2].
    Eigen::Matrix3d mass_second(int block) const
    {
        return materials[blocks[block].material].density * blocks[block].moments.second +
               blocks[block].attached_second;
    }
    /// Factor of two blocks on the friction coefficient of their joint.
    double friction_factor(int block_a, int block_b) const
    {
        return 0.5 * (blocks[block_a].friction_factor + blocks[block_b].friction_factor);
    }
    /// The joint material of the groups of two blocks.
    const JointMaterial& joint_between(int block_a, int block_b) const
    {
        const std::size_t row = blocks[block_a].group, column = blocks[block_b].group;
        return joints[joint_of_groups[row * groups.size() + column]];
    }
};

/// Friction coefficient at a speed of slip [m/s]: linear from tan(friction_angle) at rest through the points of
/// the table, constant beyond the last.
double friction_coefficient(const JointMaterial& joint, double speed);

/// How many branches the material has that has most of them.
int most_branches(const Model& model);

/// Length by which distances at a block are judged [m]: the cube root of its volume, planar the root of its area.
double size_of(const Model& model, int block);

/// Makes a block from parts in model coordinates: moves them to their common centroid and integrates the moments.
Block make_block(std::string name, int group, int material, std::vector<ConvexPolyhedron> parts);

/// The same with the stone's own moments, where the parts only approximate its shape.
Block make_block(std::string name, int group, int material, std::vector<ConvexPolyhedron> parts,
                 const Moments& moments);

/// Lets a mass [kg] at a point (3) [m, model coordinates] move with a block, whose reference point goes to the
/// common centre of mass; its elasticity stays. In a planar scene the thickness must have been set before.
void attach_mass(Model& model, int block, double mass, const Eigen::Vector3d& point);

/// The same for a planar scene, from outlines in model coordinates (x, z) and the scene's thickness [m].
Block make_planar_block(std::string name, int group, int material, std::vector<ConvexPolygon> outlines,
                        double thickness);

/// Gives a planar model another thickness [m]; its blocks were made for the one it has.
void set_thickness(Model& model, double thickness);

/// A model with one group, one block material and one joint material; what small scenes and tests start from.
Model make_model(Kinematics kinematics, const BlockMaterial& material, const JointMaterial& joint);

}  // namespace voussoir
