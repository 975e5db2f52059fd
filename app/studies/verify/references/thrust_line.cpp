#include "app/studies/verify/references/thrust_line.h"

#include <algorithm>
#include <cmath>

namespace voussoir::app::studies::verify::references
{
namespace
{

/// h H + m M >= c
struct Constraint {
    double h, m, c;
};

bool holds(const Constraint& constraint, double thrust, double moment)
{
    const double scale = std::abs(constraint.h * thrust) + std::abs(moment) + std::abs(constraint.c);
    return constraint.h * thrust + constraint.m * moment >= constraint.c - 1e-12 * scale;
}

}  // namespace

ThrustRange thrust_range(const std::vector<HalfArchJoint>& joints)
{
    std::vector<Constraint> constraints;
    for (const HalfArchJoint& j : joints) {
        constraints.push_back({-j.intrados.y(), 1, j.weight * (j.intrados.x() - j.weight_arm)});
        constraints.push_back({j.extrados.y(), -1, -j.weight * (j.extrados.x() - j.weight_arm)});
    }
    ThrustRange range;
    for (std::size_t p = 0; p < constraints.size(); ++p)
        for (std::size_t q = p + 1; q < constraints.size(); ++q) {
            const Constraint &a = constraints[p], &b = constraints[q];
            const double det = a.h * b.m - a.m * b.h;
            if (det == 0) continue;
            const double thrust = (a.c * b.m - a.m * b.c) / det, moment = (a.h * b.c - a.c * b.h) / det;
            if (!std::all_of(constraints.begin(), constraints.end(),
                             [&](const Constraint& c) { return holds(c, thrust, moment); }))
                continue;
            range.least = range.exists ? std::min(range.least, thrust) : thrust;
            range.greatest = range.exists ? std::max(range.greatest, thrust) : thrust;
            range.exists = true;
        }
    return range;
}

}  // namespace voussoir::app::studies::verify::references
