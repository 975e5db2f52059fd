// The axes of the heat maps.
#pragma once

#include <array>

namespace voussoir::app::studies::stability
{

/// N/m per contact point.
inline constexpr std::array<double, 11> contact_stiffnesses{1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                                            1e10, 1e11, 1e12, 1e13, 1e14};

/// s.
inline constexpr std::array<double, 6> time_steps{1e-5, 1e-4, 1e-3, 5e-3, 1e-2, 2e-2};

/// s; three decades. What a cell is compared with takes a tenth of them.
inline constexpr std::array<double, 6> wall_time_steps{2e-5, 1e-4, 1e-3, 5e-3, 1e-2, 2e-2};

}  // namespace voussoir::app::studies::stability
