// Many stones in few words: by the parts of a structure and their courses, as the names of stones tell them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace voussoir::app::words
{

/// "a, b and c" of few stones; of many "6 of 72 stones of wall in courses 7 to 10 and 3 of 15 stones of voussoir
/// numbered 02 to 04". A part is what stands in a name before its course ("_c07"), or else before the number it
/// ends with.
/// @param blocks indices into `names` @param names of all stones @param most that are named one by one
/// @param quote around each name
std::string stones_in_words(const std::vector<int>& blocks, const std::vector<std::string>& names,
                            std::size_t most = 5, const std::string& quote = "");

/// The part of the structure that a stone's name tells: "house_south" of "house_south_c03_b02".
std::string part_of(const std::string& name);

}  // namespace voussoir::app::words
