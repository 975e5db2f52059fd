#include "app/verify/picture.h"

#include <algorithm>
#include <utility>

namespace voussoir
{

Curve curve_of(const std::string& name, const std::vector<double>& x, const std::vector<double>& y,
               bool is_reference)
{
    constexpr std::size_t most_points = 400;  // more than the picture has room for
    const std::size_t stride = 1 + std::min(x.size(), y.size()) / most_points;
    Curve curve{name, {}, {}, is_reference};
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); i += stride) {
        curve.x.push_back(x[i]);
        curve.y.push_back(y[i]);
    }
    return curve;
}

Diagram linear_diagram(const std::string& x_title, const std::string& y_title, std::vector<Curve> curves)
{
    return {x_title, y_title, std::move(curves), {}, false};
}

}  // namespace voussoir
