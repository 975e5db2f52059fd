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

/// What gravity makes of a stone at rest in a step of length h [m/s]
double speed_of_a_step(const Stage& stage, double h)
{
    return stage.gravity.norm() * h;
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
void Landings<K>::add(const ClosingPoint& closing, double approach)
{
    const ContactPatchIn<D>& patch = contacts_.patches[closing.patch];
    const ContactPointIn<D>& point = contacts_.points[closing.point];
    const double fraction = std::min(1.0, point.gap / (h_ * approach));
    Meeting<K> m = impulses_.meeting(patch, point, h_ * fraction);
    if (m.mobility == 0) return;
    m.lands = true;
    m.approach = approach;
    m.fraction = fraction;
    m.target = *model_.joint_between(patch.block_a, patch.block_b).restitution * approach;
    impulses_.add(m);
}

template <class K>
std::vector<Jump<K>> Landings<K>::find()
{
    contact::Strips<D> strips(model_, contacts_);
    for (int k = 0; k < static_cast<int>(contacts_.patches.size()); ++k) {
        const ContactPatchIn<D>& patch = contacts_.patches[k];
        if (patch.intact || !model_.joint_between(patch.block_a, patch.block_b).has_landing_law()) continue;
        for (int i = patch.first_point, behind = end_of_corners(contacts_, patch); i < behind; ++i) {
            const double gap = contacts_.points[i].gap;
            if (gap < 0) continue;
            const double approach = approach_of({i, k});
            if (!(approach > slow_) || gap > h_ * approach) continue;
            if (strips.is_of_yielding(patch)) break;
            add({i, k}, approach);
        }
    }
    return solve();
}

template <class K>
std::vector<Jump<K>> Landings<K>::find_also(const std::vector<ClosingPoint>& missed)
{
    for (const ClosingPoint& closing : missed) add(closing, approach_of(closing));
    return solve();
}

/// What makes each body jump: bodies that one blow reaches do it together, at its first landing.
template <class K>
std::vector<typename Landings<K>::Blow> Landings<K>::blows() const
{
    const std::vector<Body<K>>& bodies = impulses_.bodies();
    DisjointSets sets(bodies.size());
    const auto moves = [&](int body) { return bodies[body].mobility(Vector::Zero(), Vector::Ones()) > 0; };
    for (const Meeting<K>& m : impulses_.meetings())
        if (m.pressed != 0 && moves(m.a) && moves(m.b)) sets.join(m.a, m.b);
    std::vector<Blow> of_root(bodies.size());
    for (const Meeting<K>& m : impulses_.meetings())
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
std::vector<double> Landings<K>::ground_works() const
{
    const std::vector<Body<K>>& bodies = impulses_.bodies();
    std::vector<double> works(bodies.size(), 0.0);
    const auto is_struck = [](const Body<K>& body) {
        return body.velocity != body.start_velocity || body.spin != body.start_spin;
    };
    for (const Meeting<K>& m : impulses_.meetings()) {
        const Vector impulse = m.pressed * m.normal + m.rubbed;  // on a
        const Vector &of_a = bodies[m.a].inverse_mass, &of_b = bodies[m.b].inverse_mass;
        double& work = works[is_struck(bodies[m.a]) ? m.a : m.b];
        for (int k = 0; k < D; ++k) {
            if (of_a[k] == 0) work -= impulse[k] * bodies[m.a].velocity[k];
            if (of_b[k] == 0) work += impulse[k] * bodies[m.b].velocity[k];
        }
    }
    return works;
}

template <class K>
std::vector<Jump<K>> Landings<K>::solve()
{
    if (impulses_.meetings().empty()) return {};
    impulses_.solve();
    const std::vector<Blow> by = blows();
    const std::vector<double> works = ground_works();
    std::vector<Jump<K>> result;
    for (std::size_t i = 0; i < impulses_.bodies().size(); ++i) {
        const Body<K>& body = impulses_.bodies()[i];
        Jump<K> jump;
        jump.velocity = body.velocity - body.start_velocity;
        const Spin turned = body.spin - body.start_spin;
        if (jump.velocity.isZero(0) && turned.isZero(0)) continue;
        if (!body.inverse_inertia.isZero(0)) jump.momentum = body.inverse_inertia.inverse() * turned;
        jump.block = impulses_.block_of(static_cast<int>(i));
        jump.fraction = by[i].fraction;
        jump.approach = by[i].approach;
        jump.ground_work = works[i];
        result.push_back(jump);
    }
    std::sort(result.begin(), result.end(), [](const Jump<K>& a, const Jump<K>& b) { return a.block < b.block; });
    return result;
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
