// Verdicts at rest on both sides of a limit, at extreme sizes, weights, moduli, places and frictions.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "app/words/diagnosis_words.h"
#include "importers/process/thread_time.h"
#include "libdda/contact/normal_stiffness.h"

namespace voussoir::app::studies::stability
{
namespace
{

constexpr double margin = 0.01;  // of the limit, on either side of it

/// A scene and the share of its weight along +x at which it falls.
struct Limited {
    Model model;
    double limit = 0;
    double gravity = scenes::papers_gravity;  // m/s2
};

/// A stack of equal blocks, which overturns about its lowest edge or slides on its bed.
struct Stack {
    int blocks = 5;
    double width = 1, height = 0.4;  // m, of a block
    double friction = 0.7;
    double density = 2000, young = 5e10;  // kg/m3, Pa
    double offset = 0;                    // m, of the foot from the origin
    double gravity = scenes::papers_gravity;
    Kinematics kinematics = Kinematics::planar_deformable;
};

Limited limited(const Stack& stack)
{
    Limited scene{
        make_model(stack.kinematics, scenes::stone(stack.density, stack.young), scenes::dry_joint(stack.friction)),
        std::min(stack.friction, stack.width / (stack.blocks * stack.height)), stack.gravity};
    Model& model = scene.model;
    model.thickness = stack.width;
    const double left = stack.offset, deep = stack.width;
    scenes::hold(model,
                 scenes::add_box(model, "ground", {left - deep, 0, -stack.height}, {left + 2 * deep, deep, 0}));
    for (int i = 0; i < stack.blocks; ++i)
        scenes::add_box(model, fmt::format("block {}", i + 1), {left, 0, i * stack.height},
                        {left + deep, deep, (i + 1) * stack.height});
    contact::stiffen_for_rest(model);
    return scene;
}

/// One static stage under the weight and a share of it along +x.
bool stands(const Limited& scene, double share, CellRun& cell)
{
    const Stage stage = scenes::static_stage({}, {share * scene.limit * scene.gravity, 0, -scene.gravity});
    State state = initial_state(scene.model);
    const double start = importers::process::thread_time();
    const RunReport report = run(scene.model, {stage}, state, {});
    cell.cpu_time += importers::process::thread_time() - start;
    cell.steps += report.steps;
    cell.step_cuts += report.step_cuts;
    cell.iterations += report.open_close_iterations;
    cell.energy_residual = std::max(cell.energy_residual, report.energy.relative_residual());
    cell.max_penetration = std::max(cell.max_penetration, report.max_penetration);
    if (has_no_answer(report.outcome)) cell.diagnosis = words::message_of(report, scene.model, {stage});
    return report.outcome == Outcome::completed;
}

CellRun run_verdicts(const Limited& scene)
{
    CellRun cell;
    const bool below = stands(scene, 1 - margin, cell), beyond = stands(scene, 1 + margin, cell);
    cell.error = ((below ? 0 : 1) + (beyond ? 1 : 0)) / 2.0;
    cell.note = fmt::format("{} below its limit of {:.4g}, {} beyond", below ? "stands" : "falls", scene.limit,
                            beyond ? "stands" : "falls");
    return cell;
}

}  // namespace

StabilityScene verdict_scene()
{
    StabilityScene scene;
    scene.name = "verdicts";
    scene.title = "Verdicts 1 % below and 1 % beyond a limit";
    scene.quantity = "share of two verdicts that are wrong";
    scene.text =
        "A stack of five deformable blocks of 1 x 1 x 0.4 m (2000 kg/m3, 50 GPa), friction coefficient 0.7, on a "
        "held base, under its weight and a share of it sideways, with the joints of a case without motion, over "
        "its size, density, modulus, gravity, place, friction, the height of a block and, of 10,000 GPa, the "
        "number "
        "of blocks: a hundred of 50 GPa bend so far that they fall 1 % below the limit of rigid ones.";
    scene.reference = "closed form: the smaller of friction and width / height";
    scene.tolerance = 0.02;  // no verdict may be wrong: one of two is 50 %
    const auto add = [&](const std::string& name, const std::string& unit, double value, const auto& change) {
        Stack stack;
        change(stack, value);
        add_cell(scene, fmt::format("{}={:g}", name, value), {{name, value, unit}}, 0,
                 [stack] { return run_verdicts(limited(stack)); });
    };
    for (const double size : {1e-3, 1e-1, 1e1, 1e3})
        add("size", "m", size, [](Stack& stack, double value) {
            stack.width *= value;
            stack.height *= value;
        });
    for (const double density : {1e0, 1e2, 1e4, 1e6})
        add("density", "kg/m3", density, [](Stack& stack, double value) { stack.density = value; });
    for (const double young : {1e8, 1e9, 1e12, 1e14})
        add("modulus", "Pa", young, [](Stack& stack, double value) { stack.young = value; });
    for (const double gravity : {1e-3, 1e-1, 1e2})
        add("gravity", "m/s2", gravity, [](Stack& stack, double value) { stack.gravity = value; });
    for (const double offset : {1e3, 1e5})
        add("offset", "m", offset, [](Stack& stack, double value) { stack.offset = value; });
    for (const double friction : {0.01, 0.1, 0.45, 0.55, 2.0, 10.0})
        add("friction", "", friction, [](Stack& stack, double value) { stack.friction = value; });
    for (const double height : {0.01, 4.0})
        add("height", "m", height, [](Stack& stack, double value) { stack.height = value; });
    for (const double blocks : {1, 20, 50, 100})
        add("blocks", "", blocks, [](Stack& stack, double value) {
            stack.blocks = static_cast<int>(value);
            stack.young = 1e13;
        });
    for (const auto& [name, kinematics] : {std::pair{"planar-rigid", Kinematics::planar_rigid},
                                           std::pair{"spatial-rigid", Kinematics::spatial_rigid},
                                           std::pair{"spatial-deformable", Kinematics::spatial_deformable}}) {
        Stack stack;
        stack.kinematics = kinematics;
        add_cell(scene, name, {{fmt::format("{}, blocks", name_of(kinematics)), 5, ""}}, 0,
                 [stack] { return run_verdicts(limited(stack)); });
    }
    return scene;
}

}  // namespace voussoir::app::studies::stability
