// Limit states with default joints: the lateral capacity of a thin arch and of walls with an
// opening, the least thickness of an arch, and a bridge in which nothing opens.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studies/verify/engine_run.h"
#include "app/studies/verify/families.h"
#include "app/studies/verify/limit_masonry.h"
#include "app/studies/verify/run_scene.h"
#include "importers/patterns/arch_bridge.h"
#include "libdda/analysis/joint_openings.h"
#include "libdda/contact/normal_stiffness.h"
#include "libdda/limit/limit_analysis.h"

namespace voussoir::app::studies::verify
{
namespace
{

namespace patterns = importers::patterns;

constexpr double gravity = scenes::papers_gravity;

/// @param friction coefficient; @param young [Pa]
Model empty_model(const scenes::SceneSetting& setting, double friction, double thickness, double young = 1e10)
{
    JointMaterial joint = scenes::dry_joint(friction);
    joint.stiffness.factor = setting.stiffness_factor.value_or(1);
    return scenes::make_scene_model(setting, scenes::stone(2200, young), joint, thickness);
}

/// Makes a model ready for a case in which nothing but a steady weight acts, as the reader of case files does.
Model for_rest(Model model)
{
    contact::stiffen_for_rest(model);
    return model;
}

/// A semicircular arch of 27 voussoirs on held supports. @param share thickness / mean radius
Model semicircle(const scenes::SceneSetting& setting, double radius, double share)
{
    Model model = empty_model(setting, 0.7, 1, 1e12);
    const double inner = radius - share * radius / 2;
    patterns::BarrelVault vault;
    vault.span = 2 * inner;
    vault.rise = inner;
    vault.thickness = share * radius;
    vault.length = 1;
    vault.courses = 27;
    vault.stones = 1;
    vault.bonded = false;
    add_arch(model, vault);
    return model;
}

/// A wall with an opening between two piers of single stones, and one lintel on both.
/// @param sill, top courses below the opening and above the lintel
Model wall_with_opening(const scenes::SceneSetting& setting, double pier, double opening, int sill, int top)
{
    constexpr double course = 0.3, width = 1;  // m
    patterns::Wall wall;
    wall.length = 2 * pier + width;
    wall.height = (sill + 1 + top) * course + opening;
    wall.block_length = width;
    wall.block_height = course;
    wall.openings = {{pier, sill * course, width, opening}};
    wall.lintel = {course, pier};
    wall.base = {0.3, 0.3};
    wall.flat = is_planar(setting.kinematics);
    Model model = empty_model(setting, 0.8, wall.thickness);
    add_wall(model, wall);
    return model;
}

/// Adds a threshold found by bisection, beside its reference, to a result.
void compare(const Model& model, const scenes::SceneSetting& setting, double reference, const std::string& what,
             VerifyResult& result)
{
    constexpr double width = 2e-4;
    const EngineThreshold found = engine_threshold(model, 0.5 * reference, 1.1 * reference, width, setting);
    const double threshold = (found.stands + found.falls) / 2;
    VerifyResult one;
    one.error = std::abs(threshold / reference - 1);
    one.answer = {threshold / reference};
    one.steps = found.steps;
    one.step_cuts = found.step_cuts;
    one.iterations = found.iterations;
    one.cpu_time = found.cpu_time;
    one.note =
        fmt::format("{} blocks: {:.5f} of the weight, {} {:.5f}", model.blocks.size(), threshold, what, reference);
    add_run(result, one);
}

VerifyResult run_arch(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const Model model = for_rest(semicircle(setting, 10, 0.12));
    const limit::LimitProblem problem = limit_problem(model);
    compare(model, setting, limit::associated_limit(problem).factor, "linear program", result);
    result.note += fmt::format(", without dilatancy {:.5f}", limit::non_associated_limit(problem).factor);
    return result;
}

VerifyResult run_walls(const scenes::SceneSetting& setting)
{
    constexpr double pier = 0.6, opening = 1.2;  // m
    VerifyResult result;
    compare(for_rest(wall_with_opening(setting, pier, opening, 0, 2)), setting, pier / opening, "piers that rock",
            result);
    const Model model = for_rest(wall_with_opening(setting, pier, opening, 2, 0));
    const limit::LimitProblem problem = limit_problem(model);
    compare(model, setting, limit::non_associated_limit(problem).factor, "linear programs without dilatancy",
            result);
    result.note += fmt::format(", with it {:.5f}", limit::associated_limit(problem).factor);
    return result;
}

constexpr double arch_radius = 5;  // m

/// Whether gravity that is suddenly there moves stones by more than joints yield: 2 s after.
bool falls_suddenly(const Model& model, const scenes::SceneSetting& setting, VerifyResult& result)
{
    scenes::StagedScene scene{model, {scenes::dynamic_stage(setting, 2)}};
    scene.stages[0].stop_after_fallen = 1;
    State state = initial_state(model);
    run_scene(scene, state, {}, result);
    double moved = 0;
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        moved = std::max(moved, (pose_of(model.kinematics, state, static_cast<int>(b)).centroid -
                                 model.blocks[b].moments.centroid)
                                    .norm());
    return moved > 1e-4 * arch_radius;
}

/// The least share of the radius at which an arch stands, by bisection.
template <typename Stands>
double least_thickness(const scenes::SceneSetting& setting, Stands&& stands)
{
    double low = 0.1, high = 0.115;
    while (high - low > 5e-6) {
        const double middle = (low + high) / 2;
        (stands(semicircle(setting, arch_radius, middle)) ? high : low) = middle;
    }
    return (low + high) / 2;
}

VerifyResult run_thickness(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const double reference = least_thickness(
        setting, [](const Model& model) { return limit::associated_limit(limit_problem(model)).found; });
    const double slowly = least_thickness(setting, [&](const Model& model) {
        const Pushed pushed = push(for_rest(model), 0, setting);
        result.cpu_time += pushed.cpu_time;
        result.steps += pushed.report.steps;
        result.iterations += pushed.report.open_close_iterations;
        return pushed.report.outcome == Outcome::completed;
    });
    const double suddenly = least_thickness(
        setting, [&](const Model& model) { return !falls_suddenly(for_rest(model), setting, result); });
    result.error = std::max(std::abs(slowly - reference), std::abs(suddenly - reference));
    result.answer = {slowly, suddenly};
    result.note = fmt::format(
        "least thickness {:.5f} of the radius at rest, {:.5f} under sudden gravity, linear "
        "program {:.5f}",
        slowly, suddenly, reference);
    return result;
}

/// A stone is a prism across the bridge: a planar scene takes its outline.
Model bridge(const scenes::SceneSetting& setting)
{
    const patterns::ArchBridge shape;
    Model model = empty_model(setting, 0.7, shape.width, 1e12);
    for (const importers::mesh::PolygonSurface& stone : patterns::arch_bridge(shape))
        add_stone(model, stone.name, make_convex_polyhedron(stone.vertices, stone.faces, stone.name));
    for (const int abutment : {0, shape.voussoirs + 1}) scenes::hold(model, abutment);
    return model;
}

VerifyResult run_bridge(const scenes::SceneSetting& setting)
{
    const scenes::StagedScene scene{for_rest(bridge(setting)),
                                    {scenes::static_stage(setting, {gravity / 2, 0, -gravity})}};
    VerifyResult result;
    State state = initial_state(scene.model);
    const std::vector<WatchedJoint> joints = joints_at_start(scene.model, state);
    run_scene(scene, state, {}, result);
    const std::vector<PlacedBlock> blocks = placed_blocks(scene.model, state);
    double slip = 0;
    for (const WatchedJoint& joint : joints) {
        const JointMotion motion = motion_of(joint, blocks);
        result.error = std::max(result.error, motion.opening);
        slip = std::max(slip, motion.slip);
    }
    result.answer = {1, result.error};
    result.note = fmt::format(
        "opens by {:.2e} m, slips by {:.1e} m; linear program: it stands up to {:.3f} of the "
        "weight",
        result.error, slip, limit::associated_limit(limit_problem(scene.model)).factor);
    return result;
}

Benchmark limit_row(std::vector<Kinematics> also)
{
    Benchmark row;
    row.source = "docs/numerics.md 6: limit analysis by linear programming over the engine's contacts";
    row.paper_error = "none: not from a paper";
    row.setting.kinematics = Kinematics::planar_rigid;
    row.setting.integrator = Integrator::energy_decaying;
    row.setting.time_step = 2e-3;
    row.also = std::move(also);
    row.tolerance = 5e-3;
    for (const double factor : {0.003, 0.03, 0.3, 1.0, 3.0}) {
        row.sweep.push_back(row.setting);
        row.sweep.back().stiffness_factor = factor;
    }
    return row;
}

std::vector<Benchmark> capacity_rows()
{
    Benchmark arch = limit_row({Kinematics::spatial_rigid, Kinematics::planar_deformable});
    arch.name = "thin-arch-lateral";
    arch.title = "The lateral capacity of a thin arch";
    arch.quantity = "|lateral load / weight at which it falls / that of limit analysis - 1|";
    arch.choices =
        "A semicircle of 27 voussoirs, its mean radius 10 m, thickness 0.12 of it, friction 0.7; 1000 GPa "
        "(elastic stones of 10 GPa lose 8 % of it, for a thin arch yields). "
        "Bisection "
        "of the verdict of static stages, to 2e-4. Default joints of a case without motion: 300 E/L "
        "between rigid stones, 30 E/L between elastic ones. Joints 300 times as soft, as those of rigid scenes "
        "once were, take 4 % of its "
        "capacity.";
    arch.run = run_arch;
    Benchmark walls = limit_row({Kinematics::spatial_rigid, Kinematics::planar_deformable});
    walls.name = "wall-opening-lateral";
    walls.title = "The lateral capacity of walls with an opening";
    walls.quantity =
        "|lateral load / weight at which it falls / that of the reference - 1|, the worse of two walls";
    walls.choices =
        "Two piers of single stones, 0.6 m wide and 1.2 m high, under one lintel, friction 0.8. Standing on the "
        "ground, under two courses, the piers rock and the lintel stays level: width / height of a pier, whatever "
        "it carries. On two courses in bond these take part, and the limit depends on dilatancy, of which the "
        "engine has none. Default joints of a case without motion, 300 E/L between rigid stones and 30 E/L "
        "between elastic ones: where joints slide, loads above the least are in equilibrium too, and with ten "
        "times the stiffness the "
        "elastic stones find some, to 1.8 % above.";
    walls.run = run_walls;
    return {arch, walls};
}

}  // namespace

std::vector<Benchmark> limit_state_benchmarks()
{
    std::vector<Benchmark> rows = capacity_rows();
    Benchmark thickness = limit_row({Kinematics::spatial_rigid});
    thickness.name = "arch-least-thickness";
    thickness.title = "The least thickness of a semicircular arch of 27 voussoirs";
    thickness.quantity =
        "|least thickness / mean radius - that of limit analysis|, of static stages or of gravity suddenly there, "
        "the worse";
    thickness.choices =
        "Mean radius 5 m, 1000 GPa, friction 0.7, joints of 300 E/L, the default of a case in which nothing "
        "but a steady weight acts: on the 10 E/L of stones that are shaken the arch bounces when it is "
        "suddenly loaded, and falls up to 0.1073. Bisection of the thickness to 5e-6; suddenly loaded it "
        "has fallen when a stone has moved by 1e-4 of the radius after 2 s.";
    thickness.tolerance = 1e-4;
    thickness.sweep = sweep_of(thickness.setting, {8e-3, 4e-3, 2e-3, 1e-3});
    thickness.run = run_thickness;
    rows.push_back(thickness);
    Benchmark closed = limit_row({Kinematics::spatial_rigid});
    closed.name = "bridge-opening";
    closed.title = "A bridge of 93 voussoirs in which nothing opens";
    closed.quantity = "the largest opening of a joint [m]";
    closed.choices =
        "Circular intrados, span 45 m, rise 5.5 m, 1.5 m to 2 m thick, friction 0.7, 5 GPa, rigid stones, "
        "default joints of a case without motion: at rest under its weight and half of it sideways. It carries "
        "more than four times that, "
        "so that the joints of rigid stones stay closed.";
    closed.tolerance = 1e-5;
    closed.run = run_bridge;
    rows.push_back(closed);
    return rows;
}

}  // namespace voussoir::app::studies::verify
