// A text line by line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace voussoir::app::words
{

/// The lines of a text without their ends; what follows the last end is one more if it is not empty. A stream
/// would take want of memory for the end of the text.
std::vector<std::string> lines_of(std::string_view text);

}  // namespace voussoir::app::words
