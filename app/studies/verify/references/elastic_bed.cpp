#include "app/studies/verify/references/elastic_bed.h"

#include <algorithm>
#include <cmath>

namespace voussoir::app::studies::verify::references
{

namespace
{

constexpr int halvings = 100;

/// Integral of a polynomial of at most third degree, by Simpson's rule.
template <class Function>
double integral(const Function& f, double from, double to)
{
    return (to - from) / 6 * (f(from) + 4 * f(0.5 * (from + to)) + f(to));
}

/// Where an increasing function passes through zero.
template <class Function>
double root_of(const Function& f, double low, double high)
{
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

BedForce strip_force(const Bed& bed, double depth, double rotation)
{
    const double half = 0.5 * bed.width, k = bed.stiffness * bed.breadth;
    const double least = depth - std::abs(rotation) * half, most = depth + std::abs(rotation) * half;
    if (most <= 0) return {};
    if (least >= 0) return {k * bed.width * depth, k * bed.width * bed.width * bed.width / 12 * rotation};
    // A triangle of pressure behind the deeper edge.
    const double closed = most / std::abs(rotation), normal = 0.5 * k * closed * most;
    return {normal, std::copysign(normal * (half - closed / 3), rotation)};
}

BedForce diagonal_force(double stiffness, double side, double depth, double rotation)
{
    const double tip = side / std::sqrt(2.0);
    BedForce force;
    // The width falls from the diagonal to both tips.
    const auto add = [&](double from, double to) {
        const double line = rotation == 0 ? from : -depth / rotation;
        if (rotation > 0) from = std::clamp(line, from, to);
        if (rotation < 0) to = std::clamp(line, from, to);
        const auto pressure = [&](double s) {
            return stiffness * (depth + rotation * s) * 2 * (tip - std::abs(s));
        };
        force.normal += integral(pressure, from, to);
        force.moment += integral([&](double s) { return pressure(s) * s; }, from, to);
    };
    add(-tip, 0);
    add(0, tip);
    return force;
}

double diagonal_rotation(double stiffness, double side, double force, double eccentricity)
{
    const double tip = side / std::sqrt(2.0), even = force / (stiffness * side * side);
    const auto eccentricity_of = [&](double rotation) {
        const auto lacks = [&](double depth) {
            return diagonal_force(stiffness, side, depth, rotation).normal - force;
        };
        const double depth = root_of(lacks, -rotation * tip, even + rotation * tip);
        return diagonal_force(stiffness, side, depth, rotation).moment / force;
    };
    double high = even / side;
    while (eccentricity_of(high) < eccentricity) high *= 2;
    return root_of([&](double rotation) { return eccentricity_of(rotation) - eccentricity; }, 0, high);
}

double lean_under(double eccentricity, double rotation, double height)
{
    return (eccentricity - height * rotation) / (height + eccentricity * rotation);
}

double eccentricity_under(double lean, double rotation, double height)
{
    return height * (lean + rotation) / (1 - lean * rotation);
}

double largest_lean(double stiffness, double width, double force, double height)
{
    const auto lean_at = [&](double rotation) {
        return lean_under(0.5 * width - std::sqrt(2 * force / (9 * stiffness * rotation)), rotation, height);
    };
    // There is one maximum.
    double low = 2 * force / (stiffness * width * width), high = width / height;
    constexpr double golden = 0.6180339887498949;
    for (int i = 0; i < halvings; ++i) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        (lean_at(left) < lean_at(right) ? low : high) = lean_at(left) < lean_at(right) ? left : right;
    }
    return lean_at(0.5 * (low + high));
}

}  // namespace voussoir::app::studies::verify::references
