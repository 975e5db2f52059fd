// Where the figures of a command go: `--json FILE` and `-o DIR`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace voussoir::app::commands
{

/// Refuses, before long work is done, a file or folder that could not be written after it. Makes nothing.
/// @param json a file, or "-"; @param folder need not be there yet
/// @throws InputError
void expect_writable(const std::optional<std::filesystem::path>& json,
                     const std::optional<std::filesystem::path>& folder);

/// Makes the folder of `-o` if it is not there. @throws InputError when it cannot be made
void make_output_folder(const std::filesystem::path& folder);

/// Writes a file of ours into a folder of `-o`, in the place of what has its name, be it a link.
/// @throws InputError when it cannot be written
void write_own_file(const std::filesystem::path& file, const std::string& text);

/// Writes a file that the user named; a link is followed. The file is there whole or not at all, unless it is a
/// pipe or a device. @throws InputError when it cannot be written
void write_named_file(const std::filesystem::path& file, const std::string& text);

/// Writes text to a file that the user named, or to standard output if the file is "-".
/// @throws InputError when it cannot be written
void write_json_text(const std::filesystem::path& file, const std::string& text);

}  // namespace voussoir::app::commands
