#include "app/studies/verify/mode_chart_points.h"

#include <numbers>
#include <random>

namespace voussoir::app::studies::verify
{

namespace
{

constexpr double degrees = std::numbers::pi / 180;
constexpr double near = 1 * degrees, too_near = 0.05 * degrees;

/// The same numbers on every machine: the library's distributions are not.
double uniform(std::mt19937_64& random, double low, double high)
{
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

ChartCase draw(ChartKind kind, std::mt19937_64& random)
{
    const bool usual = uniform(random, 0, 1) < 0.8;
    const double other = uniform(random, 10, 45);
    ChartCase point;
    if (kind == ChartKind::gravitational) {
        point.alpha = uniform(random, 14, 50);
        point.chart = {point.alpha, uniform(random, 11, 50), usual ? 20 : other};
    } else {
        point.alpha = usual ? 10 : other;
        point.chart = {uniform(random, point.alpha, 75), uniform(random, 6, 70), uniform(random, 6, 80)};
    }
    point.alpha *= degrees;
    point.chart.psi *= degrees;
    point.chart.delta *= degrees;
    point.chart.phi *= degrees;
    return point;
}

}  // namespace

std::vector<ChartCase> chart_points(ChartKind kind, int count, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::vector<ChartCase> points;
    int wanted_near = (count + 1) / 2, wanted_far = count - wanted_near;
    while (wanted_near + wanted_far > 0) {
        const ChartCase point = draw(kind, random);
        if (references::within_of_a_boundary(point.chart, too_near)) continue;
        int& wanted = references::within_of_a_boundary(point.chart, near) ? wanted_near : wanted_far;
        if (wanted == 0) continue;
        --wanted;
        points.push_back(point);
    }
    return points;
}

}  // namespace voussoir::app::studies::verify
