#include "app/case/motion.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "app/case/nearest_word.h"
#include "app/case/plane.h"
#include "records/record.h"

namespace voussoir
{
namespace
{

bool equal_ignoring_case(const std::string& a, const std::string& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// What a record file does not carry.
ReadOptions read_record_options(YamlCursor& map)
{
    ReadOptions options;
    options.unit = map.find_text("unit");
    options.time_step = map.find_quantity("time_step", dimension::time, Range::positive());
    if (map.find("column")) options.column = map.integer_or("column", 1, 10000, 1);
    return options;
}

/// The channel that `component` names, by its name or its number from 1; it may stay away when there is only one.
const Channel* choose_channel(YamlCursor& map, const YamlCursor& file, const Record& record)
{
    const std::optional<YamlCursor> component = map.find("component");
    if (!component && record.channels.size() == 1) return &record.channels.front();
    std::vector<std::string> names;
    for (std::size_t i = 0; i < record.channels.size(); ++i) {
        const std::string& name = record.channels[i].component;
        names.push_back(name.empty() ? std::to_string(i + 1) : name);
    }
    if (!component) {
        std::string list;
        for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
        file.fault(fmt::format("{} channels in the record", names.size()), "say which with component: " + list);
        return nullptr;
    }
    const std::string wanted = component->as_text();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (equal_ignoring_case(names[i], wanted) || wanted == std::to_string(i + 1)) return &record.channels[i];
    if (!wanted.empty()) component->fault("no channel \"" + wanted + "\"", suggestion(wanted, names));
    return nullptr;
}

/// What is done to a record before it is used.
struct Processing {
    std::optional<double> scale, scale_to_pga;
    bool end_correction = false;
};

Processing read_processing(YamlCursor& map)
{
    Processing processing;
    processing.scale = map.find_quantity("scale", dimension::number, Range::any());
    processing.scale_to_pga = map.find_quantity("scale_to_pga", dimension::acceleration, Range::positive());
    processing.end_correction = map.find("end_correction") && map.boolean_or("end_correction", false);
    if (processing.scale && processing.scale_to_pga)
        map.fault("both scale and scale_to_pga", "give one of the two");
    return processing;
}

/// Scales and corrects as asked, and says so in `description`.
GroundMotion process(GroundMotion motion, const Channel& channel, const Processing& asked,
                     std::string& description)
{
    if (asked.scale_to_pga && !(motion.peak_acceleration() > 0))
        throw InputError("", "its peak acceleration is 0", "it cannot be scaled to a peak");
    if (asked.end_correction && channel.quantity != Quantity::acceleration)
        throw InputError("", "end_correction of a record that is no acceleration", "take it out");
    const double factor =
        asked.scale_to_pga ? *asked.scale_to_pga / motion.peak_acceleration() : asked.scale.value_or(1);
    if (factor != 1) description += fmt::format(" x {:g}", factor);
    if (factor != 1) motion = motion.scaled(factor);
    if (!asked.end_correction) return motion;
    description += fmt::format(", end-corrected (took away {:.3g} m/s and {:.3g} m at the end)",
                               motion.residual_velocity(), motion.residual_displacement());
    return motion.with_end_correction();
}

std::string_view unit_of(Quantity quantity)
{
    if (quantity == Quantity::acceleration) return "m/s2";
    return quantity == Quantity::velocity ? "m/s" : "m";
}

std::optional<GroundMotion> read_recorded(YamlCursor& map, const YamlCursor& file, const MotionContext& context,
                                          std::string& description)
{
    const ReadOptions options = read_record_options(map);
    const Processing processing = read_processing(map);
    const std::string name = file.as_text();
    std::optional<GroundMotion> motion;
    try {
        if (name.empty()) throw InputError("", "no file name", "name a record");
        const Record record = read_record(context.folder / name, options);
        if (const Channel* channel = choose_channel(map, file, record)) {
            description += fmt::format("{} ({}, {:g} s, {:g} {})", name, record.format, channel->time_step,
                                       peak(*channel), unit_of(channel->quantity));
            motion = process(to_ground_motion(*channel, name), *channel, processing, description);
        }
    } catch (const InputError& error) {
        map.find("component");  // known, even if there is nothing to choose from
        for (const Fault& fault : error.faults)
            file.fault(fault.place.empty() ? fault.found : fault.place + ": " + fault.found, fault.expected);
    }
    return motion;
}

std::optional<GroundMotion> read_sine(YamlCursor& sine, std::optional<double> stage_duration,
                                      std::string& description)
{
    if (!sine.expect_map("a sine {acceleration: 0.5 g, frequency: 2.5 Hz}")) return std::nullopt;
    const double amplitude = sine.quantity("acceleration", dimension::acceleration, Range::any());
    const double frequency = sine.quantity("frequency", dimension::frequency, Range::positive());
    const double phase = sine.quantity_or("phase", dimension::angle, Range::any(), 0);
    std::optional<double> duration = sine.find_quantity("duration", dimension::time, Range::positive());
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

}  // namespace

std::shared_ptr<const GroundMotion> read_motion(YamlCursor& map, const std::string& whose,
                                                std::optional<double> stage_duration, MotionContext& context)
{
    if (!map.expect_map("a motion {record: file} or {sine: {...}}")) return nullptr;
    std::optional<YamlCursor> record = map.find("record"), sine = map.find("sine");
    std::string description = whose + ": ";
    std::optional<GroundMotion> motion;
    if (record.has_value() == sine.has_value())
        map.fault(record ? "both a record and a sine" : "neither a record nor a sine", "give one of the two");
    else if (record)
        motion = read_recorded(map, *record, context, description);
    else
        motion = read_sine(*sine, stage_duration, description);
    if (record.has_value() != sine.has_value()) map.reject_unknown_keys();
    if (!motion) return nullptr;
    context.notes.push_back(
        {description, motion->residual_velocity(), motion->residual_displacement(), motion->peak_acceleration()});
    return std::make_shared<const GroundMotion>(std::move(*motion));
}

std::vector<AxisMotion> read_axis_motions(YamlCursor& map, const std::string& whose,
                                          std::optional<double> stage_duration, MotionContext& context)
{
    std::vector<AxisMotion> motions;
    for (const int component : axes_of(context.kinematics)) {
        const std::string axis(1, static_cast<char>('x' + component));
        std::optional<YamlCursor> value = map.find(axis);
        if (!value) continue;
        std::shared_ptr<const GroundMotion> motion =
            read_motion(*value, fmt::format("{} {}", whose, axis), stage_duration, context);
        motions.push_back({component, std::move(*value), std::move(motion)});
    }
    if (is_planar(context.kinematics)) forbid_y(map);
    return motions;
}

}  // namespace voussoir
