#include "app/studies/converge/sample.h"

#include <algorithm>

namespace voussoir::app::studies::converge
{

using Eigen::Vector3d;

namespace
{

Sample interpolated(const std::vector<double>& from, const std::vector<Vector3d>& values,
                    const std::vector<double>& times)
{
    Sample result(3, static_cast<Eigen::Index>(times.size()));
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto after = std::lower_bound(from.begin(), from.end(), times[i]);
        const std::size_t k = std::min<std::size_t>(after - from.begin(), from.size() - 1);
        Vector3d value = values[k];
        if (k > 0 && from[k] > times[i]) {
            const double left = (from[k] - times[i]) / (from[k] - from[k - 1]);
            value += left * (values[k - 1] - values[k]);
        }
        result.block<3, 1>(0, static_cast<Eigen::Index>(i)) = value;
    }
    return result;
}

}  // namespace

Sample sample_of(const Quantity& quantity, const Recording& recording, const std::vector<double>& times)
{
    const std::vector<Vector3d>& values = recording.values[quantity.channel];
    if (quantity.measure == Measure::history) return interpolated(recording.times, values, times);
    if (quantity.measure == Measure::end) return interpolated(recording.times, values, {times.back()});
    double peak = 0;
    for (std::size_t i = 0; i < values.size() && recording.times[i] <= times.back(); ++i)
        peak = std::max(peak, values[i].norm());
    return Sample::Constant(1, 1, peak);
}

double value_of(const Quantity& quantity, const Sample& sample)
{
    const bool has_sign = quantity.measure == Measure::end && quantity.component >= 0;
    return has_sign ? sample(0, 0) : size_of(sample);
}

}  // namespace voussoir::app::studies::converge
