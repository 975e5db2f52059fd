// The text of eqsig (Python): a label, "npts dt", then one sample a line, by convention in m/s2.
//
// Source: [EqsigManual].

#include <cmath>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/keyed_header.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "eqsig";
constexpr std::size_t count_line = 1;

bool recognises(const SourceFile& file)
{
    if (!is_text(file) || file.lines.size() < 4) return false;
    std::vector<double> announced, sample, label;
    return !text::parse_separated(file.lines[0], label) && file.lines[0].find('#') == std::string_view::npos &&
           text::parse_fortran(file.lines[count_line], announced) && announced.size() == 2 &&
           announced[0] == std::floor(announced[0]) && announced[0] >= 2 &&
           text::parse_fortran(file.lines[2], sample) && sample.size() == 1 &&
           text::parse_fortran(file.lines[3], sample) && sample.size() == 1;
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    std::vector<double> announced;
    text::parse_fortran(file.lines[count_line], announced);
    Record record{file.name, format_name, {}};
    Unit unit = resolve_unit("", options, file.name, faults);
    if (!options.unit) {
        unit = *find_unit("m/s2");
        record.remarks.push_back(
            "The file states no unit: m/s2 by eqsig's convention; give the unit if it differs.");
    }
    const double time_step = resolve_time_step(announced[1], options, file.at(count_line), faults);
    std::vector<double> samples = read_fortran_samples(file, count_line + 1, faults);
    check_count(announced[0], samples.size(), file.at(count_line), faults);
    refuse_column(file, options, faults);
    faults.throw_if_any(file.name);
    record.channels.push_back(
        make_channel(std::string(text::trim(file.lines[0])), unit, time_step, std::move(samples)));
    return record;
}

}  // namespace

const Format eqsig{format_name, recognises, read};

}  // namespace voussoir::records::formats
