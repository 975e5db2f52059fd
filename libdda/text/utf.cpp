#include "libdda/text/utf.h"

#include <utf8.h>

#include <algorithm>
#include <iterator>

namespace voussoir::text
{

namespace
{

constexpr char32_t replacement = 0xFFFD;

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
    const bool none = code > 0x10FFFF || (code >= 0xD800 && code < 0xE000);
    utf8::unchecked::append(none ? replacement : code, std::back_inserter(text));
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
        append_utf8(code, text);
    }
    return text;
}

std::string as_utf8(std::string_view text)
{
    if (utf8::is_valid(text.begin(), text.end())) return std::string(text);
    std::string converted;
    for (const char c : text) append_utf8(static_cast<unsigned char>(c), converted);
    return converted;
}

}  // namespace voussoir::text
