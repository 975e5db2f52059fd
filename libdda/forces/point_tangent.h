// Tangent of the force of a contact point at the last evaluation.
#pragma once

#include "libdda/forces/contact_step.h"

namespace voussoir::step
{

/// C of one point, -dN/dg n n^T plus the shear tangent without the coupling to the normal force:
/// across n n^T + along (1 - n n^T) + ahead h h^T, h a direction in the plane of the contact.
template <int D>
struct PointTangent {
    double across = 0, along = 0, ahead = 0;  // N/m
    VectorIn<D> heading;                      // unit; of no meaning where `ahead` is zero
};

template <int D>
PointTangent<D> tangent_of(const PointStep<D>& p, bool published)
{
    const double k_t = 0.5 * (1 + p.shear_blend) * p.shear_stiffness;
    PointTangent<D> c;
    if (published) {
        if (p.status == ContactStatus::open) return c;
        c.across = 0.5 * (1 + p.normal_blend) * p.normal_stiffness;
        if (p.status == ContactStatus::locked) c.along = k_t;
        return c;
    }
    c.across = p.normal_tangent;
    if (p.turns_round) {
        c.along = p.tangent_across;
        c.ahead = p.tangent_along - p.tangent_across;
        c.heading = p.heading;
    } else if (p.status == ContactStatus::locked) {
        c.along = k_t;
    } else if (p.status == ContactStatus::sliding) {
        const double length = p.trial.norm();
        c.along = k_t * p.bound / length;
        c.ahead = -c.along;
        c.heading = p.trial / length;
    }
    return c;
}

}  // namespace voussoir::step
