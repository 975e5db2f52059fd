// Plane waves and layers at the end of a model: what dashpots reflect, and what soil on rock makes of a wave.
#pragma once

#include <complex>

namespace voussoir::app::studies::verify::references
{

/// Share of the energy of a plane wave that dashpots rho c_p and rho c_s on a plane face send back, its angle to
/// the normal being `angle` [rad]. Of an S wave the particles move in the plane of incidence.
/// @param speeds c_s / c_p. Source: [LysmerKuhlemeyer1969], a = b = 1
double reflected_energy(double angle, double speeds, bool pressure);

/// Motion of the surface of a layer on rock over that of a free surface of the rock, for a vertical S wave.
/// @param layer frequency x height / speed of the layer; @param impedance rho c of the layer / that of the rock
/// @param modulus, density of the layer at this frequency, times those without damping: 1 + 2 i ratio and 1 for
/// a ratio that is the same at all frequencies. Source: [Kramer1996], 7.2.1.4
std::complex<double> surface_over_outcrop(double layer, double impedance, std::complex<double> modulus,
                                          std::complex<double> density);

}  // namespace voussoir::app::studies::verify::references
