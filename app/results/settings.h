// The stages of a case in words and numbers, for results.h5 and summary.json.
#pragma once

#include <string>
#include <string_view>

#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::results
{

std::string_view name_of(Integrator integrator);
std::string_view name_of(OpenClose open_close);
std::string_view name_of(LinearSolverKind solver);
std::string_view name_of(StageType type);
std::string_view name_of(ContactStiffness::Kind kind);
std::string_view name_of(FaceLaw face);
std::string_view name_of(PlaneCondition plane);
std::string_view name_of(RestSupport support);

/// All settings of all stages as JSON text, SI units, keys as in the Stage struct with units appended.
std::string settings_json(const std::vector<Stage>& stages, Kinematics kinematics);

}  // namespace voussoir::app::results
