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
    double edge_stress = 0;                            // Pa, of the bed that bears most: see edge_stress.h
    double bearing_area = 0;                           // m2, of that bed; 0 when nothing presses
    double normal_force = 0;                           // N
    double widest_gap = 0;                             // m, of a contact point; no opening: see joint_openings.h
    double slip = 0;                                   // m, area-weighted length of the accumulated friction slip
    Eigen::Vector3d pressure_centre = Eigen::Vector3d::Zero();  // m, where the normal force acts; centre if none
};

/// Whether the bed that bears most is looked for, which takes two thirds of the time.
enum class EdgeStress { judged, left_out };

/// One entry per pair of blocks in contact, in ascending order of the pair.
/// @param edge_stress left out: `edge_stress` and `bearing_area` stay 0
std::vector<JointResultant> joint_resultants(const Model& model, const State& state,
                                             EdgeStress edge_stress = EdgeStress::judged);

}  // namespace voussoir
