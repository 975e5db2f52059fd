// A mass under a constant force, damped by a factor per step or by a rate.
#pragma once

namespace voussoir::app::studies::verify::references
{

/// Displacement after `steps` steps of h when the velocity is multiplied by k at the end of each:
/// u = sum_n (h v_n + a h^2 / 2), v_n = a h (k + k^2 + ... + k^n), summed in closed form. @returns [m]
/// @param acceleration force / mass [m/s2]; @param factor k [-]
double displacement_with_factor(double acceleration, double factor, double time_step, long steps);

/// Displacement of u'' = a - c u' from rest. @param rate c [1/s]
double displacement_with_rate(double acceleration, double rate, double time);

}  // namespace voussoir::app::studies::verify::references
