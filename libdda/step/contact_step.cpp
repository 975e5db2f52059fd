#include "libdda/step/contact_step.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

template <class Vector>
Vector tangential(const Vector& v, const Vector& normal)
{
    return v - normal.dot(v) * normal;
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

template <int D>
void shear_force(bool intact, double friction, FrictionBound rule, const VectorIn<D>& normal, PointStep<D>& p)
{
    const VectorIn<D> slip = p.slip_start + 0.5 * (1 + p.shear_blend) * tangential(p.displacement, normal);
    p.trial = p.shear_stiffness * slip;
    if (intact) {
        p.status = ContactStatus::locked;
        p.shear = p.trial;
        return;
    }
    if (rule == FrictionBound::exact) p.bound = friction * p.normal;
    const double length = p.trial.norm();
    if (length <= p.bound) {
        p.status = p.normal > 0 ? ContactStatus::locked : ContactStatus::open;
        p.shear = p.trial;
    } else {
        p.status = p.normal > 0 ? ContactStatus::sliding : ContactStatus::open;
        p.shear = p.bound / length * p.trial;
    }
}

template <class K>
typename K::Vector displacement_of(const VectorXd& d, int row, const typename K::Vector& lever)
{
    if (row < 0) return K::Vector::Zero();
    return K::displacement(d.segment<K::unknowns>(K::unknowns * row), lever);
}

template <class K>
void move_point(const VectorXd& d, const PatchStep<K>& patch, PointStep<K::dimension>& p)
{
    p.displacement = p.predicted + displacement_of<K>(d, patch.row_a, p.lever_a) -
                     displacement_of<K>(d, patch.row_b, p.lever_b);
    p.gap = p.gap_start + patch.normal.dot(p.displacement);
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

}  // namespace

template <class K>
void begin_contacts(const Model& model, const Stage& stage, double h, const ContactSetIn<K::dimension>& contacts,
                    const std::vector<BlockStep<K>>& blocks, ContactStep<K>& step)
{
    using Vector = typename K::Vector;
    const double blend = end_share(stage);
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
        patch.normal = found.normal;
        patch.friction_factor = model.friction_factor(found.block_a, found.block_b);
        patch.friction = patch.friction_factor * std::tan(joint.friction_angle);
        const bool has_speeds = stage.type == StageType::dynamic && !joint.friction_at_speed.empty();
        patch.friction_law = has_speeds ? &joint : nullptr;
        patch.h = h;
        patch.dashpot_over_h = joint.relaxation_time / h;
        patch.intact = found.intact;
        const typename K::Matrix back_a = a.start.map.inverse(), back_b = b.start.map.inverse();
        for (int i = found.first_point; i < found.first_point + found.point_count; ++i) {
            const ContactPointIn<K::dimension>& point = contacts.points[i];
            PointStep<K::dimension>& p = step.points[i];
            const Vector from_a = point.position - a.start.centroid, from_b = point.position - b.start.centroid;
            p.lever_a = a.predicted.map * (back_a * from_a);
            p.lever_b = b.predicted.map * (back_b * from_b);
            const Vector move_a = a.predicted.centroid - a.start.centroid + (p.lever_a - from_a);
            const Vector move_b = b.predicted.centroid - b.start.centroid + (p.lever_b - from_b);
            p.predicted = move_a - move_b;
            p.ballistic_a = a.rotation_held() ? Vector(Vector::Zero())
                                              : Vector(h * a.spin_velocity(p.lever_a) - (p.lever_a - from_a));
            p.ballistic_b = b.rotation_held() ? Vector(Vector::Zero())
                                              : Vector(h * b.spin_velocity(p.lever_b) - (p.lever_b - from_b));
            p.slip_start = point.elastic_slip;
            p.gap_start = point.gap;
            p.normal_stiffness = found.stiffness * point.area;
            p.shear_stiffness = joint.shear_to_normal_stiffness * p.normal_stiffness;
            // A contact that was open or sliding keeps the end-of-step force: impacts and slips dissipate.
            p.normal_blend = point.gap < 0 || found.intact ? blend : 1;
            p.shear_blend = found.intact || (point.gap < 0 && point.status == ContactStatus::locked) ? blend : 1;
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
void evaluate_contacts(const VectorXd& d, FrictionBound bound, int threads, ContactStep<K>& step)
{
    const int count = static_cast<int>(step.patches.size());
#pragma omp parallel for num_threads(threads) schedule(static) if (count > 256)
    for (int k = 0; k < count; ++k) {
        PatchStep<K>& patch = step.patches[k];
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = step.points[i];
            move_point(d, patch, p);
            normal_force(patch.intact, patch.dashpot_over_h, p.gap, p);
            shear_force<K::dimension>(patch.intact, friction_of(patch, p), bound, patch.normal, p);
        }
        sum_forces(step.points, patch);
    }
}

template <class K>
void evaluate_published(const VectorXd& d, ContactStep<K>& step)
{
    using Vector = typename K::Vector;
    for (PatchStep<K>& patch : step.patches) {
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            PointStep<K::dimension>& p = step.points[i];
            move_point(d, patch, p);
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

template <int D>
VectorIn<D> slip_at_end(const PointStep<D>& p, const VectorIn<D>& normal)
{
    if (p.status == ContactStatus::locked) return p.slip_start + tangential(p.displacement, normal);
    if (p.status == ContactStatus::open) return VectorIn<D>::Zero();
    // Of a published step this is not p.shear, the load it was solved with, but the load of the pass to come.
    const VectorIn<D> shear = p.bound / p.trial.norm() * p.trial;
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
            const typename K::Vector slip = slip_at_end<K::dimension>(p, patch.normal);
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
    template void evaluate_contacts(const VectorXd&, FrictionBound, int, ContactStep<K>&);              \
    template void evaluate_published(const VectorXd&, ContactStep<K>&);                                 \
    template bool switch_published(ContactStep<K>&);                                                    \
    template ContactEnergies contact_energies(const ContactStep<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

template VectorIn<3> slip_at_end(const PointStep<3>&, const VectorIn<3>&);
template VectorIn<2> slip_at_end(const PointStep<2>&, const VectorIn<2>&);

}  // namespace voussoir::step
