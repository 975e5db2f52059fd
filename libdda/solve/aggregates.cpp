#include "libdda/solve/aggregates.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace voussoir::solve
{

namespace
{

using Graph = std::vector<std::vector<int>>;

Graph neighbours_of(const BlockMatrix& pattern, const std::vector<char>& takes_part)
{
    Graph graph(pattern.rows());
    for (int i = 0; i < pattern.rows(); ++i)
        for (int p = pattern.row_start[i]; p < pattern.diagonal(i); ++p) {
            const int j = pattern.columns[p];
            if (!takes_part[i] || !takes_part[j]) continue;
            graph[i].push_back(j);
            graph[j].push_back(i);
        }
    return graph;
}

/// Grows one aggregate at a time, always by the row that has most neighbours in it.
class Growth
{
 public:
    explicit Growth(const Graph& graph) : graph_(graph), links_(graph.size(), 0) {}

    void grow(int seed, int number, int size, std::vector<int>& of_row)
    {
        edge_.clear();
        take(seed, number, of_row);
        for (int members = 1; members < size; ++members) {
            const int next = best(of_row);
            if (next < 0) break;
            take(next, number, of_row);
        }
        for (const int row : edge_) links_[row] = 0;
    }

 private:
    void take(int row, int number, std::vector<int>& of_row)
    {
        of_row[row] = number;
        for (const int other : graph_[row])
            if (of_row[other] < 0 && links_[other]++ == 0) edge_.push_back(other);
    }

    int best(const std::vector<int>& of_row) const
    {
        int found = -1;
        for (const int row : edge_)
            if (of_row[row] < 0 && (found < 0 || links_[row] > links_[found])) found = row;
        return found;
    }

    const Graph& graph_;
    std::vector<int> links_;  // of a row, to the aggregate that grows
    std::vector<int> edge_;   // rows that have any, in the order in which they were met
};

/// Joins aggregates that found no room to a neighbour. @returns for each the one it belongs to
std::vector<int> join_small(const Graph& graph, int least, const std::vector<int>& of_row, int count)
{
    std::vector<int> size(count, 0), joined(count);
    std::iota(joined.begin(), joined.end(), 0);
    for (const int number : of_row)
        if (number >= 0) ++size[number];
    for (std::size_t row = 0; row < graph.size(); ++row) {
        const int number = of_row[row];
        if (number < 0 || size[number] >= least || joined[number] != number) continue;
        for (const int other : graph[row])
            if (of_row[other] != number && size[of_row[other]] >= least) {
                joined[number] = of_row[other];
                break;
            }
    }
    return joined;
}

/// Breadth first from the first of each part of the graph, of few neighbours before of many.
std::vector<int> cuthill_mckee(Graph graph)
{
    const int count = static_cast<int>(graph.size());
    for (std::vector<int>& neighbours : graph) {
        std::sort(neighbours.begin(), neighbours.end());
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    }
    std::vector<int> place(count, -1), queue;
    queue.reserve(count);
    for (int first = 0; first < count; ++first) {
        if (place[first] >= 0) continue;
        std::size_t next = queue.size();
        place[first] = static_cast<int>(queue.size());
        queue.push_back(first);
        for (; next < queue.size(); ++next) {
            std::vector<int>& neighbours = graph[queue[next]];
            std::sort(neighbours.begin(), neighbours.end(),
                      [&](int a, int b) { return std::pair(graph[a].size(), a) < std::pair(graph[b].size(), b); });
            for (const int other : neighbours) {
                if (place[other] >= 0) continue;
                place[other] = static_cast<int>(queue.size());
                queue.push_back(other);
            }
        }
    }
    return place;
}

}  // namespace

Aggregates aggregate(const BlockMatrix& pattern, const std::vector<char>& takes_part, int size)
{
    const Graph graph = neighbours_of(pattern, takes_part);
    Aggregates result;
    result.of_row.assign(pattern.rows(), -1);
    int grown = 0;
    Growth growth(graph);
    for (int row = 0; row < pattern.rows(); ++row)
        if (takes_part[row] && result.of_row[row] < 0) growth.grow(row, grown++, size, result.of_row);
    const std::vector<int> joined = join_small(graph, size / 3, result.of_row, grown);

    std::vector<int> number(grown, -1);
    for (int k = 0; k < grown; ++k)
        if (joined[k] == k) number[k] = result.count++;
    for (int& of : result.of_row)
        if (of >= 0) of = number[joined[of]];

    Graph coarse(result.count);
    for (std::size_t row = 0; row < graph.size(); ++row)
        for (const int other : graph[row])
            if (result.of_row[row] != result.of_row[other])
                coarse[result.of_row[row]].push_back(result.of_row[other]);
    const std::vector<int> place = cuthill_mckee(std::move(coarse));
    for (int& of : result.of_row)
        if (of >= 0) of = place[of];
    return result;
}

}  // namespace voussoir::solve
