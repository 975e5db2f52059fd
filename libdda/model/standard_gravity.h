// The one number for the standard acceleration of gravity.
#pragma once

namespace voussoir
{

/// Standard gravity, exact. Source: 3rd CGPM (1901), ISO 80000-3. [m/s2]
inline constexpr double standard_gravity = 9.80665;

}  // namespace voussoir
