#include "records/record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libdda/errors.h"
#include "records/content.h"
#include "records/formats/format.h"
#include "records/units.h"

namespace voussoir::records
{

namespace
{

std::string known_formats()
{
    std::string names;
    for (const formats::Format* format : formats::all_formats())
        names += (names.empty() ? "" : ", ") + std::string(format->name);
    return names;
}

Record read_source(const SourceFile& source, const ReadOptions& options)
{
    for (const formats::Format* format : formats::all_formats())
        if (format->recognises(source)) return formats::read_as(*format, source, options);
    throw InputError({why_unknown(source, known_formats())});
}

}  // namespace

Record read_record(const std::filesystem::path& file, const ReadOptions& options)
{
    SourceFile source;
    load_source_file(file, source);
    return read_source(source, options);
}

Record parse_record(const std::string& name, std::string bytes, const ReadOptions& options)
{
    SourceFile source;
    load_source_bytes(name, std::move(bytes), source);
    return read_source(source, options);
}

Channel resampled_evenly(const Channel& channel)
{
    if (channel.times.empty()) return channel;
    const std::vector<double>& times = channel.times;
    const double span = times.back() - times.front();
    const auto intervals = static_cast<double>(times.size() - 1);
    double smallest = span;
    for (std::size_t i = 1; i < times.size(); ++i) smallest = std::min(smallest, times[i] - times[i - 1]);
    const auto count = static_cast<std::size_t>(std::ceil(std::min(span / smallest, 10 * intervals) - 1e-6));
    Channel even = channel;
    even.times.clear();
    even.time_step = span / static_cast<double>(count);
    even.samples.resize(count + 1);
    std::size_t before = 0;
    for (std::size_t i = 0; i <= count; ++i) {
        const double time = times.front() + static_cast<double>(i) * even.time_step;
        while (before + 2 < times.size() && times[before + 1] <= time) ++before;
        const double share = std::clamp((time - times[before]) / (times[before + 1] - times[before]), 0.0, 1.0);
        even.samples[i] = std::lerp(channel.samples[before], channel.samples[before + 1], share);
    }
    return even;
}

GroundMotion to_ground_motion(const Channel& channel, const std::string& source)
{
    if (!has_unit(channel))
        throw InputError(source, "the unit of the samples is unknown", "give the record a unit: " + known_units());
    if (!channel.times.empty()) return to_ground_motion(resampled_evenly(channel), source);
    switch (channel.quantity) {
        case Quantity::velocity:
            return GroundMotion::from_velocity(channel.samples, channel.time_step, source);
        case Quantity::displacement:
            return GroundMotion::from_displacement(channel.samples, channel.time_step, source);
        case Quantity::acceleration:
            break;
    }
    return GroundMotion::from_acceleration(channel.samples, channel.time_step, source);
}

double peak(const Channel& channel)
{
    double largest = 0;
    for (const double sample : channel.samples) largest = std::max(largest, std::abs(sample));
    return largest;
}

}  // namespace voussoir::records
