#include "app/render/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include "app/render/encoder.h"
#include "app/render/filmed_run.h"
#include "app/render/picture_queue.h"
#include "app/render/sheet.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

namespace
{

namespace fs = std::filesystem;

constexpr double most_frames = 1e5;
constexpr double hold = 2;  // s of film for which the last moment of a run stays that ended early

/// One run, or two side by side on one time axis, with one camera and one colour scale.
class Stage
{
 public:
    Stage(const std::vector<FilmedFile>& files, const SceneOptions& options, const Look& look, int width,
          int height)
        : width_(width / static_cast<int>(files.size())), height_(height), look_(look), framing_(options.color)
    {
        runs_.reserve(files.size());
        for (const FilmedFile& file : files) runs_.emplace_back(file.results, options, look, file.title);
        for (const FilmedRun& run : runs_) {
            run.frame_with(framing_);
            start_ = std::min(start_, run.start());
            end_ = std::max(end_, run.end());
            early_ = early_ || run.ended_early();
        }
        scale_ = scale_of(framing_, runs_.front().look());
        camera_ = framing_.camera(width_, height, runs_.front().planar(), true, look_);
    }
    double start() const { return start_; }
    double end() const { return end_; }
    bool ended_early() const { return early_; }

    /// The viewer walks on. @param share of the whole way
    void orbit(double share)
    {
        if (look_.orbit != 0)
            camera_ = framing_.camera(width_, height_, runs_.front().planar(), true, look_, share * look_.orbit);
    }

    /// Of one run's part of a picture.
    int width() const { return width_; }
    int height() const { return height_; }

    /// Reads the moment, and has another thread draw it. Times may only go on.
    void ask(double time, const std::string& note, PictureQueue& queue)
    {
        std::vector<results::RecordedFrame> frames;
        for (FilmedRun& run : runs_) frames.push_back(run.frame(time));
        queue.ask([this, frames = std::move(frames), time, camera = camera_, note](Drawing& drawing) {
            return picture(frames, time, camera, drawing, note);
        });
    }

 private:
    /// Rows of all runs, one beside the other.
    Pixels picture(const std::vector<results::RecordedFrame>& frames, double time, const Camera& camera,
                   Drawing& drawing, const std::string& note) const
    {
        const std::size_t across = static_cast<std::size_t>(width_), rows = static_cast<std::size_t>(height_);
        if (runs_.size() == 1) return runs_.front().picture(frames[0], time, camera, scale_, drawing, note);
        Pixels whole(runs_.size() * across * rows);
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            const Pixels part = runs_[i].picture(frames[i], time, camera, scale_, drawing, note);
            for (std::size_t y = 0; y < rows; ++y)
                std::copy_n(part.data() + y * across, across, whole.data() + (y * runs_.size() + i) * across);
        }
        return whole;
    }

    int width_, height_;
    Look look_;
    Framing framing_;
    std::vector<FilmedRun> runs_;
    drawing::ColorScale scale_;
    Camera camera_;
    double start_ = std::numeric_limits<double>::infinity(), end_ = -std::numeric_limits<double>::infinity();
    bool early_ = false;
};

SceneOptions scene_options_of(const FilmOptions& options, double joint_threshold)
{
    return {options.color, options.deformation_scale.value_or(1), joint_threshold};
}

/// All moments in their order, on as many threads as `jobs` says; no more are waiting than the threads need.
void draw_all(Stage& stage, const std::vector<double>& times, const std::string& note, int jobs,
              const std::function<void(const Pixels&)>& take)
{
    PictureQueue queue(jobs_for(jobs, stage.width(), stage.height()), stage.width(), stage.height());
    for (std::size_t i = 0; i < times.size(); ++i) {
        stage.orbit(static_cast<double>(i) / static_cast<double>(times.size()));
        stage.ask(times[i], note, queue);
        if (queue.is_full()) take(queue.next());
    }
    while (!queue.is_empty()) take(queue.next());
}

std::vector<double> times_between(double from, double to, const FilmOptions& options, bool ended_early)
{
    if (!(to > from))
        throw InputError("video", "no time passes in these results, there is nothing to film",
                         "ask for pictures, or give the results of a run with a dynamic stage");
    const double step = 1 / (options.frames_per_second * options.slow_down);
    const double count = std::floor((to - from) / step * (1 + 1e-12)) + 1;
    if (count > most_frames)
        throw InputError("video", fmt::format("{:.0f} frames", count),
                         "slow the film down less, or give fewer frames per second");
    std::vector<double> times;
    for (int i = 0; i < static_cast<int>(count); ++i) times.push_back(std::min(from + i * step, to));
    if (ended_early)
        times.insert(times.end(), static_cast<std::size_t>(std::ceil(hold * options.frames_per_second)), to);
    return times;
}

}  // namespace

std::vector<double> film_times(const results::ResultsReader& results, const FilmOptions& options, bool ended_early)
{
    return times_between(results.times[first_filmed(results)], results.times.back(), options, ended_early);
}

void render_film(const std::vector<FilmedFile>& files, const fs::path& film, const FilmOptions& options,
                 const Look& look, double joint_threshold,
                 const std::function<bool(std::size_t done, std::size_t all)>& told)
{
    Stage stage(files, scene_options_of(options, joint_threshold), look, options.width, options.height);
    const std::vector<double> times = times_between(stage.start(), stage.end(), options, stage.ended_early());
    const std::string note =
        options.slow_down != 1 ? fmt::format("   ·   slowed down {:g} times", options.slow_down) : "";
    Encoder encoder(film, options.format, options.width, options.height, options.frames_per_second);
    std::size_t done = 0;
    draw_all(stage, times, note, options.jobs, [&](const Pixels& pixels) {
        encoder.add(pixels);
        if (!told(++done, times.size()))
            throw InputError(film.string(), "the film was interrupted", "ask for it again");
    });
    encoder.finish();
}

std::vector<fs::path> render_beside(const std::vector<FilmedFile>& files, const fs::path& folder,
                                    const SnapshotOptions& options, const Look& look, double joint_threshold)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError(folder.string(), "cannot be created: " + error.message(), "give another folder");
    Stage stage(files, {options.color, options.deformation_scale.value_or(1), joint_threshold}, look,
                options.width, options.height);
    std::vector<double> times = options.times;
    for (int i = 1; options.times.empty() && i <= options.count; ++i)
        times.push_back(stage.start() + (stage.end() - stage.start()) * i / options.count);
    std::sort(times.begin(), times.end());
    for (double& time : times) time = std::clamp(time, stage.start(), stage.end());
    std::vector<fs::path> pictures;
    draw_all(stage, times, "", options.jobs, [&](const Pixels& pixels) {
        Image image{options.width, options.height, pixels};
        for (std::uint32_t& pixel : image.pixels) pixel |= 0xFF000000U;  // opaque
        const double time = times[pictures.size()];
        pictures.push_back(folder / fmt::format("snapshot_{:04}_t={:.3f}s.png", pictures.size() + 1, time));
        Sheet(image, 1).write(pictures.back());
    });
    return pictures;
}

}  // namespace voussoir::app::render
