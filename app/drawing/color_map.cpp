#include "app/drawing/color_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace voussoir::app::drawing
{

Rgb viridis(float share)
{
    static const std::array<Rgb, 7> coefficients = {
        Rgb(0.27772733F, 0.00540734F, 0.33409981F),   Rgb(0.10509304F, 1.40461353F, 1.38459016F),
        Rgb(-0.33086183F, 0.21484756F, 0.09509516F),  Rgb(-4.63423050F, -5.79910097F, -19.33244096F),
        Rgb(6.22826994F, 14.17993337F, 56.69055260F), Rgb(4.77638500F, -13.74514538F, -65.35303263F),
        Rgb(-5.43545586F, 4.64585261F, 26.31243525F),
    };
    const float t = std::clamp(share, 0.0F, 1.0F);
    Rgb color = Rgb::Zero();
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) color = color * t + *c;
    return color.cwiseMax(0.0F).cwiseMin(1.0F);
}

namespace
{

/// 1, 2 or 5 times a power of ten, so that about `count` steps fill the range.
double round_step(double range, int count)
{
    const double raw = range / count, power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= raw * 0.999) return factor * power;
    }
    return 10 * power;
}

}  // namespace

ColorScale make_scale(double lowest, double highest, const std::string& quantity, const std::vector<Unit>& units)
{
    ColorScale scale{lowest, highest, "", {}, {}};
    const double largest = std::max(std::abs(lowest), std::abs(highest));
    Unit unit = units.front();
    for (const Unit& candidate : units) {
        if (largest >= candidate.size) unit = candidate;
    }
    if (scale.highest - scale.lowest <= 1e-12 * largest || largest == 0) scale.highest = scale.lowest + unit.size;
    scale.caption = std::string(unit.name).empty() ? quantity : fmt::format("{} [{}]", quantity, unit.name);
    const double step = round_step((scale.highest - scale.lowest) / unit.size, 6);
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step * 1.001))));
    const double slack = 1e-9 * step;
    for (double i = std::ceil(scale.lowest / unit.size / step - slack);
         i * step <= scale.highest / unit.size + slack; ++i) {
        scale.ticks.push_back(i * step * unit.size);
        scale.labels.push_back(fmt::format("{:.{}f}", i == 0 ? 0.0 : i * step, decimals));
    }
    return scale;
}

}  // namespace voussoir::app::drawing
