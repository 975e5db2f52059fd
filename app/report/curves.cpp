#include "app/report/curves.h"

#include <algorithm>

namespace voussoir::app::report
{

using plots::Curve;
using plots::Diagram;

constexpr std::size_t most_points = 2000;  // of a curve: more than a picture has columns

Curve thinned(const std::string& name, const std::vector<double>& x, const std::vector<double>& y, double unit)
{
    Curve curve;
    curve.name = name;
    const std::size_t count = std::min(x.size(), y.size()),
                      stretch = std::max<std::size_t>(1, 2 * count / most_points);
    for (std::size_t i = 0; i < count; i += stretch) {
        const auto first = y.begin() + static_cast<std::ptrdiff_t>(i),
                   end = y.begin() + static_cast<std::ptrdiff_t>(std::min(i + stretch, count));
        auto [low, high] = std::minmax_element(first, end);
        for (const auto& place : {std::min(low, high), std::max(low, high)}) {
            curve.x.push_back(x[static_cast<std::size_t>(place - y.begin())]);
            curve.y.push_back(*place / unit);
            if (low == high) break;
        }
    }
    return curve;
}

Diagram over_time(const std::string& y_title, std::vector<Curve> curves)
{
    Diagram diagram;
    diagram.x_title = "time [s]";
    diagram.y_title = y_title;
    diagram.curves = std::move(curves);
    diagram.logarithmic_x = diagram.logarithmic_y = diagram.marks = false;
    return diagram;
}

plots::Figure figure_of(const std::string& name, const std::string& title, std::vector<Diagram> diagrams)
{
    plots::Figure figure;
    figure.name = name;
    figure.title = title;
    figure.diagrams = std::move(diagrams);
    figure.stacked = !figure.diagrams.empty() && figure.diagrams[0].x_title == "time [s]";
    return figure;
}

}  // namespace voussoir::app::report
