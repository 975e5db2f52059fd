// What the colours of stones show.
#pragma once

#include <vector>

#include "app/case/case.h"
#include "app/render/look.h"
#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// The coloured quantity of each block where all of its vertices have one value, or its group where the look has
/// groups. @returns (blocks) SI; NaN where a stone has none, as one whose joints are all open has no use of
/// friction
std::vector<double> stone_values(const results::RecordedModel& model, const results::RecordedFrame& frame,
                                 SnapshotColor color, const LookOfRun& look);

/// Largest compressive principal value of a stress [Pa] or a strain [-], > 0 in compression.
double largest_compression(const Eigen::Matrix3d& tensor);

/// Green's strain of a block in a frame, (A^T A - 1) / 2, A its map [-]; 0 of a rigid one.
Eigen::Matrix3d strain_of(const results::RecordedModel& model, const results::RecordedFrame& frame, int block);

}  // namespace voussoir::app::render
