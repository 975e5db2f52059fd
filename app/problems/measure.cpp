#include "app/problems/measure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "libdda/analysis/energies.h"
#include "libdda/model/friction_law.h"

namespace voussoir::app::problems
{

namespace
{

constexpr double unit_roundoff = std::numeric_limits<double>::epsilon();
constexpr double some_roundings = 50;       // that add up in a residual, as the engine's own bound has it
constexpr double cone_slack = 1e-6;         // of the bound of friction
constexpr double energy_slack = 1e-3;       // of what a step puts in, takes or holds
constexpr double tolerance_slack = 1.0001;  // of the tolerance that the engine compared with before it rounded

std::vector<bool> moving_blocks(const Model& model)
{
    std::vector<bool> moves(model.blocks.size(), true);
    for (const Foundation& foundation : model.foundations)
        if (foundation.fully_held()) moves[static_cast<std::size_t>(foundation.block)] = false;
    return moves;
}

/// What rounding alone leaves unbalanced of an elastic block [N].
double rounding_of_stress(const Model& model, int block)
{
    if (!is_deformable(model.kinematics)) return 0;
    const BlockMaterial& stone = model.materials[static_cast<std::size_t>(model.blocks[block].material)];
    const double constrained = stone.young * (1 - stone.poisson) / ((1 + stone.poisson) * (1 - 2 * stone.poisson));
    return some_roundings * unit_roundoff * constrained * std::pow(size_of(model, block), 2);
}

/// Coefficient of friction that no speed exceeds.
double largest_friction(const Model& model, const Stage& stage, int block_a, int block_b)
{
    const FrictionLaw law = friction_between(model, block_a, block_b, stage.type == StageType::dynamic);
    double most = law.at(0);
    if (law.joint)
        for (const FrictionAtSpeed& point : law.joint->friction_at_speed)
            most = std::max(most, law.at(point.speed));
    return most;
}

template <int D>
void add_pressing(const ContactSetIn<D>& contacts, std::vector<double>& loads)
{
    for (const ContactPatchIn<D>& patch : contacts.patches)
        for (int i = 0; i < patch.point_count; ++i) {
            const double force = std::abs(contacts.points[patch.first_point + i].normal_force);
            loads[patch.block_a] += force;
            loads[patch.block_b] += force;
        }
}

/// What a point does that it may not; empty: nothing.
template <int D>
std::string fault_of_point(const ContactPointIn<D>& point, double friction, double small)
{
    const double pressing = std::max(0.0, point.normal_force), shear = point.shear_force.norm();
    if (point.normal_force < -small) return fmt::format("pulls with {:.3g} N", -point.normal_force);
    if (shear > friction * pressing * (1 + cone_slack) + small)
        return fmt::format("rubs with {:.3g} N where {:.3g} N is the bound", shear, friction * pressing);
    return {};
}

template <int D>
std::string fault_of_contacts(const Model& model, const Stage& stage, const State& state)
{
    const std::vector<double> loads = loads_of(model, stage, state);
    const ContactSetIn<D>& contacts = contacts_in<D>(state);
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        if (patch.intact) continue;
        const double friction = largest_friction(model, stage, patch.block_a, patch.block_b);
        const double small = stage.control.force_tolerance * std::max(loads[patch.block_a], loads[patch.block_b]);
        for (int i = 0; i < patch.point_count; ++i)
            if (const std::string fault =
                    fault_of_point<D>(contacts.points[patch.first_point + i], friction, small);
                !fault.empty())
                return model.blocks[patch.block_a].name + " on " + model.blocks[patch.block_b].name + " " + fault;
    }
    return {};
}

/// What gravity has done on the way from one state to the other [J]; nothing where it is no constant force on free
/// blocks.
std::optional<double> work_of_gravity(const Model& model, const Stage& stage, const State& before,
                                      const State& after)
{
    const bool all_held = std::all_of(model.foundations.begin(), model.foundations.end(),
                                      [](const Foundation& foundation) { return foundation.fully_held(); });
    if (!all_held || stage.gravity_ramp.duration > 0) return std::nullopt;
    const std::vector<bool> moves = moving_blocks(model);
    double work = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        if (!moves[b]) continue;
        const Eigen::Vector3d way =
            pose_of(model.kinematics, after, b).centroid - pose_of(model.kinematics, before, b).centroid;
        work += model.mass(b) * stage.gravity.dot(way);
    }
    return work;
}

std::string fault_of_energies(const Model& model, const Stage& stage, const State& before, const MadeStep& step)
{
    const EnergyLedger& energy = step.energy;
    if (!(energy.relative_residual() <= energy_slack))
        return fmt::format("leaves {:.3g} of its energy unexplained", energy.relative_residual());
    const double slack = energy_slack * energy.scale();
    const auto differs = [&](double booked, double there) { return !(std::abs(booked - there) <= slack); };
    const EnergyLedger found = open_ledger(model, step.state);
    if (differs(energy.kinetic, found.kinetic)) return "books another motion than it leaves";
    if (differs(energy.strain, found.strain)) return "books another strain than it leaves";
    if (differs(energy.contact, found.contact)) return "books other contact springs than it leaves";
    const std::optional<double> fall = work_of_gravity(model, stage, before, step.state);
    if (fall && differs(energy.gravity_work, *fall)) return "books another fall of its blocks than it leaves";
    return {};
}

template <int D>
Difference difference_in(const Model& model, const Stage& stage, double h, const State& one, const State& other)
{
    const std::vector<double> loads = loads_of(model, stage, one);
    const std::vector<bool> moves = moving_blocks(model);
    Difference found;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        if (!moves[b]) continue;
        const PoseIn<D> here = pose_in<D>(model.kinematics, one, b),
                        there = pose_in<D>(model.kinematics, other, b);
        const double size = size_of(model, b), to_force = 2 * model.mass(b) / (h * h);
        const double rounding = some_roundings * unit_roundoff * (here.centroid.norm() + size);
        const double distance =
            std::max((there.centroid - here.centroid).norm(), size * (there.map - here.map).norm());
        const double allowed = stage.control.force_tolerance * loads[b] + to_force * rounding +
                               rounding_of_stress(model, b) + std::numeric_limits<double>::min();
        const double times = to_force * distance / allowed;
        if (!(times <= found.worst)) found = {times, b};
    }
    return found;
}

}  // namespace

std::vector<double> loads_of(const Model& model, const Stage& stage, const State& state)
{
    std::vector<double> loads(model.blocks.size());
    for (int b = 0; b < static_cast<int>(loads.size()); ++b) loads[b] = model.mass(b) * stage.gravity.norm();
    add_pressing(state.contacts, loads);
    add_pressing(state.planar_contacts, loads);
    return loads;
}

Difference difference_between(const Model& model, const Stage& stage, double h, const State& one,
                              const State& other)
{
    return is_planar(model.kinematics) ? difference_in<2>(model, stage, h, one, other)
                                       : difference_in<3>(model, stage, h, one, other);
}

std::string fault_of(const Model& model, const Stage& stage, const State& before, const MadeStep& step)
{
    if (!(step.report.unbalanced <= tolerance_slack * stage.control.force_tolerance))
        return fmt::format("leaves {:.3g} of a load unbalanced", step.report.unbalanced);
    const std::string fault = is_planar(model.kinematics) ? fault_of_contacts<2>(model, stage, step.state)
                                                          : fault_of_contacts<3>(model, stage, step.state);
    return fault.empty() ? fault_of_energies(model, stage, before, step) : fault;
}

}  // namespace voussoir::app::problems
