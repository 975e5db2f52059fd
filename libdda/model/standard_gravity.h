// The one number for the standard acceleration of gravity.
#pragma once

namespace voussoir
{

/// Standard gravity, exact. Source: [CGPM1901], [ISO80000-3-2019]. [m/s2]
inline constexpr double standard_gravity = 9.80665;

}  // namespace voussoir
