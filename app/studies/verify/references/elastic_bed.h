// A block on an elastic bed that does not pull: pressure stiffness x depth wherever it is closed.
#pragma once

namespace voussoir::app::studies::verify::references
{

/// What a bed gives back.
struct BedForce {
    double normal = 0;  // N
    double moment = 0;  // Nm, about the middle, against the rotation
};

/// A rectangular bed that turns about its middle line.
struct Bed {
    double stiffness = 1;  // Pa/m
    double width = 1;      // m, across the line
    double breadth = 1;    // m, along it
};

/// @param depth m, of the middle, > 0 closed; @param rotation rad
BedForce strip_force(const Bed& bed, double depth, double rotation);

/// The same of a square bed that turns about its diagonal. @param side m
BedForce diagonal_force(double stiffness, double side, double depth, double rotation);

/// Rotation of a square bed about its diagonal under a force beside its middle [rad], by bisection.
/// @param eccentricity m, across the diagonal, below half the other diagonal
double diagonal_rotation(double stiffness, double side, double force, double eccentricity);

/// Lean of the load of a block, horizontal over vertical force in its centroid, that brings the resultant to a
/// distance from the middle of its bed, measured along the block: e = h (lean + phi) + lean e phi, for the edge
/// that presses has sunk by e phi. @param height h, of the centroid [m]
double lean_under(double eccentricity, double rotation, double height);
/// The same solved for the eccentricity [m].
double eccentricity_under(double lean, double rotation, double height);

/// The largest lean at which a strip bed still has an equilibrium: the largest of lean_under() over the rotation,
/// e = b/2 - sqrt(2 N / (9 k phi)). @param force N per metre of breadth
double largest_lean(double stiffness, double width, double force, double height);

}  // namespace voussoir::app::studies::verify::references
