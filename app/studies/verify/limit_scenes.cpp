#include "app/studies/verify/limit_scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "app/studies/scenes/materials.h"
#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/verify/even_draw.h"
#include "importers/patterns/vaults.h"
#include "libdda/contact/normal_stiffness.h"

namespace voussoir::app::studies::verify
{
namespace
{

namespace patterns = importers::patterns;
using Eigen::Vector2d;

constexpr double density = 2000;  // kg/m3
// Limits are those of rigid stones. Thin arches of 5 GPa lose 1 to 2 % of theirs, for an arch yields under its
// thrust.
constexpr double young = 5e10;  // Pa
constexpr double degree = std::numbers::pi / 180;

Model empty_model(bool planar, bool rigid, double friction, double thickness = 1)
{
    scenes::SceneSetting setting;
    setting.kinematics = planar ? (rigid ? Kinematics::planar_rigid : Kinematics::planar_deformable)
                                : (rigid ? Kinematics::spatial_rigid : Kinematics::spatial_deformable);
    return scenes::make_scene_model(setting, scenes::stone(density, young), scenes::dry_joint(friction),
                                    thickness);
}

/// Adds a planar stone by its corners, anticlockwise in x and z.
int add_outline(Model& model, const std::string& name, const std::vector<Vector2d>& corners)
{
    model.blocks.push_back(make_planar_block(name, 0, 0, {make_convex_polygon(corners, name)}, model.thickness));
    return static_cast<int>(model.blocks.size()) - 1;
}

int add_rectangle(Model& model, const std::string& name, const Vector2d& lower, const Vector2d& upper)
{
    return add_outline(model, name, {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}});
}

void add_floor(Model& model)
{
    scenes::hold(model, add_rectangle(model, "floor", {-20, -1}, {20, 0}));
}

LimitMasonry arch(EvenDraw& draw, bool planar, bool rigid)
{
    const double share = draw.between(0.12, 0.3), half_embrace = draw.between(0.35, 0.5) * std::numbers::pi;
    const patterns::BarrelVault vault = circular_arch(share, half_embrace, draw.whole(5, 19));
    const double friction = draw.between(0.4, 0.9);
    LimitMasonry masonry{fmt::format("{} arch of {} stones, {:.3f} of its radius, friction {:.3f}",
                                     planar ? "planar" : "spatial", vault.courses, share, friction),
                         empty_model(planar, rigid, friction, vault.length)};
    add_arch(masonry.model, vault);
    return masonry;
}

LimitMasonry wall(EvenDraw& draw, bool rigid)
{
    patterns::Wall wall;
    wall.thickness = 0.3;
    wall.block_height = draw.between(0.2, 0.4);
    wall.block_length = wall.block_height * draw.between(1, 2.5);
    const int courses = draw.whole(3, 8);
    wall.height = courses * wall.block_height;
    wall.length = std::max(wall.height * draw.between(0.3, 1.3), 1.5 * wall.block_length);
    wall.base = {0.3, 0.3};
    wall.flat = true;
    const double friction = draw.between(0.3, 0.9);
    LimitMasonry masonry{fmt::format("wall {:.2f} x {:.2f} m of {} courses, friction {:.3f}", wall.length,
                                     wall.height, courses, friction),
                         empty_model(true, rigid, friction, wall.thickness)};
    add_wall(masonry.model, wall);
    return masonry;
}

LimitMasonry portal(EvenDraw& draw, bool rigid)
{
    const double width = draw.between(0.4, 0.8), height = draw.between(0.25, 0.6), clear = draw.between(0.8, 2.5);
    const int drums = draw.whole(1, 5);
    const double beam = draw.between(0.3, 0.8), bearing = draw.between(0.4, 1);
    const double friction = draw.between(0.3, 0.9);
    LimitMasonry masonry{fmt::format("portal of {} drums {:.2f} x {:.2f} m, {:.2f} m clear, friction {:.3f}",
                                     drums, width, height, clear, friction),
                         empty_model(true, rigid, friction)};
    Model& model = masonry.model;
    add_floor(model);
    for (int k = 0; k < drums; ++k)
        for (const double left : {0.0, width + clear})
            add_rectangle(model, fmt::format("{}{}", left == 0 ? "l" : "r", k), {left, k * height},
                          {left + width, (k + 1) * height});
    const double in = (1 - bearing) * width, top = drums * height;
    add_rectangle(model, "lintel", {in, top}, {2 * width + clear - in, top + beam});
    return masonry;
}

/// Two struts that lean against one another, each of one or more pieces.
LimitMasonry frame(EvenDraw& draw, bool rigid)
{
    const double half = draw.between(0.6, 1.4), rise = half * draw.between(0.8, 2.2),
                 foot = half * draw.between(0.3, 0.8);
    const int pieces = draw.whole(1, 3);
    const double friction = draw.between(0.6, 1.1);
    LimitMasonry masonry{fmt::format("frame of 2 x {} pieces, {:.2f} m wide, {:.2f} m high, friction {:.3f}",
                                     pieces, 2 * half, rise, friction),
                         empty_model(true, rigid, friction)};
    Model& model = masonry.model;
    add_floor(model);
    const auto at = [&](double share, bool outer) {  // of the strut on the right
        const double inner = half * (1 - share);
        return Vector2d(inner + (outer ? foot : 0) * (1 - share),
                        share * rise + (outer ? share * foot * rise / half : 0));
    };
    for (int k = 0; k < pieces; ++k) {
        const double low = static_cast<double>(k) / pieces, high = static_cast<double>(k + 1) / pieces;
        const std::vector<Vector2d> right{at(low, false), at(low, true), at(high, true), at(high, false)};
        std::vector<Vector2d> left;
        for (auto corner = right.rbegin(); corner != right.rend(); ++corner)
            left.emplace_back(-corner->x(), corner->y());
        add_outline(model, fmt::format("right{}", k), right);
        add_outline(model, fmt::format("left{}", k), left);
    }
    return masonry;
}

LimitMasonry dome(EvenDraw& draw, bool rigid)
{
    patterns::Dome dome;
    dome.radius = 3;
    dome.thickness = dome.radius * draw.between(0.08, 0.2);
    dome.oculus = draw.between(12, 25) * degree;
    dome.springing = draw.between(55, 80) * degree;
    dome.courses = draw.whole(3, 5);
    dome.stones = draw.whole(6, 10);
    const double friction = draw.between(0.5, 0.9);
    LimitMasonry masonry{fmt::format("dome of {} x {} stones, thickness {:.3f} of its radius, friction {:.3f}",
                                     dome.courses, dome.stones, dome.thickness / dome.radius, friction),
                         empty_model(false, rigid, friction)};
    const patterns::StoneGrid grid = patterns::dome(dome);
    for (const patterns::StoneGrid::Stone& stone : grid.stones()) {
        masonry.model.blocks.push_back(make_block(stone.name, 0, 0, patterns::parts_of(grid, stone)));
        if (stone.name.starts_with("support"))
            scenes::hold(masonry.model, static_cast<int>(masonry.model.blocks.size()) - 1);
    }
    return masonry;
}

}  // namespace

LimitMasonry limit_scene(std::uint64_t seed, int n, bool rigid)
{
    EvenDraw draw(seed, n);
    LimitMasonry masonry = [&] {
        switch (n % 5) {
            case 0:
                return arch(draw, n % 10 == 0, rigid);
            case 1:
                return wall(draw, rigid);
            case 2:
                return portal(draw, rigid);
            case 3:
                return frame(draw, rigid);
            default:
                return dome(draw, rigid);
        }
    }();
    contact::stiffen_for_rest(masonry.model);
    return masonry;
}

}  // namespace voussoir::app::studies::verify
