#include "app/reader/foundation.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "app/reader/passage.h"
#include "app/reader/plane.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

FoundationEntry read_entry(YamlCursor& map, Model& model, std::set<int>& taken)
{
    FoundationEntry entry;
    Foundation foundation;
    const YamlCursor::Choices<bool> held = {{"fixed", true}, {"free", false}};
    for (const int axis : axes_of(model.kinematics))
        foundation.translation_held[axis] =
            map.choice_or<bool>(std::string(1, static_cast<char>('x' + axis)), held, true);
    if (is_planar(model.kinematics)) forbid_y(map);
    foundation.rotation_held = map.choice_or<bool>("rotation", held, true);
    entry.translation_held = foundation.translation_held;
    entry.motion = map.find("motion");
    entry.motion_stage = map.find("motion_stage");
    if (entry.motion_stage && !entry.motion)
        entry.motion_stage->fault("a stage without motion", "give a motion too");
    const std::optional<YamlCursor> group = map.require("blocks", "the group of blocks that follow the ground");
    map.reject_unknown_keys();
    if (!group) return entry;
    entry.group = group->as_text();
    for (const int block : blocks_of_group(*group, model)) {
        if (!taken.insert(block).second) {
            group->fault("a second foundation of group \"" + entry.group + "\"", "keep one of them");
            break;
        }
        foundation.block = block;
        entry.places.push_back(model.blocks[block].moments.centroid);
        entry.foundations.push_back(static_cast<int>(model.foundations.size()));
        model.foundations.push_back(foundation);
    }
    return entry;
}

/// A motion, and the same of other times: foundations as far away share one.
class Delays
{
 public:
    explicit Delays(std::shared_ptr<const GroundMotion> motion) : motion_(std::move(motion)) {}
    std::shared_ptr<const GroundMotion> by(double delay)
    {
        if (!motion_ || delay <= 0) return motion_;
        std::shared_ptr<const GroundMotion>& known = made_[delay];
        if (!known) known = std::make_shared<const GroundMotion>(motion_->delayed(delay));
        return known;
    }

 private:
    std::shared_ptr<const GroundMotion> motion_;
    std::map<double, std::shared_ptr<const GroundMotion>> made_;
};

void add_motion(const AxisMotion& axis, const FoundationEntry& entry, const std::optional<Passage>& passage,
                Delays& delays, Stage& stage)
{
    if (!entry.translation_held[axis.component])
        return axis.written.fault("a motion of a free component of group \"" + entry.group + "\"",
                                  "set the component to fixed, or use body_acceleration");
    for (std::size_t i = 0; i < entry.foundations.size(); ++i) {
        const int foundation = entry.foundations[i];
        const bool taken =
            std::any_of(stage.motions.begin(), stage.motions.end(), [&](const FoundationMotion& other) {
                return other.foundation == foundation && other.component == axis.component;
            });
        if (taken)
            return axis.written.fault("a second motion of group \"" + entry.group + "\" along this axis",
                                      "keep one of them");
        const double delay = passage ? passage->delay_at(entry.places[i]) : 0;
        stage.motions.push_back({foundation, axis.component, delays.by(delay)});
    }
}

}  // namespace

std::vector<int> blocks_of_group(const YamlCursor& value, const Model& model)
{
    std::vector<int> blocks;
    const std::string name = value.as_text();
    for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i)
        if (model.groups[model.blocks[i].group] == name) blocks.push_back(i);
    // Without blocks there are faults already, and a missing group is only their echo.
    if (blocks.empty() && !name.empty() && !model.blocks.empty())
        value.fault("no block is in group \"" + name + "\"", words::suggestion(name, model.groups));
    return blocks;
}

std::vector<FoundationEntry> read_foundations(YamlCursor& top, Model& model)
{
    std::vector<FoundationEntry> entries;
    std::optional<YamlCursor> section = top.find("foundation");
    if (!section) {
        top.took_default("foundation", "none");
        return entries;
    }
    std::set<int> taken;
    if (section->is_map()) {
        entries.push_back(read_entry(*section, model, taken));
        return entries;
    }
    for (YamlCursor& item : section->items("a foundation {blocks: group} or a list of them"))
        if (item.expect_map("a foundation {blocks: group}")) entries.push_back(read_entry(item, model, taken));
    return entries;
}

void read_foundation_motions(YamlCursor& map, const std::vector<FoundationEntry>& entries,
                             std::optional<double> stage_duration, MotionContext& context, Stage& stage)
{
    if (!map.expect_map("motions {x: ..., y: ..., z: ...}")) return;
    if (entries.empty()) map.fault("a motion without foundation", "add a foundation {blocks: group}");
    const std::string whose = stage.name + ": " + (entries.size() == 1 ? entries[0].group : "all foundations");
    std::optional<Passage> passage;
    if (auto written = map.find("passes")) {
        std::vector<Eigen::Vector3d> places;
        for (const FoundationEntry& entry : entries)
            places.insert(places.end(), entry.places.begin(), entry.places.end());
        passage = read_passage(*written, context.model, places);
    }
    const std::vector<AxisMotion> motions = read_axis_motions(map, whose, stage_duration, context);
    for (const AxisMotion& axis : motions) {
        Delays delays(axis.motion);
        for (const FoundationEntry& entry : entries) add_motion(axis, entry, passage, delays, stage);
    }
    map.reject_unknown_keys();
}

}  // namespace voussoir::app::reader
