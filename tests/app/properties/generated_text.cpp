// A generated scene told as a case file, and the files that it names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/app/properties/generated_scene.h"

namespace voussoir::app::properties
{
namespace
{

using Eigen::Vector3d;

struct Writing {
    const GeneratedScene& scene;
    const Telling& telling;
    std::string out;

    bool planar() const { return telling.kinematics.starts_with("planar"); }
    std::string length(double x) const
    {
        const std::map<std::string, double> per_metre{{"m", 1}, {"cm", 100}, {"mm", 1000}};
        return telling.unit == "m" ? fmt::format("{}", x)
                                   : fmt::format("{:.10g} {}", x * per_metre.at(telling.unit), telling.unit);
    }
    Vector3d direction(const Vector3d& v) const { return telling.scale * telling.rotation() * v; }
    std::string plain(const Vector3d& v) const
    {
        return planar() ? fmt::format("[{}, {}]", v.x(), v.z()) : fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
    }
    static std::string group_of(const std::string& box) { return box == "floor" ? "foundation" : "of_" + box; }
    void add_box(const Box& box)
    {
        const Vector3d a = direction(box.lower) + telling.offset, b = direction(box.upper) + telling.offset;
        const Vector3d lower = a.cwiseMin(b), upper = a.cwiseMax(b);
        out += fmt::format("  - box: {{name: {}, lower: [{}, {}, {}], upper: [{}, {}, {}]}}\n", box.name,
                           length(lower.x()), length(lower.y()), length(lower.z()), length(upper.x()),
                           length(upper.y()), length(upper.z()));
        if (box.name == "floor")
            out += "    group: foundation\n";
        else if (!scene.bars.empty())
            out += fmt::format("    group: {}\n", group_of(box.name));
    }
    void add_boxes()
    {
        out += "blocks:\n";
        std::vector<Box> boxes = scene.boxes;
        // Stacks do not touch one another; within a stack the order stays, and with it who is first of two that
        // touch.
        const auto stack = [](const Box& box) {
            return box.name == "floor" ? std::string() : box.name.substr(0, 2);
        };
        if (telling.other_order)
            std::stable_sort(boxes.begin() + 1, boxes.end(),
                             [&](const Box& a, const Box& b) { return stack(a) > stack(b); });
        for (const Box& box : boxes) add_box(box);
    }
    /// How what is written down as the scene has it comes to where the telling has it.
    std::string placing() const
    {
        std::string keys;
        if (telling.scale != 1) keys += fmt::format(", scale: {}", telling.scale);
        if (telling.mirrored) keys += ", mirror: {plane: x}";
        if (telling.quarter_turns != 0)
            keys += fmt::format(", rotate: {{axis: z, angle: {} deg}}", 90 * telling.quarter_turns);
        if (telling.offset != Vector3d::Zero())
            keys += fmt::format(", move: [{}, {}, {}]", length(telling.offset.x()), length(telling.offset.y()),
                                length(telling.offset.z()));
        return keys;
    }
    void add_wall()
    {
        if (!scene.wall) return;
        const GeneratedWall& wall = *scene.wall;
        const std::string door =
            fmt::format(", openings: [{{at: {}, sill: {}, width: {}, height: {}}}]", length(wall.block_length),
                        length(0), length(wall.block_length), length(wall.block_height));
        out += fmt::format(
            "  - {{wall: {{length: {}, height: {}, thickness: {}, block: [{}, {}], origin: [{}, {}, {}]{}}}{}}}\n",
            length(wall.length), length(wall.height), length(wall.thickness), length(wall.block_length),
            length(wall.block_height), length(-wall.length / 2), length(-wall.thickness / 2), length(0),
            wall.door ? door : "", placing());
    }
    void add_mesh()
    {
        if (scene.mesh) out += fmt::format("  - {{mesh: stone.obj, unit: {}{}}}\n", telling.unit, placing());
    }
    /// The motion along x, of this amplitude.
    std::string shaking(double amplitude) const
    {
        switch (scene.kind) {
            case Shaking::sine:
                return sine(amplitude);
            case Shaking::ricker:
                return fmt::format("{{ricker: {{acceleration: {} m/s2, frequency: {}}}}}", amplitude,
                                   40 * scene.frequency);
            case Shaking::pulse:
                return fmt::format("{{pulse: {{acceleration: {} m/s2, period: {}}}}}", amplitude,
                                   0.08 / scene.frequency);
            case Shaking::record:
                return fmt::format("{{record: ground.txt, unit: m/s2, scale: {}}}", amplitude);
        }
        return {};
    }
    std::string sine(double amplitude) const
    {
        return fmt::format("{{sine: {{acceleration: {} m/s2, frequency: {}, duration: 1}}}}", amplitude,
                           scene.frequency);
    }
    /// Their ends are the middles of boxes, areas and stresses in the telling's units.
    void add_bars()
    {
        if (!scene.bars.empty()) out += "bars:\n";
        const double s = telling.scale;
        for (std::size_t i = 0; i < scene.bars.size(); ++i) {
            const GeneratedBar& bar = scene.bars[i];
            out += fmt::format("  - {{name: bar_{}, diameter: {}, young: {} Pa, carries: {}", i + 1,
                               length(s * bar.diameter), 2e11 / s, bar.carries);
            if (bar.yield > 0) out += fmt::format(", yield_strength: {} Pa", bar.yield / s);
            if (bar.prestress > 0) out += fmt::format(", prestress: {} Pa", bar.prestress / s);
            if (bar.dowels)
                out += fmt::format(", length: {}, between: [{}, {}]}}\n", length(s * bar.length),
                                   group_of(bar.from), group_of(bar.to));
            else
                out += fmt::format(", from: {}, to: {}}}\n", end(bar.from), end(bar.to));
        }
    }
    std::string end(const std::string& name) const
    {
        const auto box = std::find_if(scene.boxes.begin(), scene.boxes.end(),
                                      [&](const Box& known) { return known.name == name; });
        const Vector3d at = direction(0.5 * (box->lower + box->upper)) + telling.offset;
        return fmt::format("{{block: {}, at: [{}, {}]}}", name,
                           planar() ? length(at.x()) : length(at.x()) + ", " + length(at.y()), length(at.z()));
    }
    void add_motion()
    {
        const Vector3d along = direction(Vector3d::UnitX());
        const int axis = std::abs(along.y()) > std::abs(along.x()) ? 1 : 0;
        out += fmt::format("foundation: {{blocks: foundation, motion: {{{}: {}, z: {}}}{}}}\n",
                           axis == 1 ? "y" : "x", shaking(along[axis] * scene.shaking),
                           sine(telling.scale * scene.lifting), scene.goes_on ? ", motion_stage: motion" : "");
    }
    void add_start()
    {
        if (scene.thrown.empty()) return;
        out += fmt::format("initial_state: [{{blocks: {}, velocity: {}}}]\n", scene.thrown,
                           plain(direction(scene.velocity)));
    }
};

/// In the telling's unit of length; placing does the rest.
std::string obj_of(const MeshStone& stone, const Telling& telling)
{
    const std::map<std::string, double> per_metre{{"m", 1}, {"cm", 100}, {"mm", 1000}};
    const double unit = per_metre.at(telling.unit);
    std::string text = "o stone\n";
    for (const bool top : {false, true})
        for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            const Eigen::Vector2d half = top ? stone.head : stone.foot;
            text += fmt::format("v {:.12g} {:.12g} {:.12g}\n", unit * (stone.middle + corner.x() * half.x()),
                                unit * corner.y() * half.y(), top ? unit * stone.height : 0);
        }
    return text + "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

}  // namespace

std::string text_of(const GeneratedScene& scene, const Telling& telling)
{
    const double s = telling.scale, young = telling.young > 0 ? telling.young : scene.young;
    Writing writing{scene, telling, {}};
    const std::string kind = scene.deformable ? "spatial_deformable" : "spatial_rigid";
    // Mass is told in the same unit of force, so Pa = kg/(m s2) scales with 1/s and kg/m3 with 1/s^3.
    writing.out = fmt::format(
        "kinematics: {}\n"
        "gravity: {{magnitude: {} m/s2}}\n"
        "materials: {{stone: {{density: {} kg/m3, young: {} Pa, poisson: 0.2}}}}\n"
        "joints: {{dry: {{friction: {} deg{}}}}}\n",
        telling.kinematics.empty() ? kind : telling.kinematics, 9.80665 * s, 2400 / (s * s * s), young / s,
        scene.friction, telling.joint);
    // Stones of a spatial scene are free to bulge across the plane.
    if (telling.kinematics == "planar_deformable") writing.out += "plane: stress\n";
    writing.add_boxes();
    writing.add_wall();
    writing.add_mesh();
    writing.add_bars();
    writing.add_motion();
    writing.add_start();
    writing.out += "stages:\n";
    if (scene.settles) writing.out += "  - {name: rest, type: static, force_tolerance: 1e-10}\n";
    // Whether a step that takes all its iterations is cut would be up to rounding.
    writing.out +=
        "  - {name: motion, type: dynamic, duration: 20 ms, time_step: 2 ms, force_tolerance: 1e-10, "
        "max_open_close: 300}\n";
    if (scene.goes_on)
        writing.out +=
            "  - {name: afterwards, type: dynamic, duration: 5 ms, time_step: 1 ms, force_tolerance: 1e-10, "
            "max_open_close: 300, damping: {rate: 5 1/s}}\n";
    return writing.out;
}

std::map<std::string, std::string> files_of(const GeneratedScene& scene, const Telling& telling)
{
    std::map<std::string, std::string> files;
    if (scene.mesh) files["stone.obj"] = obj_of(*scene.mesh, telling);
    if (scene.kind == Shaking::record) {
        std::string record;
        for (int i = 0; i <= 30; ++i)
            record += fmt::format("{:.3f} {:.6f}\n", 1e-3 * i,
                                  std::sin(0.02 * i * scene.frequency) * (i % 7 == 3 ? 0 : 1));
        files["ground.txt"] = record;
    }
    return files;
}

}  // namespace voussoir::app::properties
