// Stiffness, mass and joints of a structure that vibrates about a state.
#pragma once

#include <vector>

#include "libdda/block/kinematics_traits.h"
#include "libdda/contact/stone_bending.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"
#include "libdda/solve/block_matrix.h"

namespace voussoir
{

/// A point of a closed joint.
template <class K>
struct VibratingPoint {
    int patch = 0;                             // its contact patch, ascending
    int row_a = -1, row_b = -1;                // of the unknowns of its blocks; -1: held
    typename K::Vector lever_a, lever_b;       // m
    typename K::Vector normal;                 // unit
    double normal_stiffness = 0;               // N/m
    double shear_stiffness = 0;                // N/m
    double stone_normal = 0, stone_shear = 0;  // the two half stones beside it / the joint, of compliance
    double relaxation_time = 0;                // s, of its dashpots
    bool measured = false;                     // its stiffness is an input in Pa/m
    bool at_corners = true;                    // its face rests on its corners alone
};

/// A face beside which stones bend and twist.
template <class K>
struct BentFace {
    static constexpr int turns = K::dimension + 1;  // slope of the gap, and the twist about the normal
    /// All of these.
    using Turns = Eigen::Matrix<double, turns, 1>;

    int first = 0, end = 0;     // the closed points of its patch
    typename K::Vector centre;  // m, of its area, from block a
    /// 1/(Nm), what the stones turn by the moments that the face would have if they did not.
    Eigen::Matrix<double, turns, turns> give = Eigen::Matrix<double, turns, turns>::Zero();

    typename K::Vector place(const VibratingPoint<K>& p) const { return p.lever_a - centre; }  // m
    /// Way of a point about the normal [m].
    typename K::Vector around(const VibratingPoint<K>& p) const
    {
        if constexpr (contact::twists<K::dimension>)
            return p.normal.cross(place(p));
        else
            return K::Vector::Zero();
    }
};

/// What vibrates: the blocks with unknowns that a closed joint holds.
template <class K>
struct Vibration {
    solve::BlockMatrix stiffness;           // N/m and the like, by row
    std::vector<double> mass;               // (rows x unknowns x unknowns)
    std::vector<double> translating_mass;   // (rows x dimension) kg; 0 where it is held
    std::vector<int> block_of_row;          // the blocks with unknowns
    std::vector<VibratingPoint<K>> points;  // of closed joints
    std::vector<BentFace<K>> bent;          // ascending; without those beside which no stone bends
};

/// @param state at rest; its velocities do not count
template <class K>
Vibration<K> vibration_about(const Model& model, const State& state);

}  // namespace voussoir
