// PNG snapshots, drawn by the helper program `voussoir-render` from a results file. Nothing of it is loaded here.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::render
{

/// Whether this build can draw.
bool has_renderer();

/// Starts `voussoir-render` (beside the running program) on a results file and returns the pictures it made.
/// @throws InputError when the helper is missing, fails, or the results cannot be read
std::vector<std::filesystem::path> render_snapshots(const std::filesystem::path& results_file,
                                                    const std::filesystem::path& folder,
                                                    const SnapshotOptions& options);

}  // namespace voussoir::app::render
