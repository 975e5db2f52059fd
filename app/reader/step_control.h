// How a stage is stepped: the numerical settings of `stages`.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// Reads time_step, integrator, open_close, tolerances and solver of one stage.
StepControl read_step_control(YamlCursor& stage, StageType type);

}  // namespace voussoir::app::reader
