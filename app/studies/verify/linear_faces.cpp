// Joints that give way linearly and open: rotation, free vibration and overturning of a block on its bed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studies/scenes/shapes.h"
#include "app/studies/verify/families.h"
#include "app/studies/verify/limit_masonry.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/elastic_bed.h"
#include "app/studies/verify/references/faces.h"
#include "app/studies/verify/references/smooth_ode.h"
#include "app/studies/verify/run_scene.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/vibration.h"

namespace voussoir::app::studies::verify
{

namespace
{

using Eigen::Vector3d;
using Eigen::VectorXd;

// A block of 1 x 1 x 2 m.
constexpr double density = 2000, mass = density * 2, weight = mass * scenes::papers_gravity;  // kg/m3, kg, N
constexpr double centroid_height = 1;                                                         // m
constexpr double rough = 1.4;                                                                 // rad: never slides

/// @param stiffness [Pa/m]
scenes::StagedScene block_scene(const scenes::SceneSetting& setting, double stiffness, const Vector3d& gravity)
{
    JointMaterial joint = scenes::dry_joint(rough);
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    joint.face = FaceLaw::linear;
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, scenes::stone(density, 1e14), joint, 1);
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-2, -2, -1}, {2, 2, 0}));
    scenes::add_box(scene.model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 2});
    scene.stages = {scenes::static_stage(setting, gravity)};
    return scene;
}

// ---- Rotation --------------------------------------------------------------------------------------------------

constexpr double lean_stiffness = 1e9;  // Pa/m

/// How far the block leans from the vertical when gravity leans [rad].
double rotation_of(const scenes::SceneSetting& setting, const Vector3d& towards, double lean, VerifyResult& result)
{
    const scenes::StagedScene scene =
        block_scene(setting, lean_stiffness, scenes::papers_gravity * (lean * towards - Vector3d::UnitZ()));
    State state = initial_state(scene.model);
    run_scene(scene, state, {}, result);
    if (is_planar(setting.kinematics)) return lean_of(scene.model, state, 1);
    const Vector3d up = pose_of(scene.model.kinematics, state, 1).map.col(2);
    return std::atan2(up.dot(towards), up.z());
}

/// The block that turns takes its weight along. @param under eccentricity -> rotation
template <class Under>
double settled(double lean, const Under& under)
{
    double rotation = 0;
    for (int i = 0; i < 100; ++i)
        rotation = under(references::eccentricity_under(lean, rotation, centroid_height));
    return rotation;
}

VerifyResult run_rotation(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const auto compare = [&](const Vector3d& towards, double lean, double expected) {
        const double ratio = rotation_of(setting, towards, lean, result) / expected;
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.note += fmt::format(" {:.4f} ({:g} m),", ratio, lean);
        return ratio;
    };
    result.note = "rotation / closed form, resultant beside the middle:";
    const auto about_middle = [](double e) { return references::rotation_under(weight, lean_stiffness, 1, e); };
    for (const double lean : {0.05, 0.1, 0.16, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45})
        result.answer.push_back(compare(Vector3d::UnitX(), lean, settled(lean, about_middle)));
    if (!is_planar(setting.kinematics)) {
        result.note += " and beside the diagonal:";
        const auto about_diagonal = [](double e) {
            return references::diagonal_rotation(lean_stiffness, 1, weight, e);
        };
        for (const double lean : {0.1, 0.2, 0.3, 0.4, 0.5, 0.55})
            compare(Vector3d(1, 1, 0).normalized(), lean, settled(lean, about_diagonal));
    }
    result.note.pop_back();
    return result;
}

// ---- Free vibration --------------------------------------------------------------------------------------------

constexpr double rock_stiffness = 1e8, spin = 0.15, rock_time = 1;  // Pa/m, rad/s, s

/// Without friction the centroid keeps its place sideways. Of rise, rotation and their speeds.
VectorXd rocking(const VectorXd& y)
{
    const double h = centroid_height, inertia = mass * (1 + 4) / 12;
    const references::BedForce bed =
        references::strip_force({rock_stiffness, 1, 1}, -(y[0] + h * (1 - std::cos(y[1]))), std::tan(y[1]));
    return Eigen::Vector4d(y[2], y[3], (bed.normal - weight) / mass,
                           (bed.normal * h * std::sin(y[1]) - bed.moment) / inertia);
}

VerifyResult run_rocking(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    scenes::StagedScene scene = block_scene(setting, rock_stiffness, scenes::papers_gravity * -Vector3d::UnitZ());
    // The equation knows springs only.
    scene.model.joints[0].friction_angle = 0;
    scene.model.joints[0].restitution.reset();
    scene.stages.push_back(scenes::dynamic_stage(setting, rock_time));
    std::vector<double> times, leans, expected;
    references::OdePoint point{0, Eigen::Vector4d(-weight / rock_stiffness, 0, 0, spin)};
    double largest = 0, off = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        times.push_back(now.stage_time);
        leans.push_back(lean_of(scene.model, now, 1));
        references::integrate([](double, const VectorXd& y) { return rocking(y); }, now.stage_time, 1e-10,
                              [](double, const VectorXd&) { return 1.0; }, point);
        expected.push_back(point.y[1]);
        largest = std::max(largest, std::abs(expected.back()));
        off = std::max(off, std::abs(leans.back() - expected.back()));
    };
    const auto start = [&](State& state) {
        double* velocity = state.velocities.data() + unknowns_per_block(scene.model.kinematics);
        if (is_planar(scene.model.kinematics))
            velocity[2] = -spin;  // turns from x to z are positive
        else
            velocity[4] = spin;
    };
    run_moving(scene, start, observer, result);
    result.error = off / largest;
    result.answer = leans;
    result.note = fmt::format("rocks by {:.2e} rad, {:.1f} times what opens its bed", largest,
                              largest / (2 * weight / rock_stiffness));
    result.picture =
        linear_diagram("time [s]", "rotation [rad]",
                       {curve_of("engine", times, leans), curve_of("equation", times, expected, true)});
    return result;
}

// ---- Overturning -----------------------------------------------------------------------------------------------

VerifyResult run_overturning(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "lean at which it falls / formula:";
    for (const double stiffness : {1e9, 1e10, 1e11}) {
        const double reference = references::largest_lean(stiffness, 1, weight, centroid_height);
        const scenes::StagedScene scene =
            block_scene(setting, stiffness, scenes::papers_gravity * Vector3d(0, 0, -1));
        const EngineThreshold found =
            engine_threshold(scene.model, 0.9 * reference, 1.1 * reference, 2e-4, setting);
        const double ratio = 0.5 * (found.stands + found.falls) / reference;
        result.answer.push_back(ratio);
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.steps += found.steps;
        result.step_cuts += found.step_cuts;
        result.iterations += found.iterations;
        result.cpu_time += found.cpu_time;
        result.note += fmt::format(" {:.5f} ({:.4f}, {:g} GPa/m),", ratio, reference, stiffness / 1e9);
    }
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> linear_face_benchmarks()
{
    Benchmark rotation;
    rotation.setting.kinematics = Kinematics::spatial_rigid;
    rotation.setting.time_step = 5e-4;
    rotation.name = "linear-rotation";
    rotation.title = "A block whose weight bears beside the middle of its bed, face: linear";
    rotation.source = "docs/faces.md: springs all over a face that do not pull; not from a paper";
    rotation.quantity = "largest |rotation / closed form - 1|";
    rotation.choices =
        "1 x 1 x 2 m on 1 GPa/m, gravity leaned, up to 0.45 of the width beside the middle, and 0.42 of the "
        "diagonal towards a corner. With face: points it errs beyond the middle third, as face-eccentric says.";
    rotation.tolerance = 0.01;
    rotation.run = run_rotation;

    Benchmark rocking = rotation;
    rocking.name = "linear-rocking";
    rocking.title = "A block that rocks on an elastic bed which opens, face: linear";
    rocking.source = "docs/faces.md: the block's equation of motion, integrated to 1e-10; not from a paper";
    rocking.quantity = "largest |rotation - reference| / largest rotation, over 1 s";
    rocking.choices =
        "1 x 1 x 2 m on 0.1 GPa/m without friction, from rest with 0.15 rad/s; springs alone, no law of landings.";
    rocking.tolerance = 0.01;
    rocking.run = run_rocking;
    rocking.setting.time_step = 1.25e-4;
    rocking.sweep = sweep_of(rocking.setting, {1e-3, 5e-4, 2.5e-4, 1.25e-4});

    Benchmark overturning = rotation;
    overturning.name = "linear-overturning";
    overturning.title = "A block that is pushed over on an elastic bed, face: linear";
    overturning.quantity = "largest |lateral load / weight at which it falls / formula - 1|";
    overturning.choices =
        "1 x 1 x 2 m on 1, 10 and 100 GPa/m. The edge that it turns over about moves in by a third of what "
        "presses; a rigid block falls at 0.5.";
    overturning.tolerance = 0.003;
    overturning.run = run_overturning;
    return with_planar({rotation, rocking, overturning});
}

}  // namespace voussoir::app::studies::verify
