#include "app/reader/motion.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/reader/motion_warnings.h"
#include "app/reader/plane.h"
#include "app/reader/record_source.h"
#include "app/reader/wave.h"
#include "libdda/errors.h"

namespace voussoir::app::reader
{
namespace
{

/// The short forms of what is done to a motion, after its processing.
struct Scaling {
    std::optional<double> scale, scale_to_pga;
    bool end_correction = false;
};

Scaling read_scaling(YamlCursor& map)
{
    Scaling scaling;
    scaling.scale = map.find_quantity("scale", words::dimension::number, words::Range::any());
    scaling.scale_to_pga =
        map.find_quantity("scale_to_pga", words::dimension::acceleration, words::Range::positive());
    scaling.end_correction = map.find("end_correction") && map.boolean_or("end_correction", false);
    if (scaling.scale && scaling.scale_to_pga) map.fault("both scale and scale_to_pga", "give one of the two");
    return scaling;
}

/// @throws InputError when it cannot be scaled as asked
double factor_of(const GroundMotion& motion, const Scaling& asked)
{
    if (!asked.scale_to_pga) return asked.scale.value_or(1);
    if (motion.peak_acceleration() > 0) return *asked.scale_to_pga / motion.peak_acceleration();
    throw InputError("", "its peak acceleration is 0", "it cannot be scaled to a peak");
}

/// Scales and corrects as asked, and says so in `description`.
GroundMotion scale(GroundMotion motion, double factor, const records::Channel& channel, const Scaling& asked,
                   std::string& description)
{
    if (asked.end_correction && channel.quantity != records::Quantity::acceleration)
        throw InputError("", "end_correction of a record that is not an acceleration", "remove it");
    if (factor != 1) description += fmt::format(" x {:g}", factor);
    if (factor != 1) motion = motion.scaled(factor);
    if (!asked.end_correction) return motion;
    description += fmt::format(", end-corrected (removed {:.3g} m/s and {:.3g} m at the end)",
                               motion.residual_velocity(), motion.residual_displacement());
    return motion.with_end_correction();
}

/// A channel, processed and scaled as its motion says. Only of records something may be amiss: of a wave
/// everything is as it was written.
std::optional<GroundMotion> finish(YamlCursor& map, const records::Channel& channel, const std::string& source,
                                   const YamlCursor& blamed, bool is_record, std::string& description)
{
    const std::size_t faults = map.fault_count();
    const Scaling scaling = read_scaling(map);
    try {
        const std::optional<records::processing::ProcessedRecord> processed =
            process_as_written(map, {channel}, {}, description);
        if (!processed || map.fault_count() > faults) return std::nullopt;
        const records::Channel& result = processed->channels.front();
        GroundMotion motion = records::to_ground_motion(result, source);
        const double factor = factor_of(motion, scaling);
        motion = scale(std::move(motion), factor, result, scaling, description);
        if (is_record) warn_of_processing(blamed, *processed, factor);
        if (is_record && channel.quantity != records::Quantity::displacement)
            warn_of_residual(blamed, motion, result.samples.size(), "");
        return motion;
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults)
            blamed.fault(fault.place.empty() ? fault.found : fault.place + ": " + fault.found, fault.expected);
    }
    return std::nullopt;
}

/// Reads what would be done to a motion that cannot be used, for its faults.
void read_in_vain(YamlCursor& map)
{
    std::string unused;
    read_scaling(map);
    process_as_written(map, {}, {}, unused);
}

std::optional<GroundMotion> read_recorded(YamlCursor& map, const YamlCursor& file, const MotionContext& context,
                                          std::string& description)
{
    const records::ReadOptions options = read_record_options(map, context.folder);
    const std::optional<records::Record> record = read_named_record(file, context.folder, options);
    const records::Channel* channel = record ? choose_channel(map, file, *record) : nullptr;
    if (!channel) {
        map.find("component");  // known, even with nothing to choose from
        read_in_vain(map);
        return std::nullopt;
    }
    description += in_words(*record, *channel, file.as_text());
    return finish(map, *channel, file.as_text(), file, true, description);
}

std::optional<GroundMotion> read_sine(YamlCursor& sine, std::optional<double> stage_duration,
                                      std::string& description)
{
    if (!sine.expect_map("a sine {acceleration: 0.5 g, frequency: 2.5 Hz}")) return std::nullopt;
    const double amplitude = sine.quantity("acceleration", words::dimension::acceleration, words::Range::any());
    const double frequency = sine.quantity("frequency", words::dimension::frequency, words::Range::positive());
    const double phase = sine.quantity_or("phase", words::dimension::angle, words::Range::any(), 0);
    std::optional<double> duration =
        sine.find_quantity("duration", words::dimension::time, words::Range::positive());
    sine.reject_unknown_keys();
    if (!duration && !stage_duration) sine.require("duration", "a time, here or as the stage's duration");
    if (!duration && stage_duration)
        sine.took_default("duration", fmt::format("the stage's, {:g} s", *stage_duration));
    if (!duration) duration = stage_duration;
    if (!duration || !std::isfinite(amplitude + frequency + phase + *duration)) return std::nullopt;
    description += fmt::format("sine {:g} m/s2, {:g} Hz, phase {:g} deg, {:g} s", amplitude, frequency,
                               phase * 180 / std::numbers::pi, *duration);
    return GroundMotion::sine_acceleration(amplitude, frequency, phase, *duration);
}

/// Which of the things a motion can be are written there.
std::vector<std::string> sources_of(YamlCursor& map)
{
    std::vector<std::string> found;
    std::vector<std::string> keys = wave_keys();
    keys.insert(keys.begin(), {"record", "sine"});
    for (const std::string& key : keys)
        if (map.find(key)) found.push_back(key);
    return found;
}

/// A motion that is nothing, for an unknown key if there is one, or that is several things at once.
void refuse_sources(YamlCursor& map, const std::vector<std::string>& sources)
{
    const std::size_t faults = map.fault_count();
    for (const char* key : {"unit", "time_step", "column", "response", "component", "processing", "scale",
                            "scale_to_pga", "end_correction"})
        map.find(key);
    map.reject_unknown_keys();
    if (map.fault_count() > faults) return;
    map.fault(sources.empty() ? "neither a record nor a wave" : "both a " + sources[0] + " and a " + sources[1],
              "give one of record, sine, ramped_sine, sweep, ricker, pulse, noise");
}

std::shared_ptr<const GroundMotion> noted(GroundMotion motion, std::string description, MotionContext& context)
{
    context.notes.push_back({std::move(description), motion.residual_velocity(), motion.residual_displacement(),
                             motion.peak_acceleration()});
    return std::make_shared<const GroundMotion>(std::move(motion));
}

}  // namespace

std::shared_ptr<const GroundMotion> read_motion(YamlCursor& map, const std::string& whose,
                                                std::optional<double> stage_duration, MotionContext& context)
{
    if (!map.expect_map("a motion {record: file}, {sine: {...}} or a wave")) return nullptr;
    const std::vector<std::string> sources = sources_of(map);
    if (sources.size() != 1) {
        refuse_sources(map, sources);
        return nullptr;
    }
    YamlCursor source = *map.find(sources[0]);
    std::string description = whose + ": ";
    std::optional<GroundMotion> motion;
    if (sources[0] == "record") {
        motion = read_recorded(map, source, context, description);
    } else if (sources[0] == "sine") {
        motion = read_sine(source, stage_duration, description);
        for (const char* key : {"processing", "scale", "scale_to_pga", "end_correction"})
            map.forbid(key, "a sine is defined by its parameters: change these, or use a ramped_sine");
    } else if (const std::optional<records::Channel> wave = read_wave(sources[0], source, description)) {
        motion = finish(map, *wave, sources[0], source, false, description);
    } else {
        read_in_vain(map);
    }
    map.reject_unknown_keys();
    if (!motion) return nullptr;
    return noted(std::move(*motion), std::move(description), context);
}

namespace
{

/// The motion of one channel of several along `component`, which is said with what was done to all of them.
void add_joint_motion(YamlCursor& map, const records::Channel& channel, int component, const std::string& said,
                      MotionContext& context, std::vector<AxisMotion>& motions)
{
    const bool is_taken = std::any_of(motions.begin(), motions.end(),
                                      [&](const AxisMotion& other) { return other.component == component; });
    if (is_taken) return map.fault("a second channel along " + channel.component, "omit one of the two");
    try {
        GroundMotion motion = records::to_ground_motion(channel, channel.component);
        if (channel.quantity != records::Quantity::displacement)
            warn_of_residual(map, motion, channel.samples.size(), " along " + channel.component);
        motions.push_back(
            {component, map, noted(std::move(motion), said + "along " + channel.component, context)});
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) map.fault(fault.place + ": " + fault.found, fault.expected);
    }
}

/// The motions of records that belong together, along the scene's axes.
std::vector<AxisMotion> read_joint_motions(YamlCursor& map, const std::string& whose, MotionContext& context)
{
    std::string description = whose + ": ";
    const std::vector<records::Channel> channels = read_joint_records(map, context.folder, description);
    const auto axes = axes_of(context.model.kinematics);
    std::vector<AxisMotion> motions;
    for (const records::Channel& channel : channels) {
        const int component = channel.component[0] - 'x';
        if (std::find(axes.begin(), axes.end(), component) == axes.end()) {
            map.warn("the motion along " + channel.component + " is ignored: the scene has no such axis");
            continue;
        }
        // What was done is said once, for all three.
        const std::string said = motions.empty() ? description + "; " : whose + ": the same, ";
        add_joint_motion(map, channel, component, said, context, motions);
    }
    if (!channels.empty() && motions.empty())
        map.fault("no record along x or z", "rotate them or assign other axes");
    for (const char* axis : {"x", "y", "z"}) map.forbid(axis, "records give all axes");
    return motions;
}

}  // namespace

std::vector<AxisMotion> read_axis_motions(YamlCursor& map, const std::string& whose,
                                          std::optional<double> stage_duration, MotionContext& context)
{
    if (map.find("records")) return read_joint_motions(map, whose, context);
    std::vector<AxisMotion> motions;
    for (const int component : axes_of(context.model.kinematics)) {
        const std::string axis(1, static_cast<char>('x' + component));
        std::optional<YamlCursor> value = map.find(axis);
        if (!value) continue;
        std::shared_ptr<const GroundMotion> motion =
            read_motion(*value, fmt::format("{} {}", whose, axis), stage_duration, context);
        motions.push_back({component, std::move(*value), std::move(motion)});
    }
    if (is_planar(context.model.kinematics)) forbid_y(map);
    if (motions.empty()) map.fault("no motion", "give x, y or z, or records");
    return motions;
}

}  // namespace voussoir::app::reader
