// ".cor.acc": ten header lines "key : value" and "Accelaration time series in m/s/s", then samples in a Fortran
// format 5E14.7, whose numbers touch.
//
// Written from the headers of the files of L'Aquila, 2009, in the European strong-motion collections.

#include <algorithm>
#include <cmath>
#include <optional>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/keyed_header.h"

namespace voussoir::records::formats
{

namespace
{

constexpr std::size_t header_search = 30;  // lines; ten in every file seen
constexpr std::string_view unit_words = "time series in ";

struct Header {
    std::string component, station, event;
    std::optional<double> count, time_step, peak;
    std::size_t count_line = 0, step_line = 0, peak_line = 0, unit_line = 0;
    std::string unit;
};

std::optional<double> number_in(std::string_view text)
{
    double value = 0;
    return text::parse_fortran_number(text, value) ? std::optional<double>(value) : std::nullopt;
}

Header read_header(const SourceFile& file)
{
    Header header;
    for (std::size_t i = 0; i < file.lines.size() && i < header_search; ++i) {
        const std::string_view line = file.lines[i];
        const std::size_t words = text::lower_case(line).find(unit_words);
        if (words != std::string::npos) {
            header.unit = std::string(text::trim(line.substr(words + unit_words.size())));
            header.unit_line = i;
            break;
        }
        const std::size_t colon = line.find(" : ");
        if (colon == std::string_view::npos) continue;
        const std::string_view key = text::trim(line.substr(0, colon)), value = text::trim(line.substr(colon + 3));
        if (key == "Orientation") header.component = std::string(value);
        if (key == "Station Code / Name") header.station = std::string(value);
        if (key == "Event Date & Time") header.event = std::string(value);
        if (key == "Number of Data") header.count = number_in(value), header.count_line = i;
        if (key == "Time Increment (s)") header.time_step = number_in(value), header.step_line = i;
        if (key == "PGA (m/s/s)") header.peak = number_in(value), header.peak_line = i;
    }
    return header;
}

bool recognises(const SourceFile& file)
{
    if (!is_text(file)) return false;
    const Header header = read_header(file);
    return header.unit_line > 0 && header.count_line > 0 && header.step_line > 0;
}

/// The header states the peak: a cheap proof that the samples were read as they were meant.
void check_peak(const Header& header, const Channel& channel, const SourceFile& file, FaultList& faults)
{
    if (!header.peak || !faults.empty()) return;
    const double found = peak(channel);
    if (std::abs(found - std::abs(*header.peak)) <= 1e-3 * found) return;  // some print four digits
    faults.add(file.at(header.peak_line),
               "the header announces a peak of " + text::to_text(*header.peak) + " m/s2 but the samples have " +
                   text::to_text(found) + " m/s2",
               "the file is damaged: download it again");
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    const Header header = read_header(file);
    const Unit unit = resolve_unit(header.unit, options, file.at(header.unit_line), faults);
    // What is not a number in the header is as bad as a zero.
    const double time_step =
        resolve_time_step(header.time_step.value_or(0), options, file.at(header.step_line), faults);
    std::vector<double> samples = read_fortran_samples(file, header.unit_line + 1, faults);
    check_count(header.count.value_or(0), samples.size(), file.at(header.count_line), faults);
    refuse_column(file, options, faults);
    Channel channel = make_channel(header.component, unit, time_step, std::move(samples));
    check_peak(header, channel, file, faults);
    faults.throw_if_any(file.name);
    orient_by_short_name(channel, channel.component);
    return {file.name, "corrected acceleration (.cor.acc)", {std::move(channel)}, header.station, header.event};
}

}  // namespace

const Format corrected_acc{"corrected acceleration (.cor.acc)", recognises, read};

}  // namespace voussoir::records::formats
