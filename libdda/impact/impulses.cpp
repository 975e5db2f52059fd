#include "libdda/impact/impulses.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "libdda/block/held_components.h"

namespace voussoir::step
{

namespace
{

constexpr int max_sweeps = 2000;  // over the contacts that impulses have reached
// What is left of a blow then is answered by the springs: of one that runs through a whole house a third to a half
// of what impulses could take (numerics.md 4).
constexpr std::size_t max_impulses = 40;     // at each contact, on the average
constexpr std::size_t few_impulses = 20000;  // in all: few contacts may have more
// Of what would stop the slip at a point: with the whole of it a stone that slides on some goes round in circles.
constexpr double cautious = 0.7;
constexpr double settled = 0.1;  // of what is negligible: changes that sweeps go on making add up
constexpr double slight = 0.02;  // of the speed that a step at rest may gain: the same among many contacts
constexpr double unmoved = 0.5;  // of such a change: a point whose stones moved less need not act again

/// The share of a friction impulse that a bound leaves.
template <class Vector>
double share_within(double bound, const Vector& rubbed)
{
    const double square = rubbed.squaredNorm();
    return square > bound * bound ? bound / std::sqrt(square) : 1;
}

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
    const HeldComponents<K> components = held_components<K>(model, block);
    for (int k = 0; k < D; ++k) body.inverse_mass[k] = components.held[k] ? 0 : 1 / model.mass(block);
    body.spin.setZero();
    body.inverse_inertia.setZero();
    if (components.turns()) {
        const auto second = from_space<D>(model.mass_second(block));
        const typename K::Matrix spread = pose.map * second * pose.map.transpose();
        if constexpr (K::deformable)
            body.spin = spin_of<D>(
                spread, axial(typename K::Matrix(typename K::Matrix(v + D) * second * pose.map.transpose())));
        else
            for (int k = 0; k < body.spin.size(); ++k) body.spin[k] = v[D + k];
        body.inverse_inertia = inertia_tensor(spread).inverse();
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
Meeting<K> Impulses<K>::meeting(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point, double time)
{
    Meeting<K> m;
    m.a = body(patch.block_a);
    m.b = body(patch.block_b);
    const Body<K>&a = bodies_[m.a], &b = bodies_[m.b];
    const Vector from_a = point.position - a.centroid, from_b = point.position - b.centroid;
    const Vector flown = a.path(from_a, time), centre = Vector::Zero();
    const Vector lever_a = from_a + flown - a.path(centre, time), lever_b = from_b + flown - b.path(centre, time);
    m.arm_a = arm_at<K>(lever_a);
    m.arm_b = arm_at<K>(lever_b);
    m.normal = patch.normal;
    m.law = friction_between(model_, patch.block_a, patch.block_b, true);
    m.friction = m.law.at_rest;
    m.bonded = patch.intact;
    const Vector velocity = start_velocity(a, b, point.position);
    const double parting = patch.normal.dot(velocity);
    m.start_slip = velocity - parting * patch.normal;
    m.target_slip.setZero();
    // A joint is not closed any further, and one that opens may be stopped: what kept it opening would add energy,
    // while impulses that bring velocities into a convex set with rest in it cannot.
    m.target = std::min(parting, 0.0);
    // Friction opposes what slip there is, also that of a joint that slides already; a bond is not changed.
    if (patch.intact) {
        m.target = parting;
        m.target_slip = m.start_slip;
    }
    m.yielding = a.mobility(lever_a) + b.mobility(lever_b);
    m.parting = m.yielding * patch.normal;
    m.mobility = patch.normal.dot(m.parting);
    m.inertia = m.mobility > 0 ? 1 / m.mobility : 0;
    m.turning_a = a.turning(lever_a);
    m.turning_b = b.turning(lever_b);
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
        for (int i = patch.first_point, behind = end_of_corners(contacts_, patch); i < behind; ++i) {
            const ContactPointIn<D>& point = contacts_.points[i];
            if (!is_closed(patch, point)) continue;
            const Meeting<K> m = meeting(patch, point, last_blow(patch));
            if (m.mobility > 0) meetings_.push_back(m);
        }
    }
}

/// When the later of the bodies of a patch was struck last, in this step [s]
template <class K>
double Impulses<K>::last_blow(const ContactPatchIn<D>& patch)
{
    const int a = body(patch.block_a), b = body(patch.block_b);
    return std::max(bodies_[a].since, bodies_[b].since);
}

template <class K>
double Impulses<K>::gap_of(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point, double time)
{
    const int in_a = body(patch.block_a), in_b = body(patch.block_b);
    const Body<K>&a = bodies_[in_a], &b = bodies_[in_b];
    const Vector from_a = point.position - a.centroid, from_b = point.position - b.centroid;
    return point.gap + patch.normal.dot(a.path(from_a, time) - b.path(from_b, time));
}

/// Whether the stones of a point press on one another, or have met and stay together.
template <class K>
bool Impulses<K>::is_closed(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point)
{
    if (patch.intact || point.gap < 0) return true;
    if (std::abs(gap_of(patch, point, last_blow(patch))) > met * bodies_[body(patch.block_a)].size) return false;
    const Vector velocity =
        start_velocity(bodies_[body(patch.block_a)], bodies_[body(patch.block_b)], point.position);
    return std::abs(patch.normal.dot(velocity)) <= slack * fastest_;
}

template <class K>
void Impulses<K>::begin_again(const std::vector<double>& times)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i].is_struck()) bodies_[i].fly_on(times[i]);
        bodies_[i].reached = false;
        bodies_[i].moved = 0;
    }
    takes_part_.assign(contacts_.patches.size(), 0);
    meetings_.clear();
    fastest_ = 0;
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

/// Lets an impulse act on the bodies of a point.
template <class K>
void Impulses<K>::push(const Meeting<K>& m, const Vector& impulse)
{
    bodies_[m.a].push(m.turning_a, impulse);
    bodies_[m.b].push(m.turning_b, -impulse);
}

/// One impulse at one point. @returns whether it changed the velocity there by more than what is negligible
template <class K>
bool Impulses<K>::act(Meeting<K>& m)
{
    const Body<K>&a = bodies_[m.a], &b = bodies_[m.b];
    const Vector velocity = a.velocity - b.velocity + (m.arm_a * a.spin - m.arm_b * b.spin);
    double press = (m.target - m.normal.dot(velocity)) * m.inertia;
    if (!m.bonded) press = std::max(press, -m.pressed);
    m.pressed += press;
    Vector slip = velocity + press * m.parting - m.target_slip;
    slip -= m.normal.dot(slip) * m.normal;
    const Vector before = m.rubbed;
    const double square = slip.squaredNorm();
    const double yielding = slip.dot(m.yielding * slip);  // times the square
    if (yielding > 0) m.rubbed -= cautious * square / yielding * slip;
    // As in a step, friction is that of the mean of the speeds before and after.
    if (m.law.joint) m.friction = m.law.at(0.5 * (m.start_slip + slip).norm());
    if (!m.bonded) m.rubbed *= share_within(m.friction * m.pressed, m.rubbed);
    const Vector rub = m.rubbed - before;
    // Its own impulse is not seen yet: friction turns a stone and so changes what presses the point.
    m.seen_a = a.moved;
    m.seen_b = b.moved;
    push(m, press * m.normal + rub);
    const double least = negligible();
    return std::abs(press) * m.mobility > least ||
           rub.squaredNorm() * yielding * yielding > least * least * square * square;
}

/// Lets every point act once whose stones have moved. @returns whether one did more than what is negligible
template <class K>
bool Impulses<K>::sweep(bool back)
{
    bool any = false;
    const std::size_t before = meetings_.size();
    for (std::size_t k = 0; k < meetings_.size(); ++k) {  // grows
        const std::size_t i = back && k < before ? before - 1 - k : k;
        if (is_still(meetings_[i])) continue;
        ++impulses_;
        if (!act(meetings_[i])) continue;
        any = true;
        const int a = meetings_[i].a, b = meetings_[i].b;
        reach(a);
        reach(b);
    }
    return any;
}

template <class K>
void Impulses<K>::remember()
{
    for (Meeting<K>& m : meetings_) m.before = m.pressed * m.normal + m.rubbed;
    remembered_ = meetings_.size();
    for (Body<K>& body : bodies_) body.swept_velocity = body.velocity, body.swept_spin = body.spin;
}

/// Goes on where the sweeps there and back led, with what they did before in it, as a gradient after Fletcher and
/// Reeves; within what can press and rub. New contacts, and sweeps that do more than those before, begin it anew.
template <class K>
void Impulses<K>::accelerate()
{
    double square = 0;
    for (std::size_t i = 0; i < remembered_; ++i) {
        const Meeting<K>& m = meetings_[i];
        square += m.mobility * (m.pressed * m.normal + m.rubbed - m.before).squaredNorm();
    }
    const bool anew = remembered_ < meetings_.size() || !(square < last_square_);
    const double share = anew ? 0 : square / last_square_;
    last_square_ = square;
    for (std::size_t i = 0; i < remembered_; ++i) {
        Meeting<K>& m = meetings_[i];
        const Vector now = m.pressed * m.normal + m.rubbed;
        const Vector farther = share * m.course;
        m.course = farther + (now - m.before);
        if (farther.isZero(0)) continue;
        m.pressed += m.normal.dot(farther);
        if (!m.bonded) m.pressed = std::max(m.pressed, 0.0);
        m.rubbed += farther - m.normal.dot(farther) * m.normal;
        if (!m.bonded) m.rubbed *= share_within(m.friction * m.pressed, m.rubbed);
        push(m, m.pressed * m.normal + m.rubbed - now);
        ++impulses_;
    }
}

/// Whether sweeps there and back changed the motion of no body: what impulses share among more points than stones
/// need may go on changing for ever.
template <class K>
bool Impulses<K>::is_done() const
{
    return std::all_of(bodies_.begin(), bodies_.end(), [&](const Body<K>& body) {
        const double slower = (body.velocity - body.swept_velocity).norm(),
                     turned = body.size * (body.spin - body.swept_spin).norm();
        return slower + turned <= settled * negligible();
    });
}

template <class K>
bool Impulses<K>::solve()
{
    impulses_ = 0;
    last_square_ = 0;
    for (int i = 0; i < max_sweeps; ++i) {
        const bool back = i % 2 == 1;
        if (!back) {
            if (i > 0 && is_done()) return true;
            remember();
        }
        // There and back, so that what is left of a symmetrical blow is nearly so.
        if (!sweep(back)) return true;
        if (impulses_ > std::max(max_impulses * meetings_.size(), few_impulses)) return false;
        // Not among few: what it leaves unfinished depends on rounding, and so on the frame and the units.
        if (back && meetings_.size() > so_few_contacts) accelerate();
    }
    return false;
}

#define VOUSSOIR_INSTANTIATE(K)                                \
    template Body<K> body_of(const Model&, const State&, int); \
    template class Impulses<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
