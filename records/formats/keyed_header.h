// Header lines "KEY: value" and what the readers of such headers share. Keys are compared by their letters and
// digits only, so that case, spacing and punctuation may vary.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "records/formats/format.h"

namespace voussoir::records::formats
{

struct HeaderLine {
    std::string key;         // lower-case letters and digits of what stands before the colon
    std::string_view value;  // trimmed; may be empty
    std::size_t line = 0;    // 0-based
};

struct KeyedHeader {
    std::vector<HeaderLine> lines;
    std::size_t end = 0;  // 0-based line after the header

    /// The first line with this key ("NUMBER OF SAMPLES"), else null.
    const HeaderLine* find(std::string_view key) const;
    /// The first line whose key begins so ("StartTime" of "StartTime(GMT+08)"), else null.
    const HeaderLine* find_beginning(std::string_view key) const;
};

/// Lines with a colon, from `first` until the first line of which `ends` is true, or `first + at_most` lines.
KeyedHeader read_keyed_header(const SourceFile& file, std::size_t first, std::size_t at_most,
                              bool (*ends)(std::string_view line));

/// Whether a line holds nothing but numbers.
bool is_row_of_numbers(std::string_view line);

/// Lower-case letters and digits of a text.
std::string letters_and_digits(std::string_view text);

/// The value as text; empty without a line.
std::string text_of(const HeaderLine* line);
/// The number the value begins with ("0.010000s", "100Hz"); nothing without one.
std::optional<double> number_of(const HeaderLine* line);
/// Where the line stands; the file without a line.
std::string place_of(const SourceFile& file, const HeaderLine* line);

/// The number of a header that must have it: adds a fault, with the key as the user reads it, when it has not.
/// @returns 0 after a fault
double required_number(const SourceFile& file, const HeaderLine* line, std::string_view key, FaultList& faults);

/// As check_count, but the file may hold up to `surplus` samples more than the header announces: a remark then.
void check_count_with_surplus(double announced, std::size_t found, std::size_t surplus, const std::string& place,
                              FaultList& faults, std::vector<std::string>& remarks);

/// Columns (width) of numbers from the line `first` on. Adds a fault for each line that holds anything but `width`
/// finite numbers.
std::vector<std::vector<double>> read_columns(const SourceFile& file, std::size_t first, std::size_t width,
                                              FaultList& faults);

/// The azimuth or the vertical of a component by the usual short names: NS, N-S, N, WE, EW, E-W, E, UD, U-D, UP,
/// U, V, Z, or a channel code that ends in N, E or Z (HNE). Other names, "1" and "2" among them, leave the
/// channel without.
void orient_by_short_name(Channel& channel, std::string_view name);

}  // namespace voussoir::records::formats
