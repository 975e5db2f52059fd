// What stones share and lack as drawn: how much of it is an error of the drawing, what is too much, and whether
// their joints can carry them at all.
#pragma once

#include <optional>

#include "app/case/case.h"
#include "app/reader/findings.h"
#include "app/reader/yaml_cursor.h"

namespace voussoir::app::reader
{

/// Reads `fit_tolerance` [m]; none if it is not given.
std::optional<double> read_fit_tolerance(YamlCursor& top);

/// Gives the model its fit_tolerance: the one given, else what the joints of mesh files need; without meshes 0.
/// Stones that overlap by too much beyond it are faults: by more than 1 % of the smaller one's volume, or as deep
/// as a run would stop at. The model must have its joints.
void settle_fit(YamlCursor& top, const std::optional<double>& given, Case& result, Findings& findings);

/// A fault for a stone so stiff for its weight that its stresses are rounding.
void refuse_rounded_stresses(const Case& the_case, Findings& findings);

/// Faults for stones that are certain to sink too deep into their neighbours in a static stage.
void refuse_soft_joints(const Case& the_case, Findings& findings);

}  // namespace voussoir::app::reader
