// What a scene is built for and run with.
#pragma once

#include <optional>

#include "libdda/model/kinematics.h"
#include "libdda/model/step_control.h"

namespace voussoir::app::studies::scenes
{

/// What studies vary of a scene.
struct SceneSetting {
    Kinematics kinematics = Kinematics::spatial_rigid;
    Integrator integrator = Integrator::newmark;
    OpenClose open_close = OpenClose::newton;
    double time_step = 1e-3;                 // s
    std::optional<double> stiffness_factor;  // times the documented default contact stiffness
};

}  // namespace voussoir::app::studies::scenes
