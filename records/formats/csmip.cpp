// CSMIP/CDMG volumes 1 and 2, also of RENADIC: for each channel 13 (V2: 25) lines of text, 100 whole numbers
// (16I5), 50 (V2: 100) real ones (8F10), the samples, and a line beginning with "/&". Volume 3 holds spectra:
// refused.
//
//   Uncorrected Accelerogram Data             Processed: 08/29/18, CGS  ce23837j     (V2: a line "CORRECTED
//   Chan  1: 360 Deg                                                                 ACCELEROGRAM" before it)
//   No. of Points =  13400  Record Length = 67.000 sec   at 200 Samples/sec
//   Units of uncor data are sec and g.         Max  =  -.105 g, at   31.575 sec.
//
// The samples of V1 are (time, value) pairs (10F7.3), or follow a line as in V2:
//
//   13400 Accelerogram points at 200 pts/sec in units of g.       Format: (8f9.6)
//   3251 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)      <- also VELOC, DISPL
//
// Source: [ShakalHuang1985], and the files' own headers.

#include <algorithm>
#include <array>
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

constexpr std::size_t header_search = 60;  // lines of text before the first numbers; 25 at most in the files seen
constexpr std::size_t step_at = 60;        // 0-based position in V2's real header
constexpr std::size_t pair_width = 7, sample_width = 10;
constexpr double time_resolution = 0.001;  // s, of times printed with three decimals

bool is_uncorrected(std::string_view line)
{
    const std::string title = text::lower_case(line);
    return title.find("uncorrected accelerogram data") != std::string::npos &&
           title.find("of volume") == std::string::npos;  // USC's
}

/// The first line from `line` on with which a channel begins, V2's line above included.
std::size_t find_channel(const SourceFile& file, std::size_t line)
{
    while (line < file.lines.size() && !is_uncorrected(file.lines[line])) ++line;
    return line;
}

bool is_spectra(const SourceFile& file, std::size_t first)
{
    const std::string title = text::lower_case(file.lines[first]);
    return title.find("response") != std::string::npos && title.find("spectr") != std::string::npos;
}

bool recognises(const SourceFile& file)
{
    const std::size_t first = skip_blank(file, 0);
    if (first >= file.lines.size()) return false;
    if (is_uncorrected(file.lines[first])) return true;
    const std::string title = text::lower_case(text::trim(file.lines[first]));
    const bool is_v2 = title.starts_with("corrected accelerogram");
    return (is_v2 || is_spectra(file, first)) &&
           find_channel(file, first) < std::min(first + 5, file.lines.size());
}

struct Header {
    std::size_t begin = 0, integer_line = 0, end = 0;  // lines
    std::vector<double> reals;
    std::string component, direction;
};

/// "Chan  1: 360 Deg      (Sta Chn: 1)" -> "chan 1: 360 Deg".
void read_component(std::string_view line, Header& header)
{
    line = text::trim(line);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return;
    header.direction = text_after(line.substr(colon), ":");
    header.component = "chan " + std::string(text::trim(line.substr(4, colon - 4))) + ": " + header.direction;
}

Header read_header(const SourceFile& file, std::size_t begin, Record& record)
{
    Header header;
    header.begin = begin;
    header.integer_line = find_numbers(file, begin, begin + header_search, 8);
    for (std::size_t i = begin; i < header.integer_line; ++i) {
        const std::string line = text::lower_case(text::trim(file.lines[i]));
        if (line.starts_with("chan ") && header.component.empty()) read_component(file.lines[i], header);
        if (line.starts_with("station ") && i + 1 < header.integer_line) {
            const std::string_view words = text::trim(file.lines[i]), name = text::trim(file.lines[i + 1]);
            record.station = std::string(text::trim(words.substr(0, words.find("  ")))) + ", " +
                             std::string(text::trim(name.substr(0, name.find("  "))));
        }
    }
    if (begin + 1 < header.integer_line) record.event = std::string(text::trim(file.lines[begin + 1]));
    const NumberBlock integers = read_block_to_short_line(file, header.integer_line, 5);
    const NumberBlock reals = read_block_to_short_line(file, integers.end, 10);
    header.reals = reals.numbers;
    header.end = reals.end;
    return header;
}

struct Announcement {
    double count = 0;
    std::optional<double> time_step;  // s
    Quantity quantity = Quantity::acceleration;
    std::string unit;
    std::size_t width = sample_width;
};

/// The line above samples; nothing when it is another.
std::optional<Announcement> parse_announcement(std::string_view text, const Header& header)
{
    const std::string line = text::lower_case(text::trim(text));
    Announcement announced;
    const bool counts = text::parse_leading_number(line, announced.count) > 0;
    const bool has_words = line.find("points") != std::string::npos || line.find("pts") != std::string::npos;
    if (!counts || !has_words) return std::nullopt;
    if (line.find("veloc") != std::string::npos) announced.quantity = Quantity::velocity;
    if (line.find("displ") != std::string::npos) announced.quantity = Quantity::displacement;
    if (const auto rate = number_after(line, " at ");
        rate && line.find("/sec") != std::string::npos && line.find("spaced at") == std::string::npos)
        announced.time_step = 1 / *rate;
    if (const auto step = number_after(line, "spaced at")) announced.time_step = *step;
    // In print the step has three decimals; the header's numbers have it in full.
    const double exact = header.reals.size() > step_at ? header.reals[step_at] : 0;
    if (announced.time_step && *announced.time_step > 0 && exact > 0 &&
        std::abs(exact - *announced.time_step) <= 0.5 * time_resolution)
        announced.time_step = exact;
    for (const std::string_view words : {"units of", "units:", "sec, in ", "sec. in ", "sec in ", ", in "}) {
        if (announced.unit.empty()) announced.unit = text_after(line, words);
    }
    if (const std::size_t width = format_width(line); width > 0) announced.width = width;
    return announced;
}

/// The even step of printed times: the header's samples a second if they agree, else the mean step, in whole
/// microseconds, if nearly all steps are that one but for rounding; nothing when they are not.
std::optional<double> even_step(const SourceFile& file, const Header& header, const std::vector<double>& times)
{
    const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
    std::size_t uneven = 0;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (std::abs(times[i] - times[i - 1] - mean) > 1.1 * time_resolution) ++uneven;
    }
    if (1000 * uneven > times.size() || mean < time_resolution) return std::nullopt;
    const std::size_t line = find_words(file, header.begin, header.integer_line, "samples/sec");
    if (line < header.integer_line) {
        const std::optional<double> rate = number_after(file.lines[line], " at ");
        if (rate && std::abs(*rate * mean - 1) < 1e-3) return 1 / *rate;
    }
    return std::round(mean * 1e6) / 1e6;
}

void remark_on_times(const std::vector<double>& times, double step, const std::string& component,
                     std::vector<std::string>& remarks)
{
    double strayed = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
        strayed = std::max(strayed, std::abs(times[i] - times.front() - static_cast<double>(i) * step));
    if (strayed <= 1.1 * time_resolution) return;
    remarks.push_back(component + ": the printed times deviate by up to " +
                      text::to_text(std::round(strayed * 1e3) / 1e3) +
                      " s from even ones; the samples are taken as evenly spaced at their mean step, " +
                      text::to_text(step) + " s");
}

/// (time, value) pairs behind V1's numbers. @returns the line behind them
std::size_t read_pairs(const SourceFile& file, const Header& header, const ReadOptions& options, Record& record,
                       FaultList& faults)
{
    const std::size_t count_line = find_words(file, header.begin, header.integer_line, "no. of points");
    const std::size_t unit_line = find_words(file, header.begin, header.integer_line, "units of");
    if (count_line == header.integer_line) {
        faults.add(file.at(header.begin), "a header without \"No. of Points\"",
                   "the file is damaged: download it again");
        return file.lines.size();
    }
    const NumberBlock block = read_block(file, header.end, pair_width);
    const double count = number_after(file.lines[count_line], "points").value_or(0);
    check_block(file, block, {count, file.at(count_line), 2}, record.remarks, faults);
    TimedSamples samples = split_pairs(file, block, record.remarks, faults);
    const std::string words = unit_line < header.integer_line ? text_after(file.lines[unit_line], " and ") : "";
    const Unit unit = resolve_unit(words, options, file.at(std::min(unit_line, count_line)), faults);
    if (!faults.empty()) return block.end;
    const std::optional<double> step = even_step(file, header, samples.times);
    Channel channel = make_channel(header.component, unit, step.value_or(0), std::move(samples.values));
    if (step) {
        channel.time_step = resolve_time_step(step, options, file.at(count_line), faults);
        remark_on_times(samples.times, channel.time_step, header.component, record.remarks);
    } else {
        refuse_time_step(file, options, faults);
        channel.times = std::move(samples.times);
    }
    set_direction(channel, parse_direction(header.direction), record.remarks);
    record.channels.push_back(std::move(channel));
    return block.end;
}

/// The series of a channel, each under its own line. @returns the line behind them
std::size_t read_series(const SourceFile& file, const Header& header, const ReadOptions& options, Record& record,
                        FaultList& faults)
{
    std::size_t line = skip_blank(file, header.end);
    for (std::size_t series = 0; line < file.lines.size(); ++series) {
        const std::optional<Announcement> announced = parse_announcement(file.lines[line], header);
        if (!announced) {
            if (series == 0) {
                faults.add(
                    file.at(line),
                    "\"" + std::string(text::trim(file.lines[line]).substr(0, 40)) +
                        "\" behind the header's numbers",
                    "expected \"3251 points of accel data equally spaced at .020 sec, in cm/sec2\" or similar");
            }
            break;
        }
        const NumberBlock block = read_block(file, line + 1, announced->width);
        check_block(file, block, {announced->count, file.at(line)}, record.remarks, faults);
        const bool asked = announced->quantity == Quantity::acceleration;
        const Unit unit = resolve_unit(announced->unit, asked ? options : ReadOptions{}, file.at(line), faults);
        const double step = resolve_time_step(announced->time_step, options, file.at(line), faults);
        record.channels.push_back(make_channel(header.component, unit, step, block.numbers));
        record.channels.back().quantity = announced->quantity;
        set_direction(record.channels.back(), parse_direction(header.direction), record.remarks);
        line = skip_blank(file, block.end);
    }
    return line;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    const std::size_t first = skip_blank(file, 0);
    if (is_spectra(file, first)) {
        throw InputError(file.at(first), "response spectra, not a time history",
                         "name the volume 1 or 2 file of the same record");
    }
    FaultList faults;
    Record record{file.name, csmip.name, {}};
    refuse_column(file, options, faults);
    std::vector<double> on_line;
    for (std::size_t line = find_channel(file, first); line < file.lines.size(); line = find_channel(file, line)) {
        const Header header = read_header(file, line, record);
        const std::size_t behind = skip_blank(file, header.end);
        if (behind >= file.lines.size()) {
            faults.add(file.at(line), "a channel without samples", "the file is cut short: download it again");
            break;
        }
        const bool in_pairs = parse_fields(file.lines[behind], pair_width, on_line);
        line = in_pairs ? read_pairs(file, header, options, record, faults)
                        : read_series(file, header, options, record, faults);
        line = std::max(line, header.end);
    }
    faults.throw_if_any(file.name);
    keep_accelerations(record);
    return record;
}

}  // namespace

const Format csmip{"CSMIP volume 1/2", recognises, read};

}  // namespace voussoir::records::formats
