// Places on a stone that a picture marks.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace voussoir::importers::mesh
{

/// What is wrong, and where. Coordinates in the unit and axes of whoever holds it.
struct MarkedFeature {
    std::string label;                                   // a few words: "hole", "faces cross"
    std::vector<Eigen::Vector3d> points;                 // single places
    std::vector<std::array<Eigen::Vector3d, 2>> lines;   // from and to
    std::vector<std::vector<Eigen::Vector3d>> polygons;  // loops
};

}  // namespace voussoir::importers::mesh
