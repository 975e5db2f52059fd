#include "libdda/step/landing.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "libdda/contact/strips.h"

namespace voussoir::step
{

namespace
{

constexpr double least_part = 0.02;  // of a step, that is worth one of its own
constexpr int max_sweeps = 200;      // over the contacts that impulses have reached
constexpr double still = 1e-6;       // of the largest approach speed: a smaller change has not reached a block

/// A block as impulses move it: rigid, for what a deformable one stores in a blow is no motion.
template <class K>
struct Body {
    using Vector = typename K::Vector;
    using Spin = typename K::Spin;
    Vector centroid, velocity;  // m, m/s
    Spin spin;                  // rad/s
    Vector inverse_mass;        // 1/kg, 0 of held components
    Eigen::Matrix<double, Spin::RowsAtCompileTime, Spin::RowsAtCompileTime> inverse_inertia;  // 1/(kg m2)
    Vector start_velocity;
    Spin start_spin;
    bool reached = false;  // by an impulse: its joints take part

    Vector velocity_at(const Vector& lever) const { return velocity + skew(spin) * lever; }
    void push(const Vector& lever, const Vector& impulse)
    {
        velocity += inverse_mass.cwiseProduct(impulse);
        spin += inverse_inertia * moment_about(lever, impulse);
    }
    /// Velocity that a unit impulse along u gives its own point, along u.
    double mobility(const Vector& lever, const Vector& u) const
    {
        const Spin moment = moment_about(lever, u);
        return u.dot(inverse_mass.cwiseProduct(u)) + moment.dot(inverse_inertia * moment);
    }
};

/// A contact point that takes part.
template <class K>
struct Meeting {
    using Vector = typename K::Vector;
    int a = 0, b = 0;         // blocks
    Vector lever_a, lever_b;  // m
    Vector normal;            // unit
    double friction = 0;      // -
    double target = 0;        // m/s, least normal speed afterwards
    Vector target_slip;       // m/s, tangential velocity that sticking keeps: that of a bond, else none
    bool bonded = false;
    bool lands = false;
    double fraction = 0;             // of the step, if it lands
    double mobility = 0;             // 1/kg, along the normal
    double pressed = 0;              // Ns, so far
    Vector rubbed = Vector::Zero();  // Ns, so far
};

template <class K>
class Landing
{
 public:
    using Vector = typename K::Vector;
    using Spin = typename K::Spin;
    static constexpr int D = K::dimension;

    Landing(const Model& model, const State& state, const ContactSetIn<D>& contacts)
        : model_(model), state_(state), contacts_(contacts), body_of_(model.blocks.size(), -1)
    {
    }

    /// Adds what lands, with the restitution of its joint. @returns whether anything does
    bool find(const Stage& stage, double h, const std::vector<int>& also);
    /// Lets impulses act until every landing point has its speed and no joint is closed any further.
    void solve();
    std::vector<Jump<K>> jumps() const;

 private:
    int body(int block);
    Meeting<K> meeting(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point, double flight);
    void reach(int body);
    double act(Meeting<K>& meeting);
    std::vector<double> fractions() const;

    const Model& model_;
    const State& state_;
    const ContactSetIn<D>& contacts_;
    std::vector<int> body_of_;  // by block
    std::vector<int> blocks_;   // by body
    std::vector<Body<K>> bodies_;
    std::vector<Meeting<K>> meetings_;
    std::vector<char> takes_part_;              // by patch: its closed points do
    std::vector<std::vector<int>> patches_of_;  // by block, made when first needed
    double fastest_ = 0;                        // m/s
};

/// Moves as the part of its motion does that carries momentum.
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
    return body;
}

/// Speed at which the stones of a point part, as rigid bodies [m/s].
template <class K>
typename K::Vector relative_velocity(const Body<K>& a, const Body<K>& b, const typename K::Vector& place)
{
    return a.velocity_at(place - a.centroid) - b.velocity_at(place - b.centroid);
}

template <class K>
int Landing<K>::body(int block)
{
    if (body_of_[block] < 0) {
        body_of_[block] = static_cast<int>(bodies_.size());
        bodies_.push_back(body_of<K>(model_, state_, block));
        blocks_.push_back(block);
    }
    return body_of_[block];
}

/// @param flight until they meet [s]: both blows act where the point of a is then, or angular momentum would be
/// lost
template <class K>
Meeting<K> Landing<K>::meeting(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point, double flight)
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
    m.mobility = bodies_[m.a].mobility(m.lever_a, patch.normal) + bodies_[m.b].mobility(m.lever_b, patch.normal);
    return m;
}

template <class K>
bool Landing<K>::find(const Stage& stage, double h, const std::vector<int>& also)
{
    const double slow = stage.gravity.norm() * h;  // what a step at rest may gain
    contact::Strips<D> strips(model_, contacts_);
    for (const ContactPatchIn<D>& patch : contacts_.patches) {
        if (patch.intact || !model_.joint_between(patch.block_a, patch.block_b).has_landing_law()) continue;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts_.points[i];
            if (point.gap < 0) continue;
            const int a = body(patch.block_a), b = body(patch.block_b);
            const Vector velocity = relative_velocity(bodies_[a], bodies_[b], point.position);
            const double approach = -patch.normal.dot(velocity);
            if (!(approach > slow)) continue;
            const bool known = std::binary_search(also.begin(), also.end(), i);
            if (point.gap > h * approach && !known) continue;
            if (strips.is_of_yielding(patch)) break;
            const double fraction = std::min(1.0, point.gap / (h * approach));
            Meeting<K> m = meeting(patch, point, h * fraction);
            if (m.mobility == 0) continue;
            m.lands = true;
            m.fraction = fraction;
            m.target = *model_.joint_between(patch.block_a, patch.block_b).restitution * approach;
            fastest_ = std::max(fastest_, approach);
            meetings_.push_back(m);
        }
    }
    return !meetings_.empty();
}

/// Lets the closed joints of a body that an impulse has reached take part: they are not closed any further, and a
/// bond is not opened either.
template <class K>
void Landing<K>::reach(int index)
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

/// One impulse at one point. @returns by how much it changed the velocity there [m/s]
template <class K>
double Landing<K>::act(Meeting<K>& m)
{
    Body<K>&a = bodies_[m.a], &b = bodies_[m.b];
    const auto push = [&](const Vector& impulse) {
        a.push(m.lever_a, impulse);
        b.push(m.lever_b, -impulse);
    };
    const auto velocity = [&] { return Vector(a.velocity_at(m.lever_a) - b.velocity_at(m.lever_b)); };
    double press = (m.target - m.normal.dot(velocity())) / m.mobility;
    if (!m.bonded) press = std::max(press, -m.pressed);
    m.pressed += press;
    push(press * m.normal);
    Vector slip = velocity() - m.target_slip;
    slip -= m.normal.dot(slip) * m.normal;
    const double speed = slip.norm();
    double rubbed = 0;
    if (speed > 0) {
        const Vector along = slip / speed;
        const double mobility = a.mobility(m.lever_a, along) + b.mobility(m.lever_b, along);
        const Vector before = m.rubbed;
        if (mobility > 0) m.rubbed -= slip / mobility;
        const double bound = m.friction * m.pressed, size = m.rubbed.norm();
        if (!m.bonded && size > bound) m.rubbed *= bound / size;
        const Vector rub = m.rubbed - before;
        push(rub);
        rubbed = rub.norm() * mobility;
    }
    return std::max(std::abs(press) * m.mobility, rubbed);
}

template <class K>
void Landing<K>::solve()
{
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        double most = 0;
        for (std::size_t i = 0; i < meetings_.size(); ++i) {  // grows
            const double change = act(meetings_[i]);
            most = std::max(most, change);
            if (change <= still * fastest_) continue;
            const int a = meetings_[i].a, b = meetings_[i].b;
            reach(a);
            reach(b);
        }
        if (most <= still * fastest_) return;
    }
}

int root_of(int i, std::vector<int>& parent)
{
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

/// When each body jumps: bodies that one blow reaches do it together, at its first landing.
template <class K>
std::vector<double> Landing<K>::fractions() const
{
    std::vector<int> parent(bodies_.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto moves = [&](int body) { return bodies_[body].mobility(Vector::Zero(), Vector::Ones()) > 0; };
    for (const Meeting<K>& m : meetings_)
        if (m.pressed != 0 && moves(m.a) && moves(m.b)) parent[root_of(m.a, parent)] = root_of(m.b, parent);
    std::vector<double> first(bodies_.size(), 1);
    for (const Meeting<K>& m : meetings_)
        if (m.lands && m.pressed > 0)
            for (const int body : {m.a, m.b}) {
                double& fraction = first[root_of(body, parent)];
                fraction = std::min(fraction, m.fraction);
            }
    std::vector<double> result(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) result[i] = first[root_of(static_cast<int>(i), parent)];
    return result;
}

template <class K>
std::vector<Jump<K>> Landing<K>::jumps() const
{
    const std::vector<double> when = fractions();
    std::vector<Jump<K>> result;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const Body<K>& body = bodies_[i];
        Jump<K> jump;
        jump.velocity = body.velocity - body.start_velocity;
        const Spin turned = body.spin - body.start_spin;
        if (jump.velocity.isZero(0) && turned.isZero(0)) continue;
        if (!body.inverse_inertia.isZero(0)) jump.momentum = body.inverse_inertia.inverse() * turned;
        jump.block = blocks_[i];
        jump.fraction = when[i];
        result.push_back(jump);
    }
    std::sort(result.begin(), result.end(), [](const Jump<K>& a, const Jump<K>& b) { return a.block < b.block; });
    return result;
}

}  // namespace

template <class K>
std::vector<Jump<K>> find_jumps(const Model& model, const Stage& stage, const State& state,
                                const ContactSetIn<K::dimension>& contacts, double h, const std::vector<int>& also)
{
    Landing<K> landing(model, state, contacts);
    if (!landing.find(stage, h, also)) return {};
    landing.solve();
    return landing.jumps();
}

template <class K>
std::optional<double> step_to_landing(const Stage& stage, const std::vector<Jump<K>>& jumps, double h)
{
    double first = 1;
    for (const Jump<K>& jump : jumps) first = std::min(first, jump.fraction);
    // Not quite: forces bend the way there.
    const double part = 0.98 * first;
    if (jumps.empty() || part * h < least_part * stage.control.time_step) return std::nullopt;
    return part * h;
}

template <class K>
std::vector<int> missed_landings(const Model& model, const Stage& stage, const State& state,
                                 const ContactSetIn<K::dimension>& contacts, const StepSystem<K>& system)
{
    std::vector<int> missed;
    const double slow = stage.gravity.norm() * system.h;
    contact::Strips<K::dimension> strips(model, contacts);
    for (const auto& patch : contacts.patches) {
        if (patch.intact || !model.joint_between(patch.block_a, patch.block_b).has_landing_law()) continue;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const auto& point = contacts.points[i];
            if (point.gap < 0 || system.contacts.points[i].normal == 0) continue;
            const Body<K> a = body_of<K>(model, state, patch.block_a), b = body_of<K>(model, state, patch.block_b);
            const double approach = -patch.normal.dot(relative_velocity(a, b, point.position));
            if (!(approach > slow) || point.gap <= system.h * approach) continue;
            if (strips.is_of_yielding(patch)) break;
            missed.push_back(i);
        }
    }
    return missed;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                   \
    template std::vector<Jump<K>> find_jumps(const Model&, const Stage&, const State&,                            \
                                             const ContactSetIn<K::dimension>&, double, const std::vector<int>&); \
    template std::optional<double> step_to_landing(const Stage&, const std::vector<Jump<K>>&, double);            \
    template std::vector<int> missed_landings(const Model&, const Stage&, const State&,                           \
                                              const ContactSetIn<K::dimension>&, const StepSystem<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
