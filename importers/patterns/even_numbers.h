// Random numbers for patterns.
#pragma once

#include <cstdint>

namespace voussoir::importers::patterns
{

/// Evenly spread numbers, the same on every machine (the distributions of the standard library are not).
/// Source: [SteeleLeaFlood2014] (splitmix64).
class EvenNumbers
{
 public:
    explicit EvenNumbers(std::uint64_t seed) : state_(seed) {}

    /// 64 bits, each as likely 0 as 1.
    std::uint64_t bits()
    {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t bits = state_;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
        return bits ^ (bits >> 31);
    }
    /// >= 0 and < 1, a multiple of 2^-53.
    double share() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// >= -1 and < 1.
    double deviation() { return 2 * share() - 1; }

 private:
    std::uint64_t state_;
};

}  // namespace voussoir::importers::patterns
