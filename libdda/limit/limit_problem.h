// Rigid blocks that press and rub on one another, as limit analysis takes them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::limit
{

/// A point at which two blocks may press and rub.
struct LimitContact {
    int block_a = 0, block_b = 0;                        // indices into LimitProblem::blocks
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // m
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();    // unit, from b to a
    double friction = 0;                                 // -, coefficient
    double cohesion = 0;                                 // N, of a joint that is bonded
    double tension = 0;                                  // N, the same
    double stiffness = 1;  // -, of its spring; only limits without dilatancy depend on it
};

/// Metal from a point of one block to a point of another.
struct LimitBar {
    int block_a = 0, block_b = 0;  // indices into LimitProblem::blocks
    Eigen::Vector3d end_a = Eigen::Vector3d::Zero(), end_b = Eigen::Vector3d::Zero();  // m
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();                                   // unit, from a to b
    double tension = 0, compression = 0, shear = 0;                                    // N, at which it yields
};

/// A rigid block. Both loads act at its centroid.
struct LimitBlock {
    std::array<bool, 3> held{};                          // along x, y, z: any force is taken there
    bool turning_held = false;                           // any moment
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  // m
    Eigen::Vector3d dead = Eigen::Vector3d::Zero();      // N, the load that stays
    Eigen::Vector3d live = Eigen::Vector3d::Zero();      // N, what a factor multiplies

    void hold() { held = {true, true, true}, turning_held = true; }
};

/// Blocks as they stand; displacements are small.
struct LimitProblem {
    bool planar = false;  // in x and z: nothing moves along y, nothing turns but about y
    std::vector<LimitBlock> blocks;
    std::vector<LimitContact> contacts;
    std::vector<LimitBar> bars;
};

/// What stands for a face.
enum class FacePoints {
    corners,  // a force anywhere within it is one at its corners; the couple about its normal is too strong
    all,      // with the area of each for a stiffness
};

/// A model in a state: its blocks where they stand, every point of its contacts that is open by no more than
/// `reach`, its bars.
/// @param dead, live accelerations [m/s2] @param reach of a contact [share of the smaller block's size]
LimitProblem limit_problem_of(const Model& model, const State& state, const Eigen::Vector3d& dead,
                              const Eigen::Vector3d& live, double reach, FacePoints points = FacePoints::corners);

/// Whether limit analysis knows all that acts in a model: not where ground carries waves, which takes what force
/// it is given.
bool is_known_to_limit_analysis(const Model& model);

}  // namespace voussoir::limit
