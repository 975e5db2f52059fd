// A file as bytes and lines, and the faults a reader finds in it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "libdda/errors.h"

namespace voussoir::records
{

struct SourceFile {
    std::string name;                     // as the user wrote it
    std::string bytes;                    // whole content, unpacked
    std::vector<std::string_view> lines;  // into `bytes`, without line ends (LF, CR LF, CR CR LF, CR)

    SourceFile() = default;
    SourceFile(const SourceFile&) = delete;  // `lines` point into `bytes`
    SourceFile& operator=(const SourceFile&) = delete;

    /// "file:line", the place of a fault. @param index 0-based
    std::string at(std::size_t index) const { return name + ":" + std::to_string(index + 1); }
};

/// Unpacks gzip and decodes UTF-16. @throws InputError when it is not a regular file, cannot be read or unpacked,
/// is empty or larger than 1 GB
void load_source_file(const std::filesystem::path& path, SourceFile& file);

/// The same from memory.
/// @throws InputError when it is empty, or gzipped and damaged or larger than 1 GB
void load_source_bytes(const std::string& name, std::string bytes, SourceFile& file);

/// No control characters other than white space: a text, in ASCII, Latin-1 or UTF-8.
bool is_text(const SourceFile& file);

/// Gathers faults, all of one file; a file with thousands of bad lines names the first few and counts the rest.
class FaultList
{
 public:
    void add(std::string place, std::string found, std::string expected);
    bool empty() const { return faults_.empty(); }
    /// @throws InputError when any fault was added
    void throw_if_any(const std::string& file);

 private:
    std::vector<Fault> faults_;
    std::size_t unnamed_ = 0;
};

}  // namespace voussoir::records
