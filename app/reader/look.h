// What a picture shows beside the stones, and from where.
#pragma once

#include "app/case/case.h"
#include "app/reader/yaml_cursor.h"

namespace voussoir::app::reader
{

/// `hide`, `cut`, `label`, `view`, `follow`, `orthographic`, `forces`, `ground`, and of a film `orbit`. Names are
/// held against the model, so that what is accepted can be drawn. @param stages that may shake the ground
LookOptions read_look(YamlCursor& map, const Model& model, const std::vector<Stage>& stages, bool film);

}  // namespace voussoir::app::reader
