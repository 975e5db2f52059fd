#include "app/results/run_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "app/results/atomic_file.h"
#include "libdda/errors.h"

namespace voussoir::app::results
{

namespace
{

/// Is the file that was opened still the one of that name? Its holder takes it away when it ends.
bool still_there(int descriptor, const std::filesystem::path& path)
{
    struct stat opened = {}, named = {};
    if (::fstat(descriptor, &opened) != 0 || ::stat(path.c_str(), &named) != 0) return false;
    return opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& folder) : path_(folder / "run.lock")
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) refuse_writing(folder, error.value());
    while (true) {
        descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor_ < 0) refuse_writing(folder, errno);
        // A file system that knows no locks fails in another way and is used without one.
        const bool taken = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
        if (!taken && still_there(descriptor_, path_)) return;
        ::close(descriptor_);
        if (!taken) continue;
        throw InputError(folder.string(), "another run is writing there",
                         "wait until it has ended, or give another folder");
    }
}

RunLock::~RunLock()
{
    ::unlink(path_.c_str());
    ::close(descriptor_);
}

}  // namespace voussoir::app::results
