// Colours in an order the eye reads as an order.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace voussoir::app::drawing
{

using Rgb = Eigen::Vector3f;  // 0 to 1 each

/// Viridis, perceptually uniform, readable without colour vision and in grey print. @param share 0 to 1, clamped
/// Source: [VanDerWaltSmith2015]; sixth-degree polynomials: [ZuckerColormaps].
Rgb viridis(float share);

/// A scale from `lowest` to `highest` with round ticks inside, in a unit that suits the size of the numbers.
struct ColorScale {
    double lowest = 0, highest = 1;  // SI
    std::string caption;             // "displacement [mm]"
    std::vector<double> ticks;       // SI
    std::vector<std::string> labels;

    /// Where a value lies, 0 to 1 inside the scale.
    float share(double value) const { return static_cast<float>((value - lowest) / (highest - lowest)); }
};

struct Unit {
    double size = 1;  // SI units in one of it
    const char* name = "";
};

inline const std::vector<Unit> length_units = {{1e-6, "µm"}, {1e-3, "mm"}, {1, "m"}};
inline const std::vector<Unit> speed_units = {{1e-6, "µm/s"}, {1e-3, "mm/s"}, {1, "m/s"}};
inline const std::vector<Unit> share_units = {{1, ""}};
inline const std::vector<Unit> strain_units = {{1e-6, "µm/m"}, {1e-3, "mm/m"}, {1, "1"}};
inline const std::vector<Unit> stress_units = {{1, "Pa"}, {1e3, "kPa"}, {1e6, "MPa"}};

/// @param units in ascending order; the largest one is taken in which the highest number is at least 1
ColorScale make_scale(double lowest, double highest, const std::string& quantity, const std::vector<Unit>& units);

}  // namespace voussoir::app::drawing
