#include "app/studies/verify/limit_masonry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "app/studies/scenes/materials.h"
#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/stages.h"
#include "app/studies/verify/even_draw.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::verify
{
namespace
{

namespace patterns = importers::patterns;
using Eigen::Vector3d;

constexpr double gravity = scenes::papers_gravity, young = 1e10;  // m/s2, Pa
constexpr double stiffness_factor = 100;                          // times E/L: a joint yields like 1 % of a stone
constexpr double touching = 1e-8;                                 // of a stone's size

/// @param depth of a stone [m]
Model empty_model(Kinematics kinematics, double friction, double depth, double thickness)
{
    scenes::SceneSetting setting;
    setting.kinematics = kinematics;
    JointMaterial joint = scenes::dry_joint(friction);
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness_factor * young / depth};
    return scenes::make_scene_model(setting, scenes::stone(2000, young), joint, thickness);
}

LimitMasonry random_wall(EvenDraw& draw, Kinematics kinematics, bool window)
{
    patterns::Wall wall;
    wall.thickness = 0.3;
    wall.block_height = draw.between(0.2, 0.4);
    wall.block_length = wall.block_height * draw.between(1, 2.5);
    const int courses = window ? draw.whole(6, 8) : draw.whole(3, 8);
    wall.height = courses * wall.block_height;
    wall.length = window ? wall.block_length * draw.whole(5, 7) : wall.height * draw.between(0.3, 1.3);
    wall.length = std::max(wall.length, 1.5 * wall.block_length);
    if (window) {
        wall.openings = {{1.5 * wall.block_length, 2 * wall.block_height, wall.length - 3 * wall.block_length,
                          (courses - 4) * wall.block_height}};
        wall.lintel = {wall.block_height, 0.5 * wall.block_length};
    }
    wall.base = {0.3, 0.3};
    wall.flat = is_planar(kinematics);
    const double friction = draw.between(0.3, 0.8);
    LimitMasonry masonry;
    masonry.model = empty_model(kinematics, friction, wall.block_height, wall.thickness);
    add_wall(masonry.model, wall);
    masonry.description = fmt::format("{}wall {:.2f} x {:.2f} m, stones {:.2f} x {:.2f} m, friction {:.3f}",
                                      window ? "windowed " : "", wall.length, wall.height, wall.block_length,
                                      wall.block_height, friction);
    return masonry;
}

LimitMasonry random_arch(EvenDraw& draw, Kinematics kinematics)
{
    const double half_embrace = draw.between(0.35, 0.5) * std::numbers::pi, share = draw.between(0.12, 0.3);
    const patterns::BarrelVault vault = circular_arch(share, half_embrace, draw.whole(7, 27));
    const double friction = draw.between(0.3, 0.8);
    LimitMasonry masonry;
    masonry.model = empty_model(kinematics, friction, vault.thickness, vault.length);
    add_arch(masonry.model, vault);
    masonry.description =
        fmt::format("arch of {} stones over {:.0f} degrees, thickness {:.3f} of the radius, friction {:.3f}",
                    vault.courses, 2 * half_embrace * 180 / std::numbers::pi, share, friction);
    return masonry;
}

}  // namespace

void add_stone(Model& model, const std::string& name, const ConvexPolyhedron& shape)
{
    double depth = 0;
    model.blocks.push_back(is_planar(model.kinematics)
                               ? make_planar_block(name, 0, 0, {outline_of(shape, depth, name)}, model.thickness)
                               : make_block(name, 0, 0, {shape}));
}

void add_wall(Model& model, const patterns::Wall& wall)
{
    for (const patterns::MasonryBlock& block : patterns::wall(wall)) {
        add_stone(model, block.name, patterns::to_polyhedron(block));
        if (block.name == wall.name + "_base") scenes::hold(model, static_cast<int>(model.blocks.size()) - 1);
    }
}

void add_arch(Model& model, const patterns::BarrelVault& vault)
{
    const patterns::StoneGrid grid = patterns::barrel_vault(vault);
    for (const patterns::StoneGrid::Stone& stone : grid.stones()) {
        add_stone(model, stone.name, patterns::parts_of(grid, stone).front());
        if (stone.name.starts_with("support")) scenes::hold(model, static_cast<int>(model.blocks.size()) - 1);
    }
}

patterns::BarrelVault circular_arch(double share, double half_embrace, int courses)
{
    constexpr double radius = 2;
    const double inner = radius - share * radius / 2;
    patterns::BarrelVault vault;
    vault.thickness = share * radius;
    vault.span = 2 * inner * std::sin(half_embrace);
    vault.rise = std::min(inner * (1 - std::cos(half_embrace)), vault.span / 2);
    vault.length = 0.5;
    vault.courses = courses;
    vault.stones = 1;
    vault.bonded = false;
    return vault;
}

LimitMasonry random_masonry(std::uint64_t seed, int n, bool in_plane)
{
    EvenDraw draw(seed, n);
    const Kinematics kinematics = n % 5 == 4 && !in_plane ? Kinematics::spatial_rigid : Kinematics::planar_rigid;
    LimitMasonry masonry = n % 3 == 2 ? random_arch(draw, kinematics) : random_wall(draw, kinematics, n % 9 < 3);
    masonry.description += is_planar(kinematics) ? "" : ", spatial";
    return masonry;
}

limit::LimitProblem limit_problem(const Model& model, limit::FacePoints points)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    return limit::limit_problem_of(model, state, {0, 0, -gravity}, {gravity, 0, 0}, touching, points);
}

Pushed push(const Model& model, double factor, const scenes::SceneSetting& setting)
{
    Stage stage = scenes::static_stage(setting, {factor * gravity, 0, -gravity});
    stage.max_static_steps = 300;  // what stands does so in less than 60
    State state = initial_state(model);
    const std::clock_t start = std::clock();
    Pushed pushed;
    pushed.report = run(model, {stage}, state, {});
    pushed.cpu_time = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return pushed;
}

EngineThreshold engine_threshold(const Model& model, double stands, double falls, double width,
                                 const scenes::SceneSetting& setting)
{
    EngineThreshold found;
    found.stands = stands;
    found.falls = falls;
    while (found.falls - found.stands > width * found.falls) {
        const double middle = (found.stands + found.falls) / 2;
        const Pushed pushed = push(model, middle, setting);
        (pushed.report.outcome == Outcome::completed ? found.stands : found.falls) = middle;
        found.steps += pushed.report.steps;
        found.step_cuts += pushed.report.step_cuts;
        found.iterations += pushed.report.open_close_iterations;
        found.cpu_time += pushed.cpu_time;
    }
    return found;
}

}  // namespace voussoir::app::studies::verify
