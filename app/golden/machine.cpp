#include <dlfcn.h>
#include <gnu/libc-version.h>

#include <filesystem>

#include "app/golden/hashes.h"
#include "libdda/compilation.h"

namespace voussoir::app::golden
{

namespace
{

namespace fs = std::filesystem;

/// The library that has a function, by the name of its file and folder, which tell the alternatives of Debian
/// apart: "blas/libblas.so.3.11.0".
std::string library_of(const char* function)
{
    Dl_info info{};
    void* const symbol = dlsym(RTLD_DEFAULT, function);
    if (symbol == nullptr || dladdr(symbol, &info) == 0) return "linked statically";
    std::error_code error;
    const fs::path file = fs::canonical(info.dli_fname, error);
    if (error) return "unknown";
    return (file.parent_path().filename() / file.filename()).string();
}

/// The C library's sine and its like differ in their last bits with the processor they find.
std::string libm()
{
    std::string text = std::string("glibc ") + gnu_get_libc_version();
#if defined(__x86_64__)
    if (__builtin_cpu_supports("fma") != 0) text += ", FMA";
#endif
    return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> machine()
{
    const Compilation engine = compilation();
    return {{"instruction_set", engine.instruction_set},
            {"compiler", engine.compiler},
            {"eigen", engine.eigen},
            {"libm", libm()},
            {"cholmod", library_of("cholmod_analyze")},
            {"lapack", library_of("dpotrf_")},
            {"blas", library_of("dgemm_")}};
}

}  // namespace voussoir::app::golden
