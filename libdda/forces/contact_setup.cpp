// Contacts as they stand when a step begins: where they act, how they slide, which springs they have.
#include <algorithm>
#include <cmath>
#include <span>

#include "libdda/forces/contact_step.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{

namespace
{

constexpr double hardly = 0.01;        // of what presses a face: whether so little slides may be rounding
constexpr double least_sliding = 0.1;  // of the speed that friction takes in a step
// (omega h)^2 of the shear vibration of two stones, between which a step is about a quarter of its period: the
// joint turns round by its own spring. In shorter steps both are exact, in longer ones the joint is as good as
// rigid.
constexpr double spring_from = 1, spring_to = 4;

/// Whether a point presses when the step begins. Faces that touch as drawn do so, or not, by rounding alone.
template <class K>
bool is_pressed(const ContactPointIn<K::dimension>& point, const PatchStep<K>& patch,
                const PointStep<K::dimension>& p)
{
    return point.gap < 0 &&
           point.gap < -contact::gap_rounding * (point.position.norm() + p.lever.norm() + patch.lever_b(p).norm());
}

/// How a point slides at the start of the step. One that hardly does sticks at once: of joints that tremble the
/// reversals decide nothing, and would keep the iteration busy.
template <class K>
void set_heading(const PatchStep<K>& patch, const BlockStep<K>& a, const BlockStep<K>& b,
                 PointStep<K::dimension>& p)
{
    const auto velocity = [](const BlockStep<K>& block, const typename K::Vector& lever) {
        const typename K::Vector of_centroid = block.velocity.template head<K::dimension>();
        return block.rotation_held() ? of_centroid : typename K::Vector(of_centroid + block.spin_velocity(lever));
    };
    const typename K::Vector slip =
        tangential(typename K::Vector(velocity(a, p.lever) - velocity(b, patch.lever_b(p))), patch.normal);
    p.speed = slip.norm();
    if (p.speed < least_sliding * patch.braking) p.speed = 0;
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
    return patch.friction.at_rest * pressing * mobility * patch.h;
}

/// A contact acts where it is in the middle of the step, on both blocks alike: then the work of its force on the
/// finite rotations and the angular momentum are those of the whole step to second order, and no moment is left
/// over. Of block b that is the material point which lies there then, not the one of the start.
/// Source: docs/method.md, "Rotation".
/// @returns the matrix that takes a lever from block a at the start to that of the middle
template <class K>
typename K::Matrix place_patch(const BlockStep<K>& a, const BlockStep<K>& b, PatchStep<K>& patch)
{
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    const Vector way_a = a.predicted.centroid - a.start.centroid, way_b = b.predicted.centroid - b.start.centroid;
    patch.between = a.start.centroid - b.start.centroid + 0.5 * (way_a - way_b);
    patch.end_of_lever = Matrix::Identity() + 0.5 * a.chord;
    patch.chord_b = b.chord;
    patch.predicted = {way_a - way_b - b.chord * patch.between, a.chord - b.chord};
    return a.turns ? Matrix(0.5 * (Matrix::Identity() + a.flow)) : Matrix(Matrix::Identity());
}

/// How the stones beside a face are bent when the step begins.
template <class K>
void begin_stones(const Model& model, const ContactPatchIn<K::dimension>& found, const BlockStep<K>& a,
                  const BlockStep<K>& b, double blend, std::span<PointStep<K::dimension>> points,
                  PatchStep<K>& patch)
{
    constexpr int D = K::dimension;
    BentStones<D>& stones = patch.stones;
    stones = {};
    if (found.edge_edge) return;
    double stiffness = 0;
    for (const PointStep<D>& p : points) {
        stiffness += p.normal_stiffness;
        stones.centre += p.normal_stiffness * p.lever;
    }
    if (!(stiffness > 0)) return;
    stones.centre /= stiffness;
    const double area = stiffness / found.stiffness;
    const contact::HalfStone<D> of_a{found.block_a, a.half_rotation * a.start.map, a.row < 0},
        of_b{found.block_b, b.half_rotation * b.start.map, b.row < 0};
    stones.bending.flexibility = contact::bending_flexibility(model, of_a, of_b, patch.normal, area);
    stones.twist.flexibility(0, 0) = contact::twist_flexibility(model, of_a, of_b, patch.normal, area);
    stones.acts = stones.bending.flexibility.trace() > 0;
    if (!stones.acts) return;
    bool presses = found.intact;
    double pressing = 0, sliding = 0, stiffness_about_normal = 0;
    for (const PointStep<D>& p : points) {
        const VectorIn<D> place = p.lever - stones.centre;
        if constexpr (contact::twists<D>) {
            const VectorIn<D> around = patch.normal.cross(place);
            stones.twist.moment_start[0] += p.shear_stiffness * around.dot(p.slip_start);
            stiffness_about_normal += p.shear_stiffness * around.squaredNorm();
        }
        if (p.gap_start >= 0 && !found.intact) continue;
        presses = true;
        const double force = p.normal_stiffness * p.gap_start;
        pressing += std::abs(force);
        if (p.shear_blend != blend) sliding += std::abs(force);
        stones.bending.moment_start -= force * place;
    }
    stones.bending.begin(presses ? blend : 1);
    // Where stones twist, one blend for all points: else the couple at the end, by which they are twisted then, is
    // not that of the slips there, and each step begins with another energy than the one before had left.
    const bool twist = stones.twist.flexibility(0, 0) * stiffness_about_normal > contact::noticeable_twist;
    const double of_shear = presses && sliding <= hardly * pressing ? blend : 1;
    if (twist)
        for (PointStep<D>& p : points) p.shear_blend = of_shear;
    stones.twist.begin(of_shear);
    stones.energy_start = found.bending_energy;
}

}  // namespace

template <class K>
void begin_contacts(const Model& model, const Stage& stage, double h, const ContactSetIn<K::dimension>& contacts,
                    const std::vector<BlockStep<K>>& blocks, ContactStep<K>& step)
{
    using Vector = typename K::Vector;
    const double blend = end_share(stage);
    const bool looks_for_turning = stage.type == StageType::dynamic && !stage.control.is_published();
    step.patches.resize(contacts.patches.size());
    step.points.resize(contacts.points.size());
    const auto begin_patch = [&](std::size_t k) {
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
        patch.friction = friction_between(model, found.block_a, found.block_b, stage.type == StageType::dynamic);
        patch.h = h;
        patch.dashpot_over_h = joint.relaxation_time / h;
        patch.braking =
            looks_for_turning ? braking_of<K>(contacts, found, joint.shear_to_normal_stiffness, patch, a, b) : 0;
        patch.intact = found.intact;
        patch.follows_turning = stage.type == StageType::dynamic;
        const typename K::Matrix to_middle = place_patch(a, b, patch);
        for (int i = found.first_point; i < found.first_point + found.point_count; ++i) {
            const ContactPointIn<K::dimension>& point = contacts.points[i];
            PointStep<K::dimension>& p = step.points[i];
            p.lever = to_middle * (point.position - a.start.centroid);
            p.slip_start = b.turns ? Vector(b.half_rotation * point.elastic_slip) : point.elastic_slip;
            p.gap_start = point.gap;
            p.normal_stiffness = found.stiffness * point.area;
            p.shear_stiffness = joint.shear_to_normal_stiffness * p.normal_stiffness;
            // A contact that was open or sliding keeps the end-of-step force: impacts and slips dissipate.
            const bool pressed = is_pressed(point, patch, p);
            p.normal_blend = pressed || found.intact ? blend : 1;
            p.shear_blend = found.intact || (pressed && point.status == ContactStatus::locked) ? blend : 1;
            p.turns_round = false;
            p.speed = 0;
            if (patch.braking > 0 && point.gap < 0 && point.status == ContactStatus::sliding)
                set_heading(patch, a, b, p);
            p.status = point.gap > 0 && !found.intact
                           ? ContactStatus::open
                           : (point.status == ContactStatus::open ? ContactStatus::locked : point.status);
            p.normal = p.bound = 0;
            p.trial = p.shear_stiffness * p.slip_start;
            p.shear = p.status == ContactStatus::sliding ? p.trial : Vector(Vector::Zero());
        }
        if constexpr (K::deformable)
            begin_stones(model, found, a, b, blend, std::span(step.points).subspan(patch.first, patch.count),
                         patch);
    };
    in_parallel(contacts.patches.size(), stage.control.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) begin_patch(k);
    });
}

#define VOUSSOIR_INSTANTIATE(K)                                                                         \
    template void begin_contacts(const Model&, const Stage&, double, const ContactSetIn<K::dimension>&, \
                                 const std::vector<BlockStep<K>>&, ContactStep<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
