#include "app/studies/verify/references/newmark_rebound.h"

#include <Eigen/Dense>
#include <cmath>

namespace voussoir::app::studies::verify::references
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{

/// M q'' + K q = f - spring (c.q) c while closed, q = (z, eps_z, eps_l) with z the centroid above its place at
/// touch.
struct LinearCube {
    Vector3d mass = Vector3d::Zero(), load = Vector3d::Zero(), gap = Vector3d::Zero();
    Matrix3d stiffness = Matrix3d::Zero();
};

LinearCube linear_cube(const DroppedCube& cube)
{
    const double volume = std::pow(cube.side, 3), mass = cube.density * volume;
    const double lambda = cube.young * cube.poisson / ((1 + cube.poisson) * (1 - 2 * cube.poisson));
    const double mu = cube.young / (2 * (1 + cube.poisson)), spread = mass * cube.side * cube.side / 12;
    LinearCube linear;
    linear.mass = {mass, spread, 2 * spread};
    linear.load = {-mass * cube.gravity, 0, 0};
    linear.gap = {1, -0.5 * cube.side, 0};
    linear.stiffness(1, 1) = volume * (lambda + 2 * mu);
    linear.stiffness(1, 2) = linear.stiffness(2, 1) = volume * 2 * lambda;
    linear.stiffness(2, 2) = volume * 4 * (lambda + mu);
    return linear;
}

/// q at the end of a step of h, with the contact in the state in which the step leaves it.
Vector3d step_end(const LinearCube& cube, double spring, const Vector3d& flight, double h, bool& closed)
{
    const Vector3d inertia = 2 / (h * h) * cube.mass;
    Vector3d end;
    for (int pass = 0; pass < 4; ++pass) {
        Matrix3d matrix = cube.stiffness;
        matrix.diagonal() += inertia;
        if (closed) matrix += spring * cube.gap * cube.gap.transpose();
        end = matrix.ldlt().solve(Vector3d(cube.load + inertia.cwiseProduct(flight)));
        const bool penetrates = cube.gap.dot(end) < 0;
        if (penetrates == closed) break;
        closed = penetrates;
    }
    return end;
}

}  // namespace

double newmark_loss(const DroppedCube& cube, double time_step)
{
    const LinearCube linear = linear_cube(cube);
    Vector3d q(cube.drop, 0, 0), v = Vector3d::Zero();
    bool closed = false, bounced = false;
    while (true) {
        const Vector3d end = step_end(linear, cube.stiffness, q + time_step * v, time_step, closed);
        const Vector3d speed = 2 / time_step * (end - q) - v;
        bounced = bounced || closed;
        if (bounced && !closed && v[0] > 0 && speed[0] <= 0)
            return 1 - (end[0] + speed[0] * speed[0] / (2 * cube.gravity)) / cube.drop;
        q = end;
        v = speed;
    }
}

}  // namespace voussoir::app::studies::verify::references
