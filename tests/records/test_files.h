// Where the tests of the records find and put their files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace voussoir::records
{

inline std::filesystem::path repository()
{
    return VOUSSOIR_REPOSITORY;
}

/// The folder of real data, from the environment or beside the repository; may not exist.
inline std::filesystem::path data_folder()
{
    const char* folder = std::getenv("VOUSSOIR_DATA");
    return folder != nullptr ? std::filesystem::path(folder) : repository().parent_path() / "shared" / "data";
}

inline std::string read_text(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// A file of the given content that lives as long as this object.
class TemporaryFile
{
 public:
    explicit TemporaryFile(const std::string& content, const std::string& name = "record.txt")
        : path_(std::filesystem::path(::testing::TempDir()) / (std::to_string(getpid()) + "_" + name))
    {
        std::ofstream(path_, std::ios::binary) << content;
    }
    ~TemporaryFile()
    {
        std::error_code error;
        std::filesystem::remove(path_, error);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

}  // namespace voussoir::records
