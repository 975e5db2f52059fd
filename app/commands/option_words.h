// Options of the command line, in and out: quantities read, words as a shell takes them.
#pragma once

#include <filesystem>
#include <string>

#include "app/words/quantity.h"

namespace voussoir::app::commands
{

/// A positive quantity. @throws InputError named by the option
double read_positive(const std::string& option, const std::string& text, const words::Dimension& dimension);

/// A word as a shell takes it: in single quotes where it holds more than plain letters.
std::string shell_word(const std::string& word);

/// " -o NAME", as it ends the command line that a page tells: the folder by its last name, for pages travel.
std::string folder_option(const std::filesystem::path& folder);

}  // namespace voussoir::app::commands
