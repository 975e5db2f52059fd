// Loaded into the program before its libraries (LD_PRELOAD): from the moment that it has saved its second restart
// file, it is given no more memory. A limit that comes from outside could come while HDF5 is at work, which does
// not survive a failed allocation; the program therefore asks for memory before it calls HDF5, and this is what is
// tested.
#include <dlfcn.h>
#include <sys/resource.h>

#include <string_view>

extern "C" int rename(const char* from, const char* to) noexcept
{
    static const auto original = reinterpret_cast<int (*)(const char*, const char*)>(dlsym(RTLD_NEXT, "rename"));
    static int saved = 0;
    const int result = original(from, to);
    if (std::string_view(to).ends_with("restart.bin") && ++saved == 2) {
        const rlimit none{1 << 20, 1 << 20};  // less than it has: nothing more is given
        setrlimit(RLIMIT_AS, &none);
    }
    return result;
}
