// A shear wave that climbs an elastic layer from a base with a given motion.
#pragma once

#include <functional>
#include <vector>

namespace voussoir::app::studies::verify::references
{

/// d'Alembert with a base of given motion and a free surface:
/// u(z, t) = sum_n (-1)^n [u0(t - (2 n H + z)/c) + u0(t - (2 (n+1) H - z)/c)].
/// @param base u0, zero before t = 0 [m]; @param height z above the base, depth H of the layer [m]
double shear_wave(const std::function<double(double)>& base, double speed, double layer, double height,
                  double time);

/// Modulus of layers of depth L and shear modulus G with a spring of stiffness k [Pa/m] in every joint, in series:
/// 1/G' = 1/G + 1/(k L). @returns G' [Pa]
double jointed_shear_modulus(double shear_modulus, double joint_stiffness, double depth);

/// Time by which `trace` lags `original` [s]: the shift of `original` that leaves the least sum of squares, found
/// to a hundredth of a sample by cubic interpolation. @param both sampled at multiples of `time_step`
double lag_of(const std::vector<double>& trace, const std::function<double(double)>& original, double time_step);

}  // namespace voussoir::app::studies::verify::references
