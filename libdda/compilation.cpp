#include "libdda/compilation.h"

#include <Eigen/Core>

#include "libdda/instruction_set.h"

namespace voussoir
{

namespace
{

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
