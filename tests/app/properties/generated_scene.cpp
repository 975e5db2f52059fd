#include "tests/app/properties/generated_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <regex>

namespace voussoir::app::properties
{
namespace
{

using Eigen::Vector3d;

/// Numbers that are the same with every library: the distributions of the standard are not.
class Random
{
 public:
    explicit Random(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
    double between(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    int whole(int low, int high)
    {
        return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
    }
    bool chance(double share) { return between(0, 1) < share; }
    /// To the millimetre.
    double length(double low, double high) { return std::round(1e3 * between(low, high)) / 1e3; }

 private:
    std::mt19937_64 engine_;
};

constexpr double spacing = 1;       // m, of stacks
constexpr double half_depth = 0.2;  // m, of flat scenes

void add_stack(int number, Random& random, GeneratedScene& scene)
{
    const double middle = spacing * number, aside = scene.flat ? 0 : random.length(-0.1, 0.1);
    double half = random.length(0.2, 0.3), foot = 0;
    const int boxes = random.whole(1, 3);
    for (int i = 0; i < boxes; ++i) {
        const double depth = scene.flat ? half_depth : random.length(0.15, 0.25),
                     height = random.length(0.15, 0.4);
        const double x = i == 0 ? middle : middle + random.length(-0.03, 0.03);
        scene.boxes.push_back({fmt::format("s{}_{}", number, i + 1),
                               {x - half, aside - depth, foot},
                               {x + half, aside + depth, foot + height}});
        foot += height;
        half = std::round(1e3 * half * random.between(0.6, 0.9)) / 1e3;
    }
}

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
    void add_box(const Box& box)
    {
        const Vector3d a = direction(box.lower) + telling.offset, b = direction(box.upper) + telling.offset;
        const Vector3d lower = a.cwiseMin(b), upper = a.cwiseMax(b);
        out += fmt::format("  - box: {{name: {}, lower: [{}, {}, {}], upper: [{}, {}, {}]}}\n", box.name,
                           length(lower.x()), length(lower.y()), length(lower.z()), length(upper.x()),
                           length(upper.y()), length(upper.z()));
        if (box.name == "floor") out += "    group: foundation\n";
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
    void add_motion()
    {
        const Vector3d along = direction(Vector3d::UnitX());
        const int axis = std::abs(along.y()) > std::abs(along.x()) ? 1 : 0;
        const auto sine = [&](double amplitude) {
            return fmt::format("{{sine: {{acceleration: {}, frequency: {}, duration: 1}}}}", amplitude,
                               scene.frequency);
        };
        out +=
            fmt::format("foundation: {{blocks: foundation, motion: {{{}: {}, z: {}}}}}\n", axis == 1 ? "y" : "x",
                        sine(along[axis] * scene.shaking), sine(telling.scale * scene.lifting));
    }
    void add_start()
    {
        if (scene.thrown.empty()) return;
        out += fmt::format("initial_state: [{{blocks: {}, velocity: {}}}]\n", scene.thrown,
                           plain(direction(scene.velocity)));
    }
};

}  // namespace

Eigen::Matrix3d Telling::rotation() const
{
    Eigen::Matrix3d turn, all = Eigen::Matrix3d::Identity();
    turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    if (mirrored) all(0, 0) = -1;
    for (int i = 0; i < quarter_turns; ++i) all = turn * all;
    return all;
}

GeneratedScene generated(std::uint64_t seed)
{
    Random random(seed);
    GeneratedScene scene;
    scene.flat = random.chance(0.4);
    scene.deformable = random.chance(0.4);
    const int stacks = random.whole(1, 3);
    const double depth = scene.flat ? half_depth : 0.8;
    scene.boxes.push_back({"floor", {-1, -depth, -0.4}, {stacks * spacing, depth, 0}});
    for (int i = 0; i < stacks; ++i) add_stack(i, random, scene);
    scene.friction = random.whole(10, 40);
    scene.young = std::pow(10, random.whole(8, 10));
    scene.shaking = random.chance(0.8) ? random.whole(1, 8) : 0;
    scene.lifting = random.chance(0.3) ? random.whole(1, 4) : 0;
    scene.frequency = random.whole(1, 8);
    scene.settles = random.chance(0.3);
    if (random.chance(0.3)) {
        scene.thrown = scene.boxes.back().name;
        const double across = scene.flat ? 0 : random.length(-0.5, 0.5);
        scene.velocity = {random.length(-2, 2), across, random.length(0, 2)};
    }
    return scene;
}

std::string text_of(const GeneratedScene& scene, const Telling& telling)
{
    const double s = telling.scale, young = telling.young > 0 ? telling.young : scene.young;
    Writing writing{scene, telling, {}};
    const std::string kind = scene.deformable ? "spatial_deformable" : "spatial_rigid";
    // Mass is told in the same unit of force, so Pa = kg/(m s2) scales with 1/s and kg/m3 with 1/s^3.
    writing.out = fmt::format(
        "kinematics: {}\n"
        "gravity: {{magnitude: {}}}\n"
        "materials: {{stone: {{density: {}, young: {}, poisson: 0.2}}}}\n"
        "joints: {{dry: {{friction: {} deg{}}}}}\n",
        telling.kinematics.empty() ? kind : telling.kinematics, 9.80665 * s, 2400 / (s * s * s), young / s,
        scene.friction, telling.joint);
    // Stones of a spatial scene are free to bulge across the plane.
    if (telling.kinematics == "planar_deformable") writing.out += "plane: stress\n";
    writing.add_boxes();
    writing.add_motion();
    writing.add_start();
    writing.out += "stages:\n";
    if (scene.settles) writing.out += "  - {name: rest, type: static}\n";
    writing.out += "  - {name: motion, type: dynamic, duration: 20 ms, time_step: 2 ms, force_tolerance: 1e-10}\n";
    return writing.out;
}

std::string mutated(std::string text, std::uint64_t seed)
{
    Random random(seed ^ 0xABCDEF);
    static const std::array<const char*, 24> values{
        "0",   "-1",   "1e300", "-1e300", "1e-300", "1e160", "nan",   "inf",     "",     "[]",     "{}", "x",
        "1e9", "1e-9", "true",  "null",   "1 kg",   "1 s",   "1e400", "[1,2,3]", "0x10", "1e20 m", "9",  "-0.001"};
    if (random.chance(0.8)) {
        static const std::regex number(R"((-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?)( (deg|ms))?)");
        const std::vector<std::smatch> found(std::sregex_iterator(text.begin(), text.end(), number), {});
        const std::smatch& chosen =
            found[static_cast<std::size_t>(random.whole(0, static_cast<int>(found.size()) - 1))];
        const auto value = values[static_cast<std::size_t>(random.whole(0, static_cast<int>(values.size()) - 1))];
        return text.replace(static_cast<std::size_t>(chosen.position()), static_cast<std::size_t>(chosen.length()),
                            value);
    }
    const auto at = static_cast<std::size_t>(random.whole(0, static_cast<int>(text.size()) - 2));
    switch (random.whole(0, 3)) {
        case 0:
            return text.erase(at, 1);
        case 1:
            return text.insert(at, 1, text[at]);
        case 2:
            return text.substr(0, at);
        default:
            return text.erase(at, text.find('\n', at) - at);
    }
}

}  // namespace voussoir::app::properties
