// Sides of a model: which faces of which blocks.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// The faces of blocks that look along `direction` and lie farthest out.
std::vector<BlockFace> faces_towards(const Model& model, const std::vector<int>& blocks,
                                     const Eigen::Vector3d& direction);

/// The corners of a face as it is drawn [m].
std::vector<Eigen::Vector3d> corners_of(const Model& model, const BlockFace& face);

/// A word (bottom, left, ...) or a direction; zero, with a fault, if it is neither.
Eigen::Vector3d read_side(const YamlCursor& value, Kinematics kinematics);

/// Blocks of a group, or of a list of them, that have unknowns; ascending. A fault where one follows the ground.
std::vector<int> free_blocks(const YamlCursor& group, const Model& model);

}  // namespace voussoir::app::reader
