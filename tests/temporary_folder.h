// A folder of its own for one test.
#pragma once

#include <cerrno>
#include <cstdlib>  // and POSIX mkdtemp
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace voussoir
{

/// A new, empty folder that goes away with this object.
class TemporaryFolder
{
 public:
    TemporaryFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "voussoir_test_XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw std::filesystem::filesystem_error("no temporary folder", pattern,
                                                    std::error_code(errno, std::generic_category()));
        path_ = pattern;
    }
    ~TemporaryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::filesystem::path write(const std::string& name, const std::string& text) const
    {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

 private:
    std::filesystem::path path_;
};

}  // namespace voussoir
