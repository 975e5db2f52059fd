#include "records/formats/fields.h"

#include <algorithm>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/words.h"

namespace voussoir::records::formats
{

namespace
{

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/// Cuts a token from its end into fields of `width`: each but the first is full where fields touch.
bool split_touching(std::string_view token, std::size_t width, std::vector<double>& numbers)
{
    const std::size_t before = numbers.size();
    for (std::size_t end = token.size(); end > 0; end -= std::min(end, width)) {
        const std::size_t start = end > width ? end - width : 0;
        double number = 0;
        if (!text::parse_fortran_number(token.substr(start, end - start), number)) {
            numbers.resize(before);
            return false;
        }
        numbers.push_back(number);
    }
    std::reverse(numbers.begin() + static_cast<std::ptrdiff_t>(before), numbers.end());
    return true;
}

bool parse_token(std::string_view token, std::size_t width, std::vector<double>& numbers)
{
    double number = 0;
    // Whole numbers that touch look like one; reals that touch have two points.
    const bool may_touch =
        width > 0 && token.size() > width && token.find_first_not_of("+-0123456789") == std::string_view::npos;
    if (!may_touch && text::parse_fortran_number(token, number)) {
        numbers.push_back(number);
        return true;
    }
    if (width > 0 && token.size() > width && split_touching(token, width, numbers)) return true;
    std::vector<double> by_exponent;
    if (!text::parse_fortran(token, by_exponent)) return false;
    numbers.insert(numbers.end(), by_exponent.begin(), by_exponent.end());
    return true;
}

/// Where `words` end in the line; npos when it does not hold them.
std::size_t end_of_words(std::string_view line, std::string_view words)
{
    const std::size_t at = text::lower_case(line).find(words);
    return at == std::string::npos ? at : at + words.size();
}

}  // namespace

bool is_blank(std::string_view line)
{
    return std::all_of(line.begin(), line.end(), [](char c) { return c == '\0' || text::trim({&c, 1}).empty(); });
}

std::size_t format_width(std::string_view text)
{
    const std::string line = text::lower_case(text);
    for (std::size_t at = 1; at + 1 < line.size(); ++at) {
        const bool is_letter =
            line[at] == 'f' || line[at] == 'e' || line[at] == 'i' || line[at] == 'd' || line[at] == 'g';
        const char before = line[at - 1];
        const bool begins = is_digit(before) || before == '(' || before == ',' || before == 'p';
        if (!is_letter || !begins || !is_digit(line[at + 1])) continue;
        double width = 0;
        const std::size_t digits = line.find_first_not_of("0123456789", at + 1);
        if (!text::parse_fortran_number(std::string_view(line).substr(at + 1, digits - at - 1), width)) continue;
        if (width >= 1 && width <= 80) return static_cast<std::size_t>(width);
    }
    return 0;
}

bool parse_fields(std::string_view line, std::size_t width, std::vector<double>& numbers)
{
    numbers.clear();
    std::string_view rest = text::trim(line);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find_first_of(" \t\f\v\r"), rest.size());
        if (!parse_token(rest.substr(0, end), width, numbers)) return false;
        rest = text::trim(rest.substr(end));
    }
    return !numbers.empty();
}

std::string first_not_number(std::string_view line, std::size_t width)
{
    std::vector<double> numbers;
    std::string_view rest = text::trim(line);
    std::size_t before = 0;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find_first_of(" \t\f\v\r"), rest.size());
        const std::string_view word = rest.substr(0, std::min<std::size_t>(end, 40));
        // A heading is better recognised by more than its first word.
        if (!parse_token(rest.substr(0, end), width, numbers) && before > 0) return std::string(word);
        if (numbers.size() == before) break;
        before = numbers.size();
        rest = text::trim(rest.substr(end));
    }
    return std::string(text::trim(line).substr(0, 40));
}

NumberBlock read_block(const SourceFile& file, std::size_t first, std::size_t width, std::size_t enough)
{
    NumberBlock block;
    block.first = block.end = first;
    std::vector<double> on_line;
    for (std::size_t i = first; i < file.lines.size() && block.numbers.size() < enough; ++i) {
        if (!is_blank(file.lines[i])) {
            if (!parse_fields(file.lines[i], width, on_line)) break;
            block.numbers.insert(block.numbers.end(), on_line.begin(), on_line.end());
        }
        block.line_ends.push_back(block.numbers.size());
        block.end = i + 1;
    }
    return block;
}

NumberBlock read_block_to_short_line(const SourceFile& file, std::size_t first, std::size_t width)
{
    NumberBlock block;
    block.first = block.end = first;
    std::vector<double> on_line;
    std::size_t before = 0;
    for (std::size_t i = first; i < file.lines.size(); ++i) {
        if (is_blank(file.lines[i])) continue;
        if (!parse_fields(file.lines[i], width, on_line)) break;
        block.numbers.insert(block.numbers.end(), on_line.begin(), on_line.end());
        block.end = i + 1;
        if (on_line.size() < before) break;
        before = on_line.size();
    }
    return block;
}

std::size_t find_numbers(const SourceFile& file, std::size_t first, std::size_t end, std::size_t count)
{
    std::vector<double> on_line;
    end = std::min(end, file.lines.size());
    for (std::size_t i = first; i < end; ++i) {
        if (parse_fields(file.lines[i], 0, on_line) && on_line.size() >= count) return i;
    }
    return end;
}

std::size_t find_words(const SourceFile& file, std::size_t first, std::size_t end, std::string_view words)
{
    end = std::min(end, file.lines.size());
    for (std::size_t i = first; i < end; ++i) {
        if (end_of_words(file.lines[i], words) != std::string_view::npos) return i;
    }
    return end;
}

std::size_t skip_blank(const SourceFile& file, std::size_t first)
{
    while (first < file.lines.size() && is_blank(file.lines[first])) ++first;
    return first;
}

std::optional<double> number_after(std::string_view line, std::string_view words)
{
    const std::size_t end = end_of_words(line, words);
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view rest = text::trim(line.substr(end));
    while (!rest.empty() && (rest.front() == '=' || rest.front() == ':')) rest = text::trim(rest.substr(1));
    double number = 0;
    if (text::parse_leading_number(rest, number) == 0) return std::nullopt;
    return number;
}

std::string text_after(std::string_view line, std::string_view words)
{
    const std::size_t end = end_of_words(line, words);
    if (end == std::string_view::npos) return "";
    std::string_view rest = text::trim(line.substr(end));
    while (!rest.empty() && (rest.front() == '=' || rest.front() == ':')) rest = text::trim(rest.substr(1));
    rest = text::trim(rest.substr(0, std::min(rest.find("  "), rest.find_first_of(",;()\t"))));
    while (!rest.empty() && rest.back() == '.') rest = text::trim(rest.substr(0, rest.size() - 1));
    return std::string(rest);
}

std::size_t line_of(const NumberBlock& block, std::size_t index)
{
    const auto after = std::upper_bound(block.line_ends.begin(), block.line_ends.end(), index);
    return block.first + static_cast<std::size_t>(after - block.line_ends.begin());
}

}  // namespace voussoir::records::formats
