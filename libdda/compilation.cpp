#include "libdda/compilation.h"

#include <Eigen/Core>

namespace voussoir
{

namespace
{

/// As far as Eigen looks at it.
constexpr std::string_view instruction_set()
{
#if defined(__AVX512F__)
    return "x86-64-v4";
#elif defined(__AVX2__) && defined(__FMA__)
    return "x86-64-v3";
#elif defined(__x86_64__)
    return "x86-64";
#elif defined(__aarch64__)
    return "aarch64";
#else
    return "unknown";
#endif
}

std::string compiler()
{
#if defined(__clang__)
    return "clang++ " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

}  // namespace

Compilation compilation()
{
    return {instruction_set(), compiler(),
            std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                std::to_string(EIGEN_MINOR_VERSION)};
}

}  // namespace voussoir
