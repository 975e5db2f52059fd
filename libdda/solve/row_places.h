// Where the blocks of a scene are whose unknowns a matrix has.
#pragma once

#include <vector>

#include "libdda/model/kinematics.h"

namespace voussoir::solve
{

struct RowPlaces {
    Kinematics kinematics = Kinematics::spatial_deformable;
    std::vector<double> centres;  // m, (rows x dimension) of the scene
    std::vector<char> free;       // (rows) whether nothing holds any of its unknowns
};

}  // namespace voussoir::solve
