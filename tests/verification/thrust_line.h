// Limit analysis of a symmetric half arch by its thrust line: the least and the greatest crown thrust.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voussoir::verification
{

/// A joint of the half arch x >= 0 with what lies between it and the crown.
struct HalfArchJoint {
    Eigen::Vector2d intrados, extrados;  // m, (x, z)
    double weight = 0;                   // N, of the stones from the crown to this joint
    double weight_arm = 0;               // m, x of their centre of gravity
};

struct ThrustRange {
    double least = 0, greatest = 0;  // N
    bool exists = false;
};

/// All thrusts H at heights z with a thrust line inside every joint. With m = H z the conditions "the moment about
/// the intrados is not negative, about the extrados not positive",
///   m - H z_P - W (x_P - x_W) >= 0 at P = intrados, <= 0 at P = extrados,
/// are linear in (H, m): the extremes are vertices of their polygon. Source: [Heyman1982], ch. 2.
inline ThrustRange thrust_range(const std::vector<HalfArchJoint>& joints)
{
    struct Constraint {
        double h, m, c;  // h H + m M >= c
    };
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
            bool inside = true;
            for (const Constraint& k : constraints) {
                const double scale = std::abs(k.h * thrust) + std::abs(moment) + std::abs(k.c);
                inside = inside && k.h * thrust + k.m * moment >= k.c - 1e-12 * scale;
            }
            if (!inside) continue;
            range.least = range.exists ? std::min(range.least, thrust) : thrust;
            range.greatest = range.exists ? std::max(range.greatest, thrust) : thrust;
            range.exists = true;
        }
    return range;
}

}  // namespace voussoir::verification
