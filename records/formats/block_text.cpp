// Corrected records as text of fixed width: lines of words, which say the time step, and blocks of numbers whose
// fields may touch, each below a line that names the quantity and its unit in words:
//
//   CORRECTED ACCELEROGRAM     COMPONENT N10W
//   2500 POINTS AT EQUAL INTERVALS OF .020 SECONDS
//   2500 ACCELERATION VALUES IN CM/SEC/SEC
//       .120   -1.325-1012.555 ...
//   2500 VELOCITY VALUES IN CM/SEC
//   2500 DISPLACEMENT VALUES IN CM
//
// No network's own format: what many have made of one. Velocity and displacement are the acceleration's integrals:
// only the acceleration is taken where there is one.

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"
#include "records/formats/format.h"
#include "records/formats/samples.h"

namespace voussoir::records::formats
{

namespace
{

constexpr const char* format_name = "blocks of fixed width";
constexpr std::size_t longest_header = 60;  // lines of words before the first block

bool holds_numbers(const SourceFile& file, std::size_t line)
{
    std::vector<double> numbers;
    return parse_fields(file.lines[line], 0, numbers);
}

/// The distance between decimal points, where it is the same all along the line, is the width of its fields; else
/// 0. Of fields that touch it is the only sign.
std::size_t width_of_fields(std::string_view line)
{
    const std::size_t first = line.find('.');
    if (first == std::string_view::npos) return 0;
    const std::size_t second = line.find('.', first + 1);
    if (second == std::string_view::npos) return 0;
    const std::size_t width = second - first;
    std::size_t at = second;
    for (std::size_t next = line.find('.', at + 1); next != std::string_view::npos;
         next = line.find('.', at + 1)) {
        if (next - at != width) return 0;
        at = next;
    }
    return width;
}

/// The first word of the line that is a unit of the quantity: "CM/SEC/SEC", "(G)", "cm/s2,"; empty: none is.
std::string unit_word(std::string_view line, Quantity quantity)
{
    constexpr std::string_view around = " \t\r()[],;:=.";
    std::size_t at = line.find_first_not_of(around);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(around, at), line.size());
        const std::string_view word = line.substr(at, end - at);
        const std::optional<Unit> unit = find_unit(word);
        if (unit && unit->quantity == quantity) return std::string(word);
        at = line.find_first_not_of(around, end);
    }
    return "";
}

/// A line of words above numbers that names what they are.
struct Block {
    std::size_t title = 0;  // 0-based line
    Quantity quantity = Quantity::acceleration;
    std::string unit;  // empty: not said
};

/// A row, be it damaged: more digits than letters. A block whose first row is damaged must not be passed over, or
/// the velocity below would be taken for all there is.
bool looks_like_row(std::string_view line)
{
    std::size_t digits = 0, letters = 0;
    for (const char c : line) {
        if (c >= '0' && c <= '9') ++digits;
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) ++letters;
    }
    return digits > letters;
}

std::optional<Block> block_at(const SourceFile& file, std::size_t line)
{
    const std::size_t below = skip_blank(file, line + 1);
    if (holds_numbers(file, line) || below >= file.lines.size() || !looks_like_row(file.lines[below]))
        return std::nullopt;
    const std::string title = text::lower_case(file.lines[line]);
    constexpr auto quantities =
        std::to_array<std::pair<std::string_view, Quantity>>({{"acceleration", Quantity::acceleration},
                                                              {"velocity", Quantity::velocity},
                                                              {"displacement", Quantity::displacement}});
    for (const auto& [word, quantity] : quantities)
        if (title.find(word) != std::string::npos)
            return Block{line, quantity, unit_word(file.lines[line], quantity)};
    return std::nullopt;
}

/// The first block; its title stands among the first lines.
std::optional<Block> first_block(const SourceFile& file)
{
    for (std::size_t i = 0; i < std::min(longest_header, file.lines.size()); ++i)
        if (std::optional<Block> block = block_at(file, i)) return block;
    return std::nullopt;
}

std::optional<Block> next_block(const SourceFile& file, std::size_t from)
{
    for (std::size_t i = from; i < file.lines.size(); ++i)
        if (std::optional<Block> block = block_at(file, i)) return block;
    return std::nullopt;
}

/// Two blocks at least, each with its unit: one alone is told from a table's heading by nothing.
bool recognises(const SourceFile& file)
{
    if (!is_text(file)) return false;
    const std::optional<Block> first = first_block(file);
    if (!first || first->unit.empty()) return false;
    const std::optional<Block> second = next_block(file, first->title + 1);
    return second && !second->unit.empty();
}

/// "INTERVALS OF .020 SECONDS", "DT = 0.02": the time step, and the line it stands on.
std::optional<double> find_step(const SourceFile& file, std::size_t end, std::size_t& line)
{
    constexpr auto words = std::to_array<std::string_view>(
        {"intervals of", "interval of", "interval", "time step", "sampling period", "dt"});
    for (const std::string_view word : words) {
        line = find_words(file, 0, end, word);
        if (line == end) continue;
        if (const std::optional<double> step = number_after(file.lines[line], word)) return step;
    }
    line = 0;
    return std::nullopt;
}

/// The number a title begins with: of the samples.
std::optional<double> announced_count(std::string_view title)
{
    double count = 0;
    return text::parse_leading_number(text::trim(title), count) > 0 ? std::optional<double>(count) : std::nullopt;
}

/// A row with a damaged number ends its block, and must not be passed over as if it were words: where no count
/// tells, a line with digits below the rows is refused unless it is a title; a row of numbers always is.
void check_below(const SourceFile& file, std::size_t end, bool is_counted, FaultList& faults)
{
    for (std::size_t i = skip_blank(file, end); i < file.lines.size() && !block_at(file, i); ++i) {
        const std::string_view line = file.lines[i];
        const bool has_digits = std::any_of(line.begin(), line.end(), [](char c) { return c >= '0' && c <= '9'; });
        std::vector<double> numbers;
        if ((has_digits && !is_counted) || parse_fields(line, width_of_fields(line), numbers)) {
            faults.add(file.at(i),
                       "\"" + std::string(text::trim(line).substr(0, 40)) + "\" below the rows of a block",
                       "only the title of another block, and words, may stand there");
            return;
        }
    }
}

/// The samples of a block, as many as its title announces if it begins with a number. @returns with them the line
/// behind
std::pair<std::vector<double>, std::size_t> read_samples(const SourceFile& file, const Block& block,
                                                         std::vector<std::string>& remarks, FaultList& faults)
{
    const std::size_t first = skip_blank(file, block.title + 1);
    NumberBlock rows = read_block(file, first, width_of_fields(file.lines[first]));
    const std::optional<double> count = announced_count(file.lines[block.title]);
    const auto found = static_cast<double>(rows.numbers.size());
    check_block(file, rows, {count.value_or(found), file.at(block.title)}, remarks, faults);
    check_below(file, rows.end, count.has_value(), faults);
    return {std::move(rows.numbers), rows.end};
}

Record read(const SourceFile& file, const ReadOptions& options)
{
    FaultList faults;
    Record record{file.name, format_name, {}};
    std::optional<Block> block = first_block(file);
    std::size_t step_line = 0;
    const std::optional<double> in_file = find_step(file, block->title + 1, step_line);
    const double time_step = resolve_time_step(in_file, options, in_file ? file.at(step_line) : file.name, faults);
    refuse_column(file, options, faults);
    // What the user says of the unit is said of the first block.
    for (ReadOptions of_unit = options; block; of_unit = {}) {
        if (block->unit.empty())
            faults.add(file.at(block->title), "a block without the unit of its numbers",
                       "name it in the title, such as \"ACCELERATION IN CM/SEC/SEC\"");
        auto [samples, end] = read_samples(file, *block, record.remarks, faults);
        const Unit unit = resolve_unit(block->unit, of_unit, file.at(block->title), faults);
        record.channels.push_back(make_channel("", unit, time_step, std::move(samples)));
        block = next_block(file, end);
    }
    faults.throw_if_any(file.name);
    keep_accelerations(record);
    return record;
}

}  // namespace

const Format block_text{format_name, recognises, read};

}  // namespace voussoir::records::formats
