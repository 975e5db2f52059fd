// Contact forces within one step: normal and shear springs with Coulomb friction, and their energies.
// Source: docs/numerics.md 2.4.
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <vector>

#include "libdda/block/block_step.h"
#include "libdda/contact/find_contacts.h"
#include "libdda/contact/stone_bending.h"
#include "libdda/model/friction_law.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{

/// A vector that is linear over a contact, at a lever from the centroid of its block a.
template <int D>
struct LinearIn {
    VectorIn<D> at_centroid = VectorIn<D>::Zero();
    MatrixIn<D> slope = MatrixIn<D>::Zero();

    VectorIn<D> at(const VectorIn<D>& lever) const { return at_centroid + slope * lever; }
};

/// A contact point within a step. Displacements are of a relative to b. What is linear over the patch is there.
template <int D>
struct PointStep {
    VectorIn<D> lever;                                 // m, from a, of the contact in the middle of the step
    VectorIn<D> slip_start;                            // m, elastic slip, turned to the middle of the step
    double gap_start = 0;                              // m
    double normal_stiffness = 0, shear_stiffness = 0;  // N/m
    double normal_blend = 1, shear_blend = 1;          // theta of the integrator
    double speed = 0;                                  // m/s, of the sliding at the start; 0: it does not slide
    VectorIn<D> heading;                               // unit, of that
    // At the current iterate:
    double gap = 0, normal = 0, elastic_normal = 0, normal_tangent = 0;  // m, N, N, N/m
    double bound = 0;                                                    // N, friction bound
    VectorIn<D> trial;                                                   // N, shear force if it all stuck
    VectorIn<D> shear;                                                   // N, resisting
    double tangent_along = 0, tangent_across = 0;  // N/m, of the shear force if it turns round
    ContactStatus status = ContactStatus::open;
    bool turns_round = false;  // the sliding of the start ends within the step
};

/// A turn of the half stones beside a face under a moment of its forces, in a step.
template <int N>
struct YieldIn {
    MatrixIn<N> flexibility = MatrixIn<N>::Zero();   // 1/(Nm)
    VectorIn<N> moment_start = VectorIn<N>::Zero();  // Nm
    VectorIn<N> turn_start = VectorIn<N>::Zero();    // rad
    double blend = 1;                                // theta of the integrator
    VectorIn<N> moment = VectorIn<N>::Zero();        // Nm, at the end of the step, at the current iterate

    double end_weight() const { return 0.5 * (1 + blend); }  // of the moment at the end, in that of the step
    VectorIn<N> steady() const { return 0.5 * (1 - blend) * moment_start; }
    VectorIn<N> turn() const { return flexibility * moment - turn_start; }          // rad, of the step
    double energy() const { return 0.5 * moment.dot(flexibility * moment); }        // J, at the end of the step
    double work() const { return (steady() + end_weight() * moment).dot(turn()); }  // J, done on the stones
    void begin(double theta)
    {
        blend = theta;
        moment = moment_start;
        turn_start = flexibility * moment_start;
    }
};

/// How the stones beside a face bend and twist. Source: docs/faces.md.
template <int D>
struct BentStones {
    bool acts = false;                         // else all of it is zero
    VectorIn<D> centre = VectorIn<D>::Zero();  // m, of the area, from a, in the middle of the step
    YieldIn<D> bending;                        // slope of the gap
    YieldIn<1> twist;                          // about the normal
    double energy_start = 0;                   // J

    double work() const { return bending.work() + twist.work(); }  // J, done on them
};
struct StiffStones {
};

template <class K>
struct PatchStep {
    using Vector = typename K::Vector;
    using Linear = LinearIn<K::dimension>;
    int row_a = -1, row_b = -1;
    int first = 0, count = 0;
    Vector normal;  // in the middle of the predicted step
    FrictionLaw friction;
    double h = 0;               // s, the step
    double braking = 0;         // m/s, what friction takes from the stones' speed in the step
    double dashpot_over_h = 0;  // -
    bool intact = false;
    bool follows_turning = true;      // gaps and slips to second order in the turning of the step
    Vector between = Vector::Zero();  // m, from the centroid of b to that of a: lever from b less that from a
    typename K::Matrix end_of_lever;  // to that of the material point of a at the end, if D = 0
    typename K::Matrix chord_b;       // of block b
    Linear predicted;                 // m, relative displacement of the step if D = 0
    // At the current iterate:
    Linear displacement;                    // m, relative, of the step; as the stones twist
    double pressing = 0;                    // N, of all points
    typename K::Unknowns force_a, force_b;  // generalised forces on the two blocks
    typename K::Square aa, ab, bb;          // stiffness
    [[no_unique_address]] std::conditional_t<K::deformable, BentStones<K::dimension>, StiffStones> stones;

    Vector lever_b(const PointStep<K::dimension>& p) const { return p.lever + between; }
};

/// All contacts of a step.
template <class K>
struct ContactStep {
    std::vector<PatchStep<K>> patches;
    std::vector<PointStep<K::dimension>> points;
};

/// What of a vector lies in the plane of a contact.
template <class Vector>
Vector tangential(const Vector& v, const Vector& normal)
{
    return v - normal.dot(v) * normal;
}

/// @param contacts with the gaps and slips at the start of the step
template <class K>
void begin_contacts(const Model& model, const Stage& stage, double h, const ContactSetIn<K::dimension>& contacts,
                    const std::vector<BlockStep<K>>& blocks, ContactStep<K>& step);

/// Forces at the iterate D (rows x unknowns), point by point and summed per patch.
template <class K>
void evaluate_contacts(const Eigen::VectorXd& d, int threads, ContactStep<K>& step);

/// The same of one patch.
template <class K>
void evaluate_patch(const Eigen::VectorXd& d, PatchStep<K>& patch, std::vector<PointStep<K::dimension>>& points);

/// Displacement of the step at the iterate D as the forces measure it, which leaves out what is of second order.
template <class K>
LinearIn<K::dimension> linear_displacement(const Eigen::VectorXd& d, const PatchStep<K>& patch);

/// The same by the published open-close rules: every point keeps its status; a sliding point carries the friction
/// of the pass before as a load.
template <class K>
void evaluate_published(const Eigen::VectorXd& d, int threads, ContactStep<K>& step);

/// New states of all points by the published rules. @returns whether any changed
template <class K>
bool switch_published(ContactStep<K>& step);

/// Contact terms of the energy audit of an accepted step.
struct ContactEnergies {
    double stored = 0, friction = 0, dashpot = 0, loss = 0, closing = 0;
};
template <class K>
ContactEnergies contact_energies(int threads, const ContactStep<K>& step);

/// Calls `add(part(index of the patch))` for all patches in their order; `part` is called on all threads.
template <class K, class PartOf, class Add>
void add_patches_in_order(const ContactStep<K>& step, int threads, const PartOf& part, const Add& add)
{
    const std::size_t count = step.patches.size();
    if (threads <= 1) {
        for (std::size_t k = 0; k < count; ++k) add(part(k));
        return;
    }
    std::vector<decltype(part(count))> parts(count);
    in_parallel(count, threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) parts[k] = part(k);
    });
    for (const auto& of_patch : parts) add(of_patch);
}

/// What the stones beside a face have stored at the end of a step [J]: of the twisting by the couple of the slips
/// there, from which the next step begins. Where points slide or open within the step its own couple is another.
template <class K>
double energy_of_stones(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points);

/// Elastic slip at the end of the step [m]: of a blend theta, t = (1-theta)/2 k s0 + (1+theta)/2 k s1.
template <class K>
typename K::Vector slip_at_end(const PatchStep<K>& patch, const PointStep<K::dimension>& point);

}  // namespace voussoir::step
