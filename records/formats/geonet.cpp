// GeoNet (New Zealand) V1A and V2A: for each of three components sixteen lines of text, 40 whole numbers (10I8),
// 60 real ones (10F8), then acceleration, and in V2A velocity and displacement, ten on a line of eight columns
// each.
//
//   Uncorrected accelerogram 20161113_110256_THZ_20 GNS Science       (V2A: Corrected accelerogram)
//   Raw readings in units of 1.00 mm/s/s  at intervals of 0.005 s     (V2A: ... data at 0.020 sec intervals)
//   Component S90E
//   Acceleration:  Peak    399.7 mm/s/s at 115.37 s     RMS    54.28 mm/s/s
//
// Whole numbers 34 to 36: samples of acceleration, velocity and displacement. Real number 26: time step [s].
//
// Source: [Cousins2008].

#include <algorithm>
#include <cmath>
#include <utility>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/direction.h"
#include "records/formats/format.h"
#include "records/formats/samples.h"

namespace voussoir::records::formats
{

namespace
{

constexpr std::size_t header_search = 40;  // lines of text before the first numbers; sixteen in every file seen
constexpr std::size_t integer_count = 40, real_count = 60, width = 8;
constexpr std::size_t counts_at = 33, step_at = 25;  // 0-based positions in the headers
constexpr double printed_rounding = 0.0005 + 1e-9;   // s, of a step printed with three decimals

/// The first line from `line` on with which a component's header begins, or the number of lines.
std::size_t find_title(const SourceFile& file, std::size_t line)
{
    for (; line < file.lines.size(); ++line) {
        const std::string title = text::lower_case(text::trim(file.lines[line]));
        if (title.starts_with("uncorrected accelerogram") || title.starts_with("corrected accelerogram")) break;
    }
    return line;
}

/// CSMIP's titles are alike; its units are not.
bool recognises(const SourceFile& file)
{
    const std::size_t first = skip_blank(file, 0);
    if (first >= file.lines.size() || find_title(file, first) != first) return false;
    const std::size_t end = std::min(first + header_search, file.lines.size());
    return find_words(file, first, end, "number of points") < end && find_words(file, first, end, "mm/s/s") < end;
}

struct Headers {
    std::size_t begin = 0, integer_line = 0, end = 0;
    std::vector<double> integers, reals;
};

Headers read_headers(const SourceFile& file, std::size_t begin, FaultList& faults)
{
    Headers headers;
    headers.begin = begin;
    headers.integer_line = find_numbers(file, begin, begin + header_search, 8);
    const NumberBlock integers = read_block(file, headers.integer_line, width, integer_count);
    const NumberBlock reals = read_block(file, integers.end, width, real_count);
    headers.integers = integers.numbers;
    headers.reals = reals.numbers;
    headers.end = reals.end;
    if (integers.numbers.size() == integer_count && reals.numbers.size() == real_count) return headers;
    faults.add(file.at(reals.end),
               "the header ends after " + std::to_string(integers.numbers.size()) + " whole and " +
                   std::to_string(reals.numbers.size()) + " real numbers",
               "it has 40 and 60: the file is cut short or damaged");
    faults.throw_if_any(file.name);
    return headers;
}

/// The step in words and as a number with one decimal more.
double time_step_of(const SourceFile& file, const Headers& headers, const ReadOptions& options, FaultList& faults)
{
    const std::size_t line = find_words(file, headers.begin, headers.integer_line, "interval");
    std::optional<double> in_words;
    if (line < headers.integer_line) {
        in_words = number_after(file.lines[line], "intervals of");
        if (!in_words) in_words = number_after(file.lines[line], " at ");
    }
    const double number = headers.reals[step_at];
    const std::string place = file.at(std::min(line, headers.integer_line));
    if (!in_words) return resolve_time_step(number, options, place, faults);
    if (!(number > 0)) return resolve_time_step(in_words, options, place, faults);
    if (*in_words > 0 && std::abs(*in_words - number) > printed_rounding) {
        faults.add(place,
                   "intervals of " + text::to_text(*in_words) + " s here but " + text::to_text(number) +
                       " s among the header's numbers",
                   "the file is damaged: download it again");
    }
    return resolve_time_step(*in_words > 0 ? number : *in_words, options, place, faults);
}

/// "mm/s/s", times the scale of "Raw readings in units of 1.00 mm/s/s".
Unit unit_of(const SourceFile& file, const Headers& headers, const ReadOptions& options, FaultList& faults)
{
    const std::size_t line = find_words(file, headers.begin, headers.integer_line, "in units of");
    if (line == headers.integer_line) return resolve_unit("mm/s2", options, file.at(headers.begin), faults);
    const std::string words = text_after(file.lines[line], "in units of");
    double scale = 0;
    const std::size_t used = text::parse_leading_number(words, scale);
    if (used == 0) return resolve_unit(words, options, file.at(line), faults);
    if (!(scale > 0) || !std::isfinite(scale)) {
        faults.add(file.at(line), "units of " + words, "a unit is greater than 0");
        return resolve_unit("mm/s2", options, file.at(line), faults);
    }
    Unit unit = resolve_unit(words.substr(used), options, file.at(line), faults);
    if (scale != 1) {
        unit.factor *= scale;
        unit.name = text::to_text(scale) + " " + unit.name;
    }
    return unit;
}

/// Passes over velocity and displacement. @returns the line behind them
std::size_t skip_others(const SourceFile& file, const Headers& headers, std::size_t line, std::size_t& skipped,
                        FaultList& faults)
{
    std::vector<std::string> unheard;  // what is left needs no remarks on its details
    for (std::size_t i = counts_at + 1; i < counts_at + 3; ++i) {
        const double count = headers.integers[i];
        if (!(count >= 1 && count < 1e9)) continue;
        const NumberBlock block = read_block(file, line, width, static_cast<std::size_t>(count));
        check_block(file, block, {count, file.at(headers.integer_line + i / 10)}, unheard, faults);
        line = block.end;
        ++skipped;
    }
    return line;
}

/// Reads the component whose header begins on line `begin`. @returns the line behind it
std::size_t read_channel(const SourceFile& file, const ReadOptions& options, std::size_t begin, Record& record,
                         std::size_t& skipped, FaultList& faults)
{
    const Headers headers = read_headers(file, begin, faults);
    const double count = headers.integers[counts_at];
    const std::size_t enough = count >= 1 && count < 1e9 ? static_cast<std::size_t>(count) : without_limit;
    const NumberBlock block = read_block(file, headers.end, width, enough);
    check_block(file, block, {count, file.at(headers.integer_line + counts_at / 10)}, record.remarks, faults);
    const std::size_t component_line = find_words(file, begin, headers.integer_line, "component ");
    std::string component;
    if (component_line < headers.integer_line)
        component = std::string(text::trim(text::trim(file.lines[component_line]).substr(10)));
    const Unit unit = unit_of(file, headers, options, faults);
    const double step = time_step_of(file, headers, options, faults);
    Channel channel = make_channel(component, unit, step, block.numbers);
    set_direction(channel, parse_direction(component), record.remarks);
    const std::size_t peak_line = find_words(file, begin, headers.integer_line, "acceleration:");
    if (peak_line < headers.integer_line && has_unit(channel)) {
        const std::optional<double> stated = number_after(file.lines[peak_line], "peak");
        if (stated) compare_peak(channel, *stated * 1e-3, 0.06e-3, file.at(peak_line), record.remarks);
    }
    record.channels.push_back(std::move(channel));
    const std::size_t station = find_words(file, begin, headers.integer_line, "site ");
    if (station < headers.integer_line) record.station = text_after(file.lines[station], "site ");
    const std::size_t event = find_words(file, begin, headers.integer_line, "epicentre");
    if (event < headers.integer_line) record.event = std::string(text::trim(file.lines[event]));
    return skip_others(file, headers, block.end, skipped, faults);
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    Record record{file.name, geonet.name, {}};
    refuse_column(file, options, faults);
    std::size_t skipped = 0;
    for (std::size_t line = find_title(file, 0); line < file.lines.size(); line = find_title(file, line))
        line = read_channel(file, options, line, record, skipped, faults);
    faults.throw_if_any(file.name);
    if (skipped > 0) {
        record.remarks.push_back("the file also holds " + std::to_string(skipped) +
                                 " series of velocity or displacement, which were not read");
    }
    return record;
}

}  // namespace

const Format geonet{"GeoNet V1A/V2A", recognises, read};

}  // namespace voussoir::records::formats
