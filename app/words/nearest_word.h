// Which known word a mistyped one was probably meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voussoir::app::words
{

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
/// Source: [Damerau1964] (optimal string alignment).
int edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to `word`, or an empty string if none is near enough to be meant. Letter case is
/// ignored.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

/// "did you mean young?" or, with nothing near, "known here: a, b, c".
std::string suggestion(std::string_view word, const std::vector<std::string>& known);

}  // namespace voussoir::app::words
