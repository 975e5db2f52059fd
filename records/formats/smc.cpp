// USGS SMC: eleven lines of text, 48 whole numbers (8I10), 50 real ones (5E15.7), comments beginning with '|', and
// the samples (8E10.4 with an exponent of one digit; they touch). One component a file. The first whole and the
// first real number are the ones that stand for "not known".
//
//   2 CORRECTED ACCELEROGRAM                                  <- what the samples are: 1 and 2 acceleration,
//   ...                                                          3 velocity, 4 displacement; else spectra
//   station = San Francisco, 1295 Shafter, F component=    360
//
// Whole numbers: 13 and 14 angle of the component from upwards and azimuth [deg], 16 comment lines, 17 number of
// values. Real number 2: samples a second; where it is not known, the samples are (time, value) pairs.
//
// Source: [SmcFormat].

#include <array>
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

constexpr std::size_t header_search = 25;  // lines of text before the numbers; eleven in every file seen
constexpr std::size_t integer_count = 48, real_count = 50;
constexpr std::size_t integer_width = 10, real_width = 15, sample_width = 10;
constexpr double largest_rate = 1e5;  // samples a second; a header with more is damaged

// 0-based positions in the headers.
constexpr std::size_t tilt_at = 12, azimuth_at = 13, count_at = 16, rate_at = 1;

struct Kind {
    std::string_view words;
    const char* unit;  // none: spectra, which are no record
};
constexpr std::array<Kind, 6> kinds{{
    {"uncorrected accelerogram", "cm/s2"},
    {"corrected accelerogram", "cm/s2"},
    {"velocity", "cm/s"},
    {"displacement", "cm"},
    {"response spectr", nullptr},
    {"fourier", nullptr},
}};

/// The kind a first line "2 CORRECTED ACCELEROGRAM" names; nothing when it is not of that form.
const Kind* find_kind(std::string_view line)
{
    const std::string title = text::lower_case(text::trim(line));
    double number = 0;
    const std::size_t used = text::parse_leading_number(title, number);
    if (used == 0 || used > 2) return nullptr;
    const std::string_view words = text::trim(std::string_view(title).substr(used));
    for (const Kind& kind : kinds) {
        if (words.starts_with(kind.words)) return &kind;
    }
    return nullptr;
}

bool recognises(const SourceFile& file)
{
    const std::size_t first = skip_blank(file, 0);
    if (first >= file.lines.size() || find_kind(file.lines[first]) == nullptr) return false;
    return find_words(file, first, first + header_search, "station =") < first + header_search &&
           find_words(file, first, first + header_search, "component") < first + header_search;
}

struct Headers {
    std::size_t text = 0;  // line of the title
    std::vector<double> integers, reals;
    std::size_t integer_line = 0, real_line = 0, end = 0;
};

Headers read_headers(const SourceFile& file, std::size_t title, FaultList& faults)
{
    Headers headers;
    headers.text = title;
    headers.integer_line = find_numbers(file, headers.text + 1, headers.text + header_search, 8);
    const NumberBlock integers = read_block(file, headers.integer_line, integer_width, integer_count);
    const NumberBlock reals = read_block(file, integers.end, real_width, real_count);
    if (integers.numbers.size() < integer_count || reals.numbers.size() < real_count) {
        faults.add(file.at(reals.end),
                   "the header ends after " + std::to_string(integers.numbers.size()) + " whole and " +
                       std::to_string(reals.numbers.size()) + " real numbers",
                   "an SMC header has 48 and 50: the file is cut short or damaged");
        faults.throw_if_any(file.name);
    }
    headers.integers = integers.numbers;
    headers.reals = reals.numbers;
    headers.real_line = integers.end;
    headers.end = reals.end;
    while (headers.end < file.lines.size()) {  // comments, as many as there are, whatever the header counts
        const std::string_view line = file.lines[headers.end];
        if (!is_blank(line) && text::trim(line).front() != '|') break;
        ++headers.end;
    }
    return headers;
}

Direction direction_of(const Headers& headers, const std::string& component)
{
    const double unknown = headers.integers[0], tilt = headers.integers[tilt_at];
    const double azimuth = headers.integers[azimuth_at];
    const Direction named = parse_direction(component);
    if (named.azimuth || named.is_vertical || named.points_down) return named;
    if (tilt == 0) return {.azimuth = {}, .is_vertical = true};
    if (tilt == 180) return {.azimuth = {}, .is_vertical = false, .points_down = true};
    if (tilt == 90 && azimuth != unknown) return parse_direction(text::to_text(azimuth));
    return {};
}

/// Zero bytes after the last sample fill the last line of some files.
void remark_on_padding(const SourceFile& file, std::vector<std::string>& remarks)
{
    if (file.bytes.find('\0') != std::string::npos)
        remarks.push_back("zero bytes that fill the last line of the file were skipped");
}

/// The samples as they are stored, their step or their times. @returns the line behind them
std::size_t read_samples(const SourceFile& file, const Headers& headers, const ReadOptions& options,
                         Channel& channel, std::vector<std::string>& remarks, FaultList& faults)
{
    const NumberBlock block = read_block(file, headers.end, sample_width);
    check_block(file, block, {headers.integers[count_at], file.at(headers.integer_line + count_at / 8)}, remarks,
                faults);
    const double rate = headers.reals[rate_at];
    if (rate == headers.reals[0]) {
        refuse_time_step(file, options, faults);
        TimedSamples samples = split_pairs(file, block, remarks, faults);
        channel.samples = std::move(samples.values);
        channel.times = std::move(samples.times);
        return block.end;
    }
    channel.samples = block.numbers;
    const std::string place = file.at(headers.real_line);
    if (rate > 0 && rate <= largest_rate)
        channel.time_step = resolve_time_step(1 / rate, options, place, faults);
    else
        faults.add(place, "the header gives " + text::to_text(rate) + " samples a second",
                   "must be greater than 0 and at most " + text::to_text(largest_rate));
    return block.end;
}

/// Station and event of the record. @returns the component's name
std::string read_text(const SourceFile& file, const Headers& headers, Record& record)
{
    if (headers.text + 3 < headers.integer_line)
        record.event = std::string(text::trim(file.lines[headers.text + 3]));
    const std::size_t line = find_words(file, headers.text, headers.integer_line, "station =");
    if (line == headers.integer_line) return "";
    const std::string_view words = file.lines[line];
    const std::size_t component = std::min(text::lower_case(words).find("component"), words.size());
    const std::string_view station = words.substr(0, component);
    record.station = std::string(text::trim(station.substr(std::min(station.find('=') + 1, station.size()))));
    return text_after(words.substr(component), "component");
}

/// Reads the component whose header begins on line `title`. @returns the line behind it
std::size_t read_channel(const SourceFile& file, const ReadOptions& options, std::size_t title, Record& record,
                         FaultList& faults)
{
    const Kind& kind = *find_kind(file.lines[title]);
    if (kind.unit == nullptr) {
        throw InputError(file.at(title), "response spectra, not a time history",
                         "use the accelerogram from which they were computed");
    }
    const Headers headers = read_headers(file, title, faults);
    const Unit unit = resolve_unit(kind.unit, options, file.at(title), faults);
    Channel stored;
    const std::size_t end = read_samples(file, headers, options, stored, record.remarks, faults);
    const std::string component = read_text(file, headers, record);
    Channel channel = make_channel(component, unit, stored.time_step, std::move(stored.samples));
    channel.times = std::move(stored.times);
    set_direction(channel, direction_of(headers, component), record.remarks);
    record.channels.push_back(std::move(channel));
    return end;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    Record record{file.name, smc.name, {}};
    refuse_column(file, options, faults);
    for (std::size_t line = skip_blank(file, 0); line < file.lines.size(); line = skip_blank(file, line)) {
        if (find_kind(file.lines[line]) == nullptr) {
            if (faults.empty())
                faults.add(file.at(line), "\"" + first_not_number(file.lines[line], 0) + "\" behind the samples",
                           "expected the end of the file or the next component");
            break;
        }
        line = read_channel(file, options, line, record, faults);
    }
    remark_on_padding(file, record.remarks);
    faults.throw_if_any(file.name);
    keep_accelerations(record);
    return record;
}

}  // namespace

const Format smc{"USGS SMC", recognises, read};

}  // namespace voussoir::records::formats
