#include "libdda/step/update.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "libdda/model/parallel.h"

namespace voussoir::step
{

using Eigen::Vector3d;

Vector3d ground_velocity(const Model& model, const Stage& stage, double time)
{
    Vector3d velocity = Vector3d::Zero();
    for (int component = 0; component < 3; ++component) {
        std::vector<const GroundMotion*> different;  // a motion shared by many foundations counts once
        std::size_t moved = 0, held = 0;
        for (const FoundationMotion& motion : stage.motions) {
            if (motion.component != component) continue;
            ++moved;
            if (std::find(different.begin(), different.end(), motion.motion.get()) == different.end())
                different.push_back(motion.motion.get());
        }
        for (const Foundation& foundation : model.foundations) held += foundation.translation_held[component];
        const std::size_t motions = different.size() + (held > moved);
        for (const GroundMotion* motion : different)
            velocity[component] += motion->velocity(time) / static_cast<double>(motions);
    }
    return velocity;
}

template <class K>
void update_blocks(const StepSystem<K>& system, State& state)
{
    constexpr int n = K::unknowns;
    in_parallel(system.blocks.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t b = first; b < end; ++b) {
            const BlockStep<K>& block = system.blocks[b];
            typename K::Unknowns d = K::Unknowns::Zero();
            typename K::Spin moment = K::Spin::Zero();
            if (block.row >= 0) {
                d = system.d.template segment<n>(n * block.row);
                moment = K::moment_of(system.contact_force.template segment<n>(n * block.row));
            }
            update_block(block, d, moment, system.h, static_cast<int>(b), state);
        }
    });
}

template <class K>
void update_contacts(const Model& model, const Stage& stage, const StepSystem<K>& system,
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
        const PatchStep<K>& patch = system.contacts.patches[k];
        const BlockStep<K>& reference = system.blocks[kept.block_b];
        typename K::Unknowns d_a = K::Unknowns::Zero(), d_b = K::Unknowns::Zero();
        if (patch.row_a >= 0) d_a = system.d.template segment<n>(n * patch.row_a);
        if (patch.row_b >= 0) d_b = system.d.template segment<n>(n * patch.row_b);
        const typename K::Matrix turn = rotation_of_step(reference, d_b);
        const typename K::Matrix rest = turn * reference.half_rotation.transpose();  // from the middle of the step
        // A point that carries next to nothing flickers by rounding, and so does one that has come to rest at its
        // friction bound, between sticking and sliding; neither is a change of the structure.
        const double load = std::max(patch.row_a >= 0 ? system.load[patch.row_a] : 0,
                                     patch.row_b >= 0 ? system.load[patch.row_b] : 0);
        const double enough = stage.unbalanced_tolerance * load;
        kept.intact = patch.intact;
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            const PointStep<dimension>& p = system.contacts.points[i];
            ContactPointIn<dimension>& point = stored.points[i];
            point = contacts.points[i];
            const Vector slip = slip_at_end(patch, p);
            const Vector sliding =
                p.displacement - patch.normal.dot(p.displacement) * patch.normal - (slip - p.slip_start);
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
            point.position = system.blocks[kept.block_a].predicted.centroid + p.end_lever_a +
                             K::displacement(d_a, p.end_lever_a);
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
void damp_velocities(const Model& model, const Stage& stage, const StepSystem<K>& system, State& state,
                     EnergyLedger& energy)
{
    const bool is_static = stage.type == StageType::static_equilibrium;
    const double factor = is_static ? 0 : stage.damping.factor_per_step * std::exp(-stage.damping.rate * system.h);
    if (factor == 1) return;
    const Vector3d ground = is_static ? Vector3d::Zero() : ground_velocity(model, stage, state.stage_time);
    double kinetic = 0;
    for (std::size_t b = 0; b < system.blocks.size(); ++b) {
        const BlockStep<K>& block = system.blocks[b];
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
    template void update_blocks(const StepSystem<K>&, State&);                             \
    template void update_contacts(const Model&, const Stage&, const StepSystem<K>&,        \
                                  const ContactSetIn<K::dimension>&, State&, StepReport&); \
    template void damp_velocities(const Model&, const Stage&, const StepSystem<K>&, State&, EnergyLedger&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
