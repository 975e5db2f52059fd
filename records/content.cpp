#include "records/content.h"

#include <algorithm>
#include <array>
#include <optional>

#include "libdda/text/fortran_numbers.h"
#include "libdda/text/utf.h"
#include "libdda/text/words.h"

namespace voussoir::records
{

namespace
{

struct Signature {
    std::string_view bytes;
    std::size_t at;
    const char* found;
    const char* expected;
};
constexpr const char* unpack_it = "unpack it and name one record in it";
constexpr std::array<Signature, 8> signatures{{
    {"PK\x03\x04", 0, "a zip archive (or an office document)", unpack_it},
    {"ustar", 257, "a tar archive", unpack_it},
    {"7z\xBC\xAF", 0, "a 7z archive", unpack_it},
    {"Rar!", 0, "a rar archive", unpack_it},
    {"BZh", 0, "a file packed by bzip2", "unpack it first, or pack it by gzip"},
    {"\xFD"
     "7zXZ",
     0, "a file packed by xz", "unpack it first, or pack it by gzip"},
    {"%PDF", 0, "a PDF document", "name the record's data, not its report"},
    {"\x89HDF", 0, "an HDF5 file", "write its traces as miniSEED or text"},
}};

bool is_control(char c)
{
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r' && byte != '\f' && byte != 0x1A;
}

/// A text with a few bytes that none may hold: damaged, not binary. @returns the first of them, or npos
std::size_t damaged_at(const std::string& bytes)
{
    const auto strange = static_cast<std::size_t>(std::count_if(bytes.begin(), bytes.end(), is_control));
    if (strange == 0 || strange * 50 > bytes.size()) return std::string::npos;
    const bool has_lines = std::count(bytes.begin(), bytes.end(), '\n') * 200 > static_cast<long>(bytes.size());
    if (!has_lines) return std::string::npos;
    return static_cast<std::size_t>(std::find_if(bytes.begin(), bytes.end(), is_control) - bytes.begin());
}

bool begins_with_number(std::string_view line)
{
    double number = 0;
    return text::parse_leading_number(text::trim(line), number) > 0;
}

Fault why_unknown_text(const SourceFile& file, const std::string& formats)
{
    const std::string start = text::lower_case(text::trim(std::string_view(file.bytes).substr(0, 500)));
    if (start.starts_with("<!doctype html") || start.find("<html") != std::string::npos)
        return {file.name, "a web page (HTML)", "the download failed: download the record again"};
    if (start.starts_with("<?xml"))
        return {file.name, "an XML file", "a record; a StationXML is given as the response of one"};
    const auto line = std::find_if(file.lines.begin(), file.lines.end(), begins_with_number);
    if (line == file.lines.end()) return {file.name, "a text without a line of numbers", formats};
    const std::string place = file.at(static_cast<std::size_t>(line - file.lines.begin()));
    if (has_decimal_commas(*line))
        return {place, "numbers with decimal commas", "write decimal points (0.01 for 0,01)"};
    return {place,
            "\"" + std::string(text::trim(*line).substr(0, 40)) + "\" begins with a number but is no row of them",
            "numbers separated by blanks, commas or semicolons, none missing"};
}

}  // namespace

std::string decode_utf16(std::string bytes)
{
    const bool marked = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
    if (!marked || bytes.size() % 2 != 0) return bytes;
    const std::optional<std::string> text = text::from_utf16(bytes);
    if (!text || text->find('\0') != std::string::npos)
        return bytes;  // binary content that only begins like a text
    return *text;
}

bool has_decimal_commas(std::string_view line)
{
    constexpr std::string_view digits = "0123456789", between = " \t;";
    std::string_view rest = text::trim(line);
    while (!rest.empty()) {
        const std::string_view word = rest.substr(0, rest.find_first_of(between));
        const std::string_view unsigned_word = word.substr(std::min(word.find_first_not_of("+-"), word.size()));
        const std::size_t comma = unsigned_word.find(',');
        const bool is_one = comma != std::string_view::npos && comma + 1 < unsigned_word.size() &&
                            unsigned_word.find(',', comma + 1) == std::string_view::npos &&
                            unsigned_word.find('.') == std::string_view::npos &&
                            unsigned_word.substr(0, comma).find_first_not_of(digits) == std::string_view::npos &&
                            digits.find(unsigned_word[comma + 1]) != std::string_view::npos;
        if (is_one) return true;
        rest = rest.substr(word.size());
        rest = rest.substr(std::min(rest.find_first_not_of(between), rest.size()));
    }
    return false;
}

Fault why_unknown(const SourceFile& file, const std::string& formats)
{
    const std::string expected = "not a record in a supported format: " + formats;
    for (const Signature& known : signatures)
        if (file.bytes.compare(std::min(known.at, file.bytes.size()), known.bytes.size(), known.bytes) == 0)
            return {file.name, known.found, known.expected};
    if (is_text(file)) return why_unknown_text(file, expected);
    const std::size_t damage = damaged_at(file.bytes);
    if (damage == std::string::npos) return {file.name, "binary content", expected};
    const auto line = static_cast<std::size_t>(
        std::count(file.bytes.begin(), file.bytes.begin() + static_cast<std::ptrdiff_t>(damage), '\n'));
    return {file.at(line), "a text with a byte " + std::to_string(static_cast<int>(file.bytes[damage])) + " in it",
            "the file is damaged: download it again"};
}

}  // namespace voussoir::records
