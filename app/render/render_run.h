// Pictures of a run: which frames, one scale and one camera for all of them.
#pragma once

#include <filesystem>
#include <vector>

#include "app/case/case.h"
#include "app/render/look.h"
#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// The frame nearest to each asked time, each frame once; without times `count` frames spread over the dynamic
/// stages (over the run if there are none), the last frame always among them. @returns ascending indices
std::vector<std::size_t> choose_frames(const results::ResultsReader& results, const SnapshotOptions& options);

/// Draws the chosen frames into `folder` as snapshot_0001_t=12.340s.png, ...
/// @param joint_threshold [m] openings and slips larger than this are marked
/// @throws InputError when the results hold no frame or no stress, or the folder cannot be written
std::vector<std::filesystem::path> render_run(const std::filesystem::path& results_file,
                                              const std::filesystem::path& folder, const SnapshotOptions& options,
                                              const Look& look, double joint_threshold);

}  // namespace voussoir::app::render
