#include "app/reader/boundaries.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "app/reader/foundation.h"
#include "app/reader/passage.h"
#include "app/reader/plane.h"
#include "app/reader/side_faces.h"
#include "app/reader/side_ground.h"
#include "app/words/nearest_word.h"
#include "libdda/block/block_face.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;

using TakenFaces = std::set<std::tuple<int, int, int>>;

void read_boundary(YamlCursor& map, Model& model, TakenFaces& taken)
{
    ViscousBoundary boundary;
    boundary.name = map.find_text("name").value_or(fmt::format("boundary {}", model.boundaries.size() + 1));
    const std::optional<YamlCursor> free_field = map.find("free_field");
    boundary.at_rest = map.choice_or<RestSupport>(
        "at_rest", {{"full", RestSupport::full}, {"normal", RestSupport::normal}, {"none", RestSupport::none}},
        free_field ? RestSupport::normal : RestSupport::full);
    const auto group = map.require("blocks", "the group of blocks whose faces are viscous, or a list of groups");
    const auto side = map.require("side", "the side of it: bottom, left, right, ... or a direction [0, 0, -1]");
    map.reject_unknown_keys();
    for (const ViscousBoundary& other : model.boundaries)
        if (other.name == boundary.name)
            map.fault("a second boundary named " + boundary.name, "give each boundary its own name");
    if (!group || !side) return;
    const Vector3d direction = read_side(*side, model.kinematics);
    const std::vector<int> blocks = free_blocks(*group, model);
    if (blocks.empty() || direction.norm() == 0) return;
    boundary.faces = faces_towards(model, blocks, direction);
    if (boundary.faces.empty())
        side->fault("no face of these blocks looks that way", "name a side that they have");
    for (const BlockFace& face : boundary.faces)
        if (!taken.insert({face.block, face.part, face.face}).second)
            return map.fault("block " + model.blocks[face.block].name + " has this face in another boundary",
                             "keep one of them");
    if (free_field) read_free_field(*free_field, model, boundary);
    model.boundaries.push_back(std::move(boundary));
}

/// What share of a motion is the wave by itself. The word must be given: half or whole is a factor of two.
double read_share(YamlCursor& map)
{
    const auto value = map.require("motion_is", "outcrop (of a free rock surface) or upgoing (the wave alone)");
    if (!value) return 1;
    const std::string word = value->as_text();
    if (word == "outcrop") return 0.5;
    if (word == "within")
        value->fault("a motion within the ground, which holds waves that go up and others that come back",
                     "give it to a foundation below, or give the outcrop motion or the upgoing wave");
    else if (!word.empty() && word != "upgoing")
        value->fault("\"" + word + "\"", "expected outcrop or upgoing");
    return 1;
}

/// Middles of the faces of a boundary, as they are drawn; none if there is no such boundary.
std::vector<Vector3d> middles_of(const Model& model, std::size_t boundary)
{
    std::vector<Vector3d> middles;
    if (boundary >= model.boundaries.size()) return middles;
    for (const BlockFace& face : model.boundaries[boundary].faces)
        middles.push_back(is_planar(model.kinematics) ? step::middle_of<2>(model, face)
                                                      : step::middle_of<3>(model, face));
    return middles;
}

void read_wave(YamlCursor& map, const Model& model, std::optional<double> stage_duration, MotionContext& context,
               Stage& stage)
{
    if (!map.expect_map("a wave {boundary: base, motion_is: outcrop, x: motion}")) return;
    std::vector<std::string> names;
    for (const ViscousBoundary& boundary : model.boundaries) names.push_back(boundary.name);
    IncomingWave wave;
    std::string name = names.empty() ? "" : names[0];
    if (const auto given = map.find("boundary")) {
        name = given->as_text();
        const auto at = std::find(names.begin(), names.end(), name);
        wave.boundary = static_cast<int>(at - names.begin());
        if (at == names.end() && !name.empty() && !names.empty())
            given->fault("no boundary \"" + name + "\"", words::suggestion(name, names));
    } else if (names.size() == 1) {
        map.took_default("boundary", name);
    } else if (!names.empty()) {
        map.require("boundary", "the name of the boundary that it comes in through");
    }
    wave.share = read_share(map);
    if (auto written = map.find("passes")) {
        const Passage passage =
            read_passage(*written, model, middles_of(model, static_cast<std::size_t>(wave.boundary)));
        wave.slowness = passage.slowness;
        wave.origin = passage.from;
    }
    for (const AxisMotion& axis :
         read_axis_motions(map, stage.name + ": wave through " + name, stage_duration, context)) {
        wave.component = axis.component;
        wave.motion = axis.motion;
        if (wave.motion) stage.incoming_waves.push_back(wave);
    }
    map.reject_unknown_keys();
}

}  // namespace

void read_boundaries(YamlCursor& top, Model& model)
{
    std::optional<YamlCursor> section = top.find("boundaries");
    const std::optional<YamlCursor> tied = top.find("tied_sides");
    std::optional<YamlCursor> periodic = top.find("periodic_sides");
    for (const auto& key : {section, tied, periodic})
        if (key && !is_deformable(model.kinematics))
            return key->fault("rigid blocks, in which no wave runs",
                              "choose spatial_deformable or planar_deformable");
    if (tied) model.tied_sides = free_blocks(*tied, model);
    if (periodic) read_periodic_sides(*periodic, model);
    if (!section) return;
    TakenFaces taken;
    for (YamlCursor& item : section->items("a list of boundaries {name, blocks, side}"))
        if (item.expect_map("a boundary {name, blocks, side}")) read_boundary(item, model, taken);
}

void read_incoming_waves(YamlCursor& value, const Model& model, std::optional<double> stage_duration,
                         MotionContext& context, Stage& stage)
{
    // Its keys are read all the same, so that their faults are listed too.
    if (model.boundaries.empty())
        value.fault("a wave without a boundary", "add boundaries: [{name: base, blocks: ..., side: bottom}]");
    if (!value.is_list()) return read_wave(value, model, stage_duration, context, stage);
    for (YamlCursor& item : value.items("a list of waves {boundary, motion_is, x: motion}"))
        read_wave(item, model, stage_duration, context, stage);
}

void refuse_unsupported(const YamlCursor& written, const Model& model, const Stage& stage, bool has_rested)
{
    if (has_rested || model.boundaries.empty() || stage.gravity.norm() == 0) return;
    const bool may_carry =
        std::any_of(model.boundaries.begin(), model.boundaries.end(),
                    [](const ViscousBoundary& boundary) { return boundary.at_rest != RestSupport::none; });
    if (may_carry)
        written.fault("a dynamic stage with gravity, and no static one before it: dashpots carry no weight",
                      "put a static stage first, or gravity: {magnitude: 0}");
}

}  // namespace voussoir::app::reader
