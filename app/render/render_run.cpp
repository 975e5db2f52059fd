#include "app/render/render_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "app/render/extrusion.h"
#include "app/render/framing.h"
#include "app/render/page.h"
#include "app/render/picture_queue.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

namespace
{

namespace fs = std::filesystem;

/// The later one of two equally near.
std::size_t nearest_frame(const std::vector<double>& times, std::size_t first, double time)
{
    std::size_t best = first;
    for (std::size_t i = first; i < times.size(); ++i) {
        if (std::abs(times[i] - time) <= std::abs(times[best] - time)) best = i;
    }
    return best;
}

}  // namespace

std::vector<std::size_t> choose_frames(const results::ResultsReader& results, const SnapshotOptions& options)
{
    std::vector<std::size_t> frames;
    for (const double time : options.times) frames.push_back(nearest_frame(results.times, 0, time));
    if (options.times.empty()) {
        const std::size_t last = results.times.size() - 1;
        const std::size_t first = std::min(first_dynamic_frame(results), last);
        const double start = first > 0 ? results.times[first - 1] : results.times[0], end = results.times[last];
        for (int i = 1; i < options.count; ++i) {
            frames.push_back(nearest_frame(results.times, first, start + (end - start) * i / options.count));
        }
        frames.push_back(last);
    }
    std::sort(frames.begin(), frames.end());
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

std::vector<fs::path> render_run(const fs::path& results_file, const fs::path& folder,
                                 const SnapshotOptions& options, const Look& look, double joint_threshold)
{
    const results::ResultsReader results(results_file);
    expect_drawable(results, results_file, options.color);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError(folder.string(), "cannot be created: " + error.message(), "give another folder");

    const SceneOptions scene_options{options.color, options.deformation_scale.value_or(1), joint_threshold,
                                     look_of(look, results_file, results)};
    const results::RecordedModel model = in_space(results.model);
    std::vector<Scene> scenes;
    Framing framing(options.color);
    for (const std::size_t frame : choose_frames(results, options)) {
        scenes.push_back(make_scene(model, results.frame(frame), scene_options));
        framing.add(scenes.back(), scenes.size() == 1 || scene_options.look.followed.empty());
    }
    const drawing::ColorScale scale = scale_of(framing, scene_options.look);
    const Camera camera = framing.camera(options.width, options.height, is_planar(model.kinematics), false, look);
    PictureQueue queue(jobs_for(options.jobs, options.width, options.height), options.width, options.height);
    std::vector<fs::path> pictures;
    for (const Scene& scene : scenes) {
        pictures.push_back(folder / fmt::format("snapshot_{:04}_t={:.3f}s.png", pictures.size() + 1, scene.time));
        queue.ask([&, path = pictures.back()](Drawing& drawing) {
            const Camera moved = moved_with(camera, scene, scenes.front().followed);
            const Image image = drawing.draw(scene, moved, scale, logical_pixel(options.width, options.height));
            PageText text = words_of(scene, model, scene_options);
            text.labels = placed_labels(scene, moved);
            write_page(image, scale, text, path);
            return Pixels();
        });
    }
    while (!queue.is_empty()) queue.next();
    return pictures;
}

}  // namespace voussoir::app::render
