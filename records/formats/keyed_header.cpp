#include "records/formats/keyed_header.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/numbers.h"
#include "libdda/text/words.h"

namespace voussoir::records::formats
{

const HeaderLine* KeyedHeader::find(std::string_view key) const
{
    const std::string wanted = letters_and_digits(key);
    const auto found =
        std::find_if(lines.begin(), lines.end(), [&](const HeaderLine& l) { return l.key == wanted; });
    return found == lines.end() ? nullptr : &*found;
}

const HeaderLine* KeyedHeader::find_beginning(std::string_view key) const
{
    const std::string wanted = letters_and_digits(key);
    const auto found =
        std::find_if(lines.begin(), lines.end(), [&](const HeaderLine& l) { return l.key.starts_with(wanted); });
    return found == lines.end() ? nullptr : &*found;
}

KeyedHeader read_keyed_header(const SourceFile& file, std::size_t first, std::size_t at_most,
                              bool (*ends)(std::string_view line))
{
    KeyedHeader header;
    header.end = first;
    const std::size_t last = std::min(file.lines.size(), first + at_most);
    for (; header.end < last && !ends(file.lines[header.end]); ++header.end) {
        const std::string_view line = file.lines[header.end];
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos) continue;
        header.lines.push_back(
            {letters_and_digits(line.substr(0, colon)), text::trim(line.substr(colon + 1)), header.end});
    }
    return header;
}

bool is_row_of_numbers(std::string_view line)
{
    std::vector<double> numbers;
    return text::parse_fortran(line, numbers) || text::parse_separated(line, numbers);
}

std::string letters_and_digits(std::string_view text)
{
    std::string kept = text::lower_case(text);
    std::erase_if(kept, [](char c) { return !((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')); });
    return kept;
}

std::string text_of(const HeaderLine* line)
{
    return line == nullptr ? std::string() : std::string(line->value);
}

std::optional<double> number_of(const HeaderLine* line)
{
    double value = 0;
    if (line == nullptr || text::parse_leading_number(line->value, value) == 0) return std::nullopt;
    return value;
}

std::string place_of(const SourceFile& file, const HeaderLine* line)
{
    return line == nullptr ? file.name : file.at(line->line);
}

double required_number(const SourceFile& file, const HeaderLine* line, std::string_view key, FaultList& faults)
{
    const std::optional<double> number = number_of(line);
    if (number) return *number;
    const std::string name(key);
    const std::string found =
        line == nullptr ? "no header line \"" + name + "\"" : name + " = \"" + std::string(line->value) + "\"";
    faults.add(place_of(file, line), found, "the header must give it as a number");
    return 0;
}

void check_count_with_surplus(double announced, std::size_t found, std::size_t surplus, const std::string& place,
                              FaultList& faults, std::vector<std::string>& remarks)
{
    const auto held = static_cast<double>(found);
    const bool is_whole = announced >= 2 && announced == std::floor(announced);
    if (is_whole && held > announced && held - announced <= static_cast<double>(surplus)) {
        remarks.push_back("The header announces " + text::to_text(announced) + " samples but the file holds " +
                          std::to_string(found) + "; all of them are taken.");
    } else {
        check_count(announced, found, place, faults);
    }
}

std::vector<std::vector<double>> read_columns(const SourceFile& file, std::size_t first, std::size_t width,
                                              FaultList& faults)
{
    std::vector<std::vector<double>> columns(width);
    std::vector<double> on_line;
    for (std::size_t i = first; i < file.lines.size(); ++i) {
        if (text::trim(file.lines[i]).empty()) continue;
        if (!text::parse_fortran(file.lines[i], on_line) || on_line.size() != width) {
            faults.add(file.at(i), "not a row of " + std::to_string(width) + " numbers",
                       "every row after the header must be complete");
            continue;
        }
        for (std::size_t column = 0; column < width; ++column) {
            const double number = on_line[column];
            if (!std::isfinite(number))
                faults.add(file.at(i), "sample " + text::to_text(number), "must be finite");
            columns[column].push_back(number);
        }
    }
    return columns;
}

void orient_by_short_name(Channel& channel, std::string_view name)
{
    constexpr std::array<std::string_view, 3> north{"ns", "n", "north"}, up{"ud", "up", "u"},
        vertical{"v", "z", "vert"};
    constexpr std::array<std::string_view, 4> east{"we", "ew", "e", "east"};
    const auto is_one_of = [&](const auto& names, const std::string& word) {
        return std::find(names.begin(), names.end(), word) != names.end();
    };
    std::string word = letters_and_digits(name);
    // A SEED channel code: band, instrument, orientation.
    const bool is_code = word.size() == 3 && std::string_view("hlgn").find(word[1]) != std::string_view::npos;
    if (is_code) word = word.substr(2);
    if (is_one_of(north, word)) channel.azimuth = 0;
    if (is_one_of(east, word)) channel.azimuth = 90;
    channel.is_vertical = is_one_of(up, word) || is_one_of(vertical, word) || word == "vertical";
}

}  // namespace voussoir::records::formats
