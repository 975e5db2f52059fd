// PNG snapshots and films, drawn by the helper program `voussoir-render` from a results file. Nothing of it is
// loaded here.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::render
{

/// Whether this build can draw.
bool has_renderer();

/// Whether the program ffmpeg is on the PATH.
bool has_ffmpeg();

/// A second run on the right of the first, and the titles over both.
struct Beside {
    std::filesystem::path results;
    std::string title, other_title;
};

/// Starts `voussoir-render` (beside the running program) on a results file and returns the pictures it made.
/// @param beside where two runs are to be seen
/// @throws InputError when the helper is missing, fails, or the results cannot be read
std::vector<std::filesystem::path> render_snapshots(const std::filesystem::path& results_file,
                                                    const std::filesystem::path& folder,
                                                    const SnapshotOptions& options,
                                                    const Beside* beside = nullptr);

/// Has the helper make a film, which has ffmpeg write it. @param told how many of how many frames are done
/// @throws InputError when the helper or ffmpeg is missing or fails, with the reason; no file is left then
void request_film(const std::filesystem::path& results_file, const std::filesystem::path& film,
                  const FilmOptions& options, const std::function<void(int done, int all)>& told,
                  const Beside* beside = nullptr);

/// video.mp4, video.gif or video.webp.
std::string film_name(FilmFormat format);

}  // namespace voussoir::app::render
