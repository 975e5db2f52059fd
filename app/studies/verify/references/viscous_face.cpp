#include "app/studies/verify/references/viscous_face.h"

#include <cmath>
#include <numbers>

namespace voussoir::app::studies::verify::references
{

using Complex = std::complex<double>;

double reflected_energy(double angle, double speeds, bool pressure)
{
    // Angles of the P and the S wave to the normal; that of P is complex where S comes in too flat to make one.
    const double sin_s = pressure ? speeds * std::sin(angle) : std::sin(angle);
    const double sin_p = sin_s / speeds;
    const Complex cos_p = std::sqrt(Complex(1 - sin_p * sin_p));
    const double cos_s = std::sqrt(1 - sin_s * sin_s);
    // Stress minus dashpots along the normal (over rho c_p) and across it (over rho c_s) of the reflected waves.
    const Complex normal_p = -(1 - 2 * sin_s * sin_s) - cos_p, normal_s = 2 * speeds * sin_s * cos_s + sin_s;
    const Complex across_p = 2 * speeds * sin_p * cos_p + sin_p, across_s = cos_s * cos_s - sin_s * sin_s + cos_s;
    // The same of the wave that comes in, with the other sign. An S wave moves along (-sin, cos).
    const Complex normal = pressure ? (1 - 2 * sin_s * sin_s) - cos_p : -2 * speeds * sin_s * cos_s + sin_s;
    const Complex across = pressure ? 2 * speeds * sin_p * cos_p - sin_p : cos_s * cos_s - sin_s * sin_s - cos_s;
    const Complex determinant = normal_p * across_s - normal_s * across_p;
    const Complex p = (normal * across_s - normal_s * across) / determinant;
    const Complex s = (normal_p * across - normal * across_p) / determinant;
    const double flow_p = cos_p.real(), flow_s = speeds * cos_s;
    return (std::norm(p) * flow_p + std::norm(s) * flow_s) / (pressure ? flow_p : flow_s);
}

Complex surface_over_outcrop(double layer, double impedance, Complex modulus, Complex density)
{
    const Complex phase = 2 * std::numbers::pi * layer * std::sqrt(density / modulus);
    return 1.0 / (std::cos(phase) + Complex(0, 1) * impedance * std::sqrt(density * modulus) * std::sin(phase));
}

}  // namespace voussoir::app::studies::verify::references
