// Text: a table whose first column is time (each further column a component), or values only, any number on a
// line, read row by row. Heading lines before the first number; lines beginning with # % ! // are comments, and
// lines beginning with * may close the file ("*** End Data ***"). Unit and, without a time column, time step come
// from the user. Times need not be evenly spaced, only increasing.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/text_heading.h"

namespace voussoir::records::formats
{

namespace
{

/// The numbers of a text, row after row.
struct Rows {
    std::vector<double> numbers;
    std::vector<std::size_t> starts;  // (rows + 1), into numbers
    std::vector<std::size_t> lines;   // (rows), 0-based line each row stands on

    std::size_t count() const { return lines.size(); }
    std::size_t width(std::size_t row) const { return starts[row + 1] - starts[row]; }
    double at(std::size_t row, std::size_t column) const { return numbers[starts[row] + column]; }
};

bool is_comment(std::string_view line)
{
    line = text::trim(line);
    return line.empty() || line.front() == '#' || line.front() == '%' || line.front() == '!' ||
           line.substr(0, 2) == "//";
}

/// A heading may not begin with a number: such a line is rather a damaged row, and skipping it would shift time.
bool begins_with_number(std::string_view line)
{
    double value = 0;
    line = text::trim(line);
    const std::size_t used = text::parse_leading_number(line, value);
    return used > 0 &&
           (used == line.size() || std::string_view(" \t,;").find(line[used]) != std::string_view::npos);
}

Rows read_rows(const SourceFile& file, FaultList& faults)
{
    Rows rows;
    rows.starts.push_back(0);
    std::vector<double> on_line;
    std::size_t closing = 0;  // first line beginning with * after the last row; 0: none
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
        if (is_comment(file.lines[i])) continue;
        if (text::parse_separated(file.lines[i], on_line)) {
            rows.numbers.insert(rows.numbers.end(), on_line.begin(), on_line.end());
            rows.starts.push_back(rows.numbers.size());
            rows.lines.push_back(i);
            if (closing > 0)
                faults.add(file.at(closing), "not a line of numbers", "only numbers between the rows");
            closing = 0;
        } else if (rows.count() > 0 && text::trim(file.lines[i]).front() == '*') {
            if (closing == 0) closing = i;
        } else if (rows.count() > 0 || begins_with_number(file.lines[i])) {
            add_row_fault(file, i,
                          "rows hold numbers with a decimal point, separated by blanks, commas or semicolons; "
                          "headings stand before them and do not begin with a number",
                          faults);
        }
    }
    return rows;
}

void check_finite(const SourceFile& file, const Rows& rows, FaultList& faults)
{
    for (std::size_t row = 0; row < rows.count(); ++row) {
        for (std::size_t column = 0; column < rows.width(row); ++column) {
            const double number = rows.at(row, column);
            if (std::isfinite(number)) continue;
            faults.add(file.at(rows.lines[row]),
                       text::to_text(number) + " in column " + std::to_string(column + 1),
                       "every number must be finite");
        }
    }
}

/// The time step [s] of a first line that gives the number of samples and the step ("11800 0.005"), which is taken
/// out of the rows: only where exactly so many numbers follow, and where it cannot be the first row of a table.
std::optional<double> take_count_and_step(Rows& rows)
{
    if (rows.count() < 2 || rows.width(0) != 2 || (rows.width(1) == 2 && rows.at(1, 0) > rows.at(0, 0)))
        return std::nullopt;
    const double count = rows.at(0, 0), step = rows.at(0, 1);
    if (count < 2 || count != static_cast<double>(rows.numbers.size() - 2) || !(step > 0 && step <= 1))
        return std::nullopt;
    rows.numbers.erase(rows.numbers.begin(), rows.numbers.begin() + 2);
    rows.starts.erase(rows.starts.begin());
    for (std::size_t& start : rows.starts) start -= 2;
    rows.lines.erase(rows.lines.begin());
    return step;
}

/// Whether all rows but the first are alike: numbers that are not count and step stand above one value on each
/// line.
bool is_first_the_odd_one(const Rows& rows)
{
    if (rows.count() < 4 || rows.width(0) < 2) return false;
    for (std::size_t row = 1; row < rows.count(); ++row)
        if (rows.width(row) != 1) return false;
    return true;
}

/// Every row as wide as the first; only a last row of values without time may be shorter.
void check_widths(const SourceFile& file, const Rows& rows, bool last_may_be_short, FaultList& faults)
{
    const std::size_t width = rows.width(0);
    if (is_first_the_odd_one(rows)) {
        faults.add(file.at(rows.lines.front()),
                   std::to_string(width) + " numbers where every other line has " + std::to_string(rows.width(1)),
                   "if these are the number of samples and the time step, so many samples must follow; otherwise "
                   "remove the line");
        return;
    }
    for (std::size_t row = 1; row < rows.count(); ++row) {
        const std::size_t here = rows.width(row);
        const bool is_last = row + 1 == rows.count();
        if (here == width || (is_last && last_may_be_short && here < width)) continue;
        faults.add(file.at(rows.lines[row]),
                   std::to_string(here) + (here == 1 ? " number" : " numbers") + " where the first row has " +
                       std::to_string(width),
                   "every row must be complete");
    }
}

/// Whether the first column is a time. Two columns always claim it; of more, the first must increase in nine rows
/// of ten, so that one damaged row is refused instead of turning times into samples.
bool has_time_column(const Rows& rows)
{
    if (rows.width(0) < 2) return false;
    if (rows.width(0) == 2) return true;
    std::size_t increasing = 0;
    for (std::size_t row = 1; row < rows.count(); ++row) {
        if (rows.at(row, 0) > rows.at(row - 1, 0)) ++increasing;
    }
    return rows.count() >= 3 && 10 * increasing >= 9 * (rows.count() - 1);
}

/// The first row whose time does not increase; 0 when all do.
std::size_t first_not_increasing(const Rows& rows)
{
    for (std::size_t row = 1; row < rows.count(); ++row) {
        if (!(rows.at(row, 0) > rows.at(row - 1, 0))) return row;
    }
    return 0;
}

/// The row to blame when times are off the grid of the mean step by more than a hundredth of it, which rounding in
/// print explains: where the step first changes, else where the times stray farthest. 0 when they are even.
std::size_t first_uneven(const Rows& rows, double step)
{
    const double start = rows.at(0, 0), first_step = rows.at(1, 0) - start;
    double farthest = 0.01 * step;
    std::size_t changed = 0, strayed = 0;
    for (std::size_t row = 1; row < rows.count(); ++row) {
        const double here = rows.at(row, 0) - rows.at(row - 1, 0);
        const double off_grid = std::abs(rows.at(row, 0) - start - static_cast<double>(row) * step);
        if (changed == 0 && std::abs(here - first_step) > 0.02 * first_step) changed = row;
        if (off_grid > farthest) farthest = off_grid, strayed = row;
    }
    return strayed > 0 && changed > 0 ? changed : strayed;
}

/// The times of the rows [s].
struct Times {
    double mean_step = 0;
    std::size_t uneven_row = 0;  // the first row where the step changes; 0: even
};

/// Adds a fault when the times do not increase, or when they are uneven where the user asked for a step.
Times judge_times(const SourceFile& file, const Rows& rows, const ReadOptions& options, FaultList& faults)
{
    const std::size_t last = rows.count() - 1;
    const double step = (rows.at(last, 0) - rows.at(0, 0)) / static_cast<double>(last);
    const auto times = [&](std::size_t row) {
        return "time " + text::to_text(rows.at(row, 0)) + " s after " + text::to_text(rows.at(row - 1, 0)) + " s";
    };
    if (const std::size_t row = first_not_increasing(rows); row > 0) {
        faults.add(file.at(rows.lines[row]), times(row), "column 1 must be an increasing time in seconds");
        return {step, 0};
    }
    const std::size_t uneven = first_uneven(rows, step);
    if (uneven > 0 && options.time_step)
        faults.add(file.at(rows.lines[uneven]),
                   times(uneven) + " where the mean step is " + text::to_text(step) + " s",
                   "omit the time step; if only the printed times are rounded, give the column too");
    return {step, uneven};
}

/// Uneven times go with the samples, and the user is told.
void set_times(Record& record, const SourceFile& file, const Rows& rows, const Times& times)
{
    for (Channel& channel : record.channels) {
        channel.time_step = 0;
        channel.times.reserve(rows.count());
        for (std::size_t row = 0; row < rows.count(); ++row) channel.times.push_back(rows.at(row, 0));
    }
    record.remarks.push_back("The times are unevenly spaced, first at " + file.at(rows.lines[times.uneven_row]) +
                             " (mean step " + text::to_text(times.mean_step) +
                             " s); for a motion they are resampled.");
}

/// 0-based columns to read, as the user asked or all that are not time.
std::vector<std::size_t> choose_columns(const Rows& rows, const ReadOptions& options, bool has_time,
                                        const std::string& name, FaultList& faults)
{
    const std::size_t width = rows.width(0);
    std::vector<std::size_t> columns;
    if (options.column) {
        const bool exists = *options.column >= 1 && static_cast<std::size_t>(*options.column) <= width;
        if (exists) return {static_cast<std::size_t>(*options.column) - 1};
        faults.add(name, "column " + std::to_string(*options.column) + " was asked for",
                   "the file has columns 1 to " + std::to_string(width));
    }
    for (std::size_t column = has_time ? 1 : 0; column < width; ++column) columns.push_back(column);
    return columns;
}

std::vector<double> take_column(const Rows& rows, std::size_t column)
{
    std::vector<double> samples;
    samples.reserve(rows.count());
    for (std::size_t row = 0; row < rows.count(); ++row) samples.push_back(rows.at(row, column));
    return samples;
}

/// Rows of three without a time are read row by row only if the last one is short: three components look the same,
/// and would be stirred into one series.
void refuse_three_components(const SourceFile& file, const Rows& rows, FaultList& faults)
{
    for (std::size_t row = 0; row < rows.count(); ++row)
        if (rows.width(row) != 3) return;
    if (rows.count() < 2) return;
    faults.add(file.at(rows.lines.front()),
               "three numbers on every line and no time: three components, or one series?",
               "name the column of a component; write a series with one value on a line");
}

/// An index before the time ("0, 0.00, 0.13") would be taken for it.
void refuse_time_behind(const SourceFile& file, const Rows& rows, FaultList& faults)
{
    const std::size_t named = named_time_column(file, rows.lines.front(), rows.width(0));
    if (named > 0)
        faults.add(file.at(rows.lines.front()),
                   "the heading calls column " + std::to_string(named + 1) + " the time, but column 1 increases",
                   "remove the column before the time");
}

bool recognises(const SourceFile& file)
{
    std::vector<double> on_line;
    return is_text(file) && std::any_of(file.lines.begin(), file.lines.end(), [&](std::string_view line) {
               return !is_comment(line) && text::parse_separated(line, on_line);
           });
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    Rows rows = read_rows(file, faults);
    const std::optional<double> step_above = take_count_and_step(rows);
    refuse_spectra(file, rows.lines.front());
    check_finite(file, rows, faults);
    const bool has_time = !step_above && has_time_column(rows);
    const bool by_row = !has_time && !options.column;  // values only: the rows are one long list
    check_widths(file, rows, by_row, faults);
    if (by_row && !step_above) refuse_three_components(file, rows, faults);
    const Unit unit = resolve_unit("", options, file.name, faults);
    const std::vector<std::size_t> columns = choose_columns(rows, options, has_time, file.name, faults);
    const std::size_t count = by_row ? rows.numbers.size() : rows.count();
    if (count < 2) faults.add(file.name, std::to_string(count) + " sample", "a record holds at least 2 samples");

    // Who names both a column and a step has said that column 1 is not to be believed.
    const bool timed = has_time && columns.front() != 0 && !(options.column && options.time_step);
    if (timed) refuse_time_behind(file, rows, faults);
    if (timed) faults.throw_if_any(file.name);  // times cannot be judged before every row is complete
    const Times times = timed ? judge_times(file, rows, options, faults) : Times{};
    faults.throw_if_any(file.name);
    const std::optional<double> in_file = timed ? std::optional<double>(times.mean_step) : step_above;
    const double time_step = resolve_time_step(in_file, options, file.name, faults);
    faults.throw_if_any(file.name);

    const char* format = by_row ? "values-only text" : rows.width(0) == 2 ? "two-column text" : "text table";
    Record record{file.name, format, {}};
    if (by_row) record.channels.push_back(make_channel("", unit, time_step, rows.numbers));
    for (const std::size_t column : by_row ? std::vector<std::size_t>{} : columns) {
        record.channels.push_back(
            make_channel("column " + std::to_string(column + 1), unit, time_step, take_column(rows, column)));
    }
    remark_on_heading(file, rows.lines.front(), unit, record.remarks);
    if (times.uneven_row > 0) set_times(record, file, rows, times);
    return record;
}

}  // namespace

const Format text_table{"text table", recognises, read};

}  // namespace voussoir::records::formats
