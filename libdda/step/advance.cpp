#include "libdda/step/advance.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <variant>

#include "libdda/step/energy_book.h"
#include "libdda/step/missed_contacts.h"
#include "libdda/step/reversal.h"
#include "libdda/step/step_system.h"
#include "libdda/step/update.h"

namespace voussoir
{

namespace
{

/// What a scene of one kinematics works on.
template <class K>
struct Work {
    std::vector<PlacedPartIn<K::dimension>> parts;
    std::vector<double> radii, reach;  // m, of the blocks
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

/// How far each block may move within the step: its velocity, its spin, gravity, and the ground under it.
template <class K>
void find_reach(const Model& model, const Stage& stage, const State& state, double h,
                const std::vector<double>& radii, std::vector<double>& reach)
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    double dashpot = 0;
    for (const JointMaterial& joint : model.joints) dashpot = std::max(dashpot, joint.relaxation_time);
    reach.resize(model.blocks.size());
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const double* v = state.velocities.data() + b * n;
        double turning = 0;
        for (int k = dimension; k < n; ++k) turning += v[k] * v[k];
        const double speed = typename K::Vector(v).norm() + std::sqrt(turning) * radii[b];
        reach[b] = (h + dashpot) * speed + h * h * stage.gravity.norm() * (stage.type == StageType::dynamic) +
                   contact_distance * size_of(model, static_cast<int>(b));
    }
    // A bond lasts until its strength breaks it, however soft it is: it is looked for as far as it has stretched.
    const auto& contacts = contacts_in<dimension>(state);
    for (const ContactPatchIn<dimension>& patch : contacts.patches) {
        if (!patch.intact) continue;
        double stretched = 0;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            stretched = std::max(stretched, contacts.points[i].gap + contacts.points[i].rest_gap);
        reach[patch.block_a] += stretched;
    }
    for (const FoundationMotion& motion : stage.motions) {
        const double from = motion.motion->displacement(state.stage_time);
        const double to = motion.motion->displacement(state.stage_time + h);
        reach[model.foundations[motion.foundation].block] += std::abs(to - from);
    }
}

template <class K>
bool iterate_open_close(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                        StepSystem<K>& system, StepReport& report)
{
    const Stopwatch watch(report, Part::open_close);
    if (stage.control.open_close == OpenClose::published) return iterate_published(stage, system, report);
    return iterate_newton(model, stage, contacts, system, report);
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

/// Books the spring energy that changed when contacts were found anew [J]. In the first step it is that of blocks
/// which the model has within one another; in a static stage nothing of it is left when the velocity has been
/// taken away.
void book_redetection(const Stage& stage, const State& state, double given, EnergyLedger& energy)
{
    if (state.step == 0)
        energy.start_contact += given;
    else if (stage.type == StageType::static_equilibrium)
        energy.damping_static -= given;
    else
        energy.redetection -= given;
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
        if (work.radii.empty()) work.radii = radii_of<K::dimension>(model);
        find_reach<K>(model, stage, state, h, work.radii, work.reach);
        // In static stages a new overlap presses; what that gives is gone with the velocity. The published
        // iteration takes contacts as they are.
        const bool forgives = stage.type == StageType::dynamic && stage.control.open_close == OpenClose::newton;
        find_contacts(model, state, work.reach, stage.control.threads, work.parts, work.contacts,
                      forgives && state.step > 0 ? NewOverlap::forgiven : NewOverlap::presses);
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
            if (shorter) {
                h = *shorter;
                continue;
            }
            if (!misses_a_contact(model, state, system, work.contacts, work.radii, work.reach,
                                  stage.control.threads))
                break;
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
    const double given = spring_energy(model, work.contacts) - energy.contact;
    book_redetection(stage, state, given, energy);
    update_blocks(system, state);
    book_step(state, system, work.contacts, energy);
    update_contacts(stage, system, work.contacts, state, report);
    if (stage.type == StageType::dynamic) state.time += h;
    state.stage_time += h;
    ++state.step;
    damp_velocities(model, stage, system, state, energy);
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
