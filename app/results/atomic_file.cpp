#include "app/results/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "libdda/errors.h"

namespace voussoir::app::results
{

namespace
{

/// Writes everything, however many calls it takes. @returns 0 or an errno
int write_all(int descriptor, std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Makes the renaming itself durable; best effort, for some file systems cannot sync a folder.
void sync_folder(const std::filesystem::path& folder)
{
    const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
}

}  // namespace

void refuse_writing(const std::filesystem::path& path, int error_number)
{
    throw InputError(path.string(), "cannot be written: " + std::generic_category().message(error_number),
                     "give a writable folder on a disk with free space");
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes)
{
    std::filesystem::path temporary = path;
    temporary += ".part";
    // What lies there is of a killed run, or a link that leads elsewhere: never written through.
    if (::unlink(temporary.c_str()) != 0 && errno != ENOENT) refuse_writing(path, errno);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) refuse_writing(path, errno);
    int error = write_all(descriptor, bytes);
    if (error == 0 && ::fsync(descriptor) != 0) error = errno;
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(temporary.c_str());
        refuse_writing(path, error);
    }
    sync_folder(path.parent_path());
}

void sync_file(const std::filesystem::path& path)
{
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor < 0) refuse_writing(path, errno);
    const int error = ::fdatasync(descriptor) != 0 ? errno : 0;
    ::close(descriptor);
    if (error != 0) refuse_writing(path, error);
}

OwnFile::OwnFile(const std::filesystem::path& path)
    : path_(path), descriptor_(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC))
{
    struct stat is = {};
    const int error = descriptor_ < 0 || ::fstat(descriptor_, &is) != 0 ? errno : 0;
    if (error == 0 && S_ISREG(is.st_mode)) {
        size_ = static_cast<std::uintmax_t>(is.st_size);
        return;
    }
    if (descriptor_ >= 0) ::close(descriptor_);
    if (error == 0 || error == ELOOP || error == ENXIO)
        throw InputError(path.string(), "a link, a folder, a pipe or a device, not a file", "remove it");
    throw InputError(path.string(), "cannot be read: " + std::generic_category().message(error),
                     "give a file that exists and may be read");
}

OwnFile::~OwnFile()
{
    ::close(descriptor_);
}

std::string OwnFile::read(std::size_t count)
{
    std::string bytes(count, '\0');
    std::size_t had = 0;
    while (had < count) {
        const ssize_t got = ::read(descriptor_, bytes.data() + had, count - had);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            throw InputError(path_.string(), "cannot be read: " + std::generic_category().message(errno),
                             "give a file that may be read");
        if (got == 0) break;
        had += static_cast<std::size_t>(got);
    }
    bytes.resize(had);
    return bytes;
}

}  // namespace voussoir::app::results
