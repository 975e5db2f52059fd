// Impulses between stones: bodies, the contacts at which they meet, and the impulses there.
#pragma once

#include <cmath>
#include <vector>

#include "libdda/model/friction_law.h"
#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

constexpr double still = 1e-6;  // of the largest approach speed: a smaller change has not reached a block
constexpr double met = 1e-6;    // of a stone's size: stones that are apart by less have met
constexpr double slack = 1e-4;  // of the largest approach speed: stones that have met and part more slowly stay

template <class K>
using TurningIn = Eigen::Matrix<double, K::Spin::RowsAtCompileTime, K::dimension>;

template <class K>
using ArmIn = Eigen::Matrix<double, K::dimension, K::Spin::RowsAtCompileTime>;

/// Velocities of a point at a lever by unit spins, as columns [m].
template <class K>
ArmIn<K> arm_at(const typename K::Vector& lever)
{
    ArmIn<K> result;
    for (int k = 0; k < result.cols(); ++k) result.col(k) = velocity_by(typename K::Spin(K::Spin::Unit(k)), lever);
    return result;
}

/// A block as impulses move it: rigid, for what a deformable one stores in a blow is no motion.
template <class K>
struct Body {
    using Vector = typename K::Vector;
    using Spin = typename K::Spin;
    Vector centroid, velocity;  // m, m/s
    Spin spin;                  // rad/s
    Vector inverse_mass;        // 1/kg, 0 of held components, as is what follows
    Eigen::Matrix<double, Spin::RowsAtCompileTime, Spin::RowsAtCompileTime> inverse_inertia;  // 1/(kg m2)
    Vector start_velocity;
    Spin start_spin;
    // Until the blow before in the same step, if there was one:
    bool has_jumped = false;
    double since = 0;                        // s, when
    Vector gone = Vector::Zero();            // m, of the centroid
    Spin turned = Spin::Zero();              // rad
    double size = 0;                         // m
    bool reached = false;                    // by an impulse: its joints take part
    Vector swept_velocity = Vector::Zero();  // when the sweeps there and back began
    Spin swept_spin = Spin::Zero();
    double moved = 0;  // m/s, sum of the most that impulses did to the velocity of its points

    /// Before any impulse.
    Vector start_velocity_at(const Vector& lever) const { return start_velocity + velocity_by(start_spin, lever); }
    /// Way of a point from the start of the step on [m]. @param time [s] not before the last blow
    Vector path(const Vector& lever, double time) const
    {
        return gone + velocity_by(turned, lever) + (time - since) * start_velocity_at(lever);
    }
    /// Begins anew after a blow at a time [s].
    void fly_on(double time)
    {
        gone += (time - since) * start_velocity;
        turned += (time - since) * start_spin;
        since = time;
        has_jumped = true;
        start_velocity = velocity;
        start_spin = spin;
    }
    bool is_struck() const { return velocity != start_velocity || spin != start_spin; }
    /// Spins that unit impulses along the axes at a lever give, as columns [1/(kg m)].
    TurningIn<K> turning(const Vector& lever) const
    {
        TurningIn<K> result;
        for (int k = 0; k < K::dimension; ++k)
            result.col(k) = inverse_inertia * moment_about(lever, Vector(Vector::Unit(k)));
        return result;
    }
    /// @param turning of the impulse's lever
    void push(const TurningIn<K>& turning, const Vector& impulse)
    {
        const Vector faster = inverse_mass.cwiseProduct(impulse);
        const Spin turned = turning * impulse;
        velocity += faster;
        spin += turned;
        moved += std::sqrt(2 * (faster.squaredNorm() + size * size * turned.squaredNorm()));
    }
    /// Velocity that a unit impulse along u gives its own point, along u.
    double mobility(const Vector& lever, const Vector& u) const
    {
        const Spin moment = moment_about(lever, u);
        return u.dot(inverse_mass.cwiseProduct(u)) + moment.dot(inverse_inertia * moment);
    }
    /// Velocities that unit impulses along the axes give their own point, as columns [1/kg].
    typename K::Matrix mobility(const Vector& lever) const
    {
        const TurningIn<K> turned = turning(lever);
        typename K::Matrix result = inverse_mass.asDiagonal();
        for (int k = 0; k < K::dimension; ++k) result.col(k) += velocity_by(Spin(turned.col(k)), lever);
        return result;
    }
};

/// A contact point that takes part.
template <class K>
struct Meeting {
    using Vector = typename K::Vector;
    int a = 0, b = 0;       // bodies
    ArmIn<K> arm_a, arm_b;  // m, velocities of the point by unit spins of the blocks, as columns
    Vector normal;          // unit
    FrictionLaw law;
    double friction = 0;  // -, its coefficient when the point last acted
    double target = 0;    // m/s, least normal speed afterwards
    Vector start_slip;    // m/s, tangential velocity before any impulse
    Vector target_slip;   // m/s, the same that sticking keeps: that of a bond, else none
    bool bonded = false;
    bool lands = false;
    double approach = 0;                // m/s, if it lands
    double fraction = 0;                // of the step, if it lands
    typename K::Matrix yielding;        // 1/kg, how fast a unit impulse there makes them part
    Vector parting;                     // 1/kg, velocity that a unit impulse along the normal makes
    double mobility = 0;                // 1/kg, of that along the normal
    double inertia = 0;                 // kg, 1 / mobility
    TurningIn<K> turning_a, turning_b;  // 1/(kg m), of the blocks by impulses there
    double seen_a = -1, seen_b = -1;    // m/s, what the bodies had moved before it last acted
    double pressed = 0;                 // Ns, so far
    Vector rubbed = Vector::Zero();     // Ns, so far
    Vector before;                      // Ns, whole impulse when the sweeps there and back began
    Vector course = Vector::Zero();     // Ns, direction of the conjugate gradients
};

/// Moves as the part of its motion does that carries momentum.
template <class K>
Body<K> body_of(const Model& model, const State& state, int block);

/// Velocity of a against b at a point before any impulse, as rigid bodies [m/s].
template <class K>
typename K::Vector start_velocity(const Body<K>& a, const Body<K>& b, const typename K::Vector& place)
{
    return a.start_velocity_at(place - a.centroid) - b.start_velocity_at(place - b.centroid);
}

/// What impulses do to the blocks that they reach: found contact by contact (projected Gauss-Seidel, there and
/// back), among many contacts accelerated by nonlinear conjugate gradients [SilcowitzNiebeErleben2010].
template <class K>
class Impulses
{
 public:
    using Vector = typename K::Vector;
    using Spin = typename K::Spin;
    static constexpr int D = K::dimension;

    /// @param slow speed that a step at rest may gain [m/s]: through many stones a small share of it need not be
    /// passed on
    Impulses(const Model& model, const State& state, const ContactSetIn<D>& contacts, double slow)
        : model_(model), state_(state), contacts_(contacts), body_of_(model.blocks.size(), -1), slow_(slow)
    {
    }

    /// @returns the index of a block's body, which is made when first asked for
    int body(int block);
    /// @param time when they meet [s]: both blows act where the point of a is then, or angular momentum would
    /// be lost
    Meeting<K> meeting(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point, double time);
    /// Adds one that lands.
    void add(const Meeting<K>& meeting);
    /// Lets impulses act until every landing point has its speed and no joint is closed any further. May be called
    /// again when more points land: it goes on from the impulses so far. @returns whether it came to its end
    bool solve();

    /// Goes on after these blows, to others in the same step. @param times of those of each body [s]
    void begin_again(const std::vector<double>& times);

    /// How far a point is open after the last blow of its bodies [m]; their places at `time` [s], no earlier.
    double gap_of(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point, double time);

    const std::vector<Body<K>>& bodies() const { return bodies_; }
    bool knows(int block) const { return body_of_[block] >= 0; }
    /// Whether a blow runs through so many contacts that impulses are accelerated.
    bool is_large() const { return meetings_.size() > so_few_contacts; }
    const std::vector<Meeting<K>>& meetings() const { return meetings_; }
    int block_of(int body) const { return blocks_[body]; }

 private:
    void reach(int body);
    double negligible() const;
    bool is_still(const Meeting<K>& meeting) const;
    bool act(Meeting<K>& meeting);
    void push(const Meeting<K>& meeting, const Vector& impulse);
    bool sweep(bool back);
    void remember();
    bool is_done() const;
    void accelerate();

    double last_blow(const ContactPatchIn<D>& patch);
    bool is_closed(const ContactPatchIn<D>& patch, const ContactPointIn<D>& point);

    static constexpr std::size_t so_few_contacts = 100;  // are left to sweeps alone

    const Model& model_;
    const State& state_;
    const ContactSetIn<D>& contacts_;
    std::vector<int> body_of_;  // by block
    std::vector<int> blocks_;   // by body
    std::vector<Body<K>> bodies_;
    std::vector<Meeting<K>> meetings_;
    std::vector<char> takes_part_;              // by patch: its closed points do
    std::vector<std::vector<int>> patches_of_;  // by block, made when first needed
    double fastest_ = 0;                        // m/s, of what lands
    double slow_ = 0;                           // m/s
    std::size_t impulses_ = 0;                  // that acted
    std::size_t remembered_ = 0;                // meetings when the sweeps there and back began
    double last_square_ = 0;                    // J, of what the sweeps before did
};

}  // namespace voussoir::step
