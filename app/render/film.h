// A film of a run, from its stored frames.
#pragma once

#include <filesystem>
#include <functional>

#include "app/case/case.h"
#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// The times of the run that the frames of a film show: from the start of the motion to the last stored frame, and
/// where the run ended early that last one for two seconds more. @returns (frames) s, ascending
/// @throws InputError when no time passes, or the film would have more than 100,000 frames
std::vector<double> film_times(const results::ResultsReader& results, const FilmOptions& options,
                               bool ended_early);

/// Draws the film and has it written by ffmpeg. One camera and one colour scale, over all that was stored.
/// @param joint_threshold [m] openings and slips larger than this are marked
/// @param told after each frame how many of how many are done; false stops, and nothing is left
/// @throws InputError when the results show nothing to film, or ffmpeg is missing or fails
void render_film(const std::filesystem::path& results_file, const std::filesystem::path& film,
                 const FilmOptions& options, double joint_threshold,
                 const std::function<bool(std::size_t done, std::size_t all)>& told);

}  // namespace voussoir::app::render
