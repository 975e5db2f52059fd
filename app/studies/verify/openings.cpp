// Openings and slips of joints against geometry: a rocking block, the hinges of an arch that becomes a mechanism,
// the beds and head joint of a sheared running bond.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/run_scene.h"
#include "libdda/analysis/joint_openings.h"

namespace voussoir::app::studies::verify
{

namespace
{

using Eigen::Vector3d;

constexpr double stiff = 1e12;  // Pa: what contacts yield by is not in the geometry

/// What geometry says of a joint.
struct Expected {
    double opening = 0, slip = 0;  // m
};
using Geometry = std::function<Expected(const WatchedJoint& joint, const State& now)>;

/// A rough joint. @param depth of a block [m]
JointMaterial rough(const scenes::SceneSetting& setting, double depth)
{
    return scenes::dry_joint_at_angle(std::numbers::pi / 3, scenes::stiffness_by_rule(setting, depth / stiff));
}

/// What was compared at the end of every step of a scene's last stage.
struct Comparison {
    std::vector<double> times, openings, expected;  // s; m, the largest of all joints
    double opening_error = 0, slip_error = 0;       // m
    double opening = 0, slip = 0;                   // m, the largest expected
    int open = 0;                                   // joints, at the end

    void add(double time, const std::vector<std::pair<JointMotion, Expected>>& joints)
    {
        double largest = 0, largest_expected = 0;
        open = 0;
        for (const auto& [motion, exact] : joints) {
            opening_error = std::max(opening_error, std::abs(motion.opening - exact.opening));
            for (const double moved : {motion.slip, motion.largest_slip})
                slip_error = std::max(slip_error, std::abs(moved - exact.slip));
            largest = std::max(largest, motion.opening);
            largest_expected = std::max(largest_expected, exact.opening);
            slip = std::max(slip, exact.slip);
            open += motion.opening > noteworthy_opening;
        }
        times.push_back(time);
        openings.push_back(largest);
        expected.push_back(largest_expected);
        opening = std::max(opening, largest_expected);
    }
};

/// Runs the scene and compares every joint. @param open how many are open at the end, or else the run has failed
VerifyResult compare(const scenes::StagedScene& scene, int open, const Geometry& geometry)
{
    VerifyResult result;
    State state = initial_state(scene.model);
    const std::vector<WatchedJoint> joints = joints_at_start(scene.model, state);
    Comparison all;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (now.stage == 0) return;
        const std::vector<PlacedBlock> blocks = placed_blocks(scene.model, now);
        std::vector<std::pair<JointMotion, Expected>> pairs;
        for (const WatchedJoint& joint : joints)
            pairs.emplace_back(motion_of(joint, blocks), geometry(joint, now));
        all.add(now.stage_time, pairs);
    };
    run_scene(scene, state, observer, result);
    if (result.failure.empty() && all.open != open)
        result.failure = fmt::format("{} joints are open at the end, not {}", all.open, open);
    result.error = std::max(all.opening_error, all.slip_error);
    result.answer = {all.openings.empty() ? 0 : *std::max_element(all.openings.begin(), all.openings.end())};
    result.note = fmt::format(
        "{} of {} joints open, by up to {:.1f} mm, slip up to {:.1f} mm; openings to {:.1e} m, slips to {:.1e} m",
        all.open, joints.size(), 1e3 * all.opening, 1e3 * all.slip, all.opening_error, all.slip_error);
    result.picture = linear_diagram(
        "time [s]", "largest opening [m]",
        {curve_of("reference", all.times, all.expected, true), curve_of("engine", all.times, all.openings)});
    return result;
}

/// The chord of the arc that the far edge of a joint describes about the other edge, when its blocks have turned
/// against each other by so much; nothing slides. @param width of the joint [m]
Expected hinge(const Model& model, const WatchedJoint& joint, const State& now, double width)
{
    const double turn = lean_of(model, now, joint.block_a) - lean_of(model, now, joint.block_b);
    return {2 * width * std::abs(std::sin(turn / 2)), 0};
}

VerifyResult run_rocking(const scenes::SceneSetting& setting)
{
    constexpr double width = 0.4, height = 1.2;  // m
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"stone", 2500, stiff, 0.2}, rough(setting, height), 1);
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-3, -0.5, -1}, {3, 0.5, 0}));
    scenes::add_box(scene.model, "block", {-width / 2, -0.5, 0}, {width / 2, 0.5, height});
    Stage shaken = scenes::dynamic_stage(setting, 0.5);
    shaken.motions = {{0, 0, std::make_shared<const GroundMotion>(GroundMotion::sine_acceleration(5, 1, 0, 0.5))}};
    scene.stages = {scenes::static_stage(setting), shaken};
    return compare(scene, 1, [&](const WatchedJoint& joint, const State& now) {
        return hinge(scene.model, joint, now, width);
    });
}

// The arch of cases/arch_planar.yaml at a fifth of its size, a mechanism from 0.374 g sideways on. Its springers
// are stones, too.
constexpr double inner = 1.85, thickness = 0.3;                                          // m
constexpr double springing = std::numbers::pi / 16, embrace = 7 * std::numbers::pi / 8;  // rad

/// A prism across the arch, its section a quadrilateral between two radii, or a corner of an abutment.
void add_voussoir(Model& model, const std::string& name, double from, double to)
{
    std::vector<Vector3d> vertices;
    for (const double y : {-0.5, 0.5})
        for (const double angle : {from, to})
            for (const double radius : {inner, inner + thickness})
                vertices.emplace_back(-radius * std::cos(angle), y, radius * std::sin(angle));
    const ConvexPolyhedron shape = make_convex_polyhedron(
        vertices, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}, name);
    double depth = 0;
    model.blocks.push_back(is_planar(model.kinematics)
                               ? make_planar_block(name, 0, 0, {outline_of(shape, depth, name)}, model.thickness)
                               : make_block(name, 0, 0, {shape}));
}

VerifyResult run_arch(const scenes::SceneSetting& setting)
{
    constexpr int stones = 7;
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"stone", 2400, stiff, 0.2}, rough(setting, 0.8), 1);
    add_voussoir(scene.model, "left", 0, springing);
    for (int i = 0; i < stones; ++i)
        add_voussoir(scene.model, fmt::format("voussoir {}", i + 1), springing + embrace * i / stones,
                     springing + embrace * (i + 1) / stones);
    add_voussoir(scene.model, "right", springing + embrace, std::numbers::pi);
    for (const int springer : {0, stones + 1}) scenes::hold(scene.model, springer);
    const double g = scenes::papers_gravity;
    scene.stages = {scenes::static_stage(setting, {0.37 * g, 0, -g}),
                    scenes::dynamic_stage(setting, 0.5, {0.4 * g, 0, -g})};
    return compare(scene, 4, [&](const WatchedJoint& joint, const State& now) {
        return hinge(scene.model, joint, now, thickness);
    });
}

/// A stone of the upper course is led along x and lies with its weight on the lower one.
void lead(Model& model, int block)
{
    scenes::hold(model, block);
    model.foundations.back().translation_held = {true, true, false};
}

/// Three stones below, two above, all led sideways by motions of their own, each further to the right than the one
/// before: the beds slip, and the head joint of the upper course opens.
VerifyResult run_bond(const scenes::SceneSetting& setting)
{
    constexpr double length = 0.5, height = 0.25;  // m
    scenes::StagedScene scene;
    Model& model = scene.model;
    model = scenes::make_scene_model(setting, {"stone", 2000, stiff, 0.2}, rough(setting, height), 0.25);
    const auto add = [&](const char* name, double from, double z) {
        return scenes::add_box(model, name, {from, -0.125, z}, {from + length, 0.125, z + height});
    };
    for (int i = 0; i < 3; ++i) scenes::hold(model, add(fmt::format("lower {}", i + 1).c_str(), i * length, 0));
    for (int i = 0; i < 2; ++i)
        lead(model, add(fmt::format("upper {}", i + 1).c_str(), (i + 0.5) * length, height));
    Stage shear = scenes::dynamic_stage(setting, 0.5);
    const double amplitudes[] = {0, 0.2, 0.5, 0.05, 0.3};  // m/s2
    std::vector<std::shared_ptr<const GroundMotion>> motions;
    for (int block = 0; block < 5; ++block) {
        motions.push_back(
            std::make_shared<const GroundMotion>(GroundMotion::sine_acceleration(amplitudes[block], 1, 0, 0.5)));
        shear.motions.push_back({block, 0, motions.back()});
    }
    scene.stages = {scenes::static_stage(setting), shear};
    return compare(scene, 1, [&](const WatchedJoint& joint, const State& now) {
        const auto moved = [&](int block) {
            return motions[static_cast<std::size_t>(block)]->displacement(now.stage_time);
        };
        const double apart = moved(joint.block_b) - moved(joint.block_a);
        const bool is_head = std::abs(joint.normal.x()) > 0.5;
        return is_head ? Expected{apart, 0} : Expected{0, std::abs(apart)};
    });
}

Benchmark row(const std::string& name, const std::string& title, const std::string& choices,
              std::function<VerifyResult(const scenes::SceneSetting&)> run)
{
    Benchmark benchmark;
    benchmark.name = name;
    benchmark.title = title;
    benchmark.source = "docs/results_format.md (definitions of joints), and geometry";
    benchmark.quantity = "largest |opening or slip of a joint - that of the geometry| in metres";
    benchmark.choices =
        choices + " The stones are rigid, the contacts those of 1e12 Pa: what they yield by is the error.";
    benchmark.setting.time_step = 1e-3;
    benchmark.tolerance = 1e-6;
    benchmark.sweep = sweep_of(benchmark.setting, {2e-3, 1e-3, 5e-4, 2.5e-4});
    for (const double factor : {0.01, 0.1, 10.0}) {
        benchmark.sweep.push_back(benchmark.setting);
        benchmark.sweep.back().stiffness_factor = factor;
    }
    benchmark.run = std::move(run);
    return benchmark;
}

}  // namespace

std::vector<Benchmark> opening_benchmarks()
{
    return {
        row("joint-rocking-block", "The joint under a rocking block",
            "A block of 0.4 m x 1.2 m is tilted by a half sine of 5 m/s2 of its base. The joint opens by the "
            "chord 2 "
            "w sin(theta/2) that belongs to the block's rotation theta and the width w, and does not slip.",
            run_rocking),
        row("joint-four-hinge-arch", "The hinges of an arch that becomes a mechanism",
            "Seven stones, 0.3 m thick on a mean radius of 2 m over 157.5 degrees (Oppenheim's arch, a mechanism "
            "from 0.374 g on), come to "
            "rest under gravity and 0.37 g sideways and are then pushed by 0.4 g, under which they turn about "
            "four hinges. Each joint "
            "opens by the chord that belongs to the rotations of its two stones and to its depth, the closed ones "
            "by nothing, and none "
            "slips.",
            run_arch),
        row("joint-running-bond", "A sheared running bond",
            "Three stones below and two above are led sideways, each by a motion of its own, the upper ones lying "
            "with their weight on the lower. Beds slip and the head joint opens by the differences of the "
            "motions.",
            run_bond)};
}

}  // namespace voussoir::app::studies::verify
