// One run as a film shows it: any moment of it as a finished picture, with its title, its strip and how it ended.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/render/drawing.h"
#include "app/render/framing.h"
#include "app/results/run_end.h"

namespace voussoir::app::render
{

/// The stored frame from which a film goes: the last before the motion, if there is one.
std::size_t first_filmed(const results::ResultsReader& results);

class FilmedRun
{
 public:
    /// @param title in place of the run's own where it is not empty
    /// @throws InputError when the results show nothing that could be drawn
    FilmedRun(const std::filesystem::path& results_file, const SceneOptions& options, const Look& look = {},
              const std::string& title = "");

    double start() const;  // s, of what is filmed
    double end() const;    // s, of the last stored frame
    bool planar() const;
    const LookOfRun& look() const { return options_.look; }
    bool ended_early() const { return !early_.empty(); }

    /// Adds what is filmed, all stored frames for the colours and some fifty for the camera; of a camera that
    /// follows something the first alone.
    void frame_with(Framing& framing) const;

    /// The run at a time, between two stored frames as in between.h. Times may only go on; before the first frame
    /// and after the last they are those.
    results::RecordedFrame frame(double time);

    /// A moment as a finished picture; several threads may draw at once. @param time that was asked of `frame`
    /// @param note that stands behind the time
    /// @returns pixels of the canvas of `drawing`, 0xXXRRGGBB, rows from the top
    std::vector<std::uint32_t> picture(const results::RecordedFrame& frame, double time, const Camera& camera,
                                       const drawing::ColorScale& scale, Drawing& drawing,
                                       const std::string& note) const;

 private:
    results::ResultsReader results_;
    results::RecordedModel model_;
    SceneOptions options_;
    MotionStrip strip_;
    std::optional<Eigen::Vector3d> followed_at_start_;  // m
    std::string early_;                                 // how the run ended before its time
    std::size_t at_ = 0;
    std::optional<results::RecordedFrame> before_, after_;
};

}  // namespace voussoir::app::render
