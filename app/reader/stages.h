// The part of a case that says what happens, one thing after another: `stages`.
#pragma once

#include <vector>

#include "app/reader/foundation.h"
#include "app/reader/motion.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// Reads the stages and all motions: those of the foundations, of the stages and of free blocks. A dynamic stage
/// without duration lasts as long as its longest motion.
std::vector<Stage> read_stages(YamlCursor& top, const Model& model, std::vector<FoundationEntry>& foundations,
                               MotionContext& context);

}  // namespace voussoir::app::reader
