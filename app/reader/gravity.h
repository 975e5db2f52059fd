// Gravity of the scene, and how a stage changes it: `gravity` at the top and in a stage.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// `gravity: {magnitude: 9.80665 m/s2, direction: [0, 0, -1]}` as a vector [m/s2]; none along y in a planar scene.
Eigen::Vector3d read_gravity(YamlCursor& top, Kinematics kinematics);

/// `gravity: {ramp: 2 s, tilt: 10 deg, from: 0 deg, towards: [1, 0, 0]}` of a stage, if it has one, into the
/// stage, whose gravity is the scene's: turned by `tilt`, and in a dynamic stage grown from nothing, or turned
/// from `from`, within `ramp`.
void read_stage_gravity(YamlCursor& map, Kinematics kinematics, Stage& stage);

}  // namespace voussoir::app::reader
