#include "libdda/impact/landing.h"

#include <Eigen/LU>
#include <algorithm>
#include <mutex>

#include "libdda/contact/strips.h"
#include "libdda/impact/impulses.h"
#include "libdda/model/disjoint_sets.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{

namespace
{

constexpr double least_part = 0.02;  // of a step, that is worth one of its own
// Of the speed that gravity makes in a step. What lands more slowly is left to the springs, which return what they
// take: with the whole of that speed a house that rocks drifts twice as far at 1 ms as at 0.25 ms, with a quarter
// walls that tremble at rest land all the time (numerics.md 4).
constexpr double slow_landing = 0.5;
constexpr int most_blows = 100;  // that follow one another in a step: a stone may rattle between two others

/// What gravity makes of a stone at rest in a step of length h [m/s]
double speed_of_a_step(const Stage& stage, double h)
{
    return stage.gravity.norm() * h;
}

/// Whether stones that come together by a way close a gap that has not closed before: one that they close but for
/// rounding too, or the corners of a face that land at the end of a step would do so one by one. @param size of a
/// stone [m]
bool closes(double gap, double way, double size)
{
    return gap >= -met * size && gap <= way + met * size;
}

/// What makes bodies jump.
struct Blow {
    double fraction = 1;  // of the step
    double approach = 0;  // m/s, of the fastest landing
};

/// What makes each body jump: bodies that one blow reaches do it together, at its first landing.
template <class K>
std::vector<Blow> blows_of(const Impulses<K>& impulses)
{
    using Vector = typename K::Vector;
    const std::vector<Body<K>>& bodies = impulses.bodies();
    DisjointSets sets(bodies.size());
    const auto moves = [&](int body) { return bodies[body].mobility(Vector::Zero(), Vector::Ones()) > 0; };
    for (const Meeting<K>& m : impulses.meetings())
        if (m.pressed != 0 && moves(m.a) && moves(m.b)) sets.join(m.a, m.b);
    std::vector<Blow> of_root(bodies.size());
    for (const Meeting<K>& m : impulses.meetings())
        if (m.lands && m.pressed > 0)
            for (const int body : {m.a, m.b}) {
                Blow& blow = of_root[sets.root_of(body)];
                blow.fraction = std::min(blow.fraction, m.fraction);
                blow.approach = std::max(blow.approach, m.approach);
            }
    std::vector<Blow> result(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) result[i] = of_root[sets.root_of(static_cast<int>(i))];
    return result;
}

/// What foundations that move do in the blows, for they push at their own speed; booked with a body that they
/// strike [J].
template <class K>
std::vector<double> ground_works_of(const Impulses<K>& impulses)
{
    using Vector = typename K::Vector;
    const std::vector<Body<K>>& bodies = impulses.bodies();
    std::vector<double> works(bodies.size(), 0.0);
    for (const Meeting<K>& m : impulses.meetings()) {
        const Vector impulse = m.pressed * m.normal + m.rubbed;  // on a
        const Vector &of_a = bodies[m.a].inverse_mass, &of_b = bodies[m.b].inverse_mass;
        double& work = works[bodies[m.a].is_struck() ? m.a : m.b];
        for (int k = 0; k < K::dimension; ++k) {
            if (of_a[k] == 0) work -= impulse[k] * bodies[m.a].velocity[k];
            if (of_b[k] == 0) work += impulse[k] * bodies[m.b].velocity[k];
        }
    }
    return works;
}

/// The jumps by what impulses did. A body that had jumped later than a blow that reaches it jumps again then.
/// @returns when, by body [s]
template <class K>
std::vector<double> add_jumps(const Impulses<K>& impulses, double h, std::vector<Jump<K>>& jumps)
{
    const std::vector<Blow> by = blows_of(impulses);
    const std::vector<double> works = ground_works_of(impulses);
    std::vector<double> times(impulses.bodies().size(), 0);
    for (std::size_t i = 0; i < impulses.bodies().size(); ++i) {
        const Body<K>& body = impulses.bodies()[i];
        Jump<K> jump;
        jump.velocity = body.velocity - body.start_velocity;
        const typename K::Spin turned = body.spin - body.start_spin;
        if (jump.velocity.isZero(0) && turned.isZero(0)) continue;
        if (!body.inverse_inertia.isZero(0)) jump.momentum = body.inverse_inertia.inverse() * turned;
        jump.block = impulses.block_of(static_cast<int>(i));
        jump.fraction = std::max(by[i].fraction, body.since / h);
        jump.approach = by[i].approach;
        jump.ground_work = works[i];
        times[i] = jump.fraction * h;
        jumps.push_back(jump);
    }
    return times;
}

}  // namespace

template <class K>
Landings<K>::Landings(const Model& model, const Stage& stage, const State& state, const ContactSetIn<D>& contacts,
                      double h)
    : model_(model),
      contacts_(contacts),
      h_(h),
      slow_(slow_landing * speed_of_a_step(stage, h)),
      impulses_(model, state, contacts, speed_of_a_step(stage, h))
{
}

/// Speed at which the stones of a point come together before the step [m/s]
template <class K>
double Landings<K>::approach_of(const ClosingPoint& closing)
{
    const ContactPatchIn<D>& patch = contacts_.patches[closing.patch];
    const int a = impulses_.body(patch.block_a), b = impulses_.body(patch.block_b);
    return -patch.normal.dot(
        start_velocity(impulses_.bodies()[a], impulses_.bodies()[b], contacts_.points[closing.point].position));
}

/// Lets a point land, with the restitution of its joint.
template <class K>
void Landings<K>::add(const Closing& closing, Impulses<K>& impulses)
{
    const ContactPatchIn<D>& patch = contacts_.patches[closing.at.patch];
    Meeting<K> m = impulses.meeting(patch, contacts_.points[closing.at.point], h_ * closing.fraction);
    if (m.mobility == 0) return;
    m.lands = true;
    m.approach = closing.approach;
    m.fraction = closing.fraction;
    m.target = *model_.joint_between(patch.block_a, patch.block_b).restitution * closing.approach;
    impulses.add(m);
    landed_.resize(contacts_.points.size(), 0);
    landed_[closing.at.point] = blow_;
}

template <class K>
std::vector<Jump<K>> Landings<K>::find()
{
    contact::Strips<D> strips(model_, contacts_);
    for (int k = 0; k < static_cast<int>(contacts_.patches.size()); ++k) {
        const ContactPatchIn<D>& patch = contacts_.patches[k];
        if (patch.intact || !model_.joint_between(patch.block_a, patch.block_b).has_landing_law()) continue;
        for (int i = patch.first_point, behind = end_of_corners(contacts_, patch); i < behind; ++i) {
            const ContactPointIn<D>& point = contacts_.points[i];
            if (point.gap < 0 && point.status != ContactStatus::open) continue;
            const double approach = approach_of({i, k}), size = size_of(model_, patch.block_a);
            if (!(approach > slow_) || !closes(point.gap, h_ * approach, size)) continue;
            if (strips.is_of_yielding(patch)) break;
            add({{i, k}, std::clamp(point.gap / (h_ * approach), 0.0, 1.0), approach}, impulses_);
        }
    }
    return jumps();
}

template <class K>
std::vector<Jump<K>> Landings<K>::find_also(const std::vector<ClosingPoint>& missed)
{
    blow_ = 1;
    std::replace_if(
        landed_.begin(), landed_.end(), [](int blow) { return blow > 1; }, 0);
    for (const ClosingPoint& closing : missed) {
        const double approach = approach_of(closing);
        add({closing, std::min(1.0, contacts_.points[closing.point].gap / (h_ * approach)), approach}, impulses_);
    }
    return jumps();
}

template <class K>
bool Landings<K>::has_landed(const ClosingPoint& closing) const
{
    return !landed_.empty() && landed_[closing.point] != 0;
}

template <class K>
void Landings<K>::solve(Impulses<K>& impulses)
{
    ++counts_.solved;
    if (!impulses.solve()) ++counts_.unfinished;
}

/// What all that lands does to the stones.
template <class K>
std::vector<Jump<K>> Landings<K>::jumps()
{
    if (impulses_.meetings().empty()) return {};
    counts_ = {};
    solve(impulses_);
    std::vector<Jump<K>> jumps;
    const std::vector<double> times = add_jumps(impulses_, h_, jumps);
    if (!impulses_.is_large()) follow(jumps, times);
    std::stable_sort(jumps.begin(), jumps.end(),
                     [](const Jump<K>& a, const Jump<K>& b) { return a.block < b.block; });
    return jumps;
}

/// Blows that follow the first ones in the step, in their order: what was struck meets something else. Not in
/// large structures, whose stones land in nearly every step and all over.
/// @param times of the first blows, by body [s]
template <class K>
void Landings<K>::follow(std::vector<Jump<K>>& jumps, std::vector<double> times)
{
    Impulses<K> impulses = impulses_;
    double fastest = 0;
    for (const Jump<K>& jump : jumps) fastest = std::max(fastest, jump.approach);
    while (blow_ < most_blows) {
        impulses.begin_again(times);
        const std::vector<Closing> next = look_for_more(impulses, fastest);
        if (next.empty()) return;
        ++blow_;
        const auto first = std::min_element(next.begin(), next.end(), [](const Closing& a, const Closing& b) {
                               return a.fraction < b.fraction;
                           })->fraction;
        for (const Closing& closing : next)
            if (closing.fraction <= first + least_part) add(closing, impulses);
        solve(impulses);
        times = add_jumps(impulses, h_, jumps);
        if (impulses.is_large()) return;
    }
    ++counts_.unfinished;
}

/// The points at which stones come together in the rest of the step, after what has struck them so far; not those
/// of the last blow, which parts them: what it leaves of their approach, given up too early, is not another one.
/// @param fastest of the first landings [m/s]
template <class K>
std::vector<typename Landings<K>::Closing> Landings<K>::look_for_more(Impulses<K>& impulses, double fastest) const
{
    std::vector<Closing> found;
    contact::Strips<D> strips(model_, contacts_);
    const double slow = std::max(slow_, slack * fastest);
    const auto is_struck = [&](int block) {
        return impulses.knows(block) && impulses.bodies()[impulses.body(block)].has_jumped;
    };
    for (int k = 0; k < static_cast<int>(contacts_.patches.size()); ++k) {
        const ContactPatchIn<D>& patch = contacts_.patches[k];
        if (!is_struck(patch.block_a) && !is_struck(patch.block_b)) continue;
        if (patch.intact || !model_.joint_between(patch.block_a, patch.block_b).has_landing_law()) continue;
        const int in_a = impulses.body(patch.block_a), in_b = impulses.body(patch.block_b);
        const Body<K>&a = impulses.bodies()[in_a], &b = impulses.bodies()[in_b];
        const double last = std::max(a.since, b.since);
        for (int i = patch.first_point, behind = end_of_corners(contacts_, patch); i < behind; ++i) {
            const ContactPointIn<D>& point = contacts_.points[i];
            if (point.gap < 0 || landed_[i] == blow_) continue;
            const double gap = impulses.gap_of(patch, point, last);
            const double approach = -patch.normal.dot(start_velocity(a, b, point.position));
            if (!(approach > slow) || !closes(gap, (h_ - last) * approach, a.size)) continue;
            if (strips.is_of_yielding(patch)) break;
            found.push_back({{i, k}, std::clamp((last + gap / approach) / h_, last / h_, 1.0), approach});
        }
    }
    return found;
}

template <class K>
std::optional<double> step_to_landing(const Stage& stage, const std::vector<Jump<K>>& jumps, double h)
{
    double first = 1;
    bool any = false;
    for (const Jump<K>& jump : jumps)
        if (jump.approach > speed_of_a_step(stage, h)) {
            any = true;
            first = std::min(first, jump.fraction);
        }
    // Not quite: forces bend the way there.
    const double part = 0.98 * first;
    if (!any || part * h < least_part * stage.control.time_step) return std::nullopt;
    return part * h;
}

template <class K>
std::vector<ClosingPoint> missed_landings(const Model& model, const Stage& stage, const State& state,
                                          const ContactSetIn<K::dimension>& contacts,
                                          const StepProblem<K>& problem)
{
    const double slow = slow_landing * speed_of_a_step(stage, problem.h);
    std::vector<ClosingPoint> met;
    std::mutex mutex;
    in_parallel(contacts.patches.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            const auto& patch = contacts.patches[k];
            if (patch.intact || !model.joint_between(patch.block_a, patch.block_b).has_landing_law()) continue;
            for (int i = patch.first_point, behind = end_of_corners(contacts, patch); i < behind; ++i) {
                const auto& point = contacts.points[i];
                if (point.gap < 0 || problem.contacts.points[i].normal == 0) continue;
                const Body<K> a = body_of<K>(model, state, patch.block_a),
                              b = body_of<K>(model, state, patch.block_b);
                const double approach = -patch.normal.dot(start_velocity(a, b, point.position));
                if (!(approach > slow) || point.gap <= problem.h * approach) continue;
                const std::lock_guard lock(mutex);
                met.push_back({i, static_cast<int>(k)});
            }
        }
    });
    std::sort(met.begin(), met.end(),
              [](const ClosingPoint& a, const ClosingPoint& b) { return a.point < b.point; });
    contact::Strips<K::dimension> strips(model, contacts);
    std::erase_if(
        met, [&](const ClosingPoint& closing) { return strips.is_of_yielding(contacts.patches[closing.patch]); });
    return met;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                        \
    template class Landings<K>;                                                                        \
    template std::optional<double> step_to_landing(const Stage&, const std::vector<Jump<K>>&, double); \
    template std::vector<ClosingPoint> missed_landings(const Model&, const Stage&, const State&,       \
                                                       const ContactSetIn<K::dimension>&, const StepProblem<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
