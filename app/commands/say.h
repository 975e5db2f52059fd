// What the commands print: the one way to the terminal.
#pragma once

#include <string>
#include <string_view>

#include "libdda/errors.h"

namespace voussoir::app::commands
{

/// One line to standard output. Names, titles, keys and paths in it may be anybody's: what would command the
/// terminal, a line end too, is shown as \xNN (libdda/text/printable.h).
void say(std::string_view line);

/// The same without the end of the line.
void say_part(std::string_view text);

/// A text of several lines, as it is but for what would command the terminal.
void say_lines(std::string_view text);

/// A line in the place of the one that was written last, which stays open. @param to_errors to standard error
void say_over(std::string_view line, bool to_errors);

/// One line to standard error.
void complain(std::string_view line);

/// Every fault, one line each, to standard error.
void complain(const InputError& error);

/// Text to standard output as it is: JSON. @throws InputError when there is no standard output
void put_json(std::string_view json);

/// All of it reaches standard output now. @returns the system's reason when some of what was ever said could not
/// be written; empty when all was, and when a reader that has had enough closed the pipe
std::string unsaid();

}  // namespace voussoir::app::commands
