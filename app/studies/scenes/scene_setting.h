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
    Integrator integrator = StepControl{}.integrator;
    OpenClose open_close = OpenClose::newton;
    double time_step = 1e-3;                      // s
    std::optional<double> stiffness_factor = {};  // times the contact stiffness that the scene has without it
    // Joints as in the papers, not the program's defaults: impacts are left to springs, and where a paper gives no
    // stiffness these have E/L in rigid scenes and 10 E/L in deformable ones.
    bool papers_joints = false;
    double error_rate = 0;  // m/s3: steps follow an error of so much x time_step^3; 0: they are of one length
};

}  // namespace voussoir::app::studies::scenes
