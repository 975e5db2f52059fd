#include "app/render/time_pictures.h"

#include <chrono>
#include <ctime>

#include "app/render/drawing.h"
#include "app/render/extrusion.h"
#include "app/render/framing.h"

namespace voussoir::app::render
{
namespace
{

/// Adds the CPU time of the process since the last call to `part`.
class Laps
{
 public:
    void lap(double& part, bool counted)
    {
        const std::clock_t now = std::clock();
        if (counted) part += static_cast<double>(now - last_) / CLOCKS_PER_SEC;
        last_ = now;
    }

 private:
    std::clock_t last_ = std::clock();
};

}  // namespace

PictureTimes time_pictures(const std::filesystem::path& results_file, const SnapshotOptions& options,
                           const Look& look, double joint_threshold, int count)
{
    const results::ResultsReader results(results_file);
    expect_drawable(results, results_file, options.color);
    const results::RecordedModel model = in_space(results.model);
    const SceneOptions scene_options{options.color, options.deformation_scale.value_or(1), joint_threshold,
                                     look_of(look, results_file, results), joint_faces_of(model)};
    const std::size_t last = results.times.size() - 1;
    Framing framing(options.color);
    framing.add(make_scene(model, results.frame(last), scene_options));
    const drawing::ColorScale scale = scale_of(framing, scene_options.look);
    const Camera camera = framing.camera(options.width, options.height, is_planar(model.kinematics), false, look);
    Drawing drawing(options.width, options.height);
    PictureTimes times;
    times.stones = model.block_names.size();
    Laps laps;
    auto start = std::chrono::steady_clock::now();
    for (int i = 0; i <= count; ++i) {
        if (i == 1) start = std::chrono::steady_clock::now();
        const results::RecordedFrame frame = results.frame(last);
        laps.lap(times.reading, i > 0);
        const Scene scene = make_scene(model, frame, scene_options);
        laps.lap(times.scene, i > 0);
        const Image image = drawing.draw(scene, camera, scale, logical_pixel(options.width, options.height));
        laps.lap(times.drawing, i > 0);
        const auto pixels = page_pixels(image, scale, words_of(scene, model, scene_options), nullptr);
        laps.lap(times.page, i > 0);
    }
    times.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / count;
    for (double* part : {&times.reading, &times.scene, &times.drawing, &times.page}) *part /= count;
    times.cpu = times.reading + times.scene + times.drawing + times.page;
    return times;
}

}  // namespace voussoir::app::render
