// What domes and vaults push against their supports, by their weight and geometry alone.
#pragma once

namespace voussoir::app::studies::verify::references
{

/// A spherical shell between two angles from its axis.
struct SphericalShell {
    double radius = 0, thickness = 0;  // m, of the intrados
    double oculus = 0, springing = 0;  // rad
    double unit_weight = 0;            // N/m3
};

/// Sum round the springing of the horizontal components of what the shell exerts on bearings that take no shear
/// [N]: the weight times the cotangent of the springing angle. In a thin shell that is the membrane force
/// N_phi = w R (cos oculus - cos phi) / sin^2 phi, w R / (1 + cos phi) when closed, times cos phi and 2 pi R sin
/// phi. Source: [TimoshenkoWoinowskyKrieger1959], ch. 14.
double dome_thrust(const SphericalShell& shell);

/// Thrust of a part of a vault that a plane of symmetry cuts at its crown, along the normal of the plane [N]:
/// moments about the point where the support's reaction acts.
/// @param weight of the part [N]; @param arm of the weight, horizontal, from that point [m];
/// @param rise of the crown's thrust above that point [m]
inline double crown_thrust(double weight, double arm, double rise)
{
    return weight * arm / rise;
}

}  // namespace voussoir::app::studies::verify::references
