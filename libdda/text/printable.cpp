#include "libdda/text/printable.h"

#include <utf8.h>

#include <array>
#include <cstdio>

namespace voussoir::text
{

namespace
{

/// Control characters, and what turns round or breaks the line it stands in. Source: [UnicodeBidi], 2.
bool commands_terminal(char32_t code)
{
    const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
    const bool direction = code == 0x061C || code == 0x200E || code == 0x200F ||
                           (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
    const bool line_end = code == 0x2028 || code == 0x2029;
    return control || direction || line_end;
}

template <typename... T>
void append(std::string& text, const char* pattern, T... values)
{
    std::array<char, 16> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, values...);  // NOLINT: patterns are literals
    text += buffer.data();
}

void append_bytes(std::string_view bytes, std::string& text)
{
    for (const char byte : bytes) append(text, "\\x%02X", static_cast<unsigned>(static_cast<unsigned char>(byte)));
}

/// Tells every character with its bytes, and bytes that are none with the code 0x80, a control.
template <typename Tell>
void each_character(std::string_view text, const Tell& tell)
{
    for (auto at = text.begin(); at != text.end();) {
        const auto from = at;
        const std::size_t left = static_cast<std::size_t>(text.end() - at);
        // At most four bytes are one character, and nothing is looked at behind the first fault.
        const std::size_t longest = left < 4 ? left : 4;
        std::size_t length = 1;
        while (length <= longest && !utf8::is_valid(from, from + static_cast<std::ptrdiff_t>(length))) ++length;
        const bool whole = length <= longest;
        at = from + (whole ? static_cast<std::ptrdiff_t>(length) : 1);
        auto reading = from;
        tell(whole ? static_cast<char32_t>(utf8::unchecked::next(reading)) : char32_t{0x80},
             text.substr(static_cast<std::size_t>(from - text.begin()), static_cast<std::size_t>(at - from)));
    }
}

std::string shown(std::string_view text, bool keeps_lines)
{
    std::string safe;
    safe.reserve(text.size());
    each_character(text, [&](char32_t code, std::string_view bytes) {
        if (commands_terminal(code) && !(keeps_lines && code == U'\n'))
            append_bytes(bytes, safe);
        else
            safe += bytes;
    });
    return safe;
}

}  // namespace

std::string printable(std::string_view text)
{
    return shown(text, false);
}

std::string printable_lines(std::string_view text)
{
    return shown(text, true);
}

std::string printable_json(std::string_view json)
{
    std::string safe;
    safe.reserve(json.size());
    each_character(json, [&](char32_t code, std::string_view bytes) {
        if (commands_terminal(code) && code >= 0x7F && bytes.size() > (code == 0x7F ? 0U : 1U))
            append(safe, "\\u%04x", static_cast<unsigned>(code));
        else
            safe += bytes;
    });
    return safe;
}

}  // namespace voussoir::text
