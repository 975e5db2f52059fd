// A shear wave that meets a joint which slips.
#pragma once

namespace voussoir::app::studies::verify::references
{

/// What becomes of a sine's energy, as roots of its share.
struct SlipCoefficients {
    double transmitted = 0, reflected = 0, absorbed = 0;  // -, their squares add up to 1
};

/// Upward shear wave of velocity v(t) at a joint with friction between two half spaces of one material: both sides
/// radiate, so that the joint carries rho c v(t) while it sticks and its strength while it slips, which it does
/// when and only when rho c |v| exceeds the strength. What passes is v clipped at strength / (rho c), what returns
/// is the rest, and the joint takes strength x slip. Over whole cycles of a sine, with s = `strength_ratio` and
/// p = asin s: passed^2 = 4/pi {p/2 - sin(2p)/4 + s^2 (pi/2 - p)}, and so on.
/// @param strength_ratio strength of the joint / peak shear stress of the wave; 1 or more: it sticks
/// Source: [Miller1978], whose equivalent linear joint these energies do without
SlipCoefficients slip_coefficients(double strength_ratio);

}  // namespace voussoir::app::studies::verify::references
