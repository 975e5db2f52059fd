// The keys walls and houses share.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/reader/block_reading.h"
#include "importers/patterns/imperfection.h"
#include "importers/patterns/masonry.h"
#include "importers/patterns/pattern.h"

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

/// `imperfection: {seed, size, joint, position, friction}` of patterns of named stones.
importers::patterns::StoneImperfection read_stone_imperfection(YamlCursor& map);

/// `name`, before the names of a pattern's stones: "north" makes "north_keystone"; by default nothing.
std::string read_name_prefix(YamlCursor& map);

/// Reads what the entry says beside the pattern and adds the stones that `make` gives, unless faults were found
/// since there were `faults_before`. Faults that `make` throws are named by keys of `map`.
/// @param groups that the pattern puts stones into
void finish_pattern(YamlCursor& entry, const YamlCursor& map, std::size_t faults_before,
                    const std::vector<std::string>& groups,
                    const std::function<importers::patterns::Pattern()>& make, BlockReading& reading);

/// Adds the blocks of a pattern to the model, wherever the entry places them.
void add_pattern(const std::vector<importers::patterns::MasonryBlock>& blocks, const YamlCursor& map,
                 Belonging belonging, BlockReading& reading);

}  // namespace voussoir::app::reader
