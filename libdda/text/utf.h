// Encodings of text: everything inside is UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace voussoir::text
{

/// UTF-16 with a byte order mark, or plainly alternating with zero bytes, as UTF-8; nothing when it is not UTF-16.
/// A half of a pair that has lost the other becomes the replacement character.
std::optional<std::string> from_utf16(std::string_view bytes);

/// Appends one character; what is none (beyond U+10FFFF, a surrogate) becomes the replacement character.
void append_utf8(char32_t code, std::string& text);

/// Text that is not UTF-8 is taken for Latin-1, as old files have it.
std::string as_utf8(std::string_view text);

}  // namespace voussoir::text
