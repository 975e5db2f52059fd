// Which things hang together when some of them are joined in pairs.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace voussoir
{

/// Sets of indices, each its own at first.
class DisjointSets
{
 public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    void join(int a, int b) { parent_[root_of(a)] = root_of(b); }
    /// The same of all that are joined.
    int root_of(int i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }

 private:
    std::vector<int> parent_;
};

}  // namespace voussoir
