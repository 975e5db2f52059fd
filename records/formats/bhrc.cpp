// BHRC, Iran's strong-motion network, volume 1: text lines, whole numbers (14I5), 38 real numbers, samples, and a
// line
// "/&" behind each of the three components.
//
//   * VOL1DS FILE:  5526/01
//   COMP L1                                           <- longitudinal, vertical, transverse
//   Avin   Station 37.734 N 47.801 E   Altitude 2026m   Azimuth L 50    T 140
//   NO. OF POINTS =   9472      DURATION =  47.360
//   UNITS ARE SECONDS AND G/10
//
// Real number 7: samples a second.
//
// Written from the headers of such files; no description of the format was at hand.

#include <cmath>
#include <utility>

#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/direction.h"
#include "records/formats/format.h"
#include "records/formats/samples.h"

namespace voussoir::records::formats
{

namespace
{

constexpr std::size_t header_search = 40;  // lines of text before the first numbers; thirteen in every file seen
constexpr std::size_t rate_at = 6;         // 0-based position in the real header
constexpr std::string_view title = "vol1ds";

bool recognises(const SourceFile& file)
{
    const std::size_t first = skip_blank(file, 0);
    if (first >= file.lines.size() ||
        find_words(file, first, first + 5, title) >= std::min(first + 5, file.lines.size()))
        return false;
    const std::size_t end = std::min(first + header_search, file.lines.size());
    return find_words(file, first, end, "no. of points") < end;
}

struct TextHeader {
    std::size_t begin = 0, end = 0;  // lines
    std::size_t count_line = 0, unit_line = 0;
    std::string component;  // "L1"
    std::string_view station;
    std::string event;
};

/// Lines that are missing are at `end`.
TextHeader read_text(const SourceFile& file, std::size_t begin)
{
    TextHeader header;
    header.begin = begin;
    header.end = find_numbers(file, begin, begin + header_search, 8);
    header.count_line = find_words(file, begin, header.end, "no. of points");
    header.unit_line = find_words(file, begin, header.end, "units are");
    const std::size_t component = find_words(file, begin, header.end, "comp ");
    if (component < header.end) header.component = text_after(file.lines[component], "comp ");
    const std::size_t station = find_words(file, begin, header.end, "azimuth");
    if (station < header.end) header.station = file.lines[station];
    const std::size_t event = find_words(file, begin, header.end, "epicenter");
    if (event < header.end) header.event = std::string(text::trim(file.lines[event]));
    return header;
}

/// L and T have their azimuths on the station's line; V is upwards.
Direction direction_of(const TextHeader& header)
{
    if (header.component.empty()) return {};
    const char letter = text::lower_case(header.component).front();
    if (letter == 'v') return {.azimuth = {}, .is_vertical = true};
    const std::size_t words = text::lower_case(header.station).find("azimuth");
    if (words == std::string::npos || (letter != 'l' && letter != 't')) return {};
    const std::optional<double> azimuth =
        number_after(header.station.substr(words + 7), std::string_view(letter == 'l' ? "l " : "t "));
    return azimuth ? parse_direction(text::to_text(*azimuth)) : Direction{};
}

/// The step from the duration and, more exactly, from the samples a second.
double time_step_of(const SourceFile& file, const TextHeader& header, const std::vector<double>& reals,
                    const ReadOptions& options, FaultList& faults)
{
    const std::string_view line = file.lines[header.count_line];
    const double count = number_after(line, "points").value_or(0);
    const std::optional<double> duration = number_after(line, "duration");
    const double rate = reals.size() > rate_at ? reals[rate_at] : 0;
    std::optional<double> step;
    if (duration && count > 0) step = *duration / count;
    if (rate > 0) {
        if (step && std::abs(*step * rate - 1) > 0.01) {
            faults.add(file.at(header.count_line),
                       "duration / points = " + text::to_text(*step) + " s but the header gives " +
                           text::to_text(rate) + " samples a second",
                       "the file is damaged: download it again");
        }
        step = 1 / rate;
    }
    return resolve_time_step(step, options, file.at(header.count_line), faults);
}

/// Reads the component whose header begins on line `begin`. @returns the line behind it
std::size_t read_channel(const SourceFile& file, const ReadOptions& options, std::size_t begin, Record& record,
                         FaultList& faults)
{
    const TextHeader header = read_text(file, begin);
    if (header.count_line == header.end || header.unit_line == header.end) {
        faults.add(file.at(begin), "a header without \"NO. OF POINTS\" and \"UNITS ARE\" before its numbers",
                   "the file is cut short or damaged: download it again");
        return file.lines.size();
    }
    const NumberBlock integers = read_block_to_short_line(file, header.end, 5);
    const NumberBlock reals = read_block_to_short_line(file, integers.end, 13);
    const NumberBlock block = read_block(file, reals.end, 13);
    const double count = number_after(file.lines[header.count_line], "points").value_or(0);
    check_block(file, block, {count, file.at(header.count_line)}, record.remarks, faults);
    const Unit unit = resolve_unit(text_after(file.lines[header.unit_line], " and "), options,
                                   file.at(header.unit_line), faults);
    const double step = time_step_of(file, header, reals.numbers, options, faults);
    record.channels.push_back(make_channel(header.component, unit, step, block.numbers));
    set_direction(record.channels.back(), direction_of(header), record.remarks);
    record.station = std::string(text::trim(header.station.substr(0, header.station.find("  "))));
    record.event = header.event;
    return block.end;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    Record record{file.name, bhrc.name, {}};
    refuse_column(file, options, faults);
    const std::size_t end = file.lines.size();
    for (std::size_t line = find_words(file, 0, end, title); line < end; line = find_words(file, line, end, title))
        line = read_channel(file, options, line, record, faults);
    faults.throw_if_any(file.name);
    return record;
}

}  // namespace

const Format bhrc{"BHRC volume 1", recognises, read};

}  // namespace voussoir::records::formats
