// USC, the University of Southern California's volume I: thirteen lines of text, 100 whole and 50 real numbers,
// then (time, value) pairs of a hand-digitized film, unevenly spaced.
//
//   FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:
//   COMP N00W                                                               9   <- a count of letters, not ours
//   NO. OF POINTS =   7340      DURATION =  31.026 SEC                      50
//   UNITS ARE SEC AND G/10                                                  22
//
// Source: [TrifunacLee1973], and the files' own headers.

#include <utility>

#include "libdda/text/words.h"
#include "records/formats/direction.h"
#include "records/formats/format.h"
#include "records/formats/samples.h"

namespace voussoir::records::formats
{

namespace
{

constexpr std::size_t header_search = 40;  // lines of text before the first numbers; thirteen in every file seen
constexpr std::string_view title = "accelerogram data of volume";

bool recognises(const SourceFile& file)
{
    const std::size_t first = skip_blank(file, 0);
    return first < file.lines.size() && text::lower_case(file.lines[first]).find(title) != std::string::npos;
}

/// The words of a line up to two blanks.
std::string words_of(std::string_view line)
{
    line = text::trim(line);
    return std::string(text::trim(line.substr(0, line.find("  "))));
}

/// Reads the channel whose title stands on line `begin`. @returns the line behind it
std::size_t read_channel(const SourceFile& file, const ReadOptions& options, std::size_t begin, Record& record,
                         FaultList& faults)
{
    const std::size_t numbers = find_numbers(file, begin, begin + header_search, 8);
    const std::size_t count_line = find_words(file, begin, numbers, "no. of points");
    const std::size_t unit_line = find_words(file, begin, numbers, "units are");
    const std::size_t component_line = find_words(file, begin + 1, numbers, "comp ");
    if (count_line == numbers || unit_line == numbers) {
        faults.add(file.at(begin), "a header without \"NO. OF POINTS\" and \"UNITS ARE\" before its numbers",
                   "the file is cut short or damaged: download it again");
        return file.lines.size();
    }
    const NumberBlock integers = read_block_to_short_line(file, numbers, 5);
    const NumberBlock reals = read_block_to_short_line(file, integers.end, 10);
    const NumberBlock block = read_block(file, reals.end, 7);
    const double count = number_after(file.lines[count_line], "points").value_or(0);
    check_block(file, block, {count, file.at(count_line), 2}, record.remarks, faults);
    TimedSamples samples = split_pairs(file, block, record.remarks, faults);
    const Unit unit =
        resolve_unit(text_after(file.lines[unit_line], " and "), options, file.at(unit_line), faults);
    const std::string component =
        component_line < numbers ? text_after(file.lines[component_line], "comp ") : std::string();
    Channel channel = make_channel(component, unit, 0, std::move(samples.values));
    channel.times = std::move(samples.times);
    set_direction(channel, parse_direction(component), record.remarks);
    record.channels.push_back(std::move(channel));
    const std::size_t station = find_words(file, begin, numbers, "station");
    if (station < numbers) record.station = words_of(file.lines[station]);
    if (begin + 1 < numbers) record.event = words_of(file.lines[begin + 1]);
    return block.end;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    Record record{file.name, usc.name, {}};
    refuse_column(file, options, faults);
    refuse_time_step(file, options, faults);
    for (std::size_t line = find_words(file, 0, file.lines.size(), title); line < file.lines.size();
         line = find_words(file, line, file.lines.size(), title)) {
        line = read_channel(file, options, line, record, faults);
    }
    faults.throw_if_any(file.name);
    return record;
}

}  // namespace

const Format usc{"USC", recognises, read};

}  // namespace voussoir::records::formats
