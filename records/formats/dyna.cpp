// DYNA 1.0 to 1.2, of the ESM and ITACA data bases (IT.AQV..HNE.D.20090406.013240.C.ACC.ASC; .VEL and .DIS hold
// velocity and displacement), and the older ITACA format, which names its direction COMPONENT and not STREAM:
//
//   EVENT_NAME: L_AQUILA_EARTHQUAKE
//   ...                                        64, 55 or 43 lines "KEY: value", here found by key
//   UNITS: cm/s^2
//   USER5:
//   0.000000                                   one sample a line
//
// Written from the headers of files of esm-db.eu and itaca.mi.ingv.it; the keys of the older formats:
// Source: [ObspyDyna].

#include <algorithm>
#include <cmath>

#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"
#include "records/start_time.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "DYNA (ESM, ITACA)";
constexpr std::size_t longest_header = 200;  // lines; 64 in version 1.2

KeyedHeader read_header(const SourceFile& file)
{
    return read_keyed_header(file, 0, longest_header, is_row_of_numbers);
}

bool recognises(const SourceFile& file)
{
    if (!is_text(file)) return false;
    const KeyedHeader header = read_header(file);
    return header.find("NDATA") != nullptr && header.find("SAMPLING_INTERVAL_S") != nullptr &&
           header.find("STATION_CODE") != nullptr && header.find("UNITS") != nullptr;
}

/// Older files write the unit with other words; what kind of motion they hold stands in DATA_TYPE.
void check_quantity(const SourceFile& file, const KeyedHeader& header, const Unit& unit, FaultList& faults)
{
    const HeaderLine* line = header.find("DATA_TYPE");
    const std::string type = text::lower_case(text_of(line));
    if (type.find("spectrum") != std::string::npos) {
        faults.add(place_of(file, line), "response spectra, not a time history",
                   "use the record's acceleration, velocity or displacement");
    } else if (!unit.name.empty()) {
        for (const Quantity quantity : {Quantity::acceleration, Quantity::velocity, Quantity::displacement}) {
            if (quantity == unit.quantity || type.find(to_text(quantity)) == std::string::npos) continue;
            faults.add(place_of(file, line), "data of type \"" + text_of(line) + "\" in " + unit.name,
                       "type and unit must agree");
        }
    }
}

/// The header states the peak. Of unprocessed records it may be meant without the mean: no fault, but told.
void compare_peak(const KeyedHeader& header, const Channel& channel, std::vector<std::string>& remarks)
{
    const char* key = channel.quantity == Quantity::velocity       ? "PGV_CM/S"
                      : channel.quantity == Quantity::displacement ? "PGD_CM"
                                                                   : "PGA_CM/S^2";
    const std::optional<double> announced = number_of(header.find(key));
    if (!announced || !has_unit(channel)) return;
    const double found = 100 * peak(channel);
    // Printed with as few as three digits after the point.
    if (std::abs(found - std::abs(*announced)) <= 1e-3 * found + 1e-3) return;
    remarks.push_back("The header announces a peak of " + text::to_text(*announced) + " (" + key +
                      ") but the samples have " + text::to_text(found) + ".");
}

std::string station_of(const KeyedHeader& header)
{
    std::string station;
    for (const char* key : {"NETWORK", "STATION_CODE", "LOCATION"}) {
        const std::string part = text_of(header.find(key));
        if (!part.empty()) station += (station.empty() ? "" : ".") + part;
    }
    return station;
}

std::string event_of(const KeyedHeader& header)
{
    std::string event;
    for (const char* key : {"EVENT_NAME", "EVENT_ID", "EVENT_DATE_YYYYMMDD"}) {
        const std::string part = text_of(header.find(key));
        if (!part.empty()) event += (event.empty() ? "" : ", ") + part;
    }
    return event;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const KeyedHeader header = read_header(file);
    const HeaderLine* units = header.find("UNITS");
    const HeaderLine* step = header.find("SAMPLING_INTERVAL_S");
    const HeaderLine* count = header.find("NDATA");
    const Unit unit = resolve_unit(text_of(units), options, place_of(file, units), faults);
    check_quantity(file, header, unit, faults);
    faults.throw_if_any(file.name);  // spectra have two columns: no fault of every line
    const double time_step = resolve_time_step(number_of(step).value_or(0), options, place_of(file, step), faults);
    std::vector<double> samples = read_fortran_samples(file, header.end, faults);
    check_count(number_of(count).value_or(0), samples.size(), place_of(file, count), faults);
    refuse_column(file, options, faults);
    const HeaderLine* stream = header.find("STREAM");
    const HeaderLine* component = stream != nullptr ? stream : header.find("COMPONENT");
    Channel channel = make_channel(text_of(component), unit, time_step, std::move(samples));
    channel.start = parse_instant(text_of(header.find("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS")));
    orient_by_short_name(channel, channel.component);
    faults.throw_if_any(file.name);
    Record record{file.name, format_name, {}, station_of(header), event_of(header)};
    compare_peak(header, channel, record.remarks);
    record.channels.push_back(std::move(channel));
    return record;
}

}  // namespace

const Format dyna{format_name, recognises, read};

}  // namespace voussoir::records::formats
