#include "libdda/forces/strength.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "libdda/geometry/polygon_moments.h"

namespace voussoir::step
{

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

constexpr double no_tension = 1e-3;  // of the cohesion

/// Most tensile normal stress of a corner [Pa, pressing positive]: N/A + bending, linear over the polygon.
template <class Patch>
double least_pressure(const Patch& patch, const std::vector<PointStep<3>>& points, const ContactSetIn<3>& contacts,
                      double area, const Vector3d& centre)
{
    // In-plane axes u, v. The corner springs are stiffer in bending than the area they stand for: only their
    // resultant counts.
    const Vector3d u = patch.normal.unitOrthogonal(), v = patch.normal.cross(u);
    std::vector<Vector2d> corners;
    Vector2d moment = Vector2d::Zero();
    double force = 0;
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const Vector3d lever = contacts.points[i].position - centre;
        const Vector2d place(u.dot(lever), v.dot(lever));
        if (!is_inner(contacts.points[i])) corners.push_back(place);
        force += points[i].normal;
        moment += points[i].normal * place;
    }
    const Vector2d bending =
        corners.size() < 3 ? Vector2d::Zero() : Vector2d(PolygonMoments(corners).second.inverse() * moment);
    double least = force / area;
    for (const Vector2d& corner : corners) least = std::min(least, force / area + bending.dot(corner));
    return least;
}

/// The same over a segment of length l: N/A -+ 6 M / (A l), M from the two ends.
template <class Patch>
double least_pressure(const Patch& patch, const std::vector<PointStep<2>>& points, const ContactSetIn<2>& contacts,
                      double area, const Vector2d& centre)
{
    double force = 0, moment = 0, half = 0;
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const double lever = patch.normal.x() * (contacts.points[i].position - centre).y() -
                             patch.normal.y() * (contacts.points[i].position - centre).x();
        force += points[i].normal;
        moment += points[i].normal * lever;
        half = std::max(half, std::abs(lever));
    }
    return force / area - (half > 0 ? 3 * std::abs(moment) / (area * half) : 0);
}

/// How far a patch is beyond its strength, as a ratio; <= 1 holds. The stress is linear over the patch,
/// N/A + (bending), and carries the resultant of the corner forces; shear is the mean against c + mu sigma.
template <class K>
double overload(const JointMaterial& joint, const PatchStep<K>& patch,
                const std::vector<PointStep<K::dimension>>& points, const ContactSetIn<K::dimension>& contacts)
{
    using Vector = typename K::Vector;
    double area = 0, force = 0;
    Vector centre = Vector::Zero(), shear = Vector::Zero();
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        area += contacts.points[i].area;
        centre += contacts.points[i].area * contacts.points[i].position;
        force += points[i].normal;
        shear += points[i].shear;
    }
    const double least = least_pressure(patch, points, contacts, area, Vector(centre / area));
    // A joint that has only cohesion breaks at the first tension; that of rounding and of forces which are
    // balanced to a tolerance is none.
    const double tensile_strength =
        joint.tensile_strength > 0 ? joint.tensile_strength : no_tension * joint.cohesion;
    const double tension = -least / std::max(tensile_strength, 1e-12);
    const double shear_strength = joint.cohesion + patch.friction.at_rest * force / area;
    const double sliding = shear.norm() / area / std::max(shear_strength, 1e-12);
    return std::max(tension, sliding);
}

/// What the open points of a joint that breaks had stored at the start of the step [J].
template <class K>
double tension_energy(const ContactStep<K>& contacts, int patch)
{
    const PatchStep<K>& broken = contacts.patches[patch];
    double energy = 0;
    for (int i = broken.first; i < broken.first + broken.count; ++i) {
        const double opening = std::max(contacts.points[i].gap_start, 0.0);
        energy += 0.5 * contacts.points[i].normal_stiffness * opening * opening;
    }
    return energy;
}

}  // namespace

template <class K>
std::optional<double> break_weakest_joint(const Model& model, const ContactSetIn<K::dimension>& contacts,
                                          ContactStep<K>& step)
{
    int weakest = -1;
    double most = 1;
    for (int k = 0; k < static_cast<int>(step.patches.size()); ++k) {
        if (!step.patches[k].intact) continue;
        const ContactPatchIn<K::dimension>& found = contacts.patches[k];
        const double ratio =
            overload(model.joint_between(found.block_a, found.block_b), step.patches[k], step.points, contacts);
        if (ratio <= most) continue;
        most = ratio;
        weakest = k;
    }
    if (weakest < 0) return std::nullopt;
    step.patches[weakest].intact = false;
    return tension_energy(step, weakest);
}

#define VOUSSOIR_INSTANTIATE(K)                                                                         \
    template std::optional<double> break_weakest_joint(const Model&, const ContactSetIn<K::dimension>&, \
                                                       ContactStep<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
