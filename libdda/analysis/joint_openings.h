// How far joints have opened and slid, whether or not their blocks still touch.
//
// A joint is a pair of blocks, not both wholly held, whose faces face each other and touch where the run begins.
// Its facing area is the part of the contact polygons of such faces where these were no further apart than the
// touching distance. All is relative to the start: what was drawn apart or into one another there is the zero.
#pragma once

#include <span>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// From where on a joint counts as opened, or slid [m]: the finest crack that a gauge shows.
constexpr double noteworthy_opening = 1e-4;

/// A corner of a facing area: two material points that faced each other at the start.
struct FacingPoint {
    Eigen::Vector3d on_a, on_b;  // m, levers: reference places relative to the blocks' centroids
    double start = 0;            // m, their distance along the normal at the start; < 0: drawn into one another
    double area = 0;             // m2, tributary: linear functions are integrated exactly
};

/// Two faces that faced each other at the start, as far as they touched.
struct FacingPatch {
    Eigen::Vector3d normal_a, normal_b;  // unit, outward, in the reference shapes
    std::vector<FacingPoint> points;     // the corners of the facing area
};

/// What a joint has done since the start. Each pair of points is measured along the mean of the normals of its two
/// faces as they are now: two blocks that turn about a common edge open and do not slip.
struct JointMotion {
    double opening = 0;       // m, largest at a corner of the facing area; 0 when closed all over
    double mean_opening = 0;  // m, over that area; < 0: pressed together
    double slip = 0;          // m, mean over that area of how far its points have moved along the joint
    double largest_slip = 0;  // m, of a corner of it
};

/// What of it was done after `rest`: a joint that has come closer, or slid back, is neither open nor has it slid.
JointMotion since(const JointMotion& rest, JointMotion now);

/// A joint of the start of a run.
struct WatchedJoint {
    int block_a = 0, block_b = 0;                      // a < b
    double area = 0;                                   // m2, of the contact polygons of faces that face each other
    double facing_area = 0;                            // m2, of what of them is within the touching distance
    bool bonded = false;                               // it has tensile strength or cohesion at the start
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, of the facing area at the start
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, outward from b; mean over that area
    std::vector<FacingPatch> patches;                  // that the facing area is made of
    JointMotion at_rest;                               // from which its peaks count
};

/// Two faces face each other when their outward normals are within this angle of opposite [rad].
constexpr double facing_angle = 0.262;  // 15 degrees: the triangles of warped joints

/// What is nearer touches [m]: the distance at which the engine looks for contacts of blocks at rest.
double touching_distance(const Model& model, int block_a, int block_b);

/// The joints of a run that begins with this state, in ascending order of the pair.
std::vector<WatchedJoint> joints_at_start(const Model& model, const State& start);

/// Where a block is, and how the normals of its faces turn.
struct PlacedBlock {
    Pose pose;             // of its material points
    Eigen::Matrix3d turn;  // of normals: the cofactors of the map
};

/// All blocks of a state.
std::vector<PlacedBlock> placed_blocks(const Model& model, const State& state, int threads = 1);

/// Of a joint whose blocks stand like this. @param blocks all of the state
JointMotion motion_of(const WatchedJoint& joint, std::span<const PlacedBlock> blocks);

/// The entries of report.joints when a run begins.
std::vector<JointPeaks> no_peaks(const std::vector<WatchedJoint>& joints);

/// Peaks count from this state from now on, in which the first motion begins.
void count_from(const Model& model, const std::vector<double>& coordinates, std::vector<WatchedJoint>& joints);

/// Brings report.joints, one entry for each joint, up to this state.
void note_joints(const Model& model, const std::vector<WatchedJoint>& joints, const State& state,
                 RunReport& report, int threads = 1);

}  // namespace voussoir
