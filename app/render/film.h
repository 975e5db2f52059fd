// A film of a run, from its stored frames.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/render/look.h"
#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// The times of the run that the frames of a film show: from the start of the motion to the last stored frame, and
/// where the run ended early that last one for two seconds more. @returns (frames) s, ascending
/// @throws InputError when no time passes, or the film would have more than 100,000 frames
std::vector<double> film_times(const results::ResultsReader& results, const FilmOptions& options,
                               bool ended_early);

/// A run of a film, and the title over it; its own where none is given.
struct FilmedFile {
    std::filesystem::path results;
    std::string title;
};

/// Draws the film and has it written by ffmpeg. One camera and one colour scale, over all that was stored.
/// @param files one run, or two side by side on one time axis: one that ends before the other keeps its last
/// moment
/// @param joint_threshold [m] openings and slips larger than this are marked
/// @param told after each frame how many of how many are done; false stops, and nothing is left
/// @throws InputError when the results show nothing to film, or ffmpeg is missing or fails
void render_film(const std::vector<FilmedFile>& files, const std::filesystem::path& film,
                 const FilmOptions& options, const Look& look, double joint_threshold,
                 const std::function<bool(std::size_t done, std::size_t all)>& told);

/// Pictures of two runs side by side, as the film has them, at the asked times or `count` times spread evenly.
/// @returns the files, in the order of time
/// @throws InputError when there is nothing to draw, or the folder cannot be written
std::vector<std::filesystem::path> render_beside(const std::vector<FilmedFile>& files,
                                                 const std::filesystem::path& folder,
                                                 const SnapshotOptions& options, const Look& look,
                                                 double joint_threshold);

}  // namespace voussoir::app::render
