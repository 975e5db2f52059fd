// Words of a text: white space, letter case.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voussoir::text
{

/// Without white space at both ends; the end-of-file mark of DOS (0x1A) counts as white space.
std::string_view trim(std::string_view text);

/// Letters of ASCII in lower case, all other bytes as they are, in every locale.
std::string lower_case(std::string_view text);

/// The same but for the case of ASCII letters?
bool equal_ignoring_case(std::string_view a, std::string_view b);

/// The words between white space.
std::vector<std::string_view> words(std::string_view line);

}  // namespace voussoir::text
