// What a static stage remembers of its steps: whether its stones come to rest, or go on moving.
#pragma once

#include <vector>

namespace voussoir
{

/// Of the static stage under way. Whoever goes on from here needs all of it.
struct StaticCourse {
    std::vector<double> start;   // State::coordinates at the stage's start; empty before its first step
    std::vector<double> before;  // the same at the start of the last step
    double acceleration = 0;     // m/s2, that moved the stones in the last step: root mean square over their mass
    int steady = 0;              // steps running in which they went on the way they went, no slower
    double kinetic = 0;          // J, of stones that were let go, after the last step; 0: all were held at rest
    int idle = 0;                // steps running in which unbalanced force and motion were both negligible
};

}  // namespace voussoir
