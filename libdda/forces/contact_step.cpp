#include "libdda/forces/contact_step.h"

#include <algorithm>
#include <cmath>

#include "libdda/forces/point_tangent.h"
#include "libdda/forces/turning.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

/// Elastic normal force and its derivative by the gap, d <= 0. A blend of one is k <-g> at the end of the step;
/// else the discrete gradient of k <-g>^2 / 2 between the gaps of start and end, which conserves energy, takes the
/// share (1 - theta). Both fall with the gap: the step's potential stays convex.
template <int D>
void elastic_normal(const PointStep<D>& p, bool intact, double gap, double& force, double& slope)
{
    const double k = p.normal_stiffness, theta = p.normal_blend;
    if (intact) {
        force = -k * (0.5 * (1 - theta) * p.gap_start + 0.5 * (1 + theta) * gap);
        slope = -k * 0.5 * (1 + theta);
        return;
    }
    const double end = gap < 0 ? -k * gap : 0, end_slope = gap < 0 ? -k : 0;
    double mean = end, mean_slope = end_slope;
    if (theta < 1 && p.gap_start < 0) {
        if (gap < 0) {
            mean = -0.5 * k * (p.gap_start + gap);
            mean_slope = -0.5 * k;
        } else {
            const double reach = gap - p.gap_start;
            mean = 0.5 * k * p.gap_start * p.gap_start / reach;
            mean_slope = -mean / reach;
        }
    }
    force = (1 - theta) * mean + theta * end;
    slope = (1 - theta) * mean_slope + theta * end_slope;
}

/// Adds the dashpot: N = <-k (g + eta dg/dt)>, which never pulls. Before the gap closes the signed -k g counts, so
/// that the force starts at g = eta |dg/dt| and not wherever a contact was found.
template <int D>
void normal_force(bool intact, double dashpot_over_h, double gap, PointStep<D>& p)
{
    double slope = 0;
    elastic_normal(p, intact, gap, p.elastic_normal, slope);
    p.normal = p.elastic_normal;
    if (dashpot_over_h > 0) {
        const double c = p.normal_stiffness * dashpot_over_h;
        p.normal += c * (p.gap_start - gap);
        slope -= c;
        if (!intact && gap > 0) {
            p.normal -= p.normal_stiffness * gap;
            slope -= p.normal_stiffness;
        }
    }
    if (!intact && p.normal <= 0) {
        p.normal = 0;
        slope = 0;
    }
    p.normal_tangent = -slope;
}

/// Friction coefficient of a point. A speed-dependent one is taken at the mean tangential speed over the step, the
/// elastic shear of the joint included, which makes it second-order in the step.
template <class K>
double friction_of(const typename K::Vector& move, const PatchStep<K>& patch)
{
    if (!patch.friction.joint) return patch.friction.at_rest;
    return patch.friction.at(move.norm() / patch.h);
}

template <int D>
void release(PointStep<D>& p)
{
    p.bound = 0;
    p.shear.setZero();
    p.status = ContactStatus::open;
    p.turns_round = false;
}

/// @param move tangential displacement of the step [m]
template <class K>
void shear_force(const typename K::Vector& move, const PatchStep<K>& patch, PointStep<K::dimension>& p)
{
    p.trial = p.shear_stiffness * (p.slip_start + 0.5 * (1 + p.shear_blend) * move);
    p.turns_round = false;
    if (patch.intact) {
        p.status = ContactStatus::locked;
        p.shear = p.trial;
        return;
    }
    p.bound = friction_of(move, patch) * p.normal;
    const bool slides = p.speed > 0;
    if (slides && p.heading.dot(move) < half_way(p, patch.h)) {
        turn_round(move, patch, p);
        return;
    }
    const double square = p.trial.squaredNorm();
    // A joint that slides all through the step has all its friction, even where its spring would not give as much
    // yet: what presses it may have grown.
    if (square <= p.bound * p.bound && !slides) {
        p.status = p.normal > 0 ? ContactStatus::locked : ContactStatus::open;
        p.shear = p.trial;
    } else {
        p.status = p.normal > 0 ? ContactStatus::sliding : ContactStatus::open;
        p.shear = p.bound / std::sqrt(square) * p.trial;
    }
}

/// What the unknowns of the two blocks of a patch do to it.
template <class K>
struct PatchMove {
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    Vector u_a = Vector::Zero(), u_b = Vector::Zero();  // m
    Matrix l_a = Matrix::Zero(), l_b = Matrix::Zero();  // displacement gradients
    Vector normal;                                      // that of the middle of the whole step

    PatchMove(const VectorXd& d, const PatchStep<K>& patch) : normal(patch.normal)
    {
        constexpr int n = K::unknowns;
        if (patch.row_a >= 0) {
            const typename K::Unknowns of_a = d.segment<n>(n * patch.row_a);
            u_a = of_a.template head<K::dimension>();
            l_a = K::gradient(of_a);
        }
        if (patch.row_b >= 0) {
            const typename K::Unknowns of_b = d.segment<n>(n * patch.row_b);
            u_b = of_b.template head<K::dimension>();
            l_b = K::gradient(of_b);
            if (patch.follows_turning) normal += 0.25 * (l_b - l_b.transpose()) * patch.normal;
        }
    }
    /// As the forces measure it.
    LinearIn<K::dimension> first_order(const PatchStep<K>& patch) const
    {
        return {patch.predicted.at_centroid + u_a - u_b - l_b * patch.between, patch.predicted.slope + l_a - l_b};
    }
    /// To second order in the turning of both blocks: the terms that the forces' own measure leaves out are small
    /// in the turning of a step, but not beside the yielding of a stiff joint, whose gap would otherwise jump
    /// whenever contacts are found anew. In static steps they are left out: those are long, the terms large in
    /// iterates on the way to the solution, and the potential not convex any more.
    LinearIn<K::dimension> displacement(const PatchStep<K>& patch) const
    {
        if (!patch.follows_turning) return first_order(patch);
        Matrix of_a = l_a * patch.end_of_lever;
        if constexpr (!K::deformable) of_a += 0.5 * l_a * of_a;  // the rotation is done exactly
        const Vector apart = u_a - u_b;
        const Matrix kept = Matrix::Identity() - 0.5 * (l_b + patch.chord_b);
        return {patch.predicted.at_centroid + kept * apart - l_b * patch.between,
                patch.predicted.slope + kept * of_a - l_b};
    }
};

/// Moves a patch to the iterate. @returns how the gap of its points changes with their place [-]; the change at
/// the centroid of block a in `opening` [m]
template <class K>
typename K::Vector move_patch(const VectorXd& d, PatchStep<K>& patch, double& opening)
{
    const PatchMove<K> move(d, patch);
    patch.displacement = move.displacement(patch);
    opening = move.normal.dot(patch.displacement.at_centroid);
    return patch.displacement.slope.transpose() * move.normal;
}

/// Normal force of a point at its gap.
template <class K>
void press(const PatchStep<K>& patch, PointStep<K::dimension>& p)
{
    if (p.gap > 0 && p.gap_start > 0 && !patch.intact && patch.dashpot_over_h == 0)
        p.normal = p.elastic_normal = p.normal_tangent = 0;  // as most that are apart, for less
    else
        normal_force(patch.intact, patch.dashpot_over_h, p.gap, p);
}

/// Finds what the stones beside a face bend by as the face moves, and adds that to how its gap changes.
/// @param tilt [-], @param opening [m] of the stones as they are drawn
template <class K>
void bend_stones(PatchStep<K>& patch, std::vector<PointStep<K::dimension>>& points, typename K::Vector& tilt,
                 double& opening)
{
    using Vector = typename K::Vector;
    const Vector centre = patch.stones.centre;
    auto& bending = patch.stones.bending;
    const auto pressure = [&](const Vector& slope) {
        const Vector bent = slope - bending.turn_start, all = tilt + bent;
        const double at_centroid = opening - bent.dot(centre);
        contact::MomentOf<K::dimension> sum;
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = points[i];
            p.gap = p.gap_start + at_centroid + all.dot(p.lever);
            press(patch, p);
            if (p.normal_tangent != 0) sum.add(p.normal, p.normal_tangent, p.lever - centre);
        }
        return sum;
    };
    contact::balance_moment(bending.flexibility, bending.steady(), bending.end_weight(), pressure, bending.moment);
    tilt += bending.turn();
    opening -= bending.turn().dot(centre);
}

/// The same of twisting, for points that are pressed as they are.
template <class K>
void twist_stones(PatchStep<K>& patch, std::vector<PointStep<K::dimension>>& points)
{
    using Vector = typename K::Vector;
    auto& twist = patch.stones.twist;
    const auto friction = [&](const VectorIn<1>& turn) {
        const double back = turn[0] - twist.turn_start[0];
        contact::MomentOf<1> sum;
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = points[i];
            if (p.normal == 0 && !patch.intact) continue;
            const Vector around = patch.normal.cross(p.lever - patch.stones.centre);
            shear_force(Vector(tangential(patch.displacement.at(p.lever), patch.normal) - back * around), patch,
                        p);
            const PointTangent<K::dimension> c = tangent_of(p, false);
            const double ahead = c.ahead == 0 ? 0 : c.heading.dot(around);
            sum.add(p.shear.dot(around), c.along * around.squaredNorm() + c.ahead * ahead * ahead);
        }
        return sum;
    };
    contact::balance_moment(twist.flexibility, twist.steady(), twist.end_weight(), friction, twist.moment);
    const typename K::Matrix back = twist.turn()[0] * skew(patch.normal);
    patch.displacement.slope -= back;
    patch.displacement.at_centroid += back * patch.stones.centre;
}

/// Bends and twists the stones beside a face. @param tilt, @param opening of bend_stones()
template <class K>
void yield(PatchStep<K>& patch, std::vector<PointStep<K::dimension>>& points, typename K::Vector& tilt,
           double& opening)
{
    bend_stones(patch, points, tilt, opening);
    if constexpr (contact::twists<K::dimension>) twist_stones(patch, points);
}

/// Sums the forces of the points of a patch.
template <class K>
class ForceSum
{
 public:
    explicit ForceSum(const typename K::Vector& normal) : normal_(normal) {}
    void add(const PointStep<K::dimension>& p)
    {
        K::add_force(force_, p.lever, typename K::Vector(p.normal * normal_ - p.shear));
        pressing_ += std::abs(p.normal);
    }
    /// Block b feels the opposite, `between` away.
    void give(PatchStep<K>& patch) const
    {
        patch.pressing = pressing_;
        patch.force_a = force_;
        typename K::Unknowns shift = K::Unknowns::Zero();
        K::add_force(shift, patch.between, typename K::Vector(force_.template head<K::dimension>()));
        shift.template head<K::dimension>().setZero();
        patch.force_b = -force_ - shift;
    }

 private:
    typename K::Vector normal_;
    typename K::Unknowns force_ = K::Unknowns::Zero();
    double pressing_ = 0;  // N
};

}  // namespace

template <class K>
void evaluate_patch(const VectorXd& d, PatchStep<K>& patch, std::vector<PointStep<K::dimension>>& points)
{
    using Vector = typename K::Vector;
    double opening = 0;
    Vector tilt = move_patch(d, patch, opening);
    if constexpr (K::deformable)
        if (patch.stones.acts) yield(patch, points, tilt, opening);
    ForceSum<K> sum(patch.normal);
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        PointStep<K::dimension>& p = points[i];
        p.gap = p.gap_start + opening + tilt.dot(p.lever);
        press(patch, p);
        if (p.normal == 0 && !patch.intact) {
            release(p);
            continue;
        }
        shear_force(tangential(patch.displacement.at(p.lever), patch.normal), patch, p);
        sum.add(p);
    }
    sum.give(patch);
}

template <class K>
LinearIn<K::dimension> linear_displacement(const VectorXd& d, const PatchStep<K>& patch)
{
    return PatchMove<K>(d, patch).first_order(patch);
}

template <class K>
void evaluate_contacts(const VectorXd& d, int threads, ContactStep<K>& step)
{
    in_parallel(step.patches.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) evaluate_patch(d, step.patches[k], step.points);
    });
}

namespace
{

/// A patch whose points keep their states, at the iterate d.
template <class K>
void keep_states(const VectorXd& d, PatchStep<K>& patch, std::vector<PointStep<K::dimension>>& points)
{
    using Vector = typename K::Vector;
    double opening = 0;
    const Vector tilt = move_patch(d, patch, opening);
    ForceSum<K> sum(patch.normal);
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        PointStep<K::dimension>& p = points[i];
        p.gap = p.gap_start + opening + tilt.dot(p.lever);
        const bool closed = p.status != ContactStatus::open;
        // Blends other than one belong to the first guess of a Newton iteration.
        const double gap = 0.5 * (1 - p.normal_blend) * p.gap_start + 0.5 * (1 + p.normal_blend) * p.gap;
        p.elastic_normal = p.normal = closed ? -p.normal_stiffness * gap : 0;
        const Vector move = tangential(patch.displacement.at(p.lever), patch.normal);
        p.trial = p.shear_stiffness * (p.slip_start + 0.5 * (1 + p.shear_blend) * move);
        if (p.status == ContactStatus::locked) p.shear = p.trial;
        if (p.status == ContactStatus::open) p.shear.setZero();
        if (closed) sum.add(p);
    }
    sum.give(patch);
}

}  // namespace

template <class K>
void evaluate_published(const VectorXd& d, int threads, ContactStep<K>& step)
{
    in_parallel(step.patches.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) keep_states(d, step.patches[k], step.points);
    });
}

template <class K>
bool switch_published(ContactStep<K>& step)
{
    using Vector = typename K::Vector;
    bool changed = false;
    for (PatchStep<K>& patch : step.patches)
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = step.points[i];
            const double length = p.trial.norm();
            const Vector move = tangential(patch.displacement.at(p.lever), patch.normal);
            const double bound = friction_of(move, patch) * std::max(p.normal, 0.0);
            p.bound = bound;
            ContactStatus next = ContactStatus::open;
            if (p.gap < 0) next = length <= bound ? ContactStatus::locked : ContactStatus::sliding;
            if (p.status == ContactStatus::open && p.gap < 0) next = ContactStatus::locked;
            if (next != p.status) {
                if (next == ContactStatus::sliding)
                    p.shear = bound / length * p.trial;
                else
                    p.shear.setZero();
                changed = true;
            }
            p.status = next;
        }
    return changed;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                          \
    template void evaluate_contacts(const VectorXd&, int, ContactStep<K>&);                              \
    template void evaluate_patch(const VectorXd&, PatchStep<K>&, std::vector<PointStep<K::dimension>>&); \
    template void evaluate_published(const VectorXd&, int, ContactStep<K>&);                             \
    template LinearIn<K::dimension> linear_displacement(const VectorXd&, const PatchStep<K>&);           \
    template bool switch_published(ContactStep<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
