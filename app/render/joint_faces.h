// Which faces of two blocks make their joint.
#pragma once

#include <vector>

#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// For each of the two blocks the face that lies at the joint's centre and looks across it; a face more than three
/// times as large as the other's (a floor under a pillar) is left away.
/// @param joint of the start of the run; @param places of the mesh's vertices there [m]
std::vector<int> faces_of_joint(const results::SurfaceMesh& mesh, const std::vector<Eigen::Vector3d>& places,
                                const WatchedJoint& joint);

}  // namespace voussoir::app::render
