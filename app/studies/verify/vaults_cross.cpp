// A cross vault under its own weight: what it pushes against its four supports.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studies/verify/families.h"
#include "app/studies/verify/references/thrust_line.h"
#include "app/studies/verify/references/vault_thrust.h"
#include "app/studies/verify/vault_scene.h"
#include "libdda/analysis/joint_resultants.h"

namespace voussoir::app::studies::verify
{
namespace
{

namespace patterns = importers::patterns;

/// The half of a vault on the positive side of a plane of its crown, across x (0) or y (1).
struct HalfVault {
    double weight = 0, centroid = 0;  // N; m from the plane, of the stones that are not held
    double thrust = 0, height = 0;    // N; m: what the other half exerts on it at the crown
    double support = 0, foot = 0;     // m: from the plane, and level, of the reactions of its supports
    double carried = 0;               // -, what its supports carry of its weight; the other half carries the rest
    double reaction = 0;              // N, of the supports along the normal of the plane, inward
};

void add_weights(const Model& model, int axis, HalfVault& half)
{
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const double x = model.blocks[b].moments.centroid[axis];
        if (model.blocks[b].group == support || x < 0) continue;
        half.weight += scenes::papers_gravity * model.mass(static_cast<int>(b));
        half.centroid += scenes::papers_gravity * model.mass(static_cast<int>(b)) * x;
    }
    half.centroid /= half.weight;
}

void add_crown(const Model& model, const State& state, int axis, HalfVault& half)
{
    for (const JointResultant& joint : joint_resultants(model, state)) {
        const double a = model.blocks[joint.block_a].moments.centroid[axis],
                     b = model.blocks[joint.block_b].moments.centroid[axis];
        if ((a > 0) == (b > 0)) continue;
        const double force = (a > 0 ? 1 : -1) * joint.force[axis];
        half.thrust += force;
        half.height += force * joint.pressure_centre.z();
    }
    half.height /= half.thrust;
}

HalfVault half_vault(const Model& model, const State& state, const std::vector<Reaction>& reactions, int axis)
{
    HalfVault half;
    add_weights(model, axis, half);
    add_crown(model, state, axis, half);
    double vertical = 0, horizontal = 0;
    for (const Reaction& reaction : reactions) {
        if (reaction.centre[axis] < 0) continue;
        vertical += reaction.force.z();
        half.support += reaction.force.z() * reaction.centre[axis];
        horizontal -= reaction.force[axis];
        half.foot -= reaction.force[axis] * reaction.centre.z();
    }
    half.support /= vertical;
    half.carried = vertical / half.weight;
    half.foot /= horizontal;
    half.reaction = horizontal;
    return half;
}

/// By geometry alone: the reaction anywhere on the springers, the thrust anywhere in the crown.
references::ThrustRange range_of(const patterns::CrossVault& vault, const HalfVault& half)
{
    const double radius = (vault.span * vault.span / 4 + vault.rise * vault.rise) / (2 * vault.rise);
    const double share = vault.thickness / radius;  // of the extrados beyond the intrados
    const double side = vault.span / 2 * (1 + share) + vault.margin, top = (radius - vault.rise) * share;
    return {references::crown_thrust(half.weight, vault.span / 2 - half.centroid, vault.rise + vault.thickness),
            references::crown_thrust(half.weight, side - half.centroid, vault.rise - top), true};
}

VerifyResult run_cross(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    for (const int n : {1, 2, 3}) {
        const patterns::CrossVault vault{.thickness = 0.4, .margin = 0.3, .courses = 3 * n, .stones = 2 * n};
        const patterns::StoneGrid grid = patterns::cross_vault(vault);
        const scenes::StagedScene scene = vault_scene(grid, setting, rough);
        State state;
        const std::vector<Reaction> reactions = rest(scene, state, result);
        if (!result.failure.empty()) return result;
        result.note += fmt::format("{}{} stones: ", separator(result), grid.stones().size());
        for (const int axis : {0, 1}) {
            const HalfVault half = half_vault(scene.model, state, reactions, axis);
            const double statics = references::crown_thrust(
                half.weight, half.carried * half.support - half.centroid, half.height - half.foot);
            const references::ThrustRange range = range_of(vault, half);
            const bool inside = half.reaction >= range.least && half.reaction <= range.greatest;
            result.error = std::max({result.error, std::abs(half.reaction / statics - 1),
                                     std::abs(half.thrust / statics - 1), inside ? 0. : 1.});
            result.answer.push_back(half.reaction);
            result.note += fmt::format(
                "thrust along {} {:.3f} kN at the supports, {:.3f} kN at the crown, statics "
                "{:.3f} kN, by geometry alone {:.0f} to {:.0f} kN, ",
                axis == 0 ? "x" : "y", half.reaction / 1e3, half.thrust / 1e3, statics / 1e3, range.least / 1e3,
                range.greatest / 1e3);
        }
        result.note += of_equilibrium(grid, scene.model, state, reactions);
    }
    return result;
}

}  // namespace

std::vector<Benchmark> cross_vault_benchmarks()
{
    Benchmark row = vault_row();
    row.name = "cross-vault-thrust";
    row.title = "A cross vault of 20 to 180 stones under its own weight";
    row.quantity =
        "largest |thrust / equilibrium of half the vault - 1| of three; 1 outside the bounds of geometry";
    row.choices =
        "Span 5 m, rise 2 m, thickness 0.4 m, friction 37 degrees. Moments of half the vault about the place "
        "where "
        "the reactions of its supports act; that place and the height of the thrust at the crown are measured, "
        "being "
        "indeterminate: by geometry alone they are known to the springers and to the thickness only. How the "
        "weight "
        "is shared by the two diagonals is indeterminate too.";
    row.run = run_cross;
    return {row};
}

}  // namespace voussoir::app::studies::verify
