// Where `--json FILE` goes.
#pragma once

#include <filesystem>
#include <string>

namespace voussoir
{

/// Writes text to a file, or to standard output if the file is "-".
/// @throws InputError when it cannot be written
void write_json_text(const std::filesystem::path& file, const std::string& text);

}  // namespace voussoir
