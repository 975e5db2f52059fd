// Faces that press evenly: stacks that sway on them, and the couple that turns a stone on one.
#pragma once

#include <Eigen/Core>
#include <span>

namespace voussoir::app::studies::verify::references
{

/// A stack of equal rigid boxes on elastic joints, the lowest on the ground.
struct Stack {
    int stones = 1;
    double width = 1, height = 1;  // m, of a stone, along the way that it sways and upwards
    double density = 1;            // kg/m3
    double normal = 1, shear = 1;  // Pa/m, of the joints
};

/// Lowest frequency at which it sways [Hz]: two unknowns a stone, offset and rotation, on joints that resist shear
/// with the stiffness times their area and turning with that times b^2/12. Weight is left out.
double sway_frequency(const Stack& stack);

/// Rotation of a strip that carries a force at a distance from its middle, on springs all over it that do not pull
/// [rad]: 12 N e / (k b^3) to b/6, then 2 N / (9 k (b/2 - e)^2). @param force [N/m]; @param stiffness [Pa/m];
/// @param width b [m];
/// @param eccentricity e, below b/2 [m]
double rotation_under(double force, double stiffness, double width, double eccentricity);

/// Mean distance of the points of a convex polygon from its centroid, by triangles in polar coordinates [m]. Even
/// pressure resists a couple about it with mu N times this.
/// @param outline counter-clockwise, the centroid the origin [m]
double mean_distance(std::span<const Eigen::Vector2d> outline);

/// Second moment of the area about the origin / area, about the axis across the plane [m2].
double polar_moment(std::span<const Eigen::Vector2d> outline);

}  // namespace voussoir::app::studies::verify::references
