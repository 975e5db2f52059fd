// A case whose blocks are listed one by one.
#pragma once

#include <string>
#include <vector>

#include "app/case/case.h"
#include "importers/mesh/polygon_surface.h"

namespace voussoir::app::commands
{

/// The text of a case with every block in place of what made them; all else stays as it is written. Read again, it
/// is the same model to rounding: names, groups, materials, shapes, friction factors, masses.
/// @throws InputError for what cannot be written so: a case with an initial state, planar blocks of several
/// outlines
std::string explicit_case(const Case& the_case);

/// The blocks as surfaces [m], those of planar scenes as prisms of its thickness.
std::vector<importers::mesh::PolygonSurface> surfaces_of(const Model& model);

}  // namespace voussoir::app::commands
