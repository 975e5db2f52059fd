// Central Weather Bureau (now Administration) of Taiwan: header lines beginning with #, then rows of time and
// three components:
//
//   #StationCode: EAS
//   #SampleRate(Hz): 50
//   #AmplitudeUnit:  gal. DCoffset(corr)
//   #DataSequence: Time U(+); N(+); E(+)
//   #Data: 4F10.3
//        0.000     0.000     0.000     0.000
//
// Written from the headers of files of the CWB's free-field network; no description of the format was at hand.

#include <algorithm>
#include <cmath>

#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "CWB (Taiwan)";
constexpr std::size_t longest_header = 100;  // lines; 22 in the files seen

KeyedHeader read_header(const SourceFile& file)
{
    return read_keyed_header(file, 0, longest_header, is_row_of_numbers);
}

bool recognises(const SourceFile& file)
{
    if (!is_text(file)) return false;
    const KeyedHeader header = read_header(file);
    return header.find_beginning("DataSequence") != nullptr && header.find_beginning("SampleRate") != nullptr;
}

struct Column {
    std::string name;          // "U"
    bool is_reversed = false;  // positive the other way: "U(-)"
};

/// "Time U(+); N(+); E(+)" -> Time, U, N, E. Adds a fault when there is no time or nothing else.
std::vector<Column> parse_sequence(const SourceFile& file, const HeaderLine* line, FaultList& faults)
{
    std::string text = text_of(line);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == ';' || c == ',' || c == '\t'; }, ' ');
    std::vector<Column> columns;
    std::string_view rest = text::trim(text);
    while (!rest.empty()) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        const bool is_reversed = word.find("(-)") != std::string_view::npos;
        columns.push_back({std::string(word.substr(0, word.find('('))), is_reversed});
        rest = text::trim(rest.substr(word.size()));
    }
    if (columns.size() < 2 || text::lower_case(columns.front().name) != "time")
        faults.add(place_of(file, line), "DataSequence = \"" + text_of(line) + "\"",
                   "time and one component or more");
    return columns;
}

/// The times must be those of the sample rate: a missing row shows there.
void check_times(const SourceFile& file, std::size_t first, const std::vector<double>& times, double time_step,
                 FaultList& faults)
{
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double on_grid = times.front() + static_cast<double>(i) * time_step;
        // Printed in thousandths of a second.
        if (std::abs(times[i] - on_grid) <= 0.02 * time_step + 1e-3) continue;
        faults.add(file.at(first + i),
                   "time " + text::to_text(times[i]) + " s where the sample rate asks for " +
                       text::to_text(on_grid) + " s",
                   "the file is damaged: download it again");
        return;
    }
}

Channel make_component(const Column& column, const Unit& unit, double time_step, std::vector<double> samples,
                       std::vector<std::string>& remarks)
{
    Channel channel = make_channel(column.name, unit, time_step, std::move(samples));
    orient_by_short_name(channel, column.name);
    if (!column.is_reversed) return channel;
    if (channel.azimuth) channel.azimuth = std::fmod(*channel.azimuth + 180, 360);
    if (channel.is_vertical) remarks.push_back("Component " + column.name + " is positive downwards.");
    channel.is_vertical = false;
    return channel;
}

std::string joined(const std::string& first, const char* between, const std::string& second)
{
    return first + (first.empty() || second.empty() ? "" : between) + second;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const KeyedHeader header = read_header(file);
    const HeaderLine* sequence = header.find_beginning("DataSequence");
    const HeaderLine* rate = header.find_beginning("SampleRate");
    const HeaderLine* units = header.find_beginning("AmplitudeUnit");
    const HeaderLine* length = header.find_beginning("RecordLength");
    const std::vector<Column> columns = parse_sequence(file, sequence, faults);
    const std::string unit_words = text_of(units);
    const Unit unit = resolve_unit(unit_words.substr(0, unit_words.find_first_of(" .;,(")), options,
                                   place_of(file, units), faults);
    const double per_second = required_number(file, rate, "SampleRate(Hz)", faults);
    const double time_step = resolve_time_step(1 / per_second, options, place_of(file, rate), faults);
    refuse_column(file, options, faults);
    faults.throw_if_any(file.name);

    std::vector<std::vector<double>> numbers = read_columns(file, header.end, columns.size(), faults);
    faults.throw_if_any(file.name);
    const auto text = [&](const char* key) { return text_of(header.find_beginning(key)); };
    Record record{file.name, format_name, {}};
    record.station = joined(text("StationCode"), " ", text("StationName"));
    record.event = joined(text("OriginTime"), " M", text("Magnitude"));
    const double announced = length != nullptr ? number_of(length).value_or(0) * per_second
                                               : static_cast<double>(numbers.front().size());
    check_count_with_surplus(std::round(announced), numbers.front().size(), 1, place_of(file, length), faults,
                             record.remarks);
    check_times(file, header.end, numbers.front(), time_step, faults);
    faults.throw_if_any(file.name);
    for (std::size_t i = 1; i < columns.size(); ++i)
        record.channels.push_back(
            make_component(columns[i], unit, time_step, std::move(numbers[i]), record.remarks));
    return record;
}

}  // namespace

const Format cwb{format_name, recognises, read};

}  // namespace voussoir::records::formats
