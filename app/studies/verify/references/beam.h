// A straight elastic cantilever with shear.
#pragma once

namespace voussoir::app::studies::verify::references
{

/// A cantilever of rectangular section that is loaded along one side of it.
struct Cantilever {
    double length = 1;              // m
    double width = 1, breadth = 1;  // m, of the section: along the load and across it
    double density = 1;             // kg/m3
    double young = 1, poisson = 0;  // Pa, -

    double area() const { return width * breadth; }
    double bending_stiffness() const { return young * breadth * width * width * width / 12; }  // Nm2
    /// N; the shear stress is a parabola over the section.
    double shear_stiffness() const { return 5.0 / 6 * young / (2 * (1 + poisson)) * area(); }
};

/// Sag at a distance from the fixed end under its mass times an acceleration [m], by Timoshenko: w'' =
/// -M / EI, and the shear V / GA beside it. Source: docs/faces.md.
double sag_at(const Cantilever& beam, double acceleration, double distance);

/// Lowest frequency at which it bends [Hz], rotary inertia and shear counted: 200 elements of Timoshenko's beam,
/// lumped masses.
double sway_frequency(const Cantilever& beam);

/// Lowest frequency at which it twists [Hz]: torsion constant and polar moment of its section.
double twist_frequency(const Cantilever& beam);

}  // namespace voussoir::app::studies::verify::references
