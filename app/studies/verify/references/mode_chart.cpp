#include "app/studies/verify/references/mode_chart.h"

#include <cmath>
#include <initializer_list>

namespace voussoir::app::studies::verify::references
{

const char* name_of(Mode mode)
{
    switch (mode) {
        case Mode::stable:
            return "stable";
        case Mode::sliding:
            return "sliding";
        case Mode::toppling:
            return "toppling";
        case Mode::both:
            break;
    }
    return "sliding and toppling";
}

double dynamic_friction_angle(double psi, double delta)
{
    const double turn = 0.75 * std::sin(psi - delta);
    return std::atan2(std::sin(psi) - std::cos(delta) * turn, std::cos(psi) + std::sin(delta) * turn);
}

Mode mode_of(const ChartPoint& p)
{
    if (p.psi < p.delta && p.psi < p.phi) return Mode::stable;
    if (p.phi < p.delta) return Mode::sliding;
    return p.phi >= dynamic_friction_angle(p.psi, p.delta) ? Mode::toppling : Mode::both;
}

bool within_of_a_boundary(const ChartPoint& point, double angle)
{
    const Mode mode = mode_of(point);
    for (double ChartPoint::*which : {&ChartPoint::psi, &ChartPoint::delta, &ChartPoint::phi})
        for (const double change : {-1.0, -0.5, 0.5, 1.0}) {
            ChartPoint moved = point;
            moved.*which += change * angle;
            if (mode_of(moved) != mode) return true;
        }
    return false;
}

void first_accelerations(const ChartPoint& p, Mode mode, double& slip, double& turn)
{
    const double s = std::sin(p.delta), c = std::cos(p.delta), friction = std::tan(p.phi);
    slip = turn = 0;
    if (mode == Mode::sliding) slip = std::sin(p.psi) - std::cos(p.psi) * friction;
    if (mode == Mode::toppling) turn = 0.75 * std::sin(p.psi - p.delta);
    if (mode != Mode::both) return;
    // N = cos psi + s turn; turn / 3 = N (friction c - s); slip + c turn = sin psi - friction N, all per m g'.
    const double lever = 3 * (friction * c - s);
    turn = lever * std::cos(p.psi) / (1 - lever * s);
    slip = std::sin(p.psi) - friction * (std::cos(p.psi) + s * turn) - c * turn;
}

}  // namespace voussoir::app::studies::verify::references
