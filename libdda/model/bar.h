// Metal between stones: tie rods, cramps and dowels.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>

namespace voussoir
{

/// A bar from a point of one block to a point of another, elastic and perfectly plastic along its axis and across
/// it, each by itself. A rod pulls along the line between its ends, wherever they go. A dowel sits in a joint:
/// both ends are at the same place, and its axis turns with block a.
struct Bar {
    std::string name;                                          // as in the case file, or of the two blocks
    int block_a = 0, block_b = 0;                              // indices into Model::blocks
    Eigen::Vector3d anchor_a = Eigen::Vector3d::Zero();        // m, from the centroid of block a as it is drawn
    Eigen::Vector3d anchor_b = Eigen::Vector3d::Zero();        // m, the same of block b
    bool is_rod = true;                                        // else a dowel
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();           // of a dowel, as it is drawn; unit
    double length = 0;                                         // m, of a rod as it is drawn
    double hold = std::numeric_limits<double>::infinity();     // m, pulled out so far it is out for good
    double axial = 0;                                          // N/m
    double lateral = 0;                                        // N/m, of a dowel
    double tension = std::numeric_limits<double>::infinity();  // N at which it yields; 0: none, it is slack
    double compression = 0;                                    // N, the same
    double shear = std::numeric_limits<double>::infinity();    // N, > 0
    double prestress = 0;                                      // N, tension at the start of the run
};

/// The most that a bar has carried.
struct BarPeaks {
    double tension = 0, compression = 0, shear = 0;  // N
    std::optional<double> yielded;                   // s since the run's start: the first time
    std::optional<double> out;                       // s, when a dowel left its hole
};

}  // namespace voussoir
