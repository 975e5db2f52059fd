// Requests for memory beyond a bound fail, and the test with them. Replaces operator new: to be included by one
// source of a program only.
#pragma once

#include <cstdlib>
#include <new>

namespace voussoir
{

/// Bytes that may be asked for at once; 0: any.
inline std::size_t largest_request = 0;

/// The bound holds as long as this lives.
struct LimitedRequests {
    explicit LimitedRequests(std::size_t bytes) { largest_request = bytes; }
    ~LimitedRequests() { largest_request = 0; }
    LimitedRequests(const LimitedRequests&) = delete;
    LimitedRequests& operator=(const LimitedRequests&) = delete;
};

}  // namespace voussoir

// Not inlined: g++ would take malloc and delete, or new and free, for a pair.
[[gnu::noinline]] void* operator new(std::size_t size)
{
    if (voussoir::largest_request > 0 && size > voussoir::largest_request) throw std::bad_alloc();
    if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    if (voussoir::largest_request > 0 && size > voussoir::largest_request) return nullptr;
    return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept
{
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept
{
    std::free(memory);
}
