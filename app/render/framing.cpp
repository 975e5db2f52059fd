#include "app/render/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdda/errors.h"

namespace voussoir::app::render
{

using Eigen::Vector3d;

namespace
{

/// "12.3 mm"; micrometres only where a tenth of a millimetre is too coarse.
std::string length_in_words(double metres)
{
    const double size = std::abs(metres);
    if (size < 5e-5) return fmt::format("{:.3g} µm", metres * 1e6);
    return size < 1 ? fmt::format("{:.3g} mm", metres * 1e3) : fmt::format("{:.3g} m", metres);
}

/// "ground displacement x 12.3 mm, z -4 mm": components that the eye could see; empty when there are none.
/// @param what moves: the ground, or of a structure on soil its foot
std::string ground_in_words(const std::string& what, const Vector3d& ground)
{
    std::string words;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(ground[axis]) < 1e-6) continue;
        words += fmt::format("{} {} {}", words.empty() ? what + " displacement" : ",", "xyz"[axis],
                             length_in_words(ground[axis]));
    }
    return words;
}

/// The box of the structure, or of foundations alone.
Eigen::AlignedBox3d built_in(const Scene& scene)
{
    Eigen::AlignedBox3d built;
    for (const bool foundation : {false, true}) {
        for (const Triangle& triangle : scene.triangles) {
            if (triangle.foundation != foundation) continue;
            for (const Vector3d& corner : triangle.corners) built.extend(corner);
        }
        if (!built.isEmpty()) break;
    }
    return built;
}

/// What is shown of the values, and in which units.
std::pair<const char*, const std::vector<drawing::Unit>&> quantity(SnapshotColor color)
{
    switch (color) {
        case SnapshotColor::principal_stress:
            return {"largest compressive principal stress", drawing::stress_units};
        case SnapshotColor::velocity:
            return {"speed", drawing::speed_units};
        case SnapshotColor::opening:
            return {"largest opening of a stone's joints", drawing::length_units};
        case SnapshotColor::slip:
            return {"largest slip of a stone's joints", drawing::length_units};
        case SnapshotColor::friction:
            return {"largest use of friction of a stone's joints", drawing::share_units};
        case SnapshotColor::principal_strain:
            return {"largest compressive principal strain", drawing::strain_units};
        case SnapshotColor::displacement:
        case SnapshotColor::group:
            break;
    }
    return {"displacement", drawing::length_units};
}

}  // namespace

void Framing::add(const Scene& scene, bool in_sight)
{
    if (built_.isEmpty()) built_ = built_in(scene);
    const double size = built_.diagonal().norm();
    for (const Triangle& triangle : scene.triangles) {
        const Vector3d reach = Vector3d::Constant((triangle.foundation ? 0.25 : 1.0) * size);
        for (int k = 0; k < 3; ++k) {
            if (in_sight)
                points_.emplace_back(
                    triangle.corners[k].cwiseMax(built_.min() - reach).cwiseMin(built_.max() + reach));
            if (triangle.foundation || std::isnan(triangle.values[k])) continue;
            lowest_ = std::min(lowest_, triangle.values[k]);
            highest_ = std::max(highest_, triangle.values[k]);
        }
    }
}

Camera Framing::camera(int width, int height, bool planar, bool strip, const Look& look, double orbited) const
{
    return look_at(points_, drawing_area(width, height, strip), static_cast<double>(width) / height,
                   planar ? View::straight_on : View::from_aside, look, orbited);
}

drawing::ColorScale Framing::scale() const
{
    double lowest = lowest_, highest = highest_;
    if (lowest > highest) lowest = highest = 0;  // foundations only
    if (color_ != SnapshotColor::principal_stress && color_ != SnapshotColor::principal_strain) lowest = 0;
    if (color_ == SnapshotColor::friction) highest = 1;  // where a joint slides, whatever happens in the run
    const auto& [name, units] = quantity(color_);
    return drawing::make_scale(lowest, highest, name, units);
}

drawing::ColorScale scale_of(const Framing& framing, const LookOfRun& look)
{
    if (look.group_names.empty()) return framing.scale();
    drawing::ColorScale scale;
    scale.highest = std::max<double>(1, static_cast<double>(look.group_names.size()) - 1);
    scale.caption = "group";
    for (std::size_t i = 0; i < look.group_names.size(); ++i) {
        scale.ticks.push_back(static_cast<double>(i));
        scale.labels.push_back(look.group_names[i]);
    }
    return scale;
}

Camera moved_with(const Camera& camera, const Scene& scene, const std::optional<Vector3d>& followed_at_start)
{
    if (!scene.followed || !followed_at_start) return camera;
    Camera moved = camera;
    Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
    shift.topRightCorner<3, 1>() = *followed_at_start - *scene.followed;
    moved.view_projection = camera.view_projection * shift;
    return moved;
}

std::vector<PlacedWord> placed_labels(const Scene& scene, const Camera& camera)
{
    std::vector<PlacedWord> words;
    words.reserve(scene.labels.size());
    for (const Label& label : scene.labels) {
        const Eigen::Vector4d clip = camera.view_projection * label.place.homogeneous();
        words.push_back({label.text, (1 + clip.x() / clip.w()) / 2, (1 - clip.y() / clip.w()) / 2});
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
    if (scene.has_blank) text.blank = "no joint that presses";
    if (options.color == SnapshotColor::displacement) text.notes.push_back("displacement " + scene.counted_from);
    if (const std::string ground = ground_in_words(model.foot.empty() ? "ground" : "foot", scene.ground);
        !ground.empty())
        text.notes.push_back(ground);
    if (is_planar(model.kinematics))
        text.notes.push_back(fmt::format("planar scene, drawn {:g} m thick", model.thickness));
    if (options.look.largest_force > 0)
        text.notes.push_back(
            fmt::format("blue: contact forces, up to {:.3g} kN, and thrust", options.look.largest_force / 1e3));
    if (!options.look.shaking.empty())
        text.notes.push_back(fmt::format("arrow: acceleration of the ground, {:.2f} m/s², at most {:.3g} m/s²",
                                         scene.ground_acceleration, options.look.shaking.front().largest));
    if (options.deformation_scale != 1) {
        text.notes.push_back(fmt::format("displacements magnified {:g} times", options.deformation_scale));
    }
    return text;
}

void expect_drawable(const results::ResultsReader& results, const std::filesystem::path& file, SnapshotColor color)
{
    if (results.times.empty()) {
        throw InputError(file.string(), "no frame", "give the results of a run that has written a frame");
    }
    if (color == SnapshotColor::principal_stress && !is_deformable(results.model.kinematics)) {
        throw InputError("color", "principal_stress of rigid blocks, which have none", "colour by displacement");
    }
    if (color == SnapshotColor::principal_strain && !is_deformable(results.model.kinematics)) {
        throw InputError("color", "principal_strain of rigid blocks, which have none", "colour by displacement");
    }
    if (results.model.mesh.face_block.empty())
        throw InputError(file.string(), "no block", "give a model with blocks");
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

}  // namespace voussoir::app::render
