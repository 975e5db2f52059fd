#include "libdda/step/contact_step.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "libdda/model/parallel.h"
#include "libdda/step/turning.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

constexpr double least_sliding = 0.1;  // of the speed that friction takes in a step
// (omega h)^2 of the shear vibration of two stones, between which a step is about a quarter of its period: the
// joint turns round by its own spring. In shorter steps both are exact, in longer ones the joint is as good as
// rigid.
constexpr double spring_from = 1, spring_to = 4;
constexpr double touching = 16 * std::numeric_limits<double>::epsilon();  // of the distances that make a gap

template <class Vector>
Vector tangential(const Vector& v, const Vector& normal)
{
    return v - normal.dot(v) * normal;
}

/// Whether a point presses when the step begins. Faces that touch as drawn do so, or not, by rounding alone.
template <int D>
bool is_pressed(const ContactPointIn<D>& point, const PointStep<D>& p)
{
    return point.gap < -touching * (point.position.norm() + p.lever_a.norm() + p.lever_b.norm());
}

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
double friction_of(const PatchStep<K>& patch, const PointStep<K::dimension>& p)
{
    if (!patch.friction_law) return patch.friction;
    return patch.friction_factor *
           friction_coefficient(*patch.friction_law, tangential(p.displacement, patch.normal).norm() / patch.h);
}

template <class K>
void shear_force(double friction, FrictionBound rule, const PatchStep<K>& patch, PointStep<K::dimension>& p)
{
    using Vector = typename K::Vector;
    const Vector move = tangential(p.displacement, patch.normal);
    p.trial = p.shear_stiffness * (p.slip_start + 0.5 * (1 + p.shear_blend) * move);
    p.turns_round = false;
    if (patch.intact) {
        p.status = ContactStatus::locked;
        p.shear = p.trial;
        return;
    }
    if (rule == FrictionBound::exact) p.bound = friction * p.normal;
    if (p.speed > 0 && p.normal > 0 && p.heading.dot(move) < half_way(p, patch.h)) {
        turn_round(move, patch, p);
        return;
    }
    const double length = p.trial.norm();
    if (length <= p.bound) {
        p.status = p.normal > 0 ? ContactStatus::locked : ContactStatus::open;
        p.shear = p.trial;
    } else {
        p.status = p.normal > 0 ? ContactStatus::sliding : ContactStatus::open;
        p.shear = p.bound / length * p.trial;
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
            normal += 0.25 * (l_b - l_b.transpose()) * patch.normal;
        }
    }
};

/// Displacement and gap of a point, second order in the turning of both blocks. The forces' own measure of the
/// displacement leaves out terms that are small in the turning of a step, but not beside the yielding of a stiff
/// joint, whose gap would otherwise jump whenever contacts are found anew. In static steps they are left out:
/// those are long, the terms large in iterates on the way to the solution, and the potential not convex any more.
template <class K>
void move_point(const PatchMove<K>& move, const PatchStep<K>& patch, PointStep<K::dimension>& p)
{
    using Vector = typename K::Vector;
    Vector of_a = move.l_a * p.end_lever_a;
    if constexpr (!K::deformable) of_a += 0.5 * move.l_a * of_a;  // the rotation is done exactly
    const Vector apart = move.u_a + of_a - move.u_b;
    p.linear = p.predicted + move.u_a - move.u_b + move.l_a * p.lever_a - move.l_b * p.lever_b;
    if (!patch.follows_turning) {
        p.displacement = p.linear;
        p.gap = p.gap_start + patch.normal.dot(p.linear);
        return;
    }
    p.displacement = p.predicted + apart - move.l_b * (p.lever_b + 0.5 * apart) - 0.5 * patch.chord_b * apart;
    p.gap = p.gap_start + move.normal.dot(p.displacement);
}

template <class K>
void sum_forces(const std::vector<PointStep<K::dimension>>& points, PatchStep<K>& patch)
{
    patch.force_a.setZero();
    patch.force_b.setZero();
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const PointStep<K::dimension>& p = points[i];
        if (p.normal == 0 && p.shear.isZero(0)) continue;
        const typename K::Vector force = p.normal * patch.normal - p.shear;
        K::add_force(patch.force_a, p.lever_a, force);
        K::add_force(patch.force_b, p.lever_b, -force);
    }
}

/// How a point slides at the start of the step. One that hardly does sticks at once: of joints that tremble the
/// reversals decide nothing, and would keep the iteration busy.
template <class K>
void set_heading(const typename K::Vector& normal, const BlockStep<K>& a, const BlockStep<K>& b, double braking,
                 PointStep<K::dimension>& p)
{
    const auto velocity = [](const BlockStep<K>& block, const typename K::Vector& lever) {
        const typename K::Vector of_centroid = block.velocity.template head<K::dimension>();
        return block.rotation_held() ? of_centroid : typename K::Vector(of_centroid + block.spin_velocity(lever));
    };
    const typename K::Vector slip =
        tangential(typename K::Vector(velocity(a, p.lever_a) - velocity(b, p.lever_b)), normal);
    p.speed = slip.norm();
    if (p.speed < least_sliding * braking) p.speed = 0;
    if (p.speed > 0) p.heading = slip / p.speed;
    // A spring that unloads while the normal force falls moves against its own force: that is no sliding.
    if (p.speed > 0 && p.heading.dot(p.slip_start) <= 0) p.speed = 0;
}

/// What friction takes from the speed of two stones in the step, as if nothing else held them [m/s]. None where
/// the joint turns round by its own spring.
template <class K>
double braking_of(const ContactSetIn<K::dimension>& contacts, const ContactPatchIn<K::dimension>& found,
                  double shear_to_normal, const PatchStep<K>& patch, const BlockStep<K>& a, const BlockStep<K>& b)
{
    double pressing = 0, area = 0;
    for (int i = found.first_point; i < found.first_point + found.point_count; ++i) {
        const ContactPointIn<K::dimension>& point = contacts.points[i];
        if (point.gap >= 0) continue;
        pressing -= found.stiffness * point.area * point.gap;
        area += point.area;
    }
    const double mobility = (a.row < 0 ? 0 : 1 / a.mass) + (b.row < 0 ? 0 : 1 / b.mass);
    const double stiffness = shear_to_normal * found.stiffness * area * mobility * patch.h * patch.h;
    if (stiffness > spring_from && stiffness < spring_to) return 0;
    return patch.friction * pressing * mobility * patch.h;
}

/// A contact acts where it is in the middle of the step, on both blocks alike: then the work of its force on the
/// finite rotations and the angular momentum are those of the whole step to second order, and no moment is left
/// over. Of block b that is the material point which lies there then, not the one of the start.
/// Source: docs/method.md, "Rotation".
/// @param position of the contact at the start of the step [m]
template <class K>
void place_point(const typename K::Vector& position, const BlockStep<K>& a, const BlockStep<K>& b, double h,
                 PointStep<K::dimension>& p)
{
    using Vector = typename K::Vector;
    const Vector lever = position - a.start.centroid;
    const Vector turned = a.turns ? Vector(a.flow * lever) : lever;
    p.end_lever_a = turned;
    const Vector middle = 0.5 * (position + a.predicted.centroid + turned);
    p.lever_a = middle - 0.5 * (a.start.centroid + a.predicted.centroid);
    p.lever_b = middle - 0.5 * (b.start.centroid + b.predicted.centroid);
    const Vector chord_a = turned - lever, chord_b = b.chord * p.lever_b;
    p.predicted =
        a.predicted.centroid - a.start.centroid + chord_a - (b.predicted.centroid - b.start.centroid + chord_b);
    p.ballistic_a = a.turns ? Vector(h * a.spin_velocity(p.lever_a) - chord_a + a.ballistic) : a.ballistic;
    p.ballistic_b = b.turns ? Vector(h * b.spin_velocity(p.lever_b) - chord_b + b.ballistic) : b.ballistic;
}

}  // namespace

template <class K>
void begin_contacts(const Model& model, const Stage& stage, double h, const ContactSetIn<K::dimension>& contacts,
                    const std::vector<BlockStep<K>>& blocks, ContactStep<K>& step)
{
    using Vector = typename K::Vector;
    const double blend = end_share(stage);
    const bool looks_for_turning =
        stage.type == StageType::dynamic && stage.control.open_close == OpenClose::newton;
    step.patches.resize(contacts.patches.size());
    step.points.resize(contacts.points.size());
    for (std::size_t k = 0; k < contacts.patches.size(); ++k) {
        const ContactPatchIn<K::dimension>& found = contacts.patches[k];
        const JointMaterial& joint = model.joint_between(found.block_a, found.block_b);
        const BlockStep<K>& a = blocks[found.block_a];
        const BlockStep<K>& b = blocks[found.block_b];
        PatchStep<K>& patch = step.patches[k];
        patch.row_a = a.row;
        patch.row_b = b.row;
        patch.first = found.first_point;
        patch.count = found.point_count;
        patch.normal = b.turns ? typename K::Vector(b.half_rotation * found.normal) : found.normal;
        patch.friction_factor = model.friction_factor(found.block_a, found.block_b);
        patch.friction = patch.friction_factor * std::tan(joint.friction_angle);
        const bool has_speeds = stage.type == StageType::dynamic && !joint.friction_at_speed.empty();
        patch.friction_law = has_speeds ? &joint : nullptr;
        patch.h = h;
        patch.dashpot_over_h = joint.relaxation_time / h;
        patch.braking =
            looks_for_turning ? braking_of<K>(contacts, found, joint.shear_to_normal_stiffness, patch, a, b) : 0;
        patch.intact = found.intact;
        patch.chord_b = b.chord;
        patch.follows_turning = stage.type == StageType::dynamic;
        for (int i = found.first_point; i < found.first_point + found.point_count; ++i) {
            const ContactPointIn<K::dimension>& point = contacts.points[i];
            PointStep<K::dimension>& p = step.points[i];
            place_point<K>(point.position, a, b, h, p);
            p.slip_start = b.turns ? Vector(b.half_rotation * point.elastic_slip) : point.elastic_slip;
            p.gap_start = point.gap;
            p.normal_stiffness = found.stiffness * point.area;
            p.shear_stiffness = joint.shear_to_normal_stiffness * p.normal_stiffness;
            // A contact that was open or sliding keeps the end-of-step force: impacts and slips dissipate.
            const bool pressed = is_pressed(point, p);
            p.normal_blend = pressed || found.intact ? blend : 1;
            p.shear_blend = found.intact || (pressed && point.status == ContactStatus::locked) ? blend : 1;
            p.turns_round = false;
            p.speed = 0;
            if (patch.braking > 0 && point.gap < 0 && point.status == ContactStatus::sliding)
                set_heading(patch.normal, a, b, patch.braking, p);
            p.status = point.gap > 0 && !found.intact
                           ? ContactStatus::open
                           : (point.status == ContactStatus::open ? ContactStatus::locked : point.status);
            p.normal = p.bound = 0;
            p.trial = p.shear_stiffness * p.slip_start;
            p.shear = p.status == ContactStatus::sliding ? p.trial : Vector(Vector::Zero());
        }
    }
}

template <class K>
void scale_stiffness(double factor, ContactStep<K>& step)
{
    for (const PatchStep<K>& patch : step.patches)
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = step.points[i];
            p.normal_stiffness *= factor;
            p.shear_stiffness *= factor;
            p.slip_start /= factor;
            if (p.gap_start < 0 || patch.intact) p.gap_start /= factor;
        }
}

template <class K>
void evaluate_contacts(const VectorXd& d, FrictionBound bound, int threads, ContactStep<K>& step)
{
    in_parallel(step.patches.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            PatchStep<K>& patch = step.patches[k];
            const PatchMove<K> move(d, patch);
            for (int i = patch.first; i < patch.first + patch.count; ++i) {
                PointStep<K::dimension>& p = step.points[i];
                move_point(move, patch, p);
                normal_force(patch.intact, patch.dashpot_over_h, p.gap, p);
                shear_force(friction_of(patch, p), bound, patch, p);
            }
            sum_forces(step.points, patch);
        }
    });
}

template <class K>
void evaluate_published(const VectorXd& d, ContactStep<K>& step)
{
    using Vector = typename K::Vector;
    for (PatchStep<K>& patch : step.patches) {
        const PatchMove<K> move(d, patch);
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = step.points[i];
            move_point(move, patch, p);
            const bool closed = p.status != ContactStatus::open;
            // Blends other than one belong to the first guess of a Newton iteration.
            const double gap = 0.5 * (1 - p.normal_blend) * p.gap_start + 0.5 * (1 + p.normal_blend) * p.gap;
            p.elastic_normal = p.normal = closed ? -p.normal_stiffness * gap : 0;
            const Vector slip = 0.5 * (1 + p.shear_blend) * tangential(p.displacement, patch.normal);
            p.trial = p.shear_stiffness * (p.slip_start + slip);
            if (p.status == ContactStatus::locked) p.shear = p.trial;
            if (p.status == ContactStatus::open) p.shear.setZero();
        }
        sum_forces(step.points, patch);
    }
}

template <class K>
bool switch_published(ContactStep<K>& step)
{
    bool changed = false;
    for (PatchStep<K>& patch : step.patches)
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = step.points[i];
            const double length = p.trial.norm();
            const double bound = friction_of(patch, p) * std::max(p.normal, 0.0);
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

template <class K>
typename K::Vector slip_at_end(const PatchStep<K>& patch, const PointStep<K::dimension>& p)
{
    using Vector = typename K::Vector;
    if (p.turns_round) return slip_after_turning(patch, p);
    if (p.status == ContactStatus::locked) return p.slip_start + tangential(p.displacement, patch.normal);
    if (p.status == ContactStatus::open) return Vector::Zero();
    // Of a published step this is not p.shear, the load it was solved with, but the load of the pass to come.
    const Vector shear = p.bound / p.trial.norm() * p.trial;
    const double theta = p.shear_blend;
    return (shear / p.shear_stiffness - 0.5 * (1 - theta) * p.slip_start) * (2 / (1 + theta));
}

template <class K>
ContactEnergies contact_energies(const ContactStep<K>& step)
{
    ContactEnergies sum;
    for (const PatchStep<K>& patch : step.patches)
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            const PointStep<K::dimension>& p = step.points[i];
            const double depth_0 = patch.intact ? p.gap_start : std::min(p.gap_start, 0.0);
            const double depth_1 = patch.intact ? p.gap : std::min(p.gap, 0.0);
            const double normal_start = 0.5 * p.normal_stiffness * depth_0 * depth_0;
            const double normal_end = 0.5 * p.normal_stiffness * depth_1 * depth_1;
            const double closing = p.gap_start - p.gap;
            const typename K::Vector slip = slip_at_end(patch, p);
            const typename K::Vector elastic = slip - p.slip_start;
            const double shear_start = 0.5 * p.shear_stiffness * p.slip_start.squaredNorm();
            const double shear_end = 0.5 * p.shear_stiffness * slip.squaredNorm();
            sum.stored += normal_end + shear_end;
            sum.dashpot += (p.normal - p.elastic_normal) * closing;
            sum.friction += p.shear.dot(tangential(p.displacement, patch.normal) - elastic);
            sum.loss += p.elastic_normal * closing - (normal_end - normal_start);
            sum.loss += p.shear.dot(elastic) - (shear_end - shear_start);
        }
    return sum;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                         \
    template void begin_contacts(const Model&, const Stage&, double, const ContactSetIn<K::dimension>&, \
                                 const std::vector<BlockStep<K>>&, ContactStep<K>&);                    \
    template void scale_stiffness(double, ContactStep<K>&);                                             \
    template void evaluate_contacts(const VectorXd&, FrictionBound, int, ContactStep<K>&);              \
    template void evaluate_published(const VectorXd&, ContactStep<K>&);                                 \
    template bool switch_published(ContactStep<K>&);                                                    \
    template ContactEnergies contact_energies(const ContactStep<K>&);                                   \
    template K::Vector slip_at_end(const PatchStep<K>&, const PointStep<K::dimension>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
