// Loaded into a program and its helpers before their libraries (LD_PRELOAD): one call of the system or of memory,
// named by the stack it is called from, fails once.
//
//   VOUSSOIR_FAULT_LIST=FILE   writes a line for each call site: its number, its kind, whose it is, the program
//   VOUSSOIR_FAULT_SITE=N      the call site that fails; VOUSSOIR_FAULT_TIME=K: at its K-th call (1)
//   VOUSSOIR_FAULT_FIRED=FILE  is made when it has failed; then nothing fails any more, in no process
//
// Memory is ours where the program's own code asks for it, with what of a library is compiled into it, and foreign
// where a library asks by itself. All calls of the system count as ours.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace
{

constexpr int frames_of_memory = 8, frames_of_system = 24;

thread_local bool inside __attribute__((tls_model("initial-exec"))) = false;
std::atomic<bool> ready{false};
const char *list_file = nullptr, *fired_file = nullptr;
std::uint64_t failing_site = 0, program_hash = 0;
std::atomic<long> failing_time{0};
std::array<std::atomic<std::uint64_t>, 1U << 17U> seen;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value)
{
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ULL;
    return hash ^ hash >> 29U;
}

std::uint64_t hash_of(const char* text)
{
    std::uint64_t hash = 1469598103934665603ULL;
    for (; *text != '\0'; ++text) hash = mixed(hash, static_cast<unsigned char>(*text));
    return hash;
}

const char* name_of(const char* path)
{
    const char* slash = std::strrchr(path, '/');
    return slash != nullptr ? slash + 1 : path;
}

/// @returns true when it was not there
bool remember(std::uint64_t site)
{
    for (std::size_t i = 0; i < seen.size(); ++i) {
        std::atomic<std::uint64_t>& place = seen[(site + i) % seen.size()];
        std::uint64_t none = 0;
        if (place.compare_exchange_strong(none, site)) return true;
        if (none == site) return false;
    }
    return false;
}

void tell(std::uint64_t site, const char* kind, bool ours)
{
    std::array<char, 128> line{};
    const int length =
        std::snprintf(line.data(), line.size(), "%llu %s %s %s\n", static_cast<unsigned long long>(site), kind,
                      ours ? "ours" : "foreign", program_invocation_short_name);
    const long file = syscall(SYS_openat, AT_FDCWD, list_file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) return;
    syscall(SYS_write, file, line.data(), length);
    syscall(SYS_close, file);
}

/// The first to make the file is the one that fails.
bool fires()
{
    const long file = syscall(SYS_openat, AT_FDCWD, fired_file, O_WRONLY | O_EXCL | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) return false;
    syscall(SYS_close, file);
    return true;
}

/// The number of a call site, the same in every run: of each frame the library and the place in it.
std::uint64_t site_of(const char* kind, bool memory, bool& ours)
{
    std::array<void*, 40> stack{};
    const int wanted = memory ? frames_of_memory : frames_of_system;
    const int count = backtrace(stack.data(), static_cast<int>(stack.size()));
    std::uint64_t site = mixed(program_hash, hash_of(kind));
    int taken = 0;
    bool decided = false;
    for (int i = 0; i < count && taken < wanted; ++i) {
        void* const frame = stack[static_cast<std::size_t>(i)];
        dl_find_object found{};
        if (_dl_find_object(frame, &found) != 0) break;
        const char* library = name_of(found.dlfo_link_map->l_name);
        if (std::strstr(library, "fail_once") != nullptr) continue;
        if (!decided && std::strstr(library, "libstdc++") == nullptr) {
            decided = true;
            ours = library[0] == '\0';
        }
        const auto offset = static_cast<char*>(frame) - static_cast<char*>(found.dlfo_map_start);
        site = mixed(mixed(site, hash_of(library)), static_cast<std::uint64_t>(offset));
        ++taken;
    }
    if (!memory) ours = true;
    return site != 0 ? site : 1;
}

/// Is this the call that fails?
bool fails(const char* kind, bool memory = false)
{
    if (!ready || inside) return false;
    inside = true;
    const int before = errno;
    bool ours = false, result = false;
    const std::uint64_t site = site_of(kind, memory, ours);
    if (list_file != nullptr && remember(site)) tell(site, kind, ours);
    if (site == failing_site && --failing_time == 0) result = fires();
    errno = before;
    inside = false;
    return result;
}

template <typename Function>
Function next(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

__attribute__((constructor)) void begin()
{
    inside = true;
    std::array<void*, 4> warm{};
    backtrace(warm.data(), static_cast<int>(warm.size()));  // its first call loads a library
    program_hash = hash_of(program_invocation_short_name);
    list_file = std::getenv("VOUSSOIR_FAULT_LIST");
    fired_file = std::getenv("VOUSSOIR_FAULT_FIRED");
    if (const char* site = std::getenv("VOUSSOIR_FAULT_SITE")) failing_site = std::strtoull(site, nullptr, 10);
    const char* time = std::getenv("VOUSSOIR_FAULT_TIME");
    failing_time = time != nullptr ? std::strtol(time, nullptr, 10) : 1;
    inside = false;
    ready = list_file != nullptr || fired_file != nullptr;
}

/// What ferror() tells, as the C library keeps it.
void note_error(std::FILE* file)
{
    constexpr int error_seen = 0x20;
    if (file != nullptr) file->_flags |= error_seen;
}

template <typename Result>
Result failed(int error, Result result)
{
    errno = error;
    return result;
}

}  // namespace

extern "C" {
extern void* __libc_malloc(std::size_t);
extern void* __libc_calloc(std::size_t, std::size_t);
extern void* __libc_realloc(void*, std::size_t);
extern void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t bytes)
{
    return fails("memory", true) ? failed<void*>(ENOMEM, nullptr) : __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes)
{
    return fails("memory", true) ? failed<void*>(ENOMEM, nullptr) : __libc_calloc(count, bytes);
}
void* realloc(void* old, std::size_t bytes)
{
    return bytes > 0 && fails("memory", true) ? failed<void*>(ENOMEM, nullptr) : __libc_realloc(old, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes)
{
    return fails("memory", true) ? failed<void*>(ENOMEM, nullptr) : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t bytes)
{
    if (fails("memory", true)) return ENOMEM;
    *result = __libc_memalign(alignment, bytes);
    return *result != nullptr ? 0 : ENOMEM;
}
}

// Each stands for the function of its name; `result` is what it gives when it fails.
#define FAILING(type, name, parameters, arguments, error, result)               \
    extern "C" type name parameters                                             \
    {                                                                           \
        static const auto original = next<type(*) parameters>(#name);           \
        return fails(#name) ? failed<type>(error, result) : original arguments; \
    }
#define FAILING_QUIETLY(name, parameters, arguments, error)           \
    extern "C" int name parameters noexcept                           \
    {                                                                 \
        static const auto original = next<int(*) parameters>(#name);  \
        return fails(#name) ? failed(error, -1) : original arguments; \
    }
#define OPENING(name)                                                             \
    extern "C" int name(const char* path, int flags, ...)                         \
    {                                                                             \
        static const auto original = next<int (*)(const char*, int, ...)>(#name); \
        va_list rest;                                                             \
        va_start(rest, flags);                                                    \
        const mode_t mode = va_arg(rest, mode_t);                                 \
        va_end(rest);                                                             \
        return fails("open") ? failed(EIO, -1) : original(path, flags, mode);     \
    }

OPENING(open)
OPENING(open64)
FAILING(std::FILE*, fopen, (const char* path, const char* mode), (path, mode), EIO, nullptr)
FAILING(std::FILE*, fopen64, (const char* path, const char* mode), (path, mode), EIO, nullptr)
FAILING(std::size_t, fwrite, (const void* data, std::size_t size, std::size_t count, std::FILE* file),
        (data, size, count, file), ENOSPC, (note_error(file), 0))
FAILING(int, fflush, (std::FILE * file), (file), ENOSPC, (note_error(file), EOF))
FAILING(ssize_t, read, (int file, void* data, std::size_t size), (file, data, size), EIO, -1)
FAILING(ssize_t, pread, (int file, void* data, std::size_t size, off_t at), (file, data, size, at), EIO, -1)
FAILING(ssize_t, pread64, (int file, void* data, std::size_t size, off64_t at), (file, data, size, at), EIO, -1)
FAILING(ssize_t, write, (int file, const void* data, std::size_t size), (file, data, size), ENOSPC, -1)
FAILING(ssize_t, writev, (int file, const iovec* data, int count), (file, data, count), ENOSPC, -1)
FAILING(ssize_t, pwrite, (int file, const void* data, std::size_t size, off_t at), (file, data, size, at), ENOSPC,
        -1)
FAILING(ssize_t, pwrite64, (int file, const void* data, std::size_t size, off64_t at), (file, data, size, at),
        ENOSPC, -1)
FAILING(int, fsync, (int file), (file), EIO, -1)
FAILING(int, fdatasync, (int file), (file), EIO, -1)
FAILING(ssize_t, send, (int file, const void* data, std::size_t size, int flags), (file, data, size, flags), EPIPE,
        -1)
FAILING(ssize_t, recv, (int file, void* data, std::size_t size, int flags), (file, data, size, flags), ECONNRESET,
        -1)
FAILING_QUIETLY(ftruncate, (int file, off_t size), (file, size), ENOSPC)
FAILING_QUIETLY(ftruncate64, (int file, off64_t size), (file, size), ENOSPC)
FAILING_QUIETLY(rename, (const char* from, const char* to), (from, to), EIO)
FAILING_QUIETLY(link, (const char* from, const char* to), (from, to), EPERM)
FAILING_QUIETLY(mkdir, (const char* path, mode_t mode), (path, mode), ENOSPC)
FAILING_QUIETLY(socketpair, (int domain, int type, int protocol, int* ends), (domain, type, protocol, ends),
                EMFILE)

extern "C" pid_t fork() noexcept
{
    static const auto original = next<pid_t (*)()>("fork");
    return fails("fork") ? failed(EAGAIN, -1) : original();
}

extern "C" int posix_spawn(pid_t* child, const char* path, const posix_spawn_file_actions_t* actions,
                           const posix_spawnattr_t* attributes, char* const* arguments,
                           char* const* environment) noexcept
{
    static const auto original =
        next<int (*)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
                     char* const*, char* const*)>("posix_spawn");
    return fails("fork") ? EAGAIN : original(child, path, actions, attributes, arguments, environment);
}
