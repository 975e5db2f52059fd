// COSMOS V0 to V2: for each channel thirteen lines of text, blocks of whole numbers, real numbers and comments,
// each under a line that counts them, the samples under theirs, and "End-of-data".
//
//   Uncorrected acceleration  (Format v01.20 with 13 text lines) Src:  ce23837j
//   Sta Chan  1: 360 deg (Rcrdr Chan  1)
//   Values used when parameter or data value is unknown/unspecified:   -999, -999.0
//    100 Integer-header values follow on  10 lines, Format= (10I8)
//    100 Real-header values follow on  17 lines, Format= (6F13.6)
//      1 Comment line(s) follow, each starting with a "|":
//   |<SCNL>23837.HNN.CE.--   <AUTH>CE 2018/08/29 14:56:15 PDT
//    13400 acceleration pts, approx  67 secs, units=g.     (02)Format=(8f9.6)
//
// Whole numbers: 1 stage (3: spectra), 3 unit, 54 azimuth [deg] (400 up, 401 down). Real numbers: 22 volts of a
// count [1e-6 V], 42 sensitivity of the sensor [V/g], 47 gain, 62 time step [ms], 34 that of the raw record [s],
// 64 peak.
//
// Source: [Cosmos2001], with its tables.

#include <algorithm>
#include <cmath>
#include <utility>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/cosmos_units.h"
#include "records/formats/direction.h"
#include "records/formats/format.h"
#include "records/formats/samples.h"

namespace voussoir::records::formats
{

namespace
{

constexpr std::size_t header_search = 80;  // lines of text of a channel
constexpr std::string_view title = "(format v";

constexpr int counts_code = 50;

bool recognises(const SourceFile& file)
{
    const std::size_t first = skip_blank(file, 0);
    if (first >= file.lines.size()) return false;
    const std::string line = text::lower_case(file.lines[first]);
    return line.find(title) != std::string::npos && line.find("text lines") != std::string::npos;
}

struct Header {
    std::size_t begin = 0, integer_line = 0, real_line = 0, end = 0;  // lines
    std::vector<double> integers, reals;
    double unknown_integer = -999, unknown_real = -999;
    std::string code;  // "23837.HNN.CE.--", of a comment; may be empty
    std::string component;

    /// By the format's numbers, from 1; nothing when the file does not know it.
    std::optional<double> integer(std::size_t number) const
    {
        if (number > integers.size() || integers[number - 1] == unknown_integer) return std::nullopt;
        return integers[number - 1];
    }
    std::optional<double> real(std::size_t number) const
    {
        if (number > reals.size() || reals[number - 1] == unknown_real) return std::nullopt;
        return reals[number - 1];
    }
};

/// The numbers under the line "100 Integer-header values follow".
NumberBlock read_counted(const SourceFile& file, std::size_t line, FaultList& faults)
{
    double count = 0;
    text::parse_leading_number(text::trim(file.lines[line]), count);
    const bool plausible = count >= 1 && count <= 1e6;
    const NumberBlock block = read_block(file, line + 1, format_width(file.lines[line]),
                                         plausible ? static_cast<std::size_t>(count) : 1);
    if (!plausible || block.numbers.size() < static_cast<std::size_t>(count)) {
        faults.add(file.at(line),
                   "a header of " + text::to_text(count) + " numbers of which " +
                       std::to_string(block.numbers.size()) + " are there",
                   "the file is cut short or damaged: download it again");
        faults.throw_if_any(file.name);
    }
    return block;
}

void read_unknowns(const SourceFile& file, Header& header)
{
    const std::size_t line = find_words(file, header.begin, header.integer_line, "unknown");
    if (line == header.integer_line) return;
    const std::string_view text = file.lines[line];
    header.unknown_integer = number_after(text.substr(0, text.rfind(',')), ":").value_or(-999);
    header.unknown_real = text.find(',') == std::string_view::npos
                              ? header.unknown_integer
                              : number_after(text.substr(text.rfind(',')), ",").value_or(-999);
}

Header read_header(const SourceFile& file, std::size_t begin, FaultList& faults)
{
    Header header;
    header.begin = begin;
    const std::size_t search_end = std::min(begin + header_search, file.lines.size());
    header.integer_line = find_words(file, begin, search_end, "integer-header");
    if (header.integer_line == search_end) {
        throw InputError(file.at(begin), "a channel without \"Integer-header values follow\"",
                         "the file is cut short or damaged: download it again");
    }
    const NumberBlock integers = read_counted(file, header.integer_line, faults);
    header.real_line = skip_blank(file, integers.end);
    if (header.real_line >= file.lines.size() ||
        text::lower_case(file.lines[header.real_line]).find("real-header") == std::string::npos) {
        throw InputError(file.at(std::min(header.real_line, file.lines.size() - 1)),
                         "no \"Real-header values follow\" behind the whole numbers",
                         "the file is cut short or damaged: download it again");
    }
    const NumberBlock reals = read_counted(file, header.real_line, faults);
    header.integers = integers.numbers;
    header.reals = reals.numbers;
    read_unknowns(file, header);
    std::size_t line = skip_blank(file, reals.end);
    if (line < file.lines.size() && text::lower_case(file.lines[line]).find("comment line") != std::string::npos)
        ++line;
    for (line = skip_blank(file, line); line < file.lines.size(); line = skip_blank(file, line + 1)) {
        if (text::trim(file.lines[line]).front() != '|') break;
        if (header.code.empty()) header.code = text_after(file.lines[line], "<scnl>");
    }
    header.code = header.code.substr(0, header.code.find_first_of(" <"));
    header.end = line;
    return header;
}

/// From the words "Sta Chan  1: 360 deg", the header's azimuth, or the code of a vertical channel.
Direction direction_of(const SourceFile& file, Header& header)
{
    const std::size_t line = find_words(file, header.begin, header.integer_line, "sta cha");
    if (line < header.integer_line) {
        std::string_view words = text::trim(file.lines[line]);
        words = words.substr(std::min(words.find(':'), words.size()));
        if (header.component.empty())
            header.component =
                "chan " + text::to_text(header.integer(50).value_or(0)) + ": " + text_after(words, ":");
        while (words.starts_with(':') || words.starts_with(' ')) words.remove_prefix(1);
        if (words.find(':') < words.find("deg")) words.remove_prefix(words.find(':') + 1);  // "Cha:  1: 340 deg"
        const Direction named = parse_direction(words);
        if (named.azimuth || named.is_vertical || named.points_down) return named;
    }
    const double azimuth = header.integer(54).value_or(0);
    if (azimuth == 400) return {.azimuth = {}, .is_vertical = true};
    if (azimuth == 401) return {.azimuth = {}, .is_vertical = false, .points_down = true};
    const std::size_t dot = header.code.find('.');
    const std::string channel =
        dot == std::string::npos ? "" : header.code.substr(dot + 1, header.code.find('.', dot + 1) - dot - 1);
    if (channel.ends_with('Z')) return {.azimuth = {}, .is_vertical = true};
    if (azimuth >= 1 && azimuth <= 360) return parse_direction(text::to_text(azimuth));
    return {};
}

/// What a count of a raw record means, from the recorder's and the sensor's numbers; without a name when the
/// header lacks them.
Unit unit_of_counts(const Header& header)
{
    const double microvolts = header.real(22).value_or(0), sensitivity = header.real(42).value_or(0);
    const double gain = header.real(47).value_or(1);
    if (!(microvolts > 0) || !(sensitivity > 0) || !(gain > 0)) return {"", Quantity::acceleration, 1};
    std::string name =
        "counts x " + text::to_text(microvolts) + "e-6 V / (" + text::to_text(sensitivity) + " V/g)";
    if (gain != 1) name += " / " + text::to_text(gain);
    return {name, Quantity::acceleration, microvolts * 1e-6 / sensitivity / gain * standard_gravity};
}

/// The unit in words and as a code, which must agree.
Unit unit_of(const SourceFile& file, const Header& header, std::size_t line, const ReadOptions& options,
             FaultList& faults)
{
    const std::string words = text_after(file.lines[line], "units=");
    const double given = cosmos_code_in(file.lines[line]).value_or(header.integer(3).value_or(0));
    const int code = static_cast<int>(std::clamp(given, 0.0, 1e6));
    const bool is_counts = code == counts_code || text::lower_case(words).starts_with("count");
    if (is_counts && !options.unit) return unit_of_counts(header);
    const std::optional<Unit> named = find_unit(words);
    if (const std::optional<Unit> known = find_cosmos_unit(code)) {
        const bool agree = !named || std::abs(named->factor - known->factor) <= 1e-9 * known->factor;
        if (!agree)
            faults.add(file.at(line),
                       "units=" + words + " with code " + std::to_string(code) + ", which is " + known->name,
                       "the file is damaged: download it again");
        if (!named && !options.unit) return *known;
    }
    return resolve_unit(words, options, file.at(line), faults);
}

/// The header's step; the raw record's only where the other is not known.
double time_step_of(const SourceFile& file, const Header& header, const ReadOptions& options, FaultList& faults)
{
    const std::optional<double> in_ms = header.real(62);
    const std::optional<double> step = in_ms ? std::optional<double>(*in_ms * 1e-3) : header.real(34);
    return resolve_time_step(step, options, file.at(header.real_line), faults);
}

void compare_duration(const SourceFile& file, const Channel& channel, std::size_t line,
                      std::vector<std::string>& remarks)
{
    const double found = static_cast<double>(channel.samples.size()) * channel.time_step;
    const double stated = number_after(file.lines[line], "approx").value_or(found);
    if (std::abs(found - stated) <= std::max(1.0, 0.02 * stated)) return;
    remarks.push_back(file.at(line) + ": approx " + text::to_text(stated) + " s here but " + text::to_text(found) +
                      " s by count and time step; the time step is used");
}

bool is_announcement(std::string_view line)
{
    double count = 0;
    const std::string text = text::lower_case(text::trim(line));
    return text::parse_leading_number(text, count) > 0 && text.find("pts") != std::string::npos;
}

/// Reads the channel whose header begins on line `begin`, one series or several. @returns the line behind it
std::size_t read_channel(const SourceFile& file, const ReadOptions& options, std::size_t begin, Record& record,
                         FaultList& faults)
{
    Header header = read_header(file, begin, faults);
    if (header.integer(1) == 3 || text::lower_case(file.lines[begin]).find("spectr") != std::string::npos) {
        throw InputError(file.at(begin), "response spectra, not a time history",
                         "name the V0, V1 or V2 file of the same record");
    }
    header.component = header.code;
    const Direction direction = direction_of(file, header);
    std::size_t line = header.end;
    if (line >= file.lines.size() || !is_announcement(file.lines[line])) {
        faults.add(file.at(std::min(line, file.lines.size() - 1)), "no line that counts samples behind the header",
                   "expected \"13400 acceleration pts, approx 67 secs, units=g (02), Format=(8f9.6)\" or similar");
        return header.end;
    }
    while (line < file.lines.size() && is_announcement(file.lines[line])) {
        const NumberBlock block = read_block(file, line + 1, format_width(file.lines[line]));
        double count = 0;
        text::parse_leading_number(text::trim(file.lines[line]), count);
        check_block(file, block, {count, file.at(line)}, record.remarks, faults);
        const Unit unit = unit_of(file, header, line, options, faults);
        const double step = time_step_of(file, header, options, faults);
        record.channels.push_back(make_channel(header.component, unit, step, block.numbers));
        set_direction(record.channels.back(), direction, record.remarks);
        compare_duration(file, record.channels.back(), line, record.remarks);
        const std::optional<double> stated = header.real(64);  // of the first series
        if (stated && line == header.end && has_unit(record.channels.back()))
            compare_peak(record.channels.back(), *stated * unit.factor, 0, file.at(header.real_line),
                         record.remarks);
        line = skip_blank(file, block.end);
    }
    const std::size_t station = find_words(file, begin, header.integer_line, "code:");
    if (station < header.integer_line) {
        const std::string_view words = file.lines[station];
        record.station = std::string(text::trim(words.substr(text::lower_case(words).find("code:") + 5)));
    }
    if (begin + 1 < header.integer_line) record.event = std::string(text::trim(file.lines[begin + 1]));
    return line;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    Record record{file.name, cosmos.name, {}};
    refuse_column(file, options, faults);
    const std::size_t end = file.lines.size();
    for (std::size_t line = find_words(file, 0, end, title); line < end; line = find_words(file, line, end, title))
        line = std::max(read_channel(file, options, line, record, faults), line + 1);
    faults.throw_if_any(file.name);
    keep_accelerations(record);
    return record;
}

}  // namespace

const Format cosmos{"COSMOS V0/V1/V2", recognises, read};

}  // namespace voussoir::records::formats
