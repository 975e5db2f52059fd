// The limits a helper process sets itself before it reads what others wrote.
#pragma once

#include <sys/resource.h>

#include <algorithm>

namespace voussoir::importers::process
{

/// Whether the program runs under AddressSanitizer.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool address_sanitizer = true;  // reserves terabytes of addresses for itself
#else
constexpr bool address_sanitizer = false;
#endif

/// From now on this process gets no more of a resource: an RLIMIT_... of <sys/resource.h>.
inline void limit_self(decltype(RLIMIT_AS) resource, rlim_t most)
{
    rlimit current{};
    if (getrlimit(resource, &current) != 0) return;
    current.rlim_cur = std::min<rlim_t>(most, current.rlim_max);
    setrlimit(resource, &current);
}

/// @param bytes of memory, counted as addresses
inline void limit_own_memory(rlim_t bytes)
{
    if (!address_sanitizer) limit_self(RLIMIT_AS, bytes);
}

}  // namespace voussoir::importers::process
