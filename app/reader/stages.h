// The part of a case that says what happens, one thing after another: `stages`, with `gravity`.
#pragma once

#include <vector>

#include "app/reader/foundation.h"
#include "app/reader/motion.h"
#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::app::reader
{

/// `gravity: {magnitude: 9.80665 m/s2, direction: [0, 0, -1]}` as a vector [m/s2]; none along y in a planar scene.
Eigen::Vector3d read_gravity(YamlCursor& top, Kinematics kinematics);

/// Reads the stages and all motions: those of the foundations, of the stages and of free blocks. A dynamic stage
/// without duration lasts as long as its longest motion.
std::vector<Stage> read_stages(YamlCursor& top, const Model& model, std::vector<FoundationEntry>& foundations,
                               MotionContext& context);

}  // namespace voussoir::app::reader
