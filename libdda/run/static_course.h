// What a static stage remembers of its steps: whether its stones come to rest, or go on moving.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Where a static stage began, to begin it again.
struct StageStart {
    State state;
    RunReport report;
};

/// How one way to rest ended.
enum class WayEnd : std::uint8_t {
    none,    // it has not
    rested,  // all unbalanced forces are gone
    fell,    // stones fall
    lost,    // neither, or the numerics gave up
};

/// Of the static stage under way. Whoever goes on from here needs all of it.
struct StaticCourse {
    std::optional<StageStart> start;  // none before its first step
    WayEnd first_way = WayEnd::none;  // how the first of two ways ended; none: this is the first
    std::vector<double> before;       // State::coordinates at the start of the last step
    double acceleration = 0;  // m/s2, that moved the stones in the last step: root mean square over their mass
    int steady = 0;           // steps running in which they went on the way they went, no slower
    double kinetic = 0;       // J, of stones that were let go, after the last step; 0: all were held at rest
    int idle = 0;             // steps running in which unbalanced force and motion were both negligible
    bool falls = false;       // stones are let go, for nothing balances them
    double asked_at = -1;     // largest share gone when it was last asked whether anything does; < 0: never
    bool was_hard = false;    // a step was cut, or took long
};

}  // namespace voussoir
