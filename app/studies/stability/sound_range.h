// Over how many decades of stiffness and time step a map holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/studies/stability/runner.h"

namespace voussoir::app::studies::stability
{

/// What every map must reach: masonry needs it.
inline constexpr double least_decades_of_stiffness = 8, least_decades_of_step = 3;

/// A rectangle of a map in which every cell has passed.
struct SoundRange {
    double softest = 0, stiffest = 0;  // N/m
    double shortest = 0, longest = 0;  // s

    double decades_of_stiffness() const;
    double decades_of_step() const;
    bool is_enough() const;
};

/// The rectangle that comes nearest to what a map must reach, or goes furthest beyond it; none if no cell passed.
/// @param scene over stiffness and time step; @param results of any cells, its own among them
std::optional<SoundRange> sound_range(const StabilityScene& scene, const std::vector<CellResult>& results);

/// "sliding holds from 1e+05 to 1e+14 N/m and from 10 us to 10 ms (9 and 3 decades)". Empty for a scene that is no
/// map, or of which not all cells were run.
std::string sound_range_in_words(const StabilityScene& scene, const std::vector<CellResult>& results);

/// Whether all cells of a map were run and it holds over less than it must.
bool holds_too_little(const StabilityScene& scene, const std::vector<CellResult>& results);

}  // namespace voussoir::app::studies::stability
