// Contact patches by the rows of the blocks that meet there.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace voussoir::step
{

/// Found when first needed in a step.
class PatchesOfRows
{
 public:
    /// To be called when the contacts of a step are known.
    void begin() { is_ready_ = false; }

    /// @param patches with row_a, row_b (-1: none); @param rows how many there are
    template <class Patch>
    void find(const std::vector<Patch>& patches, std::size_t rows)
    {
        if (is_ready_) return;
        is_ready_ = true;
        start_.assign(rows + 1, 0);
        const auto for_rows = [&](auto&& visit) {
            for (std::size_t k = 0; k < patches.size(); ++k)
                for (const int row : {patches[k].row_a, patches[k].row_b})
                    if (row >= 0) visit(row, static_cast<int>(k));
        };
        for_rows([&](int row, int) { ++start_[row + 1]; });
        for (std::size_t row = 0; row < rows; ++row) start_[row + 1] += start_[row];
        patches_.resize(start_[rows]);
        place_.assign(start_.begin(), start_.end() - 1);
        for_rows([&](int row, int k) { patches_[place_[row]++] = k; });
    }

    /// Indices of the patches of a row, ascending.
    std::span<const int> of(int row) const
    {
        return {patches_.data() + start_[row], static_cast<std::size_t>(start_[row + 1] - start_[row])};
    }

 private:
    bool is_ready_ = false;
    std::vector<int> start_, patches_;  // in compressed form
    std::vector<int> place_;            // scratch
};

}  // namespace voussoir::step
