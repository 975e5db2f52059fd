#include "app/render/render_run.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include "app/render/extrusion.h"
#include "app/render/page.h"
#include "libdda/errors.h"

namespace voussoir::app::render
{

using Eigen::Vector3d;

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

/// The first frame of a dynamic stage; 0 when the run has none.
std::size_t first_dynamic_frame(const results::ResultsReader& results)
{
    const std::vector<std::int32_t>& stages = results.stages;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const auto stage = static_cast<std::size_t>(stages[i]);
        if (stage < results.model.stage_is_dynamic.size() && results.model.stage_is_dynamic[stage]) return i;
    }
    return 0;
}

/// What the camera must see: the structure, the foundations no further out than a quarter of the structure's
/// size, and fallen blocks no further than that size.
std::vector<Vector3d> points_to_see(const std::vector<Scene>& scenes)
{
    Eigen::AlignedBox3d built;
    for (const bool foundation : {false, true}) {
        for (const Triangle& triangle : scenes.front().triangles) {
            if (triangle.foundation != foundation) continue;
            for (const Vector3d& corner : triangle.corners) built.extend(corner);
        }
        if (!built.isEmpty()) break;
    }
    const double size = built.diagonal().norm();
    const auto inside = [&](const Vector3d& corner, double beyond) {
        const Vector3d reach = Vector3d::Constant(beyond * size);
        return Vector3d(corner.cwiseMax(built.min() - reach).cwiseMin(built.max() + reach));
    };
    std::vector<Vector3d> points;
    for (const Scene& scene : scenes) {
        for (const Triangle& triangle : scene.triangles) {
            for (const Vector3d& corner : triangle.corners) {
                points.push_back(inside(corner, triangle.foundation ? 0.25 : 1.0));
            }
        }
    }
    return points;
}

/// One scale for all pictures: from the smallest value to the largest, a displacement's from zero.
drawing::ColorScale scale_of(const std::vector<Scene>& scenes, SnapshotColor color)
{
    const bool displacement = color == SnapshotColor::displacement;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double lowest = displacement ? 0 : infinity, highest = displacement ? 0 : -infinity;
    for (const Scene& scene : scenes) {
        for (const Triangle& triangle : scene.triangles) {
            if (triangle.foundation) continue;
            for (const double value : triangle.values) {
                lowest = std::min(lowest, value);
                highest = std::max(highest, value);
            }
        }
    }
    if (lowest > highest) lowest = highest = 0;  // foundations only
    if (displacement)
        return drawing::make_scale(lowest, highest, "displacement relative to the ground", drawing::length_units);
    return drawing::make_scale(lowest, highest, "largest compressive principal stress", drawing::stress_units);
}

/// "12.3 mm"; micrometres only where a tenth of a millimetre is too coarse.
std::string length_in_words(double metres)
{
    const double size = std::abs(metres);
    if (size < 5e-5) return fmt::format("{:.3g} µm", metres * 1e6);
    return size < 1 ? fmt::format("{:.3g} mm", metres * 1e3) : fmt::format("{:.3g} m", metres);
}

/// "ground displacement x 12.3 mm, z -4 mm": components that the eye could see; empty when there are none.
std::string ground_in_words(const Vector3d& ground)
{
    std::string words;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(ground[axis]) < 1e-6) continue;
        words += fmt::format("{} {} {}", words.empty() ? "ground displacement" : ",", "xyz"[axis],
                             length_in_words(ground[axis]));
    }
    return words;
}

PageText words_of(const Scene& scene, const results::RecordedModel& model, const SceneOptions& options)
{
    PageText text;
    text.title = model.title.empty() ? "voussoir" : model.title;
    text.subtitle = fmt::format("t = {:.3f} s", scene.time);
    if (!scene.stage.empty()) text.subtitle += "   ·   " + scene.stage;
    const std::string threshold = length_in_words(options.joint_threshold);
    text.opened = fmt::format("joint open by more than {} ({})", threshold, scene.opened_joints);
    text.slid = fmt::format("joint slid by more than {} ({})", threshold, scene.slid_joints);
    text.foundations = !model.foundations.empty();
    if (const std::string ground = ground_in_words(scene.ground); !ground.empty()) text.notes.push_back(ground);
    if (is_planar(model.kinematics))
        text.notes.push_back(fmt::format("planar scene, drawn {:g} m thick", model.thickness));
    if (options.deformation_scale != 1) {
        text.notes.push_back(fmt::format("displacements magnified {:g} times", options.deformation_scale));
    }
    return text;
}

void check(const results::ResultsReader& results, const fs::path& file, const SnapshotOptions& options)
{
    if (results.times.empty()) {
        throw InputError(file.string(), "no frame", "give the results of a run that has written a frame");
    }
    if (options.color == SnapshotColor::principal_stress && !is_deformable(results.model.kinematics)) {
        throw InputError("color", "principal_stress of rigid blocks, which have none", "colour by displacement");
    }
    if (results.model.mesh.face_block.empty())
        throw InputError(file.string(), "no block", "give a model with blocks");
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
                                 const SnapshotOptions& options, double joint_threshold)
{
    const results::ResultsReader results(results_file);
    check(results, results_file, options);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw InputError(folder.string(), "cannot be created: " + error.message(), "give another folder");

    const SceneOptions scene_options{options.color, options.deformation_scale.value_or(1), joint_threshold};
    const results::RecordedModel model = in_space(results.model);
    std::vector<Scene> scenes;
    for (const std::size_t frame : choose_frames(results, options)) {
        scenes.push_back(make_scene(model, results.frame(frame), scene_options));
    }
    const drawing::ColorScale scale = scale_of(scenes, options.color);
    const double aspect = static_cast<double>(options.width) / options.height;
    const View view = is_planar(model.kinematics) ? View::straight_on : View::from_aside;
    const Camera camera =
        camera_for(points_to_see(scenes), drawing_area(options.width, options.height), aspect, view);
    Drawing drawing(options.width, options.height);
    std::vector<fs::path> pictures;
    for (const Scene& scene : scenes) {
        const Image image = drawing.draw(scene, camera, scale, logical_pixel(options.width, options.height));
        pictures.push_back(folder / fmt::format("snapshot_{:04}_t={:.3f}s.png", pictures.size() + 1, scene.time));
        write_page(image, scale, words_of(scene, model, scene_options), pictures.back());
    }
    return pictures;
}

}  // namespace voussoir::app::render
