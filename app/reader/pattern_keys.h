// The keys walls and houses share.
#pragma once

#include <string>
#include <vector>

#include "app/reader/block_reading.h"
#include "importers/patterns/masonry.h"

namespace voussoir::app::reader
{

/// `name`, by default the pattern's.
std::string read_pattern_name(YamlCursor& map, const std::string& otherwise);

/// `block: [length, height]`. @returns (2) [m]; NaN, with a fault, when it cannot be used
Eigen::Vector2d read_block_format(YamlCursor& map);

/// `{at, sill, width, height}`, the keys of an opening; sill 0 by default.
importers::patterns::Opening read_opening(YamlCursor& map);

/// `lintel: {height, bearing}`; by default as high as a block, bearing on half a block's length.
importers::patterns::Lintel read_lintel(YamlCursor& map, const Eigen::Vector2d& block, bool needed);

/// `base: {height, projection}`. @param otherwise height when the key is absent [m]; 0: no base
importers::patterns::MasonryBase read_base(YamlCursor& map, double otherwise);

/// `imperfection: {seed, size, joint, friction}`.
importers::patterns::Imperfection read_imperfection(YamlCursor& map);

/// `origin: [x, y, z]`, in planar scenes [x, z] too, and `direction`, which a planar scene has not.
importers::patterns::Placement read_placement(YamlCursor& map, const BlockReading& reading);

/// Turns the faults of a pattern, named by its parameters ("openings[1]"), into faults of the case.
void place_faults(const InputError& error, const YamlCursor& map);

/// Adds the blocks of a pattern to the model, wherever the entry places them.
void add_pattern(const std::vector<importers::patterns::MasonryBlock>& blocks, const YamlCursor& map,
                 Belonging belonging, BlockReading& reading);

}  // namespace voussoir::app::reader
