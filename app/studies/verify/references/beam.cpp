#include "app/studies/verify/references/beam.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace voussoir::app::studies::verify::references
{

using Eigen::Matrix4d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double sag_at(const Cantilever& beam, double acceleration, double distance)
{
    const double load = beam.density * beam.area() * acceleration, z = distance, l = beam.length;
    return load * z * z * (z * z - 4 * l * z + 6 * l * l) / (24 * beam.bending_stiffness()) +
           load * z * (l - 0.5 * z) / beam.shear_stiffness();
}

double sway_frequency(const Cantilever& beam)
{
    constexpr int elements = 200;
    const double h = beam.length / elements, ei = beam.bending_stiffness();
    const double phi = 12 * ei / (beam.shear_stiffness() * h * h);
    Matrix4d element;  // of w and slope at its two ends
    element << 12, 6 * h, -12, 6 * h, 6 * h, (4 + phi) * h * h, -6 * h, (2 - phi) * h * h, -12, -6 * h, 12, -6 * h,
        6 * h, (2 - phi) * h * h, -6 * h, (4 + phi) * h * h;
    element *= ei / ((1 + phi) * h * h * h);
    MatrixXd stiffness = MatrixXd::Zero(2 * elements + 2, 2 * elements + 2);
    VectorXd masses = VectorXd::Zero(2 * elements + 2);
    const double mass = beam.density * beam.area() * h;
    for (int e = 0; e < elements; ++e) {
        stiffness.block<4, 4>(2 * e, 2 * e) += element;
        for (const int node : {e, e + 1}) {
            masses[2 * node] += 0.5 * mass;
            masses[2 * node + 1] += 0.5 * mass * beam.width * beam.width / 12;
        }
    }
    const VectorXd scale = masses.tail(2 * elements).cwiseSqrt().cwiseInverse();
    const MatrixXd scaled =
        scale.asDiagonal() * stiffness.bottomRightCorner(2 * elements, 2 * elements) * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
    return std::sqrt(solver.eigenvalues()[0]) / (2 * std::numbers::pi);
}

double twist_frequency(const Cantilever& beam)
{
    const double a = std::max(beam.width, beam.breadth), b = std::min(beam.width, beam.breadth);
    double series = 0;  // Saint-Venant
    for (int n = 1; n < 200; n += 2) series += std::tanh(n * std::numbers::pi * a / (2 * b)) / std::pow(n, 5);
    const double constant = a * b * b * b * (1.0 / 3 - 64 / std::pow(std::numbers::pi, 5) * b / a * series);
    const double polar = a * b * (a * a + b * b) / 12;
    const double shear = beam.young / (2 * (1 + beam.poisson));
    return std::sqrt(shear * constant / (beam.density * polar)) / (4 * beam.length);
}

}  // namespace voussoir::app::studies::verify::references
