#include "app/reader/initial_state.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/reader/blocks.h"
#include "app/reader/foundation.h"
#include "app/reader/plane.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;

constexpr double fastest = 1e4;  // m/s and rad/s: more is a slip of the pen

void refuse_haste(const YamlCursor& value, const Vector3d& motion, std::string_view unit)
{
    if (motion.cwiseAbs().maxCoeff() > fastest)  // NaN is a fault already
        value.fault(fmt::format("{:g} {}", motion.cwiseAbs().maxCoeff(), unit),
                    fmt::format("at most {:g} {}", fastest, unit));
}

/// [x, y, z], in a planar scene [x, z] or [x, 0, z].
Vector3d read_velocity(const YamlCursor& value, Kinematics kinematics)
{
    Vector3d velocity = read_vector(value, words::dimension::velocity, kinematics);
    if (is_planar(kinematics) && std::abs(velocity.y()) > 0)
        value.fault(fmt::format("{:g} m/s along y", velocity.y()), "a planar scene lies in x and z: give [x, z]");
    refuse_haste(value, velocity, "m/s");
    return velocity;
}

/// [x, y, z]; in a planar scene the angular velocity from x to z, or [0, y, 0] as spatial scenes write it.
Vector3d read_spin(const YamlCursor& value, Kinematics kinematics)
{
    Vector3d spin = Vector3d::Zero();
    if (is_planar(kinematics) && value.is_scalar()) {
        spin.y() = -value.as_quantity(words::dimension::spin, words::Range::any());
    } else {
        spin = value.as_vector(words::dimension::spin);
        if (is_planar(kinematics) && std::abs(spin.x()) + std::abs(spin.z()) > 0)
            value.fault(fmt::format("[{:g}, {:g}, {:g}] rad/s", spin.x(), spin.y(), spin.z()),
                        "blocks of a planar scene turn in its plane: give one value, > 0 from x to z");
    }
    refuse_haste(value, spin, "rad/s");
    return spin;
}

void read_turn(YamlCursor& rotate, Kinematics kinematics, InitialEntry& entry)
{
    entry.turns_about_itself = rotate.is_map() && !rotate.find("about");
    entry.turn = read_rotation(rotate, kinematics, Vector3d::Zero(), "the centre of mass of each block");
    const Vector3d& axis = entry.turn->axis;
    if (is_planar(kinematics) && std::abs(axis.x()) + std::abs(axis.z()) > 0)
        rotate.fault("a turn out of the plane of the scene", "leave away the axis, or give y");
}

InitialEntry read_entry(YamlCursor& map, Kinematics kinematics)
{
    InitialEntry entry{map, map.find("blocks"), map.find("group"), {}, false, {}, {}, {}};
    std::optional<YamlCursor> rotate = map.find("rotate");
    const std::optional<YamlCursor> velocity = map.find("velocity"), spin = map.find("spin");
    const std::optional<YamlCursor> about = map.find("spin_about");
    map.reject_unknown_keys();
    if (entry.blocks.has_value() == entry.group.has_value())
        map.fault(entry.blocks ? "both blocks and group" : "neither blocks nor group",
                  "give blocks, a pattern of names, or group, the name of a group");
    if (!rotate && !velocity && !spin)
        map.fault("neither rotate nor velocity nor spin", "give what the blocks begin with");
    if (about && !spin) about->fault("a point without spin", "give the spin about it");
    if (rotate) read_turn(*rotate, kinematics, entry);
    if (velocity) entry.velocity = read_velocity(*velocity, kinematics);
    if (spin) entry.spin = read_spin(*spin, kinematics);
    if (about) entry.spin_about = read_place(*about, kinematics);
    return entry;
}

std::vector<int> blocks_of(const InitialEntry& entry, const Model& model)
{
    std::vector<int> blocks;
    if (entry.blocks.has_value() == entry.group.has_value()) return blocks;
    if (entry.group) {
        const std::string name = entry.group->as_text();
        for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
            if (model.groups[model.blocks[b].group] == name) blocks.push_back(b);
        return blocks;
    }
    const std::string pattern = entry.blocks->as_text();
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (matches_pattern(model.blocks[b].name, pattern)) blocks.push_back(b);
    return blocks;
}

/// Without blocks there are faults already, and this would only be their echo.
void refuse_unmatched(const InitialEntry& entry, const Model& model)
{
    if (model.blocks.empty() || entry.blocks.has_value() == entry.group.has_value()) return;
    const YamlCursor& written = entry.group ? *entry.group : *entry.blocks;
    const std::string wanted = written.as_text();
    if (wanted.empty()) return;
    std::vector<std::string> names = model.groups;
    if (!entry.group) {
        names.clear();
        for (const Block& block : model.blocks) names.push_back(block.name);
    }
    written.fault(entry.group ? "no block is in group \"" + wanted + "\"" : "\"" + wanted + "\" matches no block",
                  words::suggestion(wanted, names));
}

void turn(Block& block, const Eigen::Matrix3d& rotation, const Vector3d& about)
{
    PlacedCopy copy;
    copy.linear = rotation;
    for (ConvexPolyhedron& part : block.parts) part = importers::helper::placed(std::move(part), copy, block.name);
    for (ConvexPolygon& outline : block.outlines)
        outline = importers::helper::placed(std::move(outline), copy, block.name);
    Moments& moments = block.moments;
    moments.second = rotation * moments.second * rotation.transpose();
    moments.centroid = about + rotation * (moments.centroid - about);
}

/// Along x, y or z, where the foundation holds the block and the motion would move it; "" if nowhere.
std::string held_motion(const Model& model, const InitialMotion& motion)
{
    for (const Foundation& foundation : model.foundations) {
        if (foundation.block != motion.block) continue;
        for (const int axis : axes_of(model.kinematics))
            if (foundation.translation_held[axis] && std::abs(motion.velocity[axis]) > 0)
                return fmt::format("a velocity along {}", static_cast<char>('x' + axis));
        if (foundation.rotation_held && motion.spin.squaredNorm() > 0) return "a spin";
    }
    return "";
}

/// Adds the motion of one block; false with a fault when it may not have it.
bool give_motion(const InitialEntry& entry, int block, Model& model)
{
    InitialMotion motion{block, entry.velocity.value_or(Vector3d::Zero()), entry.spin.value_or(Vector3d::Zero())};
    const std::string& name = model.blocks[block].name;
    if (entry.spin_about)
        motion.velocity +=
            motion.spin.cross(model.blocks[block].moments.centroid - (*entry.spin_about - model.origin));
    if (is_planar(model.kinematics)) motion.velocity.y() = 0;
    const bool has_one = std::any_of(model.initial_motions.begin(), model.initial_motions.end(),
                                     [&](const InitialMotion& other) { return other.block == block; });
    if (has_one) {
        entry.written.fault("a second velocity or spin of block " + name, "give both in one entry");
        return false;
    }
    if (const std::string held = held_motion(model, motion); !held.empty()) {
        entry.written.fault(held + " of block " + name + ", which the foundation holds",
                            "leave it out of initial_state, or give the foundation a motion");
        return false;
    }
    model.initial_motions.push_back(motion);
    return true;
}

}  // namespace

std::vector<InitialEntry> read_initial_state(YamlCursor& top, Kinematics kinematics)
{
    std::vector<InitialEntry> entries;
    const std::optional<YamlCursor> section = top.find("initial_state");
    if (!section) return entries;
    std::vector<YamlCursor> items = section->items("a list of {blocks, rotate, velocity, spin}");
    if (items.empty() && section->is_list()) section->fault("no entry", "give one, or leave out initial_state");
    for (YamlCursor& item : items)
        if (item.expect_map("blocks and what they begin with {blocks, rotate, velocity, spin}"))
            entries.push_back(read_entry(item, kinematics));
    return entries;
}

void turn_blocks(const std::vector<InitialEntry>& entries, Model& model)
{
    for (const InitialEntry& entry : entries) {
        const std::vector<int> blocks = blocks_of(entry, model);
        if (blocks.empty()) refuse_unmatched(entry, model);
        const bool is_sound = entry.turn && std::isfinite(entry.turn->angle) && entry.turn->axis.allFinite() &&
                              entry.turn->about.allFinite();
        if (!is_sound || entry.written.fault_count() > 0) continue;
        const Eigen::Matrix3d rotation = entry.turn->matrix();
        for (const int block : blocks)
            turn(model.blocks[block], rotation,
                 entry.turns_about_itself ? model.blocks[block].moments.centroid
                                          : Vector3d(entry.turn->about - model.origin));
    }
}

void give_initial_motions(const std::vector<InitialEntry>& entries, Model& model)
{
    for (const InitialEntry& entry : entries) {
        if (!entry.velocity && !entry.spin) continue;
        for (const int block : blocks_of(entry, model))
            if (!give_motion(entry, block, model)) break;  // the same would be said of its other blocks
    }
}

std::vector<std::string> blocks_named_in(const std::vector<InitialEntry>& entries, const Model& model)
{
    std::vector<std::string> names;
    for (const InitialEntry& entry : entries)
        for (const int block : blocks_of(entry, model)) names.push_back(model.blocks[block].name);
    return names;
}

}  // namespace voussoir::app::reader
