#include "app/reader/record_source.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "app/reader/motion_warnings.h"
#include "app/reader/processing.h"
#include "app/words/nearest_word.h"
#include "libdda/errors.h"
#include "libdda/text/words.h"
#include "records/units.h"

namespace voussoir::app::reader
{
namespace
{

std::string_view unit_of(records::Quantity quantity)
{
    if (quantity == records::Quantity::acceleration) return "m/s2";
    return quantity == records::Quantity::velocity ? "m/s" : "m";
}

std::vector<YamlCursor> files_of(const YamlCursor& records)
{
    if (records.is_scalar()) return {records};
    return records.items("a file, or a list of files");
}

/// The axes the user gave to the channels, in order.
void name_axes(const YamlCursor& list, std::vector<records::Channel>& channels)
{
    const std::vector<YamlCursor> items = list.items("an axis for each channel, [x, y, z]");
    if (items.size() != channels.size())
        return list.fault(fmt::format("{} axes for {} channels", items.size(), channels.size()),
                          "give one for each channel");
    std::vector<std::string> taken;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string axis = channels[i].component = items[i].as_text();
        if (axis != "x" && axis != "y" && axis != "z")
            items[i].fault("axis \"" + axis + "\"", "write x, y or z");
        else if (std::count(taken.begin(), taken.end(), axis) > 0)
            items[i].fault("a second channel along " + axis, "give each channel its own axis");
        taken.push_back(axis);
    }
}

/// Where channels point whose files do not say it. One that points down is turned over: our vertical is upward.
void read_azimuths(const YamlCursor& list, std::vector<records::Channel>& channels)
{
    const std::vector<YamlCursor> items = list.items("a direction for each channel, [0 deg, 90 deg, up]");
    if (items.size() != channels.size())
        return list.fault(fmt::format("{} directions for {} channels", items.size(), channels.size()),
                          "give one for each channel");
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::string word = items[i].is_scalar() ? items[i].as_text() : "";
        channels[i].is_vertical = word == "up" || word == "down";
        if (word == "down")
            for (double& sample : channels[i].samples) sample = -sample;
        channels[i].azimuth.reset();
        if (!channels[i].is_vertical)
            channels[i].azimuth =
                items[i].as_quantity(words::dimension::angle, words::Range::any()) * 180 / std::numbers::pi;
    }
}

/// Faults of process(), placed at the entry of the list that they name; those of what is done after it, at the
/// map.
void blame(const YamlCursor& map, const std::optional<YamlCursor>& list, const InputError& error)
{
    const std::vector<YamlCursor> items =
        list ? list->items("a list of steps") : std::vector<YamlCursor>{};  // as many as there are steps of theirs
    for (const Fault& fault : error.faults) {
        std::size_t step = 0;
        const bool of_step = std::sscanf(fault.place.c_str(), "processing[%zu]", &step) == 1;
        if (of_step && step < items.size())
            items[step].fault(fault.found, fault.expected);
        else
            map.fault(of_step ? fault.found : fault.place + ": " + fault.found, fault.expected);
    }
}

/// Every channel must say where it points.
void require_directions(const YamlCursor& records, const std::vector<records::Channel>& channels)
{
    for (std::size_t i = 0; i < channels.size(); ++i)
        if (!channels[i].is_vertical && !channels[i].azimuth)
            records.fault(fmt::format("channel {} has no direction", i + 1),
                          "give azimuths: [0 deg, 90 deg, up], or axes: [x, y, z], one for each channel");
}

std::vector<records::Channel> read_all(const YamlCursor& records, const std::filesystem::path& folder,
                                       const records::ReadOptions& options, std::string& description)
{
    std::vector<records::Channel> channels;
    if (records.is_list_of(0)) records.fault("no record", "name at least one file");
    for (const YamlCursor& file : files_of(records)) {
        std::optional<records::Record> record = read_named_record(file, folder, options);
        if (!record) continue;
        for (records::Channel& channel : record->channels) {
            description += (channels.empty() ? "" : ", ") + in_words(*record, channel, file.as_text());
            channels.push_back(std::move(channel));
        }
    }
    return channels;
}

}  // namespace

records::ReadOptions read_record_options(YamlCursor& map, const std::filesystem::path& folder)
{
    records::ReadOptions options;
    options.unit = map.find_text("unit");
    options.time_step = map.find_quantity("time_step", words::dimension::time, words::Range::positive());
    if (map.find("column")) options.column = map.integer_or("column", 1, 10000, 1);
    if (const std::optional<std::string> response = map.find_text("response"))
        options.response = folder / *response;
    return options;
}

std::optional<records::Record> read_named_record(const YamlCursor& file, const std::filesystem::path& folder,
                                                 const records::ReadOptions& options)
{
    const std::string name = file.as_text();
    try {
        if (name.empty()) throw InputError("", "no file name", "name a record");
        records::Record record = records::read_record(folder / name, options);
        for (const records::Channel& channel : record.channels)
            if (!records::has_unit(channel))
                throw InputError("", "the unit of \"" + name + "\" is not known",
                                 "give unit: one of " + records::known_units());
        for (const std::string& remark : record.remarks) file.warn(fmt::format("{}: {}", name, remark));
        return record;
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults)
            file.fault(fault.place.empty() ? fault.found : fault.place + ": " + fault.found, fault.expected);
    }
    return std::nullopt;
}

const records::Channel* choose_channel(YamlCursor& map, const YamlCursor& file, const records::Record& record)
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
        file.fault(fmt::format("{} channels in the record", names.size()), "select one with component: " + list);
        return nullptr;
    }
    const std::string wanted = component->as_text();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (text::equal_ignoring_case(names[i], wanted) || wanted == std::to_string(i + 1))
            return &record.channels[i];
    if (!wanted.empty()) component->fault("no channel \"" + wanted + "\"", words::suggestion(wanted, names));
    return nullptr;
}

std::optional<records::processing::ProcessedRecord> process_as_written(
    YamlCursor& map, std::vector<records::Channel> channels, const records::processing::Processing& afterwards,
    std::string& description)
{
    records::processing::Processing steps;
    const std::size_t faults = map.fault_count();
    const std::optional<YamlCursor> list = map.find("processing");
    if (list) steps = read_processing_steps(*list);
    if (channels.empty() || map.fault_count() > faults) return std::nullopt;
    steps.insert(steps.end(), afterwards.begin(), afterwards.end());
    if (steps.empty() && channels.size() == 1)
        return records::processing::ProcessedRecord{std::move(channels), {}, 0};
    try {
        records::processing::ProcessedRecord processed = records::processing::process(channels, steps);
        for (const std::string& sentence : processed.sentences) description += "; " + sentence;
        return processed;
    } catch (const InputError& error) {
        blame(map, list, error);
    }
    return std::nullopt;
}

std::string in_words(const records::Record& record, const records::Channel& channel, const std::string& name)
{
    const double step = channel.times.empty() ? channel.time_step : records::resampled_evenly(channel).time_step;
    // Some writers put a sentence where others have a station.
    constexpr std::size_t longest_station = 40;
    const bool is_named = !record.station.empty() && record.station.size() <= longest_station;
    std::string where = is_named ? fmt::format("station {}, ", record.station) : "";
    if (channel.azimuth) where += fmt::format("azimuth {:g} deg, ", *channel.azimuth);
    return fmt::format("{} ({}, {}{:g} s, {:g} {})", name, record.format, where, step, records::peak(channel),
                       unit_of(channel.quantity));
}

std::vector<records::Channel> read_joint_records(YamlCursor& map, const std::filesystem::path& folder,
                                                 std::string& description)
{
    const std::size_t faults = map.fault_count();
    const YamlCursor records = *map.find("records");
    const records::ReadOptions options = read_record_options(map, folder);
    std::vector<records::Channel> channels = read_all(records, folder, options, description);
    const std::optional<YamlCursor> axes = map.find("axes"), azimuths = map.find("azimuths");
    const std::optional<YamlCursor> x_azimuth = map.find("x_azimuth");
    if (axes && (azimuths || x_azimuth)) axes->fault("axes and azimuths", "give one of the two");
    records::processing::Processing afterwards;
    if (!axes) {
        const double east = std::numbers::pi / 2;
        afterwards.push_back(records::processing::Rotate{
            map.quantity_or("x_azimuth", words::dimension::angle, words::Range::any(), east) * 180 /
            std::numbers::pi});
    }
    if (map.fault_count() == faults) {  // else there may be fewer channels than files
        if (azimuths) read_azimuths(*azimuths, channels);
        if (axes) name_axes(*axes, channels);
        if (!axes && map.fault_count() == faults) require_directions(azimuths.value_or(records), channels);
    }
    if (map.fault_count() > faults) channels.clear();
    const std::optional<records::processing::ProcessedRecord> processed =
        process_as_written(map, std::move(channels), afterwards, description);
    if (!processed) return {};
    warn_of_processing(map, *processed, 1);
    return processed->channels;
}

}  // namespace voussoir::app::reader
