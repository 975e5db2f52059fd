#include "app/studies/verify/references/rebound.h"

#include <algorithm>
#include <cmath>

#include "app/studies/verify/references/smooth_ode.h"

namespace voussoir::app::studies::verify::references
{

using Eigen::VectorXd;

namespace
{

/// y = (z, s_z, s_l) and its rate: height of the centroid above the plane, vertical and lateral stretch.
double gap_of(const DroppedCube& cube, const VectorXd& y)
{
    return y[0] - 0.5 * cube.side * y[1];
}

VectorXd rate_of(const DroppedCube& cube, const VectorXd& y, bool touching)
{
    const double volume = std::pow(cube.side, 3), mass = cube.density * volume;
    const double spread = mass * cube.side * cube.side / 12;
    const double lambda = cube.young * cube.poisson / ((1 + cube.poisson) * (1 - 2 * cube.poisson));
    const double mu = cube.young / (2 * (1 + cube.poisson));
    const double vertical = 0.5 * (y[1] * y[1] - 1), lateral = 0.5 * (y[2] * y[2] - 1);
    const double trace = vertical + 2 * lateral;
    const double push = touching ? -cube.stiffness * gap_of(cube, y) : 0;
    VectorXd rate(6);
    rate.head<3>() = y.tail<3>();
    rate[3] = push / mass - cube.gravity;
    rate[4] = (-volume * (lambda * trace + 2 * mu * vertical) * y[1] - 0.5 * cube.side * push) / spread;
    rate[5] = -volume * (lambda * trace + 2 * mu * lateral) * y[2] / spread;
    return rate;
}

}  // namespace

Rebound first_rebound(const DroppedCube& cube, double tolerance)
{
    Rebound rebound;
    OdePoint point;
    const double rest = 0.5 * cube.side;
    point.y = VectorXd::Zero(6);
    point.y << rest, 1, 1, -std::sqrt(2 * cube.gravity * cube.drop), 0, 0;
    const double step = 1e-4;  // s, of looking for the extremes
    bool touching = true;
    while (touching || point.y[3] <= 0 || gap_of(cube, point.y) < 0.05 * cube.side) {
        const Derivative f = [&](double, const VectorXd& y) { return rate_of(cube, y, touching); };
        const double side = touching ? -1 : 1;
        const Event change = [&](double, const VectorXd& y) { return side * gap_of(cube, y); };
        if (integrate(f, point.time + step, tolerance, change, point)) touching = !touching;
        rebound.penetration = std::max(rebound.penetration, -gap_of(cube, point.y));
        rebound.centroid_depth = std::max(rebound.centroid_depth, rest - point.y[0]);
    }
    // In flight the centroid knows gravity only.
    rebound.height = point.y[0] - rest + point.y[3] * point.y[3] / (2 * cube.gravity);
    return rebound;
}

double settled_penetration(const DroppedCube& cube)
{
    return cube.density * std::pow(cube.side, 3) * cube.gravity / cube.stiffness;
}

}  // namespace voussoir::app::studies::verify::references
