#include "app/studies/ensemble/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir::app::studies::ensemble
{

namespace
{

constexpr double millimetres = 1e3;  // in a metre

bool has_nan(const std::vector<double>& values)
{
    return values.empty() || std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); });
}

double peak_of(const std::vector<Eigen::Vector3d>& history)
{
    double peak = 0;
    for (const Eigen::Vector3d& value : history) peak = std::max(peak, value.norm());
    return peak;
}

}  // namespace

std::vector<EnsembleMeasure> measures_of(const Case& member, double limit)
{
    std::vector<EnsembleMeasure> measures;
    for (const HistoryPoint& point : member.output.histories) {
        measures.push_back({point.name + ": peak drift", "mm"});
        measures.push_back({point.name + ": residual drift", "mm"});
    }
    const std::string open = fmt::format("open by more than {:g} mm", millimetres * limit);
    measures.push_back({"largest opening of a joint", "mm"});
    measures.push_back({"joints that were " + open, ""});
    measures.push_back({"joints left " + open, ""});
    return measures;
}

std::vector<double> values_of(const MemberRun& run)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), beyond = std::numeric_limits<double>::infinity();
    std::vector<double> values;
    for (const std::vector<Eigen::Vector3d>& history : run.recording.values) {
        values.push_back(run.collapse ? beyond : millimetres * peak_of(history));
        values.push_back(run.collapse ? beyond : millimetres * history.back().norm());
    }
    values.push_back(run.collapse ? beyond : millimetres * run.largest_opening);
    values.push_back(run.collapse ? beyond : run.opened);
    values.push_back(run.collapse ? beyond : run.open);
    if (!run.failure.empty()) std::fill(values.begin(), values.end(), nan);
    return values;
}

double median_of(std::vector<double> values)
{
    if (has_nan(values)) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    const double high = values[n / 2];
    return n % 2 == 1 || high == values[n / 2 - 1] ? high : 0.5 * (high + values[n / 2 - 1]);
}

double range_of(const std::vector<double>& values)
{
    if (has_nan(values)) return std::numeric_limits<double>::quiet_NaN();
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return *least == *most ? 0 : *most - *least;
}

}  // namespace voussoir::app::studies::ensemble
