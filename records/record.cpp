#include "records/record.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "libdda/errors.h"
#include "records/format.h"

namespace voussoir
{

namespace
{

// Asked in this order; a text table is the least particular.
const std::array<const Format*, 3> formats{&peer_at2, &corrected_acc, &text_table};

std::string known_formats()
{
    std::string names;
    for (const Format* format : formats) names += (names.empty() ? "" : ", ") + std::string(format->name);
    return names;
}

}  // namespace

Record read_record(const std::filesystem::path& file, const ReadOptions& options)
{
    SourceFile source;
    load_source_file(file, source);
    for (const Format* format : formats) {
        if (format->recognises(source)) return format->read(source, options);
    }
    throw InputError(source.name, is_text(source) ? "a text without a line of numbers" : "binary content",
                     "not a record in a format we read: " + known_formats());
}

GroundMotion to_ground_motion(const Channel& channel, const std::string& source)
{
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

}  // namespace voussoir
