// K-NET and KiK-net of NIED, Japan: one component a file (.EW .NS .UD; KiK-net .EW1 ... .UD1 in the borehole,
// .EW2 ... .UD2 at the surface), 17 header lines whose values begin in column 19, then counts, eight on a line:
//
//   Record Time       2011/03/11 14:46:36
//   Sampling Freq(Hz) 100Hz
//   Dir.              N-S                       KiK-net: 1 N-S, 2 E-W, 3 U-D borehole; 4, 5, 6 surface
//   Scale Factor      7845(gal)/8223790         acceleration = counts times this
//
// The offset of the counts stays: the mean is removed in processing, not here. Record Time is that of the trigger
// plus 15 s, the delay of the recorder: the first sample is 15 s earlier.
//
// Source: [KnetFormat].

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"
#include "records/start_time.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "K-NET, KiK-net";
constexpr std::size_t longest_header = 40;  // lines; 17 in every file seen

/// The header's lines by the words they begin with; longest first where one begins another.
constexpr std::array<std::string_view, 17> keys{"Origin Time",
                                                "Lat.",
                                                "Long.",
                                                "Depth. (km)",
                                                "Mag.",
                                                "Station Code",
                                                "Station Lat.",
                                                "Station Long.",
                                                "Station Height(m)",
                                                "Record Time",
                                                "Sampling Freq(Hz)",
                                                "Duration Time(s)",
                                                "Dir.",
                                                "Scale Factor",
                                                "Max. Acc. (gal)",
                                                "Last Correction",
                                                "Memo"};

/// Keys have no colon: each is known by its words. Further lines, comments of the memo among them, are passed
/// over.
KeyedHeader read_header(const SourceFile& file)
{
    KeyedHeader header;
    for (; header.end < file.lines.size() && header.end < longest_header; ++header.end) {
        const std::string_view line = text::trim(file.lines[header.end]);
        if (is_row_of_numbers(line)) break;
        for (const std::string_view key : keys) {
            if (text::lower_case(line.substr(0, key.size())) != text::lower_case(key)) continue;
            header.lines.push_back({letters_and_digits(key), text::trim(line.substr(key.size())), header.end});
            break;
        }
    }
    return header;
}

bool recognises(const SourceFile& file)
{
    if (!is_text(file)) return false;
    const KeyedHeader header = read_header(file);
    return header.find("Scale Factor") != nullptr && header.find("Sampling Freq(Hz)") != nullptr &&
           header.find("Dir.") != nullptr;
}

/// "7845(gal)/8223790" -> 0.01 * 7845 / 8223790 m/s2 a count. @returns 1 after a fault
double parse_scale(const SourceFile& file, const HeaderLine* line, FaultList& faults)
{
    const std::string text = text::lower_case(text_of(line));
    double numerator = 0, denominator = 0;
    const std::size_t used = text::parse_leading_number(text, numerator);
    const std::size_t slash = text.find('/');
    const std::string unit = used > 0 ? letters_and_digits(text.substr(used, slash - used)) : "";
    const bool complete = used > 0 && slash != std::string::npos && unit == "gal" &&
                          text::parse_fortran_number(std::string_view(text).substr(slash + 1), denominator);
    const double scale = 0.01 * numerator / denominator;
    if (complete && std::isfinite(scale) && scale > 0) return scale;
    faults.add(place_of(file, line), "Scale Factor = \"" + text_of(line) + "\"",
               "two positive numbers as in 7845(gal)/8223790");
    return 1;
}

std::optional<double> time_step_of(const HeaderLine* line)
{
    const std::optional<double> frequency = number_of(line);
    return frequency ? 1 / *frequency : 0;  // no number is as bad as a zero
}

/// Directions 1 to 6 are those of KiK-net.
void orient(Channel& channel, std::string_view direction, Record& record)
{
    constexpr std::array<const char*, 6> kiknet{"NS", "EW", "UD", "NS", "EW", "UD"};
    const bool is_number = direction.size() == 1 && direction[0] >= '1' && direction[0] <= '6';
    if (is_number) {
        const auto number = static_cast<std::size_t>(direction[0] - '1');
        orient_by_short_name(channel, kiknet[number]);
        record.remarks.push_back("Direction " + std::string(direction) + " of KiK-net is " + kiknet[number] +
                                 (number < 3 ? " in the borehole." : " at the surface."));
    } else {
        orient_by_short_name(channel, direction);
    }
}

/// What the user should know: where the record starts and what was not done to it.
void add_remarks(Record& record, const KeyedHeader& header)
{
    record.remarks.push_back("The record starts 15 s before the header's Record Time" +
                             (header.find("Record Time") ? " " + text_of(header.find("Record Time")) : "") +
                             ", the delay of the recorder.");
    record.remarks.push_back(
        "The samples keep the recorder's offset; the header's Max. Acc. is without it: remove the mean.");
}

/// Record Time is that of Japan, 9 h ahead of UTC.
std::optional<Instant> start_of(const KeyedHeader& header)
{
    std::optional<Instant> start = parse_instant(text_of(header.find("Record Time")));
    if (start) *start -= std::chrono::hours(9) + std::chrono::seconds(15);
    return start;
}

std::string event_of(const KeyedHeader& header)
{
    const std::string time = text_of(header.find("Origin Time")), magnitude = text_of(header.find("Mag."));
    return time + (magnitude.empty() ? "" : " M" + magnitude);
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const KeyedHeader header = read_header(file);
    const HeaderLine* factor = header.find("Scale Factor");
    const HeaderLine* frequency = header.find("Sampling Freq(Hz)");
    const HeaderLine* duration = header.find("Duration Time(s)");
    const double scale = parse_scale(file, factor, faults);
    resolve_unit("gal", options, place_of(file, factor), faults);
    const Unit unit{"counts x " + text_of(factor) + " gal", Quantity::acceleration, scale};
    const double time_step =
        resolve_time_step(time_step_of(frequency), options, place_of(file, frequency), faults);
    std::vector<double> samples = read_fortran_samples(file, header.end, faults);
    if (samples.size() < 2) faults.add(file.name, std::to_string(samples.size()) + " samples", "2 or more");
    refuse_column(file, options, faults);
    Record record{file.name, format_name, {}, text_of(header.find("Station Code")), event_of(header)};
    if (faults.empty() && duration != nullptr) {
        const double announced = required_number(file, duration, "Duration Time(s)", faults) / time_step;
        const auto one_second = static_cast<std::size_t>(std::min(1 / time_step, 1e6));
        check_count_with_surplus(std::round(announced), samples.size(), one_second, place_of(file, duration),
                                 faults, record.remarks);
    }
    faults.throw_if_any(file.name);
    const std::string direction = text_of(header.find("Dir."));
    Channel channel = make_channel(direction, unit, time_step, std::move(samples));
    channel.start = start_of(header);
    orient(channel, direction, record);
    record.channels.push_back(std::move(channel));
    add_remarks(record, header);
    return record;
}

}  // namespace

const Format knet{format_name, recognises, read};

}  // namespace voussoir::records::formats
