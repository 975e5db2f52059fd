#include "app/studies/verify/picture.h"

#include <algorithm>
#include <utility>

namespace voussoir::app::studies::verify
{

plots::Curve curve_of(const std::string& name, const std::vector<double>& x, const std::vector<double>& y,
                      bool is_reference)
{
    constexpr std::size_t max_points = 800;  // more than the picture has room for
    if (y.size() <= max_points) return {name, x, y, is_reference};
    plots::Curve curve{name, {}, {}, is_reference};
    const std::size_t bin = 1 + 2 * y.size() / max_points;
    for (std::size_t first = 0; first < y.size(); first += bin) {
        const auto begin = y.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = y.begin() + static_cast<std::ptrdiff_t>(std::min(first + bin, y.size()));
        const auto [least, most] = std::minmax_element(begin, end);
        for (const auto at : {std::min(least, most), std::max(least, most)}) {
            curve.x.push_back(x[at - y.begin()]);
            curve.y.push_back(*at);
        }
    }
    curve.x.push_back(x.back());
    curve.y.push_back(y.back());
    return curve;
}

plots::Diagram linear_diagram(const std::string& x_title, const std::string& y_title,
                              std::vector<plots::Curve> curves)
{
    return {x_title, y_title, std::move(curves), {}, false, false, false};
}

}  // namespace voussoir::app::studies::verify
