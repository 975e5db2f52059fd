#include "libdda/step/impulses.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace voussoir::step
{

namespace
{

constexpr int max_sweeps = 200;  // over the contacts that impulses have reached
// Of a blow that runs through a wall a hundredth is left after that many impulses a contact; the springs answer
// it.
constexpr std::size_t max_impulses = 60;      // at each contact, on the average
constexpr std::size_t so_few_contacts = 100;  // which may have more
constexpr double still = 1e-6;   // of the largest approach speed: a smaller change has not reached a block
constexpr double slight = 0.02;  // of the speed that a step at rest may gain: the same among many contacts
constexpr double unmoved = 0.5;  // of such a change: a point whose stones moved less need not act again

}  // namespace

template <class K>
Body<K> body_of(const Model& model, const State& state, int block)
{
    constexpr int D = K::dimension;
    Body<K> body;
    const PoseIn<D> pose = pose_in<D>(K::kinematics, state, block);
    const double* v = state.velocities.data() + block * K::unknowns;
    body.centroid = pose.centroid;
    body.velocity = typename K::Vector(v);
    const auto second = from_space<D>(model.mass_second(block));
    const typename K::Matrix spread = pose.map * second * pose.map.transpose();
    if constexpr (K::deformable)
        body.spin = spin_of<D>(
            spread, axial(typename K::Matrix(typename K::Matrix(v + D) * second * pose.map.transpose())));
    else
        for (int k = 0; k < body.spin.size(); ++k) body.spin[k] = v[D + k];
    body.inverse_mass.setConstant(1 / model.mass(block));
    body.inverse_inertia = inertia_tensor(spread).inverse();
    for (const Foundation& foundation : model.foundations) {
        if (foundation.block != block) continue;
        for (int k = 0; k < D; ++k)
            if (foundation.translation_held[axis_in_space<D>(k)]) body.inverse_mass[k] = 0;
        if (foundation.rotation_held) body.inverse_inertia.setZero();
    }
    body.start_velocity = body.velocity;
    body.start_spin = body.spin;
    body.size = size_of(model, block);
    return body;
}

template <class K>
int Impulses<K>::body(int block)
{
    if (body_of_[block] < 0) {
        body_of_[block] = static_cast<int>(bodies_.size());
        bodies_.push_back(body_of<K>(model_, state_, block));
        blocks_.push_back(block);
    }
    return body_of_[block];
}

template <class K>
Meeting<K> Impulses<K>::meeting(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point, double flight)
{
    Meeting<K> m;
    m.a = body(patch.block_a);
    m.b = body(patch.block_b);
    const Body<K>&a = bodies_[m.a], &b = bodies_[m.b];
    m.lever_a = point.position - a.centroid;
    m.lever_b = point.position - b.centroid + flight * (a.velocity_at(m.lever_a) - b.velocity);
    m.lever_a += flight * (a.velocity_at(m.lever_a) - a.velocity);
    m.normal = patch.normal;
    m.friction = model_.friction_factor(patch.block_a, patch.block_b) *
                 std::tan(model_.joint_between(patch.block_a, patch.block_b).friction_angle);
    m.bonded = patch.intact;
    const Vector velocity = relative_velocity(bodies_[m.a], bodies_[m.b], point.position);
    m.target = patch.normal.dot(velocity);
    m.target_slip.setZero();
    m.yielding = a.mobility(m.lever_a) + b.mobility(m.lever_b);
    m.parting = m.yielding * patch.normal;
    m.mobility = patch.normal.dot(m.parting);
    m.turning_a = a.turning(m.lever_a);
    m.turning_b = b.turning(m.lever_b);
    return m;
}

template <class K>
void Impulses<K>::add(const Meeting<K>& meeting)
{
    fastest_ = std::max(fastest_, meeting.approach);
    meetings_.push_back(meeting);
}

/// Lets the closed joints of a body that an impulse has reached take part: they are not closed any further, and a
/// bond is not opened either.
template <class K>
void Impulses<K>::reach(int index)
{
    if (bodies_[index].reached || bodies_[index].mobility(Vector::Zero(), Vector::Ones()) == 0) return;
    bodies_[index].reached = true;
    if (patches_of_.empty()) {
        patches_of_.resize(model_.blocks.size());
        takes_part_.assign(contacts_.patches.size(), 0);
        for (int k = 0; k < static_cast<int>(contacts_.patches.size()); ++k) {
            patches_of_[contacts_.patches[k].block_a].push_back(k);
            patches_of_[contacts_.patches[k].block_b].push_back(k);
        }
    }
    for (const int k : patches_of_[blocks_[index]]) {
        if (takes_part_[k]) continue;
        takes_part_[k] = 1;
        const ContactPatchIn<D>& patch = contacts_.patches[k];
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts_.points[i];
            if (point.gap >= 0 && !patch.intact) continue;
            Meeting<K> m = meeting(patch, point, 0);
            // As it was before the impulses.
            Body<K> a = bodies_[m.a], b = bodies_[m.b];
            a.velocity = a.start_velocity;
            a.spin = a.start_spin;
            b.velocity = b.start_velocity;
            b.spin = b.start_spin;
            const Vector velocity = relative_velocity(a, b, point.position);
            m.target = patch.normal.dot(velocity);
            // Friction opposes what slip there is, also that of a joint that slides already.
            if (patch.intact) m.target_slip = velocity - m.target * patch.normal;
            if (m.mobility > 0) meetings_.push_back(m);
        }
    }
}

/// A change of velocity that need not be passed on [m/s].
template <class K>
double Impulses<K>::negligible() const
{
    const double relative = still * fastest_;
    return meetings_.size() > so_few_contacts ? std::max(relative, slight * slow_) : relative;
}

/// Whether nothing worth an impulse has happened to the stones of a point since it last acted.
template <class K>
bool Impulses<K>::is_still(const Meeting<K>& m) const
{
    return std::max(bodies_[m.a].moved - m.seen_a, bodies_[m.b].moved - m.seen_b) <= unmoved * negligible();
}

/// One impulse at one point. @returns by how much it changed the velocity there [m/s]
template <class K>
double Impulses<K>::act(Meeting<K>& m)
{
    Body<K>&a = bodies_[m.a], &b = bodies_[m.b];
    const Vector velocity = a.velocity_at(m.lever_a) - b.velocity_at(m.lever_b);
    double press = (m.target - m.normal.dot(velocity)) / m.mobility;
    if (!m.bonded) press = std::max(press, -m.pressed);
    m.pressed += press;
    Vector slip = velocity + press * m.parting - m.target_slip;
    slip -= m.normal.dot(slip) * m.normal;
    const double square = slip.squaredNorm();
    Vector rub = Vector::Zero();
    double rubbed = 0;
    if (square > 0) {
        const double yielding = slip.dot(m.yielding * slip);  // times the square
        const Vector before = m.rubbed;
        if (yielding > 0) m.rubbed -= square / yielding * slip;
        const double bound = m.friction * m.pressed, size = m.rubbed.squaredNorm();
        if (!m.bonded && size > bound * bound) m.rubbed *= bound / std::sqrt(size);
        rub = m.rubbed - before;
        rubbed = rub.norm() * yielding / square;
    }
    // Its own impulse is not seen yet: friction turns a stone and so changes what presses the point.
    m.seen_a = a.moved;
    m.seen_b = b.moved;
    const Vector impulse = press * m.normal + rub;
    a.push(m.turning_a, impulse);
    b.push(m.turning_b, -impulse);
    return std::max(std::abs(press) * m.mobility, rubbed);
}

template <class K>
void Impulses<K>::solve()
{
    std::size_t impulses = 0;
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        double most = 0;
        // There and back, so that what is left of a symmetrical blow is nearly so.
        const std::size_t before = meetings_.size();
        for (std::size_t k = 0; k < meetings_.size(); ++k) {  // grows
            const std::size_t i = sweep % 2 == 1 && k < before ? before - 1 - k : k;
            if (is_still(meetings_[i])) continue;
            ++impulses;
            const double change = act(meetings_[i]);
            most = std::max(most, change);
            if (change <= negligible()) continue;
            const int a = meetings_[i].a, b = meetings_[i].b;
            reach(a);
            reach(b);
        }
        if (most <= negligible() || impulses > max_impulses * std::max(meetings_.size(), so_few_contacts)) return;
    }
}

#define VOUSSOIR_INSTANTIATE(K)                                \
    template Body<K> body_of(const Model&, const State&, int); \
    template class Impulses<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
