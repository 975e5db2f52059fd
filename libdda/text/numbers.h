// Numbers in text, the same in every locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace voussoir::text
{

/// The whole word as a number, or nothing; a leading plus is allowed. May be infinite or not a number where the
/// word says so; too large is nothing, too small is zero.
std::optional<double> parse_number(std::string_view word);
std::optional<long long> parse_integer(std::string_view word);

/// A finite number, or nothing.
std::optional<double> parse_finite(std::string_view word);

/// Shortest text that reads back as the same number, for messages.
std::string to_text(double value);

}  // namespace voussoir::text
