// Elastic rods and layers that vibrate: exact frequencies and amplitudes.
#pragma once

namespace voussoir::app::studies::verify::references
{

/// Lowest frequency [Hz] of a rod, one end held and one free, of n elements of constant strain with the mass that
/// belongs to them: omega^2 = 6 (c n / H)^2 (1 - cos t)/(2 + cos t), t = pi / (2 n). The mode is sin(j t) at the
/// nodes. The rod itself (n infinite) has c / (4 H); one element is 10 % above it.
/// @param speed c of waves along the rod [m/s]; @param height H of the rod [m]
double rod_frequency(int elements, double speed, double height);

/// Amplitude of the free surface of an elastic layer relative to its rigid base, over that of the base's motion,
/// when the base moves by a sine: damping of `rate` [1/s] times the mass and the velocity relative to the base.
/// With k^2 = (w^2 - i w rate)/c^2 the relative motion is w^2/(c^2 k^2) |1/cos(k H) - 1|.
/// @param speed c of shear waves [m/s]; @param height H of the layer [m]; @param frequency [Hz]
/// Source: [Kramer1996], 7.2.1, with damping by the mass instead of by the strain
double layer_amplitude(double speed, double height, double rate, double frequency);

}  // namespace voussoir::app::studies::verify::references
