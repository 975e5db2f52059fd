#include "libdda/step/energy_book.h"

#include <algorithm>

namespace voussoir::step
{

namespace
{

/// Work of the ground on the structure: held blocks move against their contact forces, held components of other
/// blocks against all forces on them [J].
template <class K>
double foundation_work(const StepProblem<K>& problem, const ContactSetIn<K::dimension>& contacts)
{
    constexpr int dimension = K::dimension;
    using Vector = typename K::Vector;
    const auto moved = [&](int block) {
        const BlockStep<K>& b = problem.blocks[block];
        return Vector(b.predicted.centroid - b.start.centroid);
    };
    double work = 0;
    for (std::size_t k = 0; k < contacts.patches.size(); ++k) {
        const PatchStep<K>& patch = problem.contacts.patches[k];
        const auto& found = contacts.patches[k];
        if (patch.row_b < 0) work -= patch.force_b.template head<dimension>().dot(moved(found.block_b));
        if (patch.row_a < 0) work -= patch.force_a.template head<dimension>().dot(moved(found.block_a));
    }
    for (std::size_t row = 0; row < problem.block_of_row.size(); ++row) {
        const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
        const Vector force =
            block.body_force + problem.contact_force.template segment<dimension>(K::unknowns * row);
        for (int k = 0; k < dimension; ++k)
            if (block.held[k]) work -= force[k] * moved(problem.block_of_row[row])[k];
    }
    return work;
}

/// What carrying the angular momentum exactly adds to the kinetic energy of the linear update v^ + 2 D / h [J].
/// From momentum and shape alone and not from the velocities of the state, so that an update which loses momentum
/// shows in the residual instead of passing for a loss of the method.
template <class K>
double momentum_gain(const BlockStep<K>& block, const typename K::Unknowns& d, const typename K::Spin& moment,
                     double h)
{
    using Matrix = typename K::Matrix;
    using Spin = typename K::Spin;
    if (block.rotation_held() || block.sides_tied) return 0;
    const Spin momentum = block.momentum + h * moment;
    const typename K::Unknowns linear = block.velocity + 2 / h * d;
    if constexpr (K::deformable) {
        const Matrix rate = K::gradient(linear) * block.predicted.map;
        const Matrix map = block.predicted.map + K::gradient(d) * block.predicted.map;
        const Spin missing = momentum - axial(Matrix(rate * block.density_second * map.transpose()));
        const Matrix spread = map * block.density_second * map.transpose();
        return spin_of<K::dimension>(spread, missing).dot(momentum - 0.5 * missing);
    } else {
        const Spin spin = linear.template tail<K::spins>();
        const Matrix turn = rotation_by(Spin(d.template tail<K::spins>()));
        const Spin turned = spin_of<K::dimension>(Matrix(turn * block.spread * turn.transpose()), momentum);
        return 0.5 * momentum.dot(turned) - 0.5 * spin.dot(inertia_tensor(block.spread) * spin);
    }
}

/// What the finite rotation adds to the kinetic energy: the momentum balance measures displacement by h v^ + D,
/// the forces work on the true one. Each force times the difference of the two, plus the steps of the kinetic
/// energy from the start to the prediction and from the linear to the exact update [J]. What the elastic force
/// does is not taken from what it is booked to store and lose, or no error of those terms would ever show.
template <class K>
double rotation_gain(const BlockStep<K>& block, const InternalForce<K>& internal, const typename K::Unknowns& d,
                     const typename K::Spin& moment, double h)
{
    double gain = block.predicted_kinetic - block.start_kinetic + momentum_gain(block, d, moment, h);
    if constexpr (K::deformable) {
        using Matrix = typename K::Matrix;
        using Flat = Eigen::Map<const Matrix>;
        if (block.rotation_held()) return gain;
        const typename K::Unknowns path = h * block.velocity + d;
        const Matrix end = block.predicted.map + K::gradient(d) * block.predicted.map;
        const Matrix way = (end - block.step_rotation * block.start.map) * block.predicted.map.inverse();
        const Flat force(internal.force.data() + K::dimension), steady(block.steady.data() + K::dimension),
            linear(path.data() + K::dimension);
        gain += steady.cwiseProduct(linear).sum() + force.cwiseProduct(way - linear).sum();
    }
    return gain;
}

/// Strain energy of a block as the state has it [J].
template <class K>
double strain_energy_of(const BlockStep<K>& block, const State& state, int b)
{
    if (!K::deformable || block.rotation_held()) return 0;
    const typename K::Matrix strain = green_strain_of(pose_in<K::dimension>(K::kinematics, state, b).map);
    const double own = block.elasticity.energy(strain);
    if (block.memory.branches.empty()) return own;
    return own + stored_in(block.memory.branches, state, b, block.elasticity, strain);
}

/// What a block adds to the ledger [J].
struct RowShare {
    double gravity_work = 0, load_work = 0, loss = 0, damped = 0, rotation_gain = 0, impact = 0, ground_work = 0,
           strain = 0, kinetic = 0;
    bool jumps = false;
};

template <class K>
RowShare share_of_row(const State& state, const StepProblem<K>& problem, int row)
{
    constexpr int n = K::unknowns;
    using Vector = typename K::Vector;
    const int b = problem.block_of_row[row];
    const BlockStep<K>& block = problem.blocks[b];
    const InternalForce<K>& internal = problem.internal[row];
    const typename K::Unknowns d = problem.d.template segment<n>(n * row);
    const typename K::Spin moment = K::moment_of(problem.contact_force.template segment<n>(n * row));
    const Vector moved = pose_in<K::dimension>(K::kinematics, state, b).centroid - block.start.centroid;
    RowShare share;
    share.gravity_work = block.gravity.dot(moved);
    share.load_work = (block.body_force - block.gravity).dot(moved);
    share.loss = internal.loss;
    share.damped = internal.damped;
    share.jumps = block.jumps;
    share.rotation_gain =
        rotation_gain(block, internal, d, moment, problem.h) + block.body_force.dot(block.ballistic);
    share.impact = block.impact;
    share.ground_work = block.ground_work;
    share.strain = strain_energy_of(block, state, b);
    share.kinetic = kinetic_energy_of(block, state, b);
    return share;
}

struct PatchShare {
    double gain = 0;  // J
    bool jumps = false;
};

/// Work of the forces of a patch on the displacements that the momentum knows, beyond that on the finite ones.
template <class K>
PatchShare gain_of_patch(const StepProblem<K>& problem, std::size_t k, const ContactPatchIn<K::dimension>& found)
{
    using Vector = typename K::Vector;
    const PatchStep<K>& patch = problem.contacts.patches[k];
    const BlockStep<K>&a = problem.blocks[found.block_a], &b = problem.blocks[found.block_b];
    PatchShare share{0, a.jumps || b.jumps};
    if (patch.pressing == 0 && patch.force_a.isZero(0)) return share;
    const typename K::Matrix turn_b = ballistic_turn(b, problem.h);
    LinearIn<K::dimension> known = linear_displacement(problem.d, patch);
    known.at_centroid += a.ballistic - b.ballistic - turn_b * patch.between;
    known.slope += ballistic_turn(a, problem.h) - turn_b;
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        const PointStep<K::dimension>& p = problem.contacts.points[i];
        if (p.normal == 0 && p.shear.isZero(0)) continue;
        const Vector force = p.normal * patch.normal - p.shear;
        share.gain += force.dot(known.at(p.lever)) - p.normal * (p.gap - p.gap_start) +
                      p.shear.dot(patch.displacement.at(p.lever));
    }
    if constexpr (K::deformable) share.gain += patch.stones.work();  // gaps and slips are those of bent stones
    return share;
}

}  // namespace

template <class K>
void book_step(const State& state, const StepProblem<K>& problem, const ContactSetIn<K::dimension>& contacts,
               EnergyLedger& energy)
{
    const ContactEnergies contact = contact_energies(problem.threads, problem.contacts);
    energy.contact = contact.stored;
    energy.friction += contact.friction;
    energy.damping_contact += contact.dashpot;
    energy.algorithmic += contact.loss;
    energy.closing += contact.closing;
    energy.fracture += problem.fracture;
    energy.foundation_work += foundation_work(problem, contacts);
    energy.kinetic = energy.strain = 0;
    add_in_order(
        problem.block_of_row.size(), problem.threads,
        [&](std::size_t row) { return share_of_row(state, problem, static_cast<int>(row)); },
        [&](const RowShare& share) {
            energy.gravity_work += share.gravity_work;
            energy.load_work += share.load_work;
            energy.algorithmic += share.loss;
            energy.damping_material += share.damped;
            (share.jumps ? energy.impact : energy.algorithmic_rotation) -= share.rotation_gain;
            energy.impact += share.impact;
            energy.foundation_work += share.ground_work;
            energy.strain += share.strain;
            energy.kinetic += share.kinetic;
        });
    add_patches_in_order(
        problem.contacts, problem.threads,
        [&](std::size_t k) { return gain_of_patch(problem, k, contacts.patches[k]); },
        [&](const PatchShare& share) {
            (share.jumps ? energy.impact : energy.algorithmic_rotation) -= share.gain;
        });
    problem.others.each(
        [&](const auto& group) { book_forces(state, problem.blocks, problem.d, problem.h, group, energy); });
    energy.note_peaks();
}

#define VOUSSOIR_INSTANTIATE(K) \
    template void book_step(const State&, const StepProblem<K>&, const ContactSetIn<K::dimension>&, EnergyLedger&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
