// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace voussoir::app::results
{

/// Writes under a temporary name beside `path`, syncs to the disk, renames, syncs the folder.
/// @throws InputError with the system's reason; the temporary file is removed and an older `path` untouched
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// What was written into a file by others is on the disk when this returns. @throws InputError
void sync_file(const std::filesystem::path& path);

/// @throws InputError when the file cannot be read
std::string read_whole_file(const std::filesystem::path& path);

/// Refusal of a file that cannot be written, with the system's words for `error_number`.
[[noreturn]] void refuse_writing(const std::filesystem::path& path, int error_number);

}  // namespace voussoir::app::results
