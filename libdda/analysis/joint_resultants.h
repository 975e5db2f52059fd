// What each joint carries.
#pragma once

#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Resultant of one joint (all patches of one pair of blocks), acting on block a.
struct JointResultant {
    int block_a = 0, block_b = 0;                      // a < b
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   // N, on block a
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // Nm on block a about `centre`
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, area centroid of the joint's contact polygons
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // area-weighted, outward from block b
    double area = 0;                                   // m2, of the polygons
    double closed_area = 0;                            // m2, tributary area of closed points
    double effective_area = 0;                         // m2, that the normal force acts in the middle of
    double edge_stress = 0;                            // Pa, see below
    double normal_force = 0;                           // N
    double max_opening = 0;                            // m, largest gap of a corner
    double slip = 0;                                   // m, area-weighted length of the accumulated sliding
    Eigen::Vector3d pressure_centre = Eigen::Vector3d::Zero();  // m, where the normal force acts; centre if none
};

/// One entry per pair of blocks in contact, in ascending order of the pair.
///
/// Their edge stress is the mean on the part of a joint that its normal force acts in the middle of. Of a
/// rectangular joint b x l with eccentricities e: N / ((b - 2 e_b) (l - 2 e_l)). Source: Meyerhof (1953), as in EN
/// 1996-1-1, 6.1.2.2; of other shapes with b and l the sides of the smallest rectangle around them, times the
/// share of it that they fill. A joint that bears on its edge bears on a tenth of its extent (ibid., annex C (4)):
/// corner springs put the resultant of a rocking stone on the very edge, where any force would crush. Glued stones
/// that meet in several planes are judged in each, and the worst counts; what lies in one plane is one bed.
std::vector<JointResultant> joint_resultants(const Model& model, const State& state);

}  // namespace voussoir
