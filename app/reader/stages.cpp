#include "app/reader/stages.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/reader/bars.h"
#include "app/reader/boundaries.h"
#include "app/reader/gravity.h"
#include "app/reader/step_control.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

/// A stage whose motions are still to be read.
struct StageEntry {
    Stage stage;
    YamlCursor written;
    std::optional<double> duration;
    std::optional<YamlCursor> motion, body_acceleration, incoming_wave;
    bool expects_motion = false;
};

bool is_dynamic(const Stage& stage)
{
    return stage.type == StageType::dynamic;
}

void read_damping(YamlCursor& map, Damping& damping)
{
    if (!map.expect_map("damping {rate: 0.5 1/s} or {factor_per_step: 0.94}")) return;
    const auto rate = map.find_quantity("rate", words::dimension::rate, words::Range::non_negative());
    const auto factor = map.find_quantity("factor_per_step", words::dimension::number, {0, 1, true, true});
    map.reject_unknown_keys();
    if (rate && factor) map.fault("both rate and factor_per_step", "give one of the two");
    damping.rate = rate.value_or(0);
    damping.factor_per_step = factor.value_or(1);
}

/// When fallen blocks end the stage's run.
int read_collapse(YamlCursor& map)
{
    if (!map.expect_map("collapse {stop_after: 1}")) return 0;
    const int blocks = map.find("stop_after") ? map.integer_or("stop_after", 1, 1'000'000'000, 1) : 0;
    if (blocks == 0) map.require("stop_after", "the number of fallen blocks at which the run ends, such as 1");
    map.reject_unknown_keys();
    return blocks;
}

void read_dynamic(YamlCursor& map, StageEntry& entry)
{
    for (const char* key : {"unbalanced_tolerance", "max_static_steps", "gravity_increments"})
        map.forbid(key, "it belongs to static stages");
    entry.duration = map.find_quantity("duration", words::dimension::time, words::Range::positive());
    entry.motion = map.find("motion");
    entry.body_acceleration = map.find("body_acceleration");
    entry.incoming_wave = map.find("incoming_wave");
    entry.expects_motion = entry.motion || entry.body_acceleration || entry.incoming_wave;
    if (std::optional<YamlCursor> collapse = map.find("collapse"))
        entry.stage.stop_after_fallen = read_collapse(*collapse);
    if (std::optional<YamlCursor> damping = map.find("damping"))
        read_damping(*damping, entry.stage.damping);
    else
        map.took_default("damping", "none");
}

void read_static(YamlCursor& map, Stage& stage)
{
    map.forbid("duration", "a static stage ends at equilibrium");
    for (const char* key : {"motion", "body_acceleration", "incoming_wave", "damping", "collapse", "integrator",
                            "dissipation", "step_error"})
        map.forbid(key, "it belongs to dynamic stages");
    stage.unbalanced_tolerance = map.quantity_or("unbalanced_tolerance", words::dimension::number,
                                                 {0, 1, false, false}, stage.unbalanced_tolerance);
    stage.max_static_steps = map.integer_or("max_static_steps", 1, 1'000'000'000, stage.max_static_steps);
    stage.gravity_increments = map.integer_or("gravity_increments", 1, 1'000'000, stage.gravity_increments);
}

StageEntry read_stage(YamlCursor& map, const Eigen::Vector3d& gravity, Kinematics kinematics, std::size_t index)
{
    StageEntry entry{{}, map, {}, {}, {}, {}, false};
    Stage& stage = entry.stage;
    stage.gravity = gravity;
    const std::optional<std::string> name = map.find_text("name");
    stage.name = name.value_or(fmt::format("stage {}", index + 1));
    if (!name) map.took_default("name", stage.name);
    const auto type = map.find_choice<StageType>(
        "type", {{"static", StageType::static_equilibrium}, {"dynamic", StageType::dynamic}});
    if (!type) map.require("type", "static or dynamic");
    stage.type = type.value_or(StageType::dynamic);
    read_stage_gravity(map, kinematics, stage);
    stage.control = read_step_control(map, stage.type);
    if (is_dynamic(stage))
        read_dynamic(map, entry);
    else
        read_static(map, stage);
    map.reject_unknown_keys();
    return entry;
}

void read_body_accelerations(StageEntry& entry, const Model& model, MotionContext& context)
{
    for (YamlCursor& item : entry.body_acceleration->items("a list of {blocks: group, x: motion}")) {
        if (!item.expect_map("a body acceleration {blocks: group, x: motion}")) continue;
        const auto group = item.require("blocks", "the group of blocks it acts on");
        const std::string whose = entry.stage.name + ": body acceleration of " + (group ? group->as_text() : "?");
        const std::vector<AxisMotion> motions = read_axis_motions(item, whose, entry.duration, context);
        item.reject_unknown_keys();
        if (!group) continue;
        for (const int block : blocks_of_group(*group, model))
            for (const AxisMotion& axis : motions)
                entry.stage.body_accelerations.push_back({block, axis.component, axis.motion});
    }
}

/// The stage a foundation's motion acts in: the only dynamic one, or the one it names. Null, with a fault, if
/// none.
StageEntry* stage_of_motion(const FoundationEntry& foundation, std::vector<StageEntry>& stages)
{
    std::vector<StageEntry*> dynamic;
    std::vector<std::string> names;
    for (StageEntry& entry : stages)
        if (is_dynamic(entry.stage)) {
            dynamic.push_back(&entry);
            names.push_back(entry.stage.name);
        }
    if (foundation.motion_stage) {
        const std::string name = foundation.motion_stage->as_text();
        for (StageEntry* entry : dynamic)
            if (entry->stage.name == name) return entry;
        if (!name.empty())
            foundation.motion_stage->fault("no dynamic stage \"" + name + "\"", words::suggestion(name, names));
        return nullptr;
    }
    if (dynamic.size() == 1) return dynamic.front();
    if (dynamic.empty())
        foundation.motion->fault("a motion, but no dynamic stage", "add a stage of type dynamic");
    else
        foundation.motion->fault(fmt::format("{} dynamic stages in which it could act", dynamic.size()),
                                 "name one with motion_stage, or give the stages their own motion");
    return nullptr;
}

/// More steps than this are a slip of the pen: at a millisecond each they take eleven days.
constexpr double max_steps = 1e9;

/// A dynamic stage without duration lasts as long as its longest motion.
void settle_duration(StageEntry& entry)
{
    Stage& stage = entry.stage;
    if (!is_dynamic(stage)) return;
    double longest = 0;
    const auto consider = [&](const std::shared_ptr<const GroundMotion>& motion) {
        if (motion) longest = std::max(longest, motion->duration());
    };
    for (const FoundationMotion& motion : stage.motions) consider(motion.motion);
    for (const BodyAcceleration& load : stage.body_accelerations) consider(load.motion);
    for (const IncomingWave& wave : stage.incoming_waves) consider(wave.motion);
    stage.duration = entry.duration.value_or(longest);
    if (stage.duration / stage.control.time_step > max_steps)
        entry.written.fault(
            fmt::format("{:.3g} steps: {:g} s in steps of {:g} s", stage.duration / stage.control.time_step,
                        stage.duration, stage.control.time_step),
            fmt::format("a stage has at most {:g}", max_steps));
    if (entry.duration) return;
    if (longest > 0)
        entry.written.took_default("duration", fmt::format("{:g} s, that of its longest motion", longest));
    else if (!entry.expects_motion)  // else its motion could not be read, and that is said already
        entry.written.require("duration", "a time such as 20 s; there is no motion to take it from");
}

/// The published iteration knows neither bonds nor dashpots, and no stones that bend: it would silently leave them
/// out.
void refuse_published_iteration_of(const Model& model, StageEntry& entry)
{
    if (entry.stage.control.open_close != OpenClose::published) return;
    for (const JointMaterial& joint : model.joints) {
        if (is_deformable(model.kinematics) && joint.face != FaceLaw::corners)
            entry.written.fault(
                "open_close: published does not bend stones as face: points and linear do, which joint " +
                    joint.name + " has",
                "write face: corners in the joint, or use newton");
        if (joint.has_strength() || joint.relaxation_time > 0)
            entry.written.fault(
                "open_close: published has no cohesion, tensile strength or relaxation time, which joint " +
                    joint.name + " has",
                "use newton, or joints with friction only");
    }
}

/// Newmark's integrator leaves impacts to the springs: a rebound asked for would silently be left out.
void refuse_rebound_by_newmark(const std::vector<JointMaterial>& joints, StageEntry& entry)
{
    if (entry.stage.control.integrator != Integrator::newmark || entry.stage.type != StageType::dynamic) return;
    for (const JointMaterial& joint : joints)
        if (joint.has_landing_law() && *joint.restitution > 0)
            entry.written.fault("integrator: newmark leaves impacts to the springs, but joint " + joint.name +
                                    " has a restitution",
                                "use energy_decaying, or write restitution: none");
}

std::vector<StageEntry> read_entries(YamlCursor& section, const Eigen::Vector3d& gravity, Kinematics kinematics)
{
    std::vector<StageEntry> stages;
    std::vector<YamlCursor> items = section.items("a list of stages");
    if (items.empty() && section.is_list()) section.fault("no stage", "give at least one");
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (!items[i].expect_map("a stage {name, type: static or dynamic}")) continue;
        StageEntry entry = read_stage(items[i], gravity, kinematics, i);
        const bool known = std::any_of(stages.begin(), stages.end(), [&](const StageEntry& other) {
            return other.stage.name == entry.stage.name;
        });
        if (known) items[i].fault("a second stage named " + entry.stage.name, "give each stage its own name");
        stages.push_back(std::move(entry));
    }
    return stages;
}

}  // namespace

std::vector<Stage> read_stages(YamlCursor& top, const Model& model, std::vector<FoundationEntry>& foundations,
                               MotionContext& context)
{
    const Eigen::Vector3d gravity = read_gravity(top, model.kinematics);
    std::vector<Stage> stages;
    std::optional<YamlCursor> section = top.require("stages", "the stages, [{name: self-weight, type: static}]");
    if (!section) return stages;
    std::vector<StageEntry> entries = read_entries(*section, gravity, model.kinematics);
    for (FoundationEntry& foundation : foundations) {
        if (!foundation.motion) continue;
        StageEntry* entry = stage_of_motion(foundation, entries);
        if (entry == nullptr) continue;
        entry->expects_motion = true;
        read_foundation_motions(*foundation.motion, {foundation}, entry->duration, context, entry->stage);
    }
    bool has_rested = false;
    for (StageEntry& entry : entries) {
        has_rested = has_rested || !is_dynamic(entry.stage);
        refuse_unsupported(entry.written, model, entry.stage, has_rested);
        refuse_published_iteration_of(model, entry);
        refuse_bars(entry.written, model, entry.stage);
        refuse_rebound_by_newmark(model.joints, entry);
        if (entry.motion)
            read_foundation_motions(*entry.motion, foundations, entry.duration, context, entry.stage);
        if (entry.incoming_wave)
            read_incoming_waves(*entry.incoming_wave, model, entry.duration, context, entry.stage);
        if (entry.body_acceleration) read_body_accelerations(entry, model, context);
        settle_duration(entry);
        stages.push_back(std::move(entry.stage));
    }
    return stages;
}

}  // namespace voussoir::app::reader
