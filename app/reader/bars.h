// The part of a case that says what metal is between stones: `bars`.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// Fills model.bars: rods from a point of a block to a point of another, and dowels in all joints of two groups.
/// Blocks, their masses and foundations must have been read.
void read_bars(YamlCursor& top, Model& model);

/// The published iteration knows no bars. @param written the stage, for the fault
void refuse_bars(const YamlCursor& written, const Model& model, const Stage& stage);

}  // namespace voussoir::app::reader
