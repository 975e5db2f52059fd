#include "app/results/own_folder.h"

#include <cerrno>
#include <system_error>

#include "app/results/atomic_file.h"

namespace voussoir::app::results
{

namespace fs = std::filesystem;

bool is_own_folder(const fs::path& folder)
{
    std::error_code none;
    return fs::is_directory(fs::symlink_status(folder, none));
}

void make_own_folder(const fs::path& folder)
{
    std::error_code error;
    if (fs::is_symlink(fs::symlink_status(folder, error))) fs::remove(folder, error);
    fs::create_directories(folder, error);
    if (error || !is_own_folder(folder)) refuse_writing(folder, error ? error.value() : ENOTDIR);
}

}  // namespace voussoir::app::results
