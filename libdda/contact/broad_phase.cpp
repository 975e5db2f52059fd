#include "libdda/contact/broad_phase.h"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "libdda/model/parallel.h"

namespace voussoir::contact
{

template <int D>
void find_candidates(const std::vector<PlacedPartIn<D>>& parts, const std::vector<double>& reach,
                     const std::vector<bool>& fully_held, int threads, Candidates& candidates)
{
    std::vector<std::pair<int, int>>& pairs = candidates.pairs;
    pairs.clear();
    if (parts.empty()) return;
    VectorIn<D> lower = parts.front().lower, upper = parts.front().upper;
    for (const PlacedPartIn<D>& part : parts) {
        lower = lower.cwiseMin(part.lower);
        upper = upper.cwiseMax(part.upper);
    }
    int axis = 0;
    (upper - lower).maxCoeff(&axis);

    const auto low = [&](int i) { return parts[i].lower[axis] - reach[parts[i].block]; };
    std::vector<int>& order = candidates.order;
    order.resize(parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return low(i) < low(j) || (low(i) == low(j) && i < j); });

    const auto look = [&](std::size_t from, std::size_t end, std::vector<std::pair<int, int>>& found) {
        for (std::size_t k = from; k < end; ++k) {
            const PlacedPartIn<D>& first = parts[order[k]];
            const double high = first.upper[axis] + reach[first.block];
            for (std::size_t m = k + 1; m < order.size() && low(order[m]) <= high; ++m) {
                const PlacedPartIn<D>& second = parts[order[m]];
                if (first.block == second.block || (fully_held[first.block] && fully_held[second.block])) continue;
                const double grow = reach[first.block] + reach[second.block];
                const bool apart = ((first.lower.array() - grow) > second.upper.array()).any() ||
                                   ((second.lower.array() - grow) > first.upper.array()).any();
                if (!apart) found.emplace_back(std::min(order[k], order[m]), std::max(order[k], order[m]));
            }
        }
    };
    if (threads <= 1) {
        look(0, order.size(), pairs);
    } else {
        std::mutex mutex;
        in_parallel(order.size(), threads, [&](std::size_t from, std::size_t end) {
            std::vector<std::pair<int, int>> found;
            look(from, end, found);
            const std::lock_guard lock(mutex);
            pairs.insert(pairs.end(), found.begin(), found.end());
        });
    }
    std::sort(pairs.begin(), pairs.end());
}

template void find_candidates(const std::vector<PlacedPart>&, const std::vector<double>&, const std::vector<bool>&,
                              int, Candidates&);
template void find_candidates(const std::vector<PlacedOutline>&, const std::vector<double>&,
                              const std::vector<bool>&, int, Candidates&);

}  // namespace voussoir::contact
