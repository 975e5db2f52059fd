#include "app/render/filmed_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/render/between.h"
#include "app/render/extrusion.h"
#include "app/results/recorded_motions.h"

namespace voussoir::app::render
{

namespace
{

namespace fs = std::filesystem;

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

std::size_t first_filmed(const results::ResultsReader& results)
{
    const std::size_t moving = first_dynamic_frame(results);
    return moving > 0 ? moving - 1 : 0;
}

FilmedRun::FilmedRun(const fs::path& results_file, const SceneOptions& options, const Look& look,
                     const std::string& title)
    : results_(results_file), options_(options)
{
    expect_drawable(results_, results_file, options.color);
    options_.look = look_of(look, results_file, results_);
    const results::RunEnd end = results::run_end_of(results_file);
    early_ = results::early_end_in_words(end);
    model_ = in_space(results_.model);
    options_.joint_faces = joint_faces_of(model_);
    if (!title.empty()) model_.title = title;
    strip_ = strip_of(results_file, end);
    at_ = first_filmed(results_);
    followed_at_start_ = make_scene(model_, results_.frame(at_), options_).followed;
}

double FilmedRun::start() const
{
    return results_.times[first_filmed(results_)];
}

double FilmedRun::end() const
{
    return results_.times.back();
}

bool FilmedRun::planar() const
{
    return is_planar(model_.kinematics);
}

void FilmedRun::frame_with(Framing& framing) const
{
    const std::size_t first = first_filmed(results_), count = results_.times.size() - first;
    const std::size_t every = std::max<std::size_t>(1, count / 50);
    for (std::size_t i = first; i < results_.times.size(); ++i)
        framing.add(make_scene(model_, results_.frame(i), options_),
                    i == first || (options_.look.followed.empty() &&
                                   ((i - first) % every == 0 || i + 1 == results_.times.size())));
}

/// Reads each stored frame once as the time goes on, and mixes the two about it.
results::RecordedFrame FilmedRun::frame(double time)
{
    if (!before_) before_ = results_.frame(at_);
    while (at_ + 1 < results_.times.size() && results_.times[at_ + 1] <= time) {
        ++at_;
        before_ = after_ ? std::move(*after_) : results_.frame(at_);
        after_.reset();
    }
    if (at_ + 1 >= results_.times.size() || time <= before_->time) return *before_;
    if (!after_) after_ = results_.frame(at_ + 1);
    return between(results_.model.kinematics, *before_, *after_, time);
}

std::vector<std::uint32_t> FilmedRun::picture(const results::RecordedFrame& frame, double time,
                                              const Camera& camera, const drawing::ColorScale& scale,
                                              Drawing& drawing, const std::string& note) const
{
    const Scene scene = make_scene(model_, frame, options_);
    const Camera moved = moved_with(camera, scene, followed_at_start_);
    PageText text = words_of(scene, model_, options_);
    text.subtitle += note;
    if (time >= end()) text.alarm = early_;
    text.labels = placed_labels(scene, moved);
    MotionStrip strip = strip_;
    strip.now = scene.time;
    const Image image = drawing.draw(scene, moved, scale, logical_pixel(drawing.width(), drawing.height()));
    return page_pixels(image, scale, text, &strip);
}

}  // namespace voussoir::app::render
