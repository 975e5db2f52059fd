#include "libdda/block/prediction.h"

namespace voussoir::step
{

using Eigen::Map;

namespace
{

/// Mean angular velocity of the step for constant momentum H: the implicit midpoint rule
/// w = I(exp(h w / 2) A)^-1 H, symmetric in time, so that the kinetic energy of a free spin does not drift.
template <int D>
SpinIn<D> midpoint_spin(const MatrixIn<D>& map, const MatrixIn<D>& density_second, const SpinIn<D>& spin,
                        const SpinIn<D>& momentum, double h)
{
    SpinIn<D> w = spin;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const MatrixIn<D> half = rotation_by(SpinIn<D>(0.5 * h * w)) * map;
        const SpinIn<D> next = spin_of<D>(spread_of(half, density_second), momentum);
        const double change = h * (next - w).norm();
        w = next;
        if (change < 1e-16) break;
    }
    return w;
}

/// Velocities at the start of the step, and the spin that carries the angular momentum.
/// @returns dA/dt
template <class K>
typename K::Matrix read_velocities(const State& state, int block, BlockStep<K>& step)
{
    const double* v = state.velocities.data() + block * K::unknowns;
    step.start_velocity = typename K::Vector(v);
    const typename K::Matrix& map = step.start.map;
    if constexpr (K::deformable) {
        typename K::Matrix rate(v + K::dimension);
        if (step.sides_tied) {
            step.momentum.setZero();
            step.start_spin.setZero();
            step.stretching = rate;
            return rate;
        }
        step.momentum = axial(typename K::Matrix(rate * step.density_second * map.transpose()));
        step.start_spin = spin_of<K::dimension>(spread_of(map, step.density_second), step.momentum);
        step.stretching = rate - skew(step.start_spin) * map;
        return rate;
    } else {
        for (int k = 0; k < step.start_spin.size(); ++k) step.start_spin[k] = v[K::dimension + k];
        step.momentum = inertia_tensor(spread_of(map, step.density_second)) * step.start_spin;
        step.stretching.setZero();
        return skew(step.start_spin) * map;
    }
}

/// A block in free flight, some way from the start of the step.
template <class K>
struct Flight {
    PoseIn<K::dimension> pose;
    OrientationIn<K::dimension> orientation;  // rigid
    typename K::Matrix stretching;            // 1/s, dA/dt without the spin
    typename K::Vector velocity;              // m/s
    typename K::Spin spin, momentum;          // rad/s, Nms
    typename K::Spin turn;                    // rad, of the last leg; small enough to be halved
    typename K::Matrix rotation;              // since the start
};

template <class K>
double kinetic_energy(const BlockStep<K>& step, const Flight<K>& flight)
{
    return kinetic_energy(step, flight.velocity,
                          typename K::Matrix(skew(flight.spin) * flight.pose.map + flight.stretching));
}

/// q + t v, with the rotation done exactly and the momentum kept exactly. Source: docs/numerics.md 2.6.
template <class K>
void fly(const BlockStep<K>& step, double t, Flight<K>& flight)
{
    constexpr int dimension = K::dimension;
    flight.pose.centroid += t * flight.velocity;
    flight.turn =
        t * midpoint_spin<dimension>(flight.pose.map, step.density_second, flight.spin, flight.momentum, t);
    const typename K::Matrix rotation = rotation_by(flight.turn);
    if constexpr (K::deformable) {
        flight.pose.map = rotation * (flight.pose.map + t * flight.stretching);
        flight.stretching = rotation * flight.stretching;
    } else {
        flight.orientation = flight.orientation.turned_by(flight.turn);
        flight.pose.map = flight.orientation.matrix();
    }
    flight.rotation = rotation * flight.rotation;
    flight.spin = spin_of<dimension>(spread_of(flight.pose.map, step.density_second), flight.momentum);
}

}  // namespace

template <class K>
double kinetic_energy(const BlockStep<K>& step, const typename K::Vector& velocity, const typename K::Matrix& rate)
{
    double twice = 0;
    for (int k = 0; k < K::dimension; ++k)
        if (!step.held[k]) twice += step.mass * velocity[k] * velocity[k];
    if (!step.rotation_held()) twice += (rate * step.density_second).cwiseProduct(rate).sum();
    return 0.5 * twice;
}

template <class K>
void predict(const State& state, int block, double h, std::span<const Jump<K>> jumps, BlockStep<K>& step)
{
    constexpr int dimension = K::dimension;
    const typename K::Matrix rate = read_velocities(state, block, step);
    step.start_kinetic = kinetic_energy(step, step.start_velocity, rate);
    Flight<K> flight{step.start,      {},
                     step.stretching, step.start_velocity,
                     step.start_spin, step.momentum,
                     K::Spin::Zero(), K::Matrix::Identity()};
    if constexpr (!K::deformable) {
        const double* x = state.coordinates.data() + block * coordinates_per_block(K::kinematics);
        flight.orientation = OrientationIn<dimension>::read(x + dimension);
    }
    step.jumps = !jumps.empty();
    step.impact = step.ground_work = 0;
    double flown = 0;
    for (const Jump<K>& jump : jumps) {
        fly(step, jump.fraction * h - flown, flight);
        flown = jump.fraction * h;
        double taken = kinetic_energy(step, flight);
        flight.velocity += jump.velocity;
        flight.momentum += jump.momentum;
        flight.spin = spin_of<dimension>(spread_of(flight.pose.map, step.density_second), flight.momentum);
        taken -= kinetic_energy(step, flight);
        step.start_kinetic -= taken;
        // What the ground gave is in the kinetic energy afterwards: the impulses took that much more.
        step.ground_work += jump.ground_work;
        step.impact += taken + jump.ground_work;
    }
    fly(step, h - flown, flight);

    step.momentum = flight.momentum;
    step.step_rotation = flight.rotation;
    step.half_rotation = step.jumps ? half_of(flight.rotation) : rotation_by(typename K::Spin(0.5 * flight.turn));
    step.stretching = flight.stretching;
    step.predicted = flight.pose;
    step.predicted_orientation = flight.orientation;
    step.spread = spread_of(step.predicted.map, step.density_second);
    step.predicted_spin = flight.spin;
    step.predicted_velocity = flight.velocity;
    step.ballistic.setZero();
    if (step.jumps) step.ballistic = h * flight.velocity - (flight.pose.centroid - step.start.centroid);
    const typename K::Matrix predicted_rate = skew(step.predicted_spin) * step.predicted.map + step.stretching;
    step.predicted_kinetic = kinetic_energy(step, step.predicted_velocity, predicted_rate);
    step.velocity.template head<dimension>() = step.predicted_velocity;
    if constexpr (K::deformable)
        Map<typename K::Matrix>{step.velocity.data() + dimension} = predicted_rate * step.predicted.map.inverse();
    else
        step.velocity.template tail<K::spins>() = step.predicted_spin;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                \
    template double kinetic_energy(const BlockStep<K>&, const typename K::Vector&, const typename K::Matrix&); \
    template void predict(const State&, int, double, std::span<const Jump<K>>, BlockStep<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
