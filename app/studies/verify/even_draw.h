// Even numbers from a generator whose answers the standard fixes: the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace voussoir::app::studies::verify
{

/// The numbers of the n-th scene of a row.
class EvenDraw
{
 public:
    EvenDraw(std::uint64_t seed, int n) : random_(seed * 1000003 + static_cast<std::uint64_t>(n)) {}
    double between(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
    }
    /// low, low + 1, ... or high
    int whole(int low, int high) { return std::min(high, static_cast<int>(std::floor(between(low, high + 1)))); }

 private:
    std::mt19937_64 random_;
};

}  // namespace voussoir::app::studies::verify
