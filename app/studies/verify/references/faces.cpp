#include "app/studies/verify/references/faces.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace voussoir::app::studies::verify::references
{

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

double sway_frequency(const Stack& stack)
{
    const int unknowns = 2 * stack.stones;
    const double b = stack.width, half = 0.5 * stack.height;
    MatrixXd stiffness = MatrixXd::Zero(unknowns, unknowns);
    VectorXd masses(unknowns);
    for (int upper = 0; upper < unknowns; upper += 2) {
        // Of a slice of one metre: what the joint below a stone is sheared by, and turned by.
        VectorXd sheared = VectorXd::Zero(unknowns), turned = VectorXd::Zero(unknowns);
        sheared[upper] = 1;
        sheared[upper + 1] = -half;
        turned[upper + 1] = 1;
        if (upper > 0) {
            sheared[upper - 2] = -1;
            sheared[upper - 1] = -half;
            turned[upper - 1] = -1;
        }
        stiffness += b * stack.shear * sheared * sheared.transpose() +
                     b * b * b / 12 * stack.normal * turned * turned.transpose();
        const double mass = stack.density * b * stack.height;
        masses[upper] = mass;
        masses[upper + 1] = mass / 12 * (b * b + stack.height * stack.height);
    }
    const VectorXd scale = masses.cwiseSqrt().cwiseInverse();
    const MatrixXd scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
    return std::sqrt(solver.eigenvalues()[0]) / (2 * std::numbers::pi);
}

double rotation_under(double force, double stiffness, double width, double eccentricity)
{
    if (eccentricity <= width / 6) return 12 * force * eccentricity / (stiffness * width * width * width);
    const double to_edge = 0.5 * width - eccentricity;
    return 2 * force / (9 * stiffness * to_edge * to_edge);
}

double mean_distance(std::span<const Vector2d> outline)
{
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d &p = outline[i], &q = outline[(i + 1) % outline.size()];
        const Vector2d along = (q - p).normalized();
        const double height = p.x() * along.y() - p.y() * along.x();
        // Integral of r^2 dr over a ray, then of h sqrt(h^2 + s^2) / 3 along the side.
        const auto so_far = [&](double s) {
            return height / 6 * (s * std::hypot(s, height) + height * height * std::asinh(s / height));
        };
        sum += so_far(q.dot(along)) - so_far(p.dot(along));
        area += 0.5 * height * (q - p).norm();
    }
    return sum / area;
}

double polar_moment(std::span<const Vector2d> outline)
{
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d &p = outline[i], &q = outline[(i + 1) % outline.size()];
        const double triangle = 0.5 * (p.x() * q.y() - p.y() * q.x());
        sum += triangle / 6 * (p.squaredNorm() + p.dot(q) + q.squaredNorm());
        area += triangle;
    }
    return sum / area;
}

}  // namespace voussoir::app::studies::verify::references
