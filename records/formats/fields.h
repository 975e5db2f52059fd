// Blocks of numbers in Fortran's fixed fields, which may touch, and the words of the headers around them.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "records/source_file.h"

namespace voussoir::records::formats
{

/// Nothing but white space and the zero bytes some programs fill their last line with.
bool is_blank(std::string_view line);

/// The width of the numbers of a Fortran format: "(8f9.6)" -> 9, "Format=(10I8)" -> 8, "8(1PE10.4E1)" -> 10; 0
/// when the text names none.
std::size_t format_width(std::string_view text);

/// Numbers separated by white space, or touching, each but the first of which then fills its field.
/// @param width of a field; 0: not known
/// @returns false when anything on the line is not a number, or nothing is
bool parse_fields(std::string_view line, std::size_t width, std::vector<double>& numbers);

/// The first word of the line that parse_fields cannot read; the whole line, cut to 40 letters, when there is
/// none.
std::string first_not_number(std::string_view line, std::size_t width);

struct NumberBlock {
    std::vector<double> numbers;
    std::vector<std::size_t> line_ends;  // numbers up to the end of each line that holds some
    std::size_t first = 0, end = 0;      // 0-based lines [first, end)
};

constexpr std::size_t without_limit = std::numeric_limits<std::size_t>::max();

/// The numbers on whole lines from `first` on, until there are `enough` or a line holds anything else; blank lines
/// are passed over. Memory grows with what is there, never with what is asked for.
NumberBlock read_block(const SourceFile& file, std::size_t first, std::size_t width,
                       std::size_t enough = without_limit);

/// The same up to the first line that holds fewer numbers than the one before it: a header of 100 numbers, 16 on a
/// line, ends with a line of 4.
NumberBlock read_block_to_short_line(const SourceFile& file, std::size_t first, std::size_t width);

/// The first line in [first, end) with at least `count` numbers; `end` when there is none.
std::size_t find_numbers(const SourceFile& file, std::size_t first, std::size_t end, std::size_t count);

/// The first line in [first, end) that holds `words` (in lower case) in any case; `end` when there is none.
std::size_t find_words(const SourceFile& file, std::size_t first, std::size_t end, std::string_view words);

/// The first line from `first` on that is not blank, or the number of lines.
std::size_t skip_blank(const SourceFile& file, std::size_t first);

/// "No. of points =  3500" -> 3500: the number behind `words` (in lower case), ':' or '=' between them or not.
std::optional<double> number_after(std::string_view line, std::string_view words);

/// What stands behind `words` (in lower case), up to two blanks, ',', ';', '(' or ')', without a closing full
/// stop.
std::string text_after(std::string_view line, std::string_view words);

/// Line of the number at `index` of the block.
std::size_t line_of(const NumberBlock& block, std::size_t index);

}  // namespace voussoir::records::formats
