// Files that are there whole or not at all.
#pragma once

#include <cstdint>
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

/// A file of ours, opened to be read. Anybody may have put something else in its place: a link is not followed,
/// and only a regular file is read, for a pipe would never end.
class OwnFile
{
 public:
    /// @throws InputError when there is no such file or it cannot be read
    explicit OwnFile(const std::filesystem::path& path);
    ~OwnFile();
    OwnFile(const OwnFile&) = delete;
    OwnFile& operator=(const OwnFile&) = delete;

    std::uintmax_t size() const { return size_; }  // bytes, when it was opened
    /// The next bytes, fewer at the end of the file. @throws InputError
    std::string read(std::size_t count);

 private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    std::uintmax_t size_ = 0;
};

/// Refusal of a file that cannot be written, with the system's words for `error_number`.
[[noreturn]] void refuse_writing(const std::filesystem::path& path, int error_number);

}  // namespace voussoir::app::results
