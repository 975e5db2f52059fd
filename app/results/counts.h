// Counts that were read from a file.
#pragma once

#include <cstdint>

namespace voussoir::app::results
{

/// Neither negative nor so large that a run could count past the end of its type.
constexpr bool is_count(std::int64_t value)
{
    constexpr std::int64_t most = std::int64_t{1} << 53;  // exact as a double too
    return value >= 0 && value <= most;
}

}  // namespace voussoir::app::results
