// Waves that come in through a viscous base and leave by it.
#include "app/studies/verify/ground.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/viscous_face.h"
#include "app/studies/verify/settings.h"
#include "libdda/forces/viscous_boundary.h"
#include "libdda/model/elasticity.h"

namespace voussoir::app::studies::verify
{

using Eigen::Vector3d;
using std::numbers::pi;

namespace
{

constexpr double unbreakable = 1e15;  // Pa

JointMaterial bond(double factor)
{
    JointMaterial joint;
    joint.name = "bond";
    joint.friction_angle = 0.5;
    joint.cohesion = joint.tensile_strength = unbreakable;
    joint.stiffness.factor = factor;
    return joint;
}

/// The underside of the first block, a box.
BlockFace underside(const Model& model)
{
    const Block& block = model.blocks[0];
    if (is_planar(model.kinematics)) {
        const auto& corners = block.outlines[0].vertices;
        for (int i = 0; i < 4; ++i)
            if (corners[i].y() < 0 && corners[(i + 1) % 4].y() < 0) return {0, 0, i};
    } else {
        for (int f = 0; f < 6; ++f)
            if (face_normal(block.parts[0], f).z() < -0.5) return {0, 0, f};
    }
    return {};
}

}  // namespace

Model ground_model(const scenes::SceneSetting& setting, const GroundColumn& column)
{
    const auto material = [&](const GroundLayer& layer) {
        const double young = 2 * (1 + column.poisson) * column.density * layer.speed * layer.speed;
        return BlockMaterial{"ground", column.density, young, column.poisson, 0, layer.damping, layer.branches};
    };
    Model model = make_model(setting.kinematics, material(column.layers[0]),
                             bond(column.joints * setting.stiffness_factor.value_or(1)));
    model.materials.clear();
    double z = 0;
    for (const GroundLayer& layer : column.layers) {
        model.materials.push_back(material(layer));
        const double depth = layer.thickness / layer.blocks;
        for (int i = 0; i < layer.blocks; ++i, z += depth) {
            const int block = scenes::add_box(model, "layer", {-0.5, -0.5, z}, {0.5, 0.5, z + depth});
            model.blocks[block].material = static_cast<int>(model.materials.size()) - 1;
            model.tied_sides.push_back(block);
        }
    }
    model.boundaries.push_back({"base", {underside(model)}, RestSupport::full});
    return model;
}

GroundMotion ricker_velocity(double peak, double frequency)
{
    std::vector<double> samples;
    const double interval = 1 / (200 * frequency);
    for (int i = 0; i <= 480; ++i) {
        const double b = std::pow(pi * frequency * (i * interval - 1.2 / frequency), 2);
        samples.push_back(peak * (1 - 2 * b) * std::exp(-b));
    }
    samples.push_back(0);
    return GroundMotion::from_velocity(samples, interval, "Ricker's pulse of velocity");
}

SurfaceMotion surface_motion(const scenes::SceneSetting& setting, const Model& model, int component,
                             const GroundMotion& motion, double duration, VerifyResult& result)
{
    scenes::StagedScene scene{model, {scenes::dynamic_stage(setting, duration, Vector3d::Zero())}};
    scene.stages[0].incoming_waves = {{0, component, std::make_shared<const GroundMotion>(motion)}};
    const int top = static_cast<int>(model.blocks.size()) - 1;
    const Vector3d to_surface(0, 0, 0.5 * model.blocks[top].moments.volume);  // m: the section is 1 m2
    SurfaceMotion surface;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const Vector3d velocity =
            velocity_of(model.kinematics, now, top) + map_rate_of(model.kinematics, now, top) * to_surface;
        surface.times.push_back(now.stage_time);
        surface.velocities.push_back(velocity[component]);
    };
    State state = initial_state(model);
    surface.report = run_scene(scene, state, observer, result);
    return surface;
}

namespace
{

constexpr double peak = 0.01, pulse_frequency = 5;                 // m/s, Hz
constexpr double shear_speed = 200, speeds = 0.57735026918962573;  // m/s; c_s / c_p of Poisson's ratio 1/4

/// One pulse through a column of 1.5 wavelengths.
struct Passage {
    bool pressure = false;
    int blocks_to_wave = 40;
    double joints = 1;  // times the default
};
struct Measured {
    double surface = 0;    // largest velocity of the surface / twice the wave's
    double reflected = 0;  // largest of what comes a second time, over the same
    double residual = 0;   // of the energy
};

Measured measure(const scenes::SceneSetting& setting, const Passage& passage, VerifyResult& result)
{
    const double speed = passage.pressure ? shear_speed / speeds : shear_speed, wave = speed / pulse_frequency;
    const GroundColumn column{
        {{1.5 * wave, shear_speed, 3 * passage.blocks_to_wave / 2}}, 2000, 0.25, passage.joints};
    const double second = 5.7 / pulse_frequency;  // s, when the surface would move again
    const SurfaceMotion surface =
        surface_motion(setting, ground_model(setting, column), passage.pressure ? 2 : 0,
                       ricker_velocity(peak, pulse_frequency), second + 1 / pulse_frequency, result);
    Measured measured;
    for (std::size_t i = 0; i < surface.times.size(); ++i) {
        const double share = std::abs(surface.velocities[i]) / (2 * peak);
        measured.surface = std::max(measured.surface, share);
        if (surface.times[i] > second - 1 / pulse_frequency)
            measured.reflected = std::max(measured.reflected, share);
    }
    measured.residual = surface.report.energy.relative_residual();
    if (result.picture.curves.empty())
        result.picture =
            linear_diagram("time [s]", "surface [m/s]", {curve_of("engine", surface.times, surface.velocities)});
    return measured;
}

VerifyResult run_viscous_base(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "reflected / incoming:";
    for (const bool pressure : {false, true})
        for (const Passage& passage : {Passage{pressure, 10, 10},
                                       {pressure, 20, 10},
                                       {pressure, 40, 10},
                                       {pressure, 40, 1},
                                       {pressure, 40, 0.1}}) {
            const Measured measured = measure(setting, passage, result);
            if (passage.blocks_to_wave == 40 && passage.joints == 10) {
                result.error = std::max(result.error, measured.reflected);
                result.answer.push_back(measured.surface);
            }
            result.note += fmt::format(" {:.2e} ({}, {} blocks to a wave, joints {:g} E/L),", measured.reflected,
                                       pressure ? "P" : "S", passage.blocks_to_wave, 300 * passage.joints);
        }
    result.note.pop_back();
    return result;
}

VerifyResult run_free_surface(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "surface / twice the wave:";
    for (const bool pressure : {false, true}) {
        const Measured measured = measure(setting, {pressure, 40, 1}, result);
        result.error = std::max(result.error, std::abs(measured.surface - 1));
        result.answer.push_back(measured.surface);
        result.note += fmt::format(" {:.4f} ({}; residual of the energy {:.0e}),", measured.surface,
                                   pressure ? "P" : "S", measured.residual);
    }
    result.note.pop_back();
    return result;
}

/// A plane wave at a face: its particles move along `particles`, it runs along `way` (both may be complex).
struct PlaneWave {
    std::complex<double> particles[2], way[2];
    double speed = 0;  // m/s
};

/// Stress of a wave on the face plus what the dashpots of the engine press, per velocity of its particles, along
/// the normal and across it. The engine's matrix is applied to the wave's velocities in the block.
std::array<std::complex<double>, 2> at_face(const PlaneWave& wave, const Model& model, const Eigen::Matrix3d& turn,
                                            const step::SpatialDeformable::Square& dashpots, double area)
{
    const Elasticity e = elasticity_of(model, 0);
    std::complex<double> along = 0;
    for (int k = 0; k < 2; ++k) along += wave.particles[k] * wave.way[k];
    const Vector3d axes[2] = {turn.col(2), turn.col(0)};  // normal, across
    std::array<std::complex<double>, 2> sum;
    for (int k = 0; k < 2; ++k) {
        const std::complex<double> shear = wave.particles[k] * wave.way[0] + wave.particles[0] * wave.way[k];
        sum[k] = -((k == 0 ? e.lambda * along : 0.0) + e.mu * shear) / wave.speed;
        for (int j = 0; j < 2; ++j) {
            step::SpatialDeformable::Unknowns velocity = step::SpatialDeformable::Unknowns::Zero();
            velocity.head<3>() = axes[j];
            const Vector3d force = (dashpots * velocity).head<3>() / area;
            sum[k] += wave.particles[j] * force.dot(axes[k]);
        }
    }
    return sum;
}

double reflected_by_engine(double angle, bool pressure)
{
    scenes::SceneSetting setting;
    setting.kinematics = Kinematics::spatial_deformable;
    const Model model = ground_model(setting, {{{1, shear_speed, 1}}});
    // The underside of the block, turned somewhere: its outward normal is col(2).
    const Eigen::Matrix3d map = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    Eigen::Matrix3d turn;
    turn << map.col(0), -map.col(1), -map.col(2);
    const auto dashpots = step::dashpots_of<step::SpatialDeformable>(model, model.boundaries[0].faces[0], map);
    using Complex = std::complex<double>;
    const double sin_s = pressure ? speeds * std::sin(angle) : std::sin(angle), sin_p = sin_s / speeds;
    const Complex cos_p = std::sqrt(Complex(1 - sin_p * sin_p)), cos_s = std::sqrt(Complex(1 - sin_s * sin_s));
    const double fast = shear_speed / speeds;
    const PlaneWave in = pressure ? PlaneWave{{cos_p, sin_p}, {cos_p, sin_p}, fast}
                                  : PlaneWave{{-sin_s, cos_s}, {cos_s, sin_s}, shear_speed};
    const PlaneWave p{{-cos_p, sin_p}, {-cos_p, sin_p}, fast}, s{{sin_s, cos_s}, {-cos_s, sin_s}, shear_speed};
    const auto of_in = at_face(in, model, turn, dashpots, 1), of_p = at_face(p, model, turn, dashpots, 1),
               of_s = at_face(s, model, turn, dashpots, 1);
    Eigen::Matrix2cd matrix;
    matrix << of_p[0], of_s[0], of_p[1], of_s[1];
    const Eigen::Vector2cd back = matrix.inverse() * Eigen::Vector2cd(-of_in[0], -of_in[1]);
    const double flow_p = cos_p.real(), flow_s = speeds * cos_s.real();
    return (std::norm(back[0]) * flow_p + std::norm(back[1]) * flow_s) / (pressure ? flow_p : flow_s);
}

VerifyResult run_oblique(const scenes::SceneSetting&)
{
    VerifyResult result;
    result.note = "reflected energy:";
    for (const bool pressure : {true, false})
        for (const double angle : {0.0, 30.0, 45.0, 60.0}) {
            const double exact = references::reflected_energy(angle * pi / 180, speeds, pressure);
            const double ours = reflected_by_engine(angle * pi / 180, pressure);
            result.error = std::max(result.error, std::abs(ours - exact));
            result.note += fmt::format(" {:.4f} ({} at {:g} degrees; closed form {:.4f}),", ours,
                                       pressure ? "P" : "S", angle, exact);
        }
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> ground_benchmarks()
{
    Benchmark row;
    row.setting.kinematics = Kinematics::spatial_deformable;
    row.source = "docs/method.md (Boundaries): a plane wave along a column; [LysmerKuhlemeyer1969]";
    std::vector<Benchmark> rows;

    row.name = "viscous-base";
    row.title = "A pulse of P and of S that comes back to the viscous base it came from";
    row.quantity = "largest velocity that the surface has once more / that it had, 40 blocks to a wave";
    row.choices =
        "Ricker's pulse of 5 Hz, column of one and a half wavelengths whose sides are tied, joints of 3000 E/L. "
        "The others show the size of blocks and the stiffness of joints.";
    row.setting.time_step = 5e-4;
    row.tolerance = 0.001;
    row.run = run_viscous_base;
    rows.push_back(row);

    row.name = "free-surface";
    row.title = "A pulse of P and of S at a free surface, at defaults";
    row.quantity = "|largest velocity of the surface / twice that of the wave - 1|";
    row.choices = "Ricker's pulse of 5 Hz, 40 blocks to a wave, default joints.";
    row.setting.time_step = 2e-3;
    row.tolerance = 0.01;
    row.run = run_free_surface;
    rows.push_back(row);
    rows = with_planar(std::move(rows));

    row.name = "viscous-oblique";
    row.title = "Plane waves at 0, 30, 45 and 60 degrees to a viscous face";
    row.source = "[LysmerKuhlemeyer1969], a = b = 1";
    row.quantity = "largest |reflected energy / incoming - closed form|";
    row.choices =
        "The engine's own matrix of a face, of a block that lies somehow, on the velocities of the waves.";
    row.tolerance = 0.005;
    row.run = run_oblique;
    rows.push_back(row);
    for (Benchmark& response : ground_response_rows()) rows.push_back(std::move(response));
    for (Benchmark& decay : ground_decay_rows()) rows.push_back(std::move(decay));
    return rows;
}

}  // namespace voussoir::app::studies::verify
