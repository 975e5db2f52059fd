// A block that falls flat on springs and bounces: its exact motion, without any loss.
#pragma once

namespace voussoir::app::studies::verify::references
{

/// A cube of constant strain (affine, St Venant-Kirchhoff) above a frictionless plane, springs under its corners.
struct DroppedCube {
    double side = 0;       // m
    double density = 0;    // kg/m3
    double young = 0;      // Pa
    double poisson = 0;    // -
    double stiffness = 0;  // N/m, of all springs together
    double drop = 0;       // m, of the lower face
    double gravity = 0;    // m/s2
};

struct Rebound {
    double height = 0;          // m, of the centroid's apex after the first bounce, above its place at contact
    double penetration = 0;     // m, largest, of the corners
    double centroid_depth = 0;  // m, lowest place of the centroid below that at first touch
};

/// Unknowns: centroid height, vertical and lateral stretch; contact opens and closes at located events. What the
/// bounce does not give back as height stays in the block as vibration. Integrated to `tolerance` per step.
Rebound first_rebound(const DroppedCube& cube, double tolerance = 1e-11);

/// Settled penetration of a block on springs, weight / stiffness [m].
double settled_penetration(const DroppedCube& cube);

}  // namespace voussoir::app::studies::verify::references
