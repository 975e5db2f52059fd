#include "tests/app/properties/generated_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// Of numbers of their own, so that a scene without them is the one it was before there were any.
void add_other_kinds(std::uint64_t seed, GeneratedScene& scene)
{
    Random random(seed ^ 0x5EEDED);
    if (random.chance(0.1)) {
        GeneratedWall wall;
        wall.block_length = random.length(0.3, 0.4);
        wall.block_height = random.length(0.1, 0.2);
        wall.length = wall.block_length * random.whole(2, 4);
        wall.height = wall.block_height * random.whole(2, 4);
        wall.thickness = scene.flat ? 2 * half_depth : random.length(0.2, 0.4);
        wall.door = wall.length > 1 && random.chance(0.3);
        scene.wall = wall;
        scene.boxes.resize(1);
        scene.boxes[0].upper.x() = 1;
        scene.thrown.clear();
    }
    if (!scene.wall && random.chance(0.04)) {
        MeshStone stone;
        stone.middle = -0.7;
        stone.foot = {random.length(0.1, 0.2), scene.flat ? half_depth : random.length(0.1, 0.2)};
        stone.head = {random.length(0.05, 0.1), scene.flat ? half_depth : random.length(0.05, 0.1)};
        stone.height = random.length(0.15, 0.4);
        scene.mesh = stone;
    }
    if (random.chance(0.3)) scene.kind = static_cast<Shaking>(random.whole(1, 3));
    scene.goes_on = random.chance(0.15);
    if (scene.goes_on) scene.lifting = 0;  // a floor that rises and stops at once throws what stands on it
}

/// Of numbers of their own, as above.
void add_bars(std::uint64_t seed, GeneratedScene& scene)
{
    Random random(seed ^ 0xBA45);
    const int boxes = static_cast<int>(scene.boxes.size());
    // What is thrown off jerks its rods, again and again: rounding decides where it is after that.
    if (boxes < 2 || !scene.thrown.empty() || !random.chance(0.2)) return;
    for (int left = random.whole(1, 2); left > 0; --left) {
        GeneratedBar bar;
        const int upper = random.whole(1, boxes - 1);
        bar.dowels = random.chance(0.4);
        // Its stack's boxes come from the floor up, so that what it stands on is the one before it or the floor.
        const bool on_floor = scene.boxes[upper].name.ends_with("_1");
        bar.to = scene.boxes[upper].name;
        bar.from = scene.boxes[on_floor ? 0 : upper - 1].name;
        if (!bar.dowels) bar.from = scene.boxes[(upper + random.whole(1, boxes - 1)) % boxes].name;
        bar.diameter = 1e-3 * random.whole(4, 20);
        if (random.chance(0.5)) bar.yield = 1e6 * random.whole(1, 200);
        // Without rest first a prestress is a jerk, too; a large one drags stones along until the rod is slack.
        if (!bar.dowels && random.chance(0.3) && scene.settles) bar.prestress = 5e5;
        bar.length = random.length(0.02, 0.1);
        bar.carries = bar.dowels ? "shear" : "tension";
        const bool both = random.chance(0.3);
        if (both && bar.dowels) bar.carries = "[tension, shear]";
        // A stone that is propped up from its own stack stands on a pin: where it rests nobody knows.
        if (both && bar.from.substr(0, 2) != bar.to.substr(0, 2) && bar.from != "floor" && bar.to != "floor")
            bar.carries = "[tension, compression]";
        scene.bars.push_back(bar);
    }
}

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
    add_other_kinds(seed, scene);
    add_bars(seed, scene);
    return scene;
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
