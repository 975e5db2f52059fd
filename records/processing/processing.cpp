#include "records/processing/processing.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "records/processing/steps.h"
#include "records/start_time.h"
#include "records/units.h"

namespace voussoir::records::processing
{

namespace
{

std::string place_of(std::size_t step)
{
    return "processing[" + std::to_string(step) + "]";
}

void check_channels(const std::vector<Channel>& channels)
{
    std::vector<Fault> faults;
    if (channels.empty()) faults.push_back({"processing", "no channel", "a record with at least one"});
    for (const Channel& channel : channels) {
        const std::string place = "processing: component \"" + channel.component + "\"";
        if (!has_unit(channel))
            faults.push_back({place, "samples of an unknown unit", "give the record a unit: " + known_units()});
        const bool is_timed = channel.time_step > 0 || channel.times.size() == channel.samples.size();
        if (channel.samples.size() < 2 || !is_timed)
            faults.push_back({place,
                              std::to_string(channel.samples.size()) + " samples, time step " +
                                  figure(channel.time_step) + " s",
                              "at least 2 samples and a time step"});
    }
    if (!faults.empty()) throw InputError(std::move(faults));
}

void make_even(ProcessedRecord& record)
{
    for (Channel& channel : record.channels) {
        if (channel.times.empty()) continue;
        channel = resampled_evenly(channel);
        record.sentences.push_back(
            "component \"" + channel.component + "\": uneven samples interpolated linearly to " +
            std::to_string(channel.samples.size()) + " at " + figure(channel.time_step) + " s");
    }
}

/// A step may overflow on absurd numbers; nothing after it is to see that.
void require_finite(const std::vector<Channel>& channels, const std::string& place)
{
    for (const Channel& channel : channels) {
        for (const double sample : channel.samples) {
            if (!std::isfinite(sample))
                throw InputError(place, "component \"" + channel.component + "\" is not finite after this step",
                                 "check the record's unit and the parameters of the step");
        }
    }
}

}  // namespace

ProcessedRecord process(const std::vector<Channel>& channels, const Processing& steps)
{
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < steps.size(); ++i) check_step(steps[i], place_of(i), faults);
    if (!faults.empty()) throw InputError(std::move(faults));
    check_channels(channels);
    ProcessedRecord record{channels, {}, 0};
    make_even(record);
    for (const std::string& sentence : bring_into_step(record.channels)) record.sentences.push_back(sentence);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        std::visit([&](const auto& step) { apply(step, place_of(i), record); }, steps[i]);
        require_finite(record.channels, place_of(i));
    }
    return record;
}

// ---- what steps share

std::string figure(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string si_unit(Quantity quantity)
{
    switch (quantity) {
        case Quantity::velocity:
            return "m/s";
        case Quantity::displacement:
            return "m";
        case Quantity::acceleration:
            break;
    }
    return "m/s2";
}

std::string per_channel(const std::vector<Channel>& channels, const std::vector<double>& values,
                        const std::string& unit_suffix)
{
    std::string text;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (i > 0) text += ", ";
        if (!channels[i].component.empty()) text += channels[i].component + " ";
        text += figure(values[i]) + " " + si_unit(channels[i].quantity) + unit_suffix;
    }
    return text;
}

void require_accelerations(const std::vector<Channel>& channels, const std::string& place, const std::string& what)
{
    for (const Channel& channel : channels) {
        if (channel.quantity != Quantity::acceleration)
            throw InputError(place,
                             what + " of component \"" + channel.component + "\", a " + to_text(channel.quantity),
                             "do it before the step that integrates, or differentiate first");
    }
}

void require_alike(const std::vector<Channel>& channels, const std::string& place, bool in_count)
{
    const Channel& first = channels.front();
    for (const Channel& other : channels) {
        if (std::abs(other.time_step - first.time_step) > 1e-9 * first.time_step)
            throw InputError(
                place, "time steps of " + figure(first.time_step) + " s and " + figure(other.time_step) + " s",
                "resample the components to one time step first");
        if (in_count && other.samples.size() != first.samples.size())
            throw InputError(place,
                             "components of " + std::to_string(first.samples.size()) + " and " +
                                 std::to_string(other.samples.size()) + " samples",
                             "give them one window first");
    }
}

}  // namespace voussoir::records::processing
