#include "app/report/point_history.h"

#include <algorithm>

namespace voussoir::app::report
{

namespace
{

/// The last row before the first motion.
std::size_t row_at_rest(const RunRecord& record, const std::vector<double>& times)
{
    const State& rest = record.results.model.rest.state;
    if (rest.coordinates.empty()) return 0;
    const auto next = std::upper_bound(times.begin(), times.end(), rest.time);
    return next == times.begin() ? 0 : static_cast<std::size_t>(next - times.begin()) - 1;
}

}  // namespace

bool is_of_foot(const std::string& column)
{
    return column.starts_with("ground u");
}

PointHistory point_history(const RunRecord& record, const std::string& column)
{
    const std::vector<double> times = record.histories.column(record.histories.names.front());
    const std::vector<double> places = record.histories.column(column);
    const std::string foot = "ground" + column.substr(std::min(column.rfind(" u"), column.size()));
    const auto& names = record.histories.names;
    std::vector<double> of_foot(places.size(), 0);
    if (std::find(names.begin(), names.end(), foot) != names.end()) of_foot = record.histories.column(foot);
    const std::size_t first = row_at_rest(record, times);
    const bool counts_from_rest = !record.results.model.rest.state.coordinates.empty();
    const double at_rest = counts_from_rest && first < places.size() ? places[first] - of_foot[first] : 0;
    PointHistory history;
    for (std::size_t i = first; i < places.size(); ++i) {
        history.times.push_back(times[i]);
        history.moved.push_back(places[i] - of_foot[i] - at_rest);
    }
    return history;
}

}  // namespace voussoir::app::report
