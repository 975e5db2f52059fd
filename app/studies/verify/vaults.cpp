// Domes and vaults under their own weight: what they push against their supports.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/studies/verify/families.h"
#include "app/studies/verify/references/thrust_line.h"
#include "app/studies/verify/references/vault_thrust.h"
#include "app/studies/verify/vault_scene.h"

namespace voussoir::app::studies::verify
{
namespace
{

namespace patterns = importers::patterns;
using Eigen::Vector3d;

VerifyResult run_dome(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    for (const int n : {1, 2, 3}) {
        const patterns::Dome dome{.thickness = 0.25,
                                  .oculus = 5 * degree,
                                  .springing = 45 * degree,
                                  .courses = 4 * n,
                                  .stones = 12 * n,
                                  .bonded = false};
        const patterns::StoneGrid grid = patterns::dome(dome);
        const scenes::StagedScene scene = vault_scene(grid, setting, smooth);
        State state;
        const std::vector<Reaction> reactions = rest(scene, state, result);
        if (!result.failure.empty()) return result;
        double thrust = 0;
        for (const Reaction& reaction : reactions)
            thrust -= reaction.force.head<2>().dot(reaction.centre.head<2>().normalized());
        const double round =
            references::dome_thrust({dome.radius, dome.thickness, dome.oculus, dome.springing, vault_unit_weight});
        result.error = std::abs(thrust / round - 1);
        result.answer.push_back(thrust);
        result.note += fmt::format("{}{} stones: thrust {:.2f} kN, of the shell {:.2f} kN, ", separator(result),
                                   grid.stones().size(), thrust / 1e3, round / 1e3) +
                       of_equilibrium(grid, scene.model, state, reactions);
    }
    return result;
}

/// Joints of the right half of a vault with an even number of courses, one stone along each.
std::vector<references::HalfArchJoint> half_arch(const patterns::BarrelVault& vault,
                                                 const patterns::StoneGrid& grid, const Model& model)
{
    std::vector<references::HalfArchJoint> joints;
    double weight = 0, moment = 0;
    // Block 0 is the left support, then the courses from left to right.
    for (int course = vault.courses / 2 + 1; course <= vault.courses + 1; ++course) {
        const patterns::ThroughEdge& below = grid.stones()[course].parts[0].edges[0];
        const Vector3d inner = grid.corners()[below.inner], outer = grid.corners()[below.outer];
        joints.push_back(
            {{inner.x(), inner.z()}, {outer.x(), outer.z()}, weight, weight > 0 ? moment / weight : 0});
        weight += scenes::papers_gravity * model.mass(course);
        moment += scenes::papers_gravity * model.mass(course) * model.blocks[course].moments.centroid.x();
    }
    return joints;
}

VerifyResult run_barrel(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    bool all_inside = true;
    for (const double share : {0.15, 0.12, 0.11}) {
        const double radius = 5, thickness = share * radius, inner = radius - thickness / 2;
        const patterns::BarrelVault vault{.span = 2 * inner,
                                          .rise = inner,
                                          .thickness = thickness,
                                          .length = 1,
                                          .courses = 20,
                                          .stones = 1,
                                          .bonded = false};
        const patterns::StoneGrid grid = patterns::barrel_vault(vault);
        const scenes::StagedScene scene = vault_scene(grid, setting, rough);
        State state;
        const std::vector<Reaction> reactions = rest(scene, state, result);
        if (!result.failure.empty()) return result;
        const references::ThrustRange range = references::thrust_range(half_arch(vault, grid, scene.model));
        const double thrust = reactions.front().force.x(), middle = (range.least + range.greatest) / 2;
        all_inside = all_inside && range.exists && thrust >= range.least && thrust <= range.greatest;
        result.error = all_inside ? std::abs(thrust / middle - 1) : 1;
        result.answer.push_back(thrust);
        result.note +=
            fmt::format("{}thickness {:g} of the radius: thrust {:.3f} kN, statics {:.3f} to {:.3f} kN, ",
                        separator(result), share, thrust / 1e3, range.least / 1e3, range.greatest / 1e3) +
            of_equilibrium(grid, scene.model, state, reactions);
    }
    return result;
}

}  // namespace

std::vector<Benchmark> vault_benchmarks()
{
    Benchmark row = vault_row();
    std::vector<Benchmark> rows;

    row.name = "dome-thrust";
    row.title = "A dome of 60 to 468 stones on smooth bearings, under its own weight";
    row.quantity = "|thrust at the springing / that of the membrane - 1|, the finest of three";
    row.choices =
        "Radius 5 m, thickness 0.25 m, from 5 to 45 degrees from the axis: less than the 51.8 degrees at which "
        "hoop "
        "forces of the membrane turn to tension, which dry joints have not. On bearings that take no shear the "
        "reaction is normal to the bed, so that the thrust follows from the weight alone; with friction it would "
        "lie between the limits of limit analysis. What differs is chords for arcs.";
    row.run = run_dome;
    rows.push_back(row);

    row.name = "barrel-thrust";
    row.title = "A semicircular barrel vault near its least thickness, under its own weight";
    row.quantity =
        "|thrust / middle of the range of limit analysis - 1| at 0.11 of the radius; 1 when any of three "
        "thicknesses leaves its range";
    row.choices =
        "Mean radius 5 m, 20 courses, friction 37 degrees. Thrust is indeterminate by the width of the range: 26 "
        "% of "
        "its middle at 0.15 of the mean radius, 1.8 % at 0.11; below 0.1075 no vault stands.";
    row.run = run_barrel;
    rows.push_back(row);
    return rows;
}

}  // namespace voussoir::app::studies::verify
