// What results.h5 holds once: the case, the model, the motions.
#pragma once

#include "app/case/case.h"
#include "app/results/hdf5_file.h"
#include "app/results/surface_mesh.h"

namespace voussoir::app::results
{

/// Writes root attributes, /case, /model and, only if a stage has one, /motions.
void write_model_records(const Case& the_case, const SurfaceMesh& mesh, Hdf5File& file);

}  // namespace voussoir::app::results
