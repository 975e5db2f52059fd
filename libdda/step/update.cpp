#include "libdda/step/update.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "libdda/block/ground_velocity.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{

using Eigen::Vector3d;

template <class K>
void update_blocks(const StepProblem<K>& problem, State& state)
{
    constexpr int n = K::unknowns;
    in_parallel(problem.blocks.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t b = first; b < end; ++b) {
            const BlockStep<K>& block = problem.blocks[b];
            if (problem.stays && block.row >= 0) continue;  // the moment of what rounding leaves would turn it
            typename K::Unknowns d = K::Unknowns::Zero();
            typename K::Spin moment = K::Spin::Zero();
            if (block.row >= 0) {
                d = problem.d.template segment<n>(n * block.row);
                moment = K::moment_of(problem.contact_force.template segment<n>(n * block.row));
            }
            update_block(block, d, moment, problem.h, static_cast<int>(b), state);
        }
    });
}

template <class K>
void update_contacts(const Model& model, const Stage& stage, const StepProblem<K>& problem,
                     const ContactSetIn<K::dimension>& contacts, State& state, StepReport& report)
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    using Vector = typename K::Vector;
    ContactSetIn<dimension>& stored = contacts_in<dimension>(state);
    stored.patches.resize(contacts.patches.size());
    stored.points.resize(contacts.points.size());
    struct Found {
        bool state_changed = false;
        double penetration = 0;  // m
        int closed = 0;
    };
    const auto update_patch = [&](std::size_t k, Found& found) {
        ContactPatchIn<dimension>& kept = stored.patches[k];
        kept = contacts.patches[k];
        const PatchStep<K>& patch = problem.contacts.patches[k];
        const BlockStep<K>& reference = problem.blocks[kept.block_b];
        typename K::Unknowns d_a = K::Unknowns::Zero(), d_b = K::Unknowns::Zero();
        if (patch.row_a >= 0) d_a = problem.d.template segment<n>(n * patch.row_a);
        if (patch.row_b >= 0) d_b = problem.d.template segment<n>(n * patch.row_b);
        const typename K::Matrix turn = rotation_of_step(reference, d_b);
        const typename K::Matrix rest = turn * reference.half_rotation.transpose();  // from the middle of the step
        // A point that carries next to nothing flickers by rounding, and so does one that has come to rest at its
        // friction bound, between sticking and sliding; neither is a change of the structure.
        const double load = std::max(patch.row_a >= 0 ? problem.load[patch.row_a] : 0,
                                     patch.row_b >= 0 ? problem.load[patch.row_b] : 0);
        const double enough = stage.unbalanced_tolerance * load;
        kept.intact = patch.intact;
        if constexpr (K::deformable) kept.bending_energy = energy_of_stones(patch, problem.contacts.points);
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            const PointStep<dimension>& p = problem.contacts.points[i];
            ContactPointIn<dimension>& point = stored.points[i];
            point = contacts.points[i];
            const Vector slip = slip_at_end(patch, p);
            const Vector move = patch.displacement.at(p.lever);
            const Vector sliding = tangential(move, patch.normal) - (slip - p.slip_start);
            point.plastic_slip = turn * point.plastic_slip;
            if (p.status != ContactStatus::open) point.plastic_slip += rest * sliding;
            point.elastic_slip = rest * slip;
            const double carried = std::max(p.normal, -p.normal_stiffness * p.gap_start);
            const bool stays_closed = p.status != ContactStatus::open && point.status != ContactStatus::open;
            const bool at_bound = stays_closed && std::abs(p.trial.norm() - p.bound) <= enough;
            found.state_changed =
                found.state_changed || (point.status != p.status && carried > enough && !at_bound);
            point.status = p.status;
            point.gap = p.gap;
            point.normal_force = p.normal;
            point.shear_force = p.shear;
            const Vector lever = patch.end_of_lever * p.lever;
            point.position = problem.blocks[kept.block_a].predicted.centroid + lever + K::displacement(d_a, lever);
            found.penetration = std::max(found.penetration, contact::depth_beyond_fit(model, point));
            found.closed += p.status != ContactStatus::open;
        }
    };
    std::mutex mutex;
    in_parallel(stored.patches.size(), stage.control.threads, [&](std::size_t first, std::size_t end) {
        Found found;
        for (std::size_t k = first; k < end; ++k) update_patch(k, found);
        const std::lock_guard lock(mutex);
        report.contact_state_changed = report.contact_state_changed || found.state_changed;
        report.max_penetration = std::max(report.max_penetration, found.penetration);
        report.closed_points += found.closed;
    });
}

template <class K>
void damp_velocities(const Model& model, const Stage& stage, const StepProblem<K>& problem, State& state,
                     EnergyLedger& energy)
{
    const bool is_static = stage.type == StageType::static_equilibrium;
    const double factor =
        is_static ? 0 : stage.damping.factor_per_step * std::exp(-stage.damping.rate * problem.h);
    if (factor == 1) return;
    const Vector3d ground = is_static ? Vector3d::Zero() : ground_velocity(model, stage, state.stage_time);
    double kinetic = 0;
    for (std::size_t b = 0; b < problem.blocks.size(); ++b) {
        const BlockStep<K>& block = problem.blocks[b];
        double* v = state.velocities.data() + b * K::unknowns;
        for (int k = 0; k < K::unknowns; ++k) {
            const double base = k < K::dimension ? ground[axis_in_space<K::dimension>(k)] : 0;
            if (is_static || !block.held[k]) v[k] = base + factor * (v[k] - base);
        }
        if (block.row >= 0) kinetic += kinetic_energy_of(block, state, static_cast<int>(b));
    }
    (is_static ? energy.damping_static : energy.damping_kinetic) += energy.kinetic - kinetic;
    energy.kinetic = kinetic;
}

#define VOUSSOIR_INSTANTIATE(K)                                                            \
    template void update_blocks(const StepProblem<K>&, State&);                            \
    template void update_contacts(const Model&, const Stage&, const StepProblem<K>&,       \
                                  const ContactSetIn<K::dimension>&, State&, StepReport&); \
    template void damp_velocities(const Model&, const Stage&, const StepProblem<K>&, State&, EnergyLedger&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
