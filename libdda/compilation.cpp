#include "libdda/compilation.h"

#include <Eigen/Core>

#include "libdda/instruction_set.h"

// Memory is aligned otherwise under them, and sums of Eigen end in other bits.
#if defined(__SANITIZE_ADDRESS__)
#define SANITIZERS " with sanitizers"
#else
#define SANITIZERS ""
#endif

namespace voussoir
{

namespace
{

std::string compiler()
{
#if defined(__clang__)
    return "clang++ " __clang_version__;
#else
    return "g++ " __VERSION__ SANITIZERS;
#endif
}

std::string eigen()
{
    return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
           std::to_string(EIGEN_MINOR_VERSION);
}

}  // namespace

Compilation compilation()
{
    return {std::string(instruction_set()), compiler(), eigen()};
}

}  // namespace voussoir
