// Ground beside a model: columns that move as it would without it, and sides that are one and the same.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// Fills boundary.free_field: for each of its faces the block of the group, a list of groups, that lies beside it.
/// Model::tied_sides must have been read.
void read_free_field(const YamlCursor& group, const Model& model, ViscousBoundary& boundary);

/// Fills model.side_ties of `periodic_sides: {blocks: soil, sides: [left, right]}`, or a list of such; joints must
/// have been read.
void read_periodic_sides(YamlCursor& value, Model& model);

}  // namespace voussoir::app::reader
