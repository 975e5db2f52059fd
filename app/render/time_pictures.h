// How long a picture takes.
#pragma once

#include <filesystem>

#include "app/case/case.h"
#include "app/render/look.h"

namespace voussoir::app::render
{

/// Means over the pictures but for the first, which also warms up. CPU time is of all threads.
struct PictureTimes {
    std::size_t stones = 0;
    double cpu = 0, wall = 0;                              // s
    double reading = 0, scene = 0, drawing = 0, page = 0;  // s of CPU
};

/// Draws the last frame `count` times into memory. @throws InputError when there is nothing to draw
PictureTimes time_pictures(const std::filesystem::path& results_file, const SnapshotOptions& options,
                           const Look& look, double joint_threshold, int count);

}  // namespace voussoir::app::render
