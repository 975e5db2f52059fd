#include "importers/mesh/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace voussoir
{

namespace
{

constexpr const char* white_space = " \t\r\n\v\f";

template <class Number>
std::errc parse(std::string_view word, Number& value)
{
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end != word.data() + word.size() ? std::errc::invalid_argument : error;
}

/// Bytes of the character that begins the text; 0: it is not UTF-8.
std::size_t utf8_length(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0x80                       ? 1
                               : byte(0) >= 0xC2 && byte(0) < 0xE0  ? 2
                               : byte(0) >= 0xE0 && byte(0) < 0xF0  ? 3
                               : byte(0) >= 0xF0 && byte(0) <= 0xF4 ? 4
                                                                    : 0;
    if (length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (byte(i) >> 6 != 2) return 0;
    if (length < 3) return length;
    const bool too_long = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xF0 && byte(1) < 0x90);
    const bool no_character = (byte(0) == 0xED && byte(1) >= 0xA0) || (byte(0) == 0xF4 && byte(1) >= 0x90);
    return too_long || no_character ? 0 : length;
}

enum class Utf16 { no, low_byte_first, high_byte_first };

Utf16 kind_of(std::string_view bytes)
{
    if (bytes.starts_with("\xFF\xFE")) return Utf16::low_byte_first;
    if (bytes.starts_with("\xFE\xFF")) return Utf16::high_byte_first;
    // Without a mark: a beginning of plain characters, each with a zero byte on the same side.
    const std::size_t looked_at = std::min<std::size_t>(bytes.size() / 2 * 2, 64);
    std::size_t low_first = 0, high_first = 0;
    for (std::size_t i = 0; i < looked_at; i += 2) {
        low_first += bytes[i] > 0 && bytes[i + 1] == 0;
        high_first += bytes[i] == 0 && bytes[i + 1] > 0;
    }
    if (looked_at < 16) return Utf16::no;
    if (2 * low_first == looked_at) return Utf16::low_byte_first;
    return 2 * high_first == looked_at ? Utf16::high_byte_first : Utf16::no;
}

}  // namespace

void append_utf8(char32_t code, std::string& text)
{
    const auto byte = [&](char32_t value) { text.push_back(static_cast<char>(value)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xC0 | code >> 6);
    } else if (code < 0x10000) {
        byte(0xE0 | code >> 12);
        byte(0x80 | (code >> 6 & 0x3F));
    } else {
        byte(0xF0 | code >> 18);
        byte(0x80 | (code >> 12 & 0x3F));
        byte(0x80 | (code >> 6 & 0x3F));
    }
    byte(0x80 | (code & 0x3F));
}

std::string_view trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(white_space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(white_space) - first + 1);
}

std::string lower_case(std::string_view text)
{
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return lower;
}

std::vector<std::string_view> words(std::string_view line)
{
    std::vector<std::string_view> found;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = std::min(line.find_first_of(white_space), line.size());
        found.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return found;
}

std::optional<double> parse_number(std::string_view word)
{
    double value = 0;
    const std::errc error = parse(word, value);
    if (error == std::errc()) return value;
    const bool tiny = error == std::errc::result_out_of_range && word.find_first_of("eE") != word.npos &&
                      word.find('-', word.find_first_of("eE")) != word.npos;
    return tiny ? std::optional<double>(0.0) : std::nullopt;
}

std::optional<double> parse_finite(std::string_view word)
{
    const std::optional<double> value = parse_number(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<long long> parse_integer(std::string_view word)
{
    long long value = 0;
    return parse(word, value) == std::errc() ? std::optional<long long>(value) : std::nullopt;
}

bool Lines::next(std::string_view& line)
{
    if (rest_.empty()) return false;
    ++number_;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line = rest_.substr(0, end);
    const std::size_t mark = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
    rest_.remove_prefix(std::min(end + mark, rest_.size()));
    return true;
}

std::string line_place(const std::string& place, std::string_view text, std::ptrdiff_t offset)
{
    if (offset < 0) return place;
    const std::string_view before = text.substr(0, std::min<std::size_t>(offset, text.size()));
    return place + ":" + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
}

std::optional<std::string> from_utf16(std::string_view bytes)
{
    const Utf16 kind = kind_of(bytes);
    if (kind == Utf16::no) return std::nullopt;
    const std::size_t low = kind == Utf16::low_byte_first ? 0 : 1;
    const auto unit = [&](std::size_t i) {
        return static_cast<char32_t>(static_cast<unsigned char>(bytes[i + low]) |
                                     static_cast<unsigned char>(bytes[i + 1 - low]) << 8);
    };
    std::string text;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        char32_t code = unit(i);
        if (i == 0 && code == 0xFEFF) continue;
        const bool pair = code >= 0xD800 && code < 0xDC00 && i + 3 < bytes.size() && unit(i + 2) >= 0xDC00 &&
                          unit(i + 2) < 0xE000;
        if (pair) code = 0x10000 + ((code - 0xD800) << 10) + (unit(i += 2) - 0xDC00);
        append_utf8(code >= 0xD800 && code < 0xE000 ? 0xFFFD : code, text);
    }
    return text;
}

std::string as_utf8(std::string_view text)
{
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t length = utf8_length(rest);
        rest.remove_prefix(length);
        if (length > 0) continue;
        std::string converted;
        for (const char c : text) append_utf8(static_cast<unsigned char>(c), converted);
        return converted;
    }
    return std::string(text);
}

void FaultList::add(int line, std::string found, std::string expected)
{
    if (!full()) faults_.push_back({place_ + ":" + std::to_string(line), std::move(found), std::move(expected)});
}

void FaultList::throw_if_any() const
{
    if (!faults_.empty()) throw InputError(faults_);
}

}  // namespace voussoir
