#include "app/render/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/render/between.h"
#include "app/render/encoder.h"
#include "app/render/extrusion.h"
#include "app/render/framing.h"
#include "app/results/recorded_motions.h"
#include "app/results/run_end.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

namespace
{

namespace fs = std::filesystem;

constexpr double most_frames = 1e5;
constexpr double hold = 2;  // s of film for which the last moment of a run stays that ended early

/// The stored frame from which the film goes: the last before the motion, if there is one.
std::size_t first_filmed(const results::ResultsReader& results)
{
    const std::size_t moving = first_dynamic_frame(results);
    return moving > 0 ? moving - 1 : 0;
}

/// Reads each stored frame once as the time goes on, and mixes the two about it.
class Playback
{
 public:
    Playback(const results::ResultsReader& results, std::size_t first)
        : results_(results), at_(first), before_(results.frame(first))
    {
    }
    results::RecordedFrame frame(double time)
    {
        while (at_ + 1 < results_.times.size() && results_.times[at_ + 1] <= time) {
            ++at_;
            before_ = after_ ? std::move(*after_) : results_.frame(at_);
            after_.reset();
        }
        if (at_ + 1 >= results_.times.size()) return before_;
        if (!after_) after_ = results_.frame(at_ + 1);
        return between(results_.model.kinematics, before_, *after_, time);
    }

 private:
    const results::ResultsReader& results_;
    std::size_t at_;
    results::RecordedFrame before_;
    std::optional<results::RecordedFrame> after_;
};

/// Camera and colours over all stored frames; the camera is content with some fifty.
Framing framing_of(const results::ResultsReader& results, const results::RecordedModel& model,
                   const SceneOptions& options)
{
    Framing framing(options.color);
    const std::size_t first = first_filmed(results), count = results.times.size() - first;
    const std::size_t every = std::max<std::size_t>(1, count / 50);
    for (std::size_t i = first; i < results.times.size(); ++i)
        framing.add(make_scene(model, results.frame(i), options),
                    (i - first) % every == 0 || i + 1 == results.times.size());
    return framing;
}

/// Of the motion with the largest peak.
MotionStrip strip_of(const fs::path& results_file, const results::RunEnd& end)
{
    MotionStrip strip;
    strip.end = std::max(end.planned, end.reached);
    strip.label = "time";
    const results::RecordedMotion* largest = nullptr;
    const std::vector<results::RecordedMotion> motions = results::recorded_motions(results_file);
    for (const results::RecordedMotion& motion : motions)
        if (!largest || motion.peak_acceleration > largest->peak_acceleration) largest = &motion;
    if (!largest) return strip;
    for (const double time : largest->times) strip.times.push_back(largest->start + time);
    strip.values = largest->acceleration;
    const std::string axis = largest->followers.empty() ? "" : largest->followers.front();
    strip.label = fmt::format("acceleration along {}, peak {:.3g} m/s²", axis.empty() ? '?' : axis.back(),
                              largest->peak_acceleration);
    return strip;
}

}  // namespace

std::vector<double> film_times(const results::ResultsReader& results, const FilmOptions& options, bool ended_early)
{
    const double from = results.times[first_filmed(results)], to = results.times.back();
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

void render_film(const fs::path& results_file, const fs::path& film, const FilmOptions& options,
                 double joint_threshold, const std::function<bool(std::size_t done, std::size_t all)>& told)
{
    const results::ResultsReader results(results_file);
    expect_drawable(results, results_file, options.color);
    const results::RunEnd end = results::run_end_of(results_file);
    const std::string early = results::early_end_in_words(end);
    const std::vector<double> times = film_times(results, options, !early.empty());

    const SceneOptions scene_options{options.color, options.deformation_scale.value_or(1), joint_threshold};
    const results::RecordedModel model = in_space(results.model);
    const Framing framing = framing_of(results, model, scene_options);
    const drawing::ColorScale scale = framing.scale();
    const Camera camera = framing.camera(options.width, options.height, is_planar(model.kinematics), true);
    MotionStrip strip = strip_of(results_file, end);
    Playback playback(results, first_filmed(results));
    Encoder encoder(film, options.format, options.width, options.height, options.frames_per_second);
    Drawing drawing(options.width, options.height);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Scene scene = make_scene(model, playback.frame(times[i]), scene_options);
        PageText text = words_of(scene, model, scene_options);
        if (options.slow_down != 1)
            text.subtitle += fmt::format("   ·   slowed down {:g} times", options.slow_down);
        if (times[i] >= results.times.back()) text.alarm = early;
        strip.now = scene.time;
        const Image image = drawing.draw(scene, camera, scale, logical_pixel(options.width, options.height));
        encoder.add(page_pixels(image, scale, text, &strip));
        if (!told(i + 1, times.size()))
            throw InputError(film.string(), "the film was interrupted", "ask for it again");
    }
    encoder.finish();
}

}  // namespace voussoir::app::render
