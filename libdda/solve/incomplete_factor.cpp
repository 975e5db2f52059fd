#include "libdda/solve/incomplete_factor.h"

#include <algorithm>
#include <utility>

#include "libdda/solve/aggregates.h"

namespace voussoir::solve
{

namespace
{

constexpr int rows_in_domain = 256;  // some, or more
constexpr int most_domains = 16;

}  // namespace

Domains divide_into_domains(const BlockMatrix& pattern, int least_rows, int most)
{
    const int rows = pattern.rows();
    if (rows < blocks_worth_threads) return {std::vector<int>(rows, 0), 1};
    Aggregates aggregates = aggregate(pattern, std::vector<char>(rows, 1), std::max(least_rows, rows / most));
    return {std::move(aggregates.of_row), aggregates.count};
}

/// @param place of each row of the matrix in the order of the factor
void IncompleteFactor::set_order(const BlockMatrix& a, std::vector<int>& place)
{
    const std::vector<int>& of = domains_.of_row;
    std::vector<char> is_border(a.rows(), false);
    for (int i = 0; i < a.rows(); ++i)
        for (int p = a.row_start[i]; p < a.diagonal(i); ++p)
            if (const int j = a.columns[p]; of[i] != of[j]) is_border[of[i] > of[j] ? i : j] = true;
    std::vector<std::vector<int>> rows(2 * count_);
    for (int i = 0; i < a.rows(); ++i) rows[is_border[i] ? count_ + of[i] : of[i]].push_back(i);
    order_.clear();
    inside_.clear();
    border_.clear();
    for (int part = 0; part < 2 * count_; ++part) {
        (part < count_ ? inside_ : border_).push_back(static_cast<int>(order_.size()));
        order_.insert(order_.end(), rows[part].begin(), rows[part].end());
    }
    inside_.push_back(border_.front());
    border_.push_back(a.rows());
    place.resize(a.rows());
    for (int i = 0; i < a.rows(); ++i) place[order_[i]] = i;
}

void IncompleteFactor::analyse(const BlockMatrix& a)
{
    columns_ = a.columns;
    row_start_ = a.row_start;
    of_matrix_ = columns_of(a);
    domains_ = divide_into_domains(a, rows_in_domain, most_domains);
    count_ = domains_.count;
    std::vector<int> place;
    set_order(a, place);

    struct Entry {
        int row, column;
        Taken taken;
    };
    std::vector<Entry> entries;
    const int first_border = border_.front();
    for (int i = 0; i < a.rows(); ++i)
        for (int p = a.row_start[i]; p < a.row_start[i + 1]; ++p) {
            const int j = a.columns[p], row = std::max(place[i], place[j]), column = std::min(place[i], place[j]);
            if (column >= first_border && domains_.of_row[i] != domains_.of_row[j]) continue;
            entries.push_back({row, column, {p, row != place[i]}});
        }
    std::sort(entries.begin(), entries.end(), [](const Entry& one, const Entry& other) {
        return std::pair(one.row, one.column) < std::pair(other.row, other.column);
    });
    l_.block_size = a.block_size;
    l_.row_start.assign(a.rows() + 1, 0);
    l_.columns.clear();
    taken_.clear();
    for (const Entry& entry : entries) {
        ++l_.row_start[entry.row + 1];
        l_.columns.push_back(entry.column);
        taken_.push_back(entry.taken);
    }
    for (int i = 0; i < a.rows(); ++i) l_.row_start[i + 1] += l_.row_start[i];
    below_ = columns_of(l_);
    ordered_.resize(0);  // zeros behind other numbers of a segment
}

}  // namespace voussoir::solve
