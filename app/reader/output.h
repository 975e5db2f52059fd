// The part of a case that says what to write: `output`.
#pragma once

#include <vector>

#include "app/reader/case_file.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// Blocks named in histories must be in the model; times of snapshots must lie in the run.
OutputOptions read_output(YamlCursor& top, const Model& model, const std::vector<Stage>& stages);

}  // namespace voussoir::app::reader
