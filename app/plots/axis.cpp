#include "app/plots/axis.h"

#include <algorithm>
#include <cmath>

namespace voussoir::app::plots
{
namespace
{

std::vector<Tick> powers_of_ten(const Axis& axis)
{
    const int first = static_cast<int>(std::ceil(axis.low)), last = static_cast<int>(std::floor(axis.high));
    const int skip = last - first > 9 ? 2 : 1;
    std::vector<Tick> ticks;
    for (int power = first - 1; power <= last; ++power)
        for (int i = 1; i < 10; ++i) {
            const double value = i * std::pow(10.0, power), share = axis.share(value);
            if (share < 0 || share > 1) continue;
            ticks.push_back({value, i == 1 && (power - first) % skip == 0});
        }
    return ticks;
}

std::vector<Tick> round_numbers(const Axis& axis)
{
    constexpr double fewest = 4;
    const double range = axis.high - axis.low, power = std::pow(10.0, std::floor(std::log10(range / fewest)));
    const double rough = range / fewest / power, step = power * (rough >= 5 ? 5 : rough >= 2 ? 2 : 1);
    std::vector<Tick> ticks;
    const double first = std::ceil(axis.low / step);
    const int count = static_cast<int>(std::floor(axis.high / step) - first) + 1;
    for (int i = 0; i < count; ++i) ticks.push_back({(first + i) * step, true});
    return ticks;
}

}  // namespace

double Axis::share(double value) const
{
    return ((logarithmic ? std::log10(value) : value) - low) / (high - low);
}

Axis axis_for(const std::vector<double>& values, bool logarithmic)
{
    if (values.empty()) return {logarithmic, 0, 1};
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    constexpr double margin = 0.06;
    if (!logarithmic) {
        constexpr double rounding = 1e-12;
        const double size = std::max(std::abs(*most), std::abs(*least)), spread = *most - *least;
        const double range = spread > rounding * size ? spread : std::max(size, 1.0);
        return {false, *least - margin * range, *most + margin * range};
    }
    Axis axis{true, std::log10(*least), std::log10(*most)};
    const double room = margin * std::max(axis.high - axis.low, 1.0);
    axis.low -= room;
    axis.high += room;
    if (std::floor(axis.high) > std::ceil(axis.low)) return axis;
    return {true, std::floor(axis.low), std::ceil(axis.high)};
}

std::vector<Tick> ticks_of(const Axis& axis)
{
    return axis.logarithmic ? powers_of_ten(axis) : round_numbers(axis);
}

}  // namespace voussoir::app::plots
