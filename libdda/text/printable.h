// Text of others on a terminal: names, titles, keys and paths may hold characters that command it.
#pragma once

#include <string>
#include <string_view>

namespace voussoir::text
{

/// What a terminal may be shown on one line: each byte of a control character (line ends and tabs too), of a mark
/// that changes the direction of writing or ends a line, and each byte that is not UTF-8, as \xNN.
std::string printable(std::string_view text);

/// The same of a text of several lines, whose ends stay.
std::string printable_lines(std::string_view text);

/// JSON whose strings hold such characters only as \uNNNN: the same values. @param json UTF-8
std::string printable_json(std::string_view json);

}  // namespace voussoir::text
