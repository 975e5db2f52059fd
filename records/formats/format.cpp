#include "records/formats/format.h"

#include <cmath>
#include <utility>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/content.h"
#include "records/formats/fields.h"

namespace voussoir::records::formats
{

Unit resolve_unit(const std::string& in_header, const ReadOptions& options, const std::string& place,
                  FaultList& faults)
{
    const Unit none{"", Quantity::acceleration, 1};
    const std::optional<Unit> from_header = find_unit(in_header);
    if (!options.unit) {
        if (from_header) return *from_header;
        return none;
    }
    const std::optional<Unit> given = find_unit(*options.unit);
    if (!given) {
        faults.add(place, "unit \"" + *options.unit + "\" was asked for", "use one of " + known_units());
        return none;
    }
    const bool same =
        !from_header || (from_header->quantity == given->quantity && from_header->factor == given->factor);
    if (!same) {
        faults.add(place, "the file is in " + from_header->name + " but " + given->name + " was asked for",
                   "omit the unit");
    }
    return *given;
}

double resolve_time_step(std::optional<double> in_file, const ReadOptions& options, const std::string& place,
                         FaultList& faults)
{
    if (!in_file && !options.time_step) {
        faults.add(place, "no time step", "give the record a time_step");
        return 1;
    }
    const double time_step = in_file ? *in_file : *options.time_step;
    if (!(time_step > 0) || !std::isfinite(time_step)) {
        faults.add(place, "time step = " + text::to_text(time_step) + " s", "must be finite and greater than 0");
        return 1;
    }
    // Times are often printed with few digits: the same step to a thousandth is the same step.
    if (in_file && options.time_step && !(std::abs(*options.time_step - time_step) <= 1e-3 * time_step)) {
        faults.add(place,
                   "the file has time step " + text::to_text(time_step) + " s but " +
                       text::to_text(*options.time_step) + " s was asked for",
                   "omit the time step");
    }
    return time_step;
}

void add_row_fault(const SourceFile& file, std::size_t line, const std::string& expected, FaultList& faults)
{
    if (has_decimal_commas(file.lines[line]))
        faults.add(file.at(line), "numbers with decimal commas", "write decimal points (0.01 for 0,01)");
    else
        faults.add(file.at(line), "not a line of numbers: \"" + first_not_number(file.lines[line], 0) + "\"",
                   expected);
}

std::vector<double> read_fortran_samples(const SourceFile& file, std::size_t first, FaultList& faults)
{
    std::vector<double> samples, on_line;
    for (std::size_t i = first; i < file.lines.size(); ++i) {
        if (text::trim(file.lines[i]).empty()) continue;
        if (!text::parse_fortran(file.lines[i], on_line)) {
            add_row_fault(file, i, "every line after the header holds samples only", faults);
            if (has_decimal_commas(file.lines[i])) faults.throw_if_any(file.name);  // they stand on every line
            continue;
        }
        for (const double sample : on_line) {
            if (!std::isfinite(sample))
                faults.add(file.at(i), "sample " + text::to_text(sample), "must be finite");
        }
        samples.insert(samples.end(), on_line.begin(), on_line.end());
    }
    return samples;
}

void check_count(double announced, std::size_t found, const std::string& place, FaultList& faults)
{
    const bool plausible = announced >= 2 && announced == std::floor(announced);
    const bool printable = plausible && announced < 1e18;
    const std::string count =
        printable ? std::to_string(static_cast<long long>(announced)) : text::to_text(announced);
    if (!plausible) {
        faults.add(place, "the header announces " + count + " samples",
                   "a record holds a whole number of samples, 2 or more");
    } else if (announced != static_cast<double>(found)) {
        faults.add(place, "the header announces " + count + " samples but the file holds " + std::to_string(found),
                   "the file is cut short or damaged: download it again");
    }
}

void refuse_column(const SourceFile& file, const ReadOptions& options, FaultList& faults)
{
    if (!options.column) return;
    faults.add(file.name, "a column was asked for", "the format names its components itself: omit it");
}

Channel make_channel(std::string component, const Unit& unit, double time_step, std::vector<double> samples)
{
    for (double& sample : samples) sample *= unit.factor;
    Channel channel;
    channel.component = std::move(component);
    channel.quantity = unit.quantity;
    channel.time_step = time_step;
    channel.samples = std::move(samples);
    channel.unit_in_file = unit.name;
    return channel;
}

}  // namespace voussoir::records::formats
