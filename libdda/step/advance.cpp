#include "libdda/step/advance.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <variant>

#include "libdda/step/reversal.h"
#include "libdda/step/step_system.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

/// What a scene of one kinematics works on.
template <class K>
struct Work {
    std::vector<PlacedPartIn<K::dimension>> parts;
    std::vector<double> reach;
    ContactSetIn<K::dimension> contacts;
    StepSystem<K> system;
};

}  // namespace

struct Workspace::Implementation {
    std::variant<Work<SpatialDeformable>, Work<SpatialRigid>, Work<PlanarDeformable>, Work<PlanarRigid>> work;
};

Workspace::Workspace(const Model& model) : implementation(std::make_unique<Implementation>())
{
    switch (model.kinematics) {
        case Kinematics::spatial_deformable:
            break;  // the variant's first
        case Kinematics::spatial_rigid:
            implementation->work.emplace<Work<SpatialRigid>>();
            break;
        case Kinematics::planar_deformable:
            implementation->work.emplace<Work<PlanarDeformable>>();
            break;
        case Kinematics::planar_rigid:
            implementation->work.emplace<Work<PlanarRigid>>();
            break;
    }
}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

namespace
{

constexpr double cut_factor = 0.3;
constexpr double contact_distance = 1e-3;  // of a block's size: closer parts are candidates whatever their speed

class Stopwatch
{
 public:
    Stopwatch(StepReport& report, Part part) : seconds_(report.seconds[static_cast<int>(part)]) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
    double& seconds_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <int D>
double radius_of(const Block& block)
{
    double square = 0;
    for (const auto& part : ShapeIn<D>::of(block))
        for (const VectorIn<D>& x : part.vertices) square = std::max(square, x.squaredNorm());
    return std::sqrt(square);
}

/// How far each block may move within the step: its velocity, its spin, gravity, and the ground under it.
template <class K>
void find_reach(const Model& model, const Stage& stage, const State& state, double h, std::vector<double>& reach)
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    double dashpot = 0;
    for (const JointMaterial& joint : model.joints) dashpot = std::max(dashpot, joint.dashpot);
    reach.resize(model.blocks.size());
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const double* v = state.velocities.data() + b * n;
        double turning = 0;
        for (int k = dimension; k < n; ++k) turning += v[k] * v[k];
        const double speed =
            typename K::Vector(v).norm() + std::sqrt(turning) * radius_of<dimension>(model.blocks[b]);
        reach[b] = (h + dashpot) * speed + h * h * stage.gravity.norm() * (stage.type == StageType::dynamic) +
                   contact_distance * size_of(model, static_cast<int>(b));
    }
    for (const FoundationMotion& motion : stage.motions) {
        const double from = motion.motion->displacement(state.stage_time);
        const double to = motion.motion->displacement(state.stage_time + h);
        reach[model.foundations[motion.foundation].block] += std::abs(to - from);
    }
}

/// The velocity that complete kinetic damping would leave: that of the ground; where supports move differently,
/// the mean of their motions.
Vector3d ground_velocity(const Stage& stage, double time)
{
    Vector3d velocity = Vector3d::Zero();
    for (int component = 0; component < 3; ++component) {
        std::vector<const GroundMotion*> different;  // a motion shared by many foundations counts once
        for (const FoundationMotion& motion : stage.motions)
            if (motion.component == component &&
                std::find(different.begin(), different.end(), motion.motion.get()) == different.end())
                different.push_back(motion.motion.get());
        for (const GroundMotion* motion : different)
            velocity[component] += motion->velocity(time) / static_cast<double>(different.size());
    }
    return velocity;
}

template <class K>
bool iterate_open_close(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                        StepSystem<K>& system, StepReport& report)
{
    const Stopwatch watch(report, Part::open_close);
    if (stage.control.open_close == OpenClose::published) return iterate_published(stage, system, report);
    return iterate_newton(model, stage, contacts, system, report);
}

/// Work of the ground on the structure: held blocks move against their contact forces, held components of other
/// blocks against all forces on them [J].
template <class K>
double foundation_work(const StepSystem<K>& system, const ContactSetIn<K::dimension>& contacts)
{
    constexpr int dimension = K::dimension;
    using Vector = typename K::Vector;
    const auto moved = [&](int block) {
        const BlockStep<K>& b = system.blocks[block];
        return Vector(b.predicted.centroid - b.start.centroid);
    };
    double work = 0;
    for (std::size_t k = 0; k < contacts.patches.size(); ++k) {
        const PatchStep<K>& patch = system.contacts.patches[k];
        const auto& found = contacts.patches[k];
        if (patch.row_b < 0) work -= patch.force_b.template head<dimension>().dot(moved(found.block_b));
        if (patch.row_a < 0) work -= patch.force_a.template head<dimension>().dot(moved(found.block_a));
    }
    for (std::size_t row = 0; row < system.block_of_row.size(); ++row) {
        const BlockStep<K>& block = system.blocks[system.block_of_row[row]];
        const Vector force =
            block.body_force + system.contact_force.template segment<dimension>(K::unknowns * row);
        for (int k = 0; k < dimension; ++k)
            if (block.held[k]) work -= force[k] * moved(system.block_of_row[row])[k];
    }
    return work;
}

/// What the finite rotation adds to the kinetic energy: the momentum balance measures displacement by h v^ + D,
/// the forces work on the true one. Each force times the difference of the two, plus the steps of the kinetic
/// energy from the start to the prediction and from the linear to the exact update [J].
template <class K>
double rotation_gain(const BlockStep<K>& block, const InternalForce<K>& internal, const typename K::Unknowns& d,
                     double h, double end_kinetic)
{
    const typename K::Unknowns path = h * block.velocity + d;
    const double linear_end = block.predicted_kinetic + (block.inertia * d).dot(path);
    double gain = block.predicted_kinetic - block.start_kinetic + end_kinetic - linear_end;
    if constexpr (K::deformable) {
        constexpr int strains = K::unknowns - K::dimension;
        if (block.rotation_held()) return gain;
        gain += (block.steady - internal.force).template tail<strains>().dot(path.template tail<strains>());
        gain += internal.energy - block.elasticity.energy(block.start_strain) + internal.loss;
    }
    return gain;
}

/// Work and losses of the accepted step, each from its own forces and displacements: see EnergyLedger. The state
/// is already the new one.
template <class K>
void book_step(const State& state, const StepSystem<K>& system, const ContactSetIn<K::dimension>& contacts,
               EnergyLedger& energy)
{
    constexpr int n = K::unknowns;
    using Vector = typename K::Vector;
    const ContactEnergies contact = contact_energies(system.contacts);
    energy.contact = contact.stored;
    energy.friction += contact.friction;
    energy.damping_contact += contact.dashpot;
    energy.algorithmic += contact.loss;
    energy.fracture += system.fracture;
    energy.foundation_work += foundation_work(system, contacts);
    energy.kinetic = energy.strain = 0;
    for (std::size_t row = 0; row < system.block_of_row.size(); ++row) {
        const int b = system.block_of_row[row];
        const BlockStep<K>& block = system.blocks[b];
        const InternalForce<K>& internal = system.internal[row];
        const typename K::Unknowns d = system.d.template segment<n>(n * row);
        const Vector moved = block.predicted.centroid + d.template head<K::dimension>() - block.start.centroid;
        const double kinetic = kinetic_energy_of(block, state, b);
        energy.gravity_work += block.gravity.dot(moved);
        energy.load_work += (block.body_force - block.gravity).dot(moved);
        energy.algorithmic += internal.loss;
        energy.algorithmic_rotation -= rotation_gain(block, internal, d, system.h, kinetic);
        energy.strain += internal.energy;
        energy.kinetic += kinetic;
    }
    for (const PatchStep<K>& patch : system.contacts.patches)
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            const PointStep<K::dimension>& p = system.contacts.points[i];
            const Vector force = p.normal * patch.normal - p.shear;
            energy.algorithmic_rotation -= force.dot(p.ballistic_a - p.ballistic_b);
        }
}

/// Moves all blocks to the end of the step.
template <class K>
void update_blocks(const StepSystem<K>& system, State& state)
{
    constexpr int n = K::unknowns;
    for (std::size_t b = 0; b < system.blocks.size(); ++b) {
        const BlockStep<K>& block = system.blocks[b];
        typename K::Unknowns d = K::Unknowns::Zero();
        typename K::Spin moment = K::Spin::Zero();
        if (block.row >= 0) {
            d = system.d.template segment<n>(n * block.row);
            moment = K::moment_of(system.contact_force.template segment<n>(n * block.row));
        }
        update_block(block, d, moment, system.h, static_cast<int>(b), state);
    }
}

/// Stores the contacts with the forces, gaps and slips of the end of the step. Slips turn with the reference body.
template <class K>
void update_contacts(const Stage& stage, const StepSystem<K>& system, const ContactSetIn<K::dimension>& contacts,
                     State& state, StepReport& report)
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    using Vector = typename K::Vector;
    ContactSetIn<dimension>& stored = contacts_in<dimension>(state);
    stored = contacts;
    for (std::size_t k = 0; k < stored.patches.size(); ++k) {
        ContactPatchIn<dimension>& kept = stored.patches[k];
        const PatchStep<K>& patch = system.contacts.patches[k];
        const BlockStep<K>& reference = system.blocks[kept.block_b];
        const BlockStep<K>& incident = system.blocks[kept.block_a];
        typename K::Unknowns d_a = K::Unknowns::Zero(), d_b = K::Unknowns::Zero();
        if (patch.row_a >= 0) d_a = system.d.template segment<n>(n * patch.row_a);
        if (patch.row_b >= 0) d_b = system.d.template segment<n>(n * patch.row_b);
        const typename K::Matrix turn = rotation_of_step(reference, d_b);
        // A point that carries next to nothing flickers by rounding, and so does one that has come to rest at its
        // friction bound, between sticking and sliding; neither is a change of the structure.
        const double load = std::max(patch.row_a >= 0 ? system.load[patch.row_a] : 0,
                                     patch.row_b >= 0 ? system.load[patch.row_b] : 0);
        const double enough = stage.unbalanced_tolerance * load;
        kept.intact = patch.intact;
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            const PointStep<dimension>& p = system.contacts.points[i];
            ContactPointIn<dimension>& point = stored.points[i];
            const Vector slip = slip_at_end<dimension>(p, patch.normal);
            const Vector sliding =
                p.displacement - patch.normal.dot(p.displacement) * patch.normal - (slip - p.slip_start);
            if (p.status != ContactStatus::open) point.plastic_slip += sliding;
            point.plastic_slip = turn * point.plastic_slip;
            point.elastic_slip = turn * slip;
            const double carried = std::max(p.normal, -p.normal_stiffness * p.gap_start);
            const bool stays_closed = p.status != ContactStatus::open && point.status != ContactStatus::open;
            const bool at_bound = stays_closed && std::abs(p.trial.norm() - p.bound) <= enough;
            report.contact_state_changed =
                report.contact_state_changed || (point.status != p.status && carried > enough && !at_bound);
            point.status = p.status;
            point.gap = p.gap;
            point.normal_force = p.normal;
            point.shear_force = p.shear;
            point.position = incident.predicted.centroid + p.lever_a + K::displacement(d_a, p.lever_a);
            report.max_penetration = std::max(report.max_penetration, -p.gap);
            report.closed_points += p.status != ContactStatus::open;
        }
    }
}

/// Velocities after the step: zero in a static stage, else damped relative to the ground.
template <class K>
void damp_velocities(const Stage& stage, const StepSystem<K>& system, State& state, EnergyLedger& energy)
{
    const bool is_static = stage.type == StageType::static_equilibrium;
    const double factor = is_static ? 0 : stage.damping.factor_per_step * std::exp(-stage.damping.rate * system.h);
    if (factor == 1) return;
    const Vector3d ground = is_static ? Vector3d::Zero() : ground_velocity(stage, state.stage_time);
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

/// Largest force that inertia still had to balance, as a share of the block's load: what a static stage must bring
/// to nothing. With the velocity zeroed it is the unbalanced force itself.
template <class K>
double inertia_ratio(const StepSystem<K>& system)
{
    constexpr int n = K::unknowns;
    double worst = 0;
    for (std::size_t row = 0; row < system.block_of_row.size(); ++row) {
        const BlockStep<K>& block = system.blocks[system.block_of_row[row]];
        const typename K::Unknowns force = block.inertia * system.d.template segment<n>(n * row);
        const double size = std::max(force.template head<K::dimension>().norm(),
                                     force.template tail<n - K::dimension>().norm() / block.size);
        if (size > 0) worst = std::max(worst, size / system.load[row]);
    }
    return worst;
}

template <class K>
StepReport advance_with(const Model& model, const Stage& stage, double time_step, State& state,
                        EnergyLedger& energy, Work<K>& work)
{
    StepSystem<K>& system = work.system;
    StepReport report;
    double h = time_step;
    {
        const Stopwatch watch(report, Part::contact_search);
        find_reach<K>(model, stage, state, h, work.reach);
        find_contacts(model, state, work.reach, stage.control.threads, work.parts, work.contacts);
    }
    const bool may_divide = stage.type == StageType::dynamic && stage.control.open_close == OpenClose::newton;
    ReversalSearch reversal;
    while (true) {
        {
            const Stopwatch watch(report, Part::assembly);
            assemble_blocks(model, stage, state, work.contacts, h, system);
        }
        if (iterate_open_close(model, stage, work.contacts, system, report)) {
            std::optional<double> shorter;
            if (may_divide && static_cast<int>(system.block_of_row.size()) <= stage.control.divide_up_to_blocks)
                shorter = step_to_reversal(work.contacts, system, reversal);
            if (!shorter) break;
            h = *shorter;
            continue;
        }
        ++report.cuts;
        reversal = {};
        h *= cut_factor;
        if (h < stage.control.min_time_step) {
            report.outcome = StepOutcome::gave_up;
            return report;
        }
    }
    const Stopwatch watch(report, Part::update);
    report.time_step = h;
    report.divided = reversal.passes > 0;
    energy.redetection += energy.contact - spring_energy(model, work.contacts);
    update_blocks(system, state);
    book_step(state, system, work.contacts, energy);
    update_contacts(stage, system, work.contacts, state, report);
    state.time += h;
    state.stage_time += h;
    ++state.step;
    damp_velocities(stage, system, state, energy);
    for (const BlockStep<K>& block : system.blocks)
        if (block.row >= 0)
            report.max_displacement = std::max(
                report.max_displacement, system.d.template segment<K::dimension>(K::unknowns * block.row).norm());
    if (stage.type == StageType::static_equilibrium)
        report.inertia_ratio = inertia_ratio(system) + report.unbalanced;
    return report;
}

}  // namespace

StepReport advance(const Model& model, const Stage& stage, double time_step, State& state, EnergyLedger& energy,
                   Workspace& work)
{
    return std::visit([&](auto& of) { return advance_with(model, stage, time_step, state, energy, of); },
                      work.implementation->work);
}

namespace
{

template <int D>
void find_contacts_at_rest(const Model& model, State& state)
{
    std::vector<double> reach(model.blocks.size());
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        reach[b] = contact_distance * size_of(model, static_cast<int>(b));
    std::vector<PlacedPartIn<D>> parts;
    ContactSetIn<D> contacts;
    find_contacts(model, state, reach, 1, parts, contacts);
    contacts_in<D>(state) = std::move(contacts);
}

}  // namespace

void find_initial_contacts(const Model& model, State& state)
{
    if (is_planar(model.kinematics))
        find_contacts_at_rest<2>(model, state);
    else
        find_contacts_at_rest<3>(model, state);
}

}  // namespace voussoir
