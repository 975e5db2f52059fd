// A shear wave that climbs a stack of layers.
#include "app/studies/verify/waves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/shear_wave.h"

namespace voussoir::app::studies::verify
{

constexpr double shear_to_normal = 0.5;  // the documented default
constexpr double unbreakable = 1e15;     // Pa, strength of a bonded joint

namespace
{

JointMaterial bond()
{
    JointMaterial joint;
    joint.face = FaceLaw::corners;  // a column of ground that shears and does not bend
    joint.name = "bond";
    joint.friction_angle = 0.5;
    joint.cohesion = joint.tensile_strength = unbreakable;
    joint.shear_to_normal_stiffness = shear_to_normal;
    return joint;
}

}  // namespace

double young_of(const Column& column, const Layer& layer)
{
    return 2 * (1 + column.poisson) * column.density * layer.speed * layer.speed;
}

scenes::StagedScene column_scene(const scenes::SceneSetting& setting, const Column& column,
                                 const GroundMotion& base, double duration)
{
    scenes::StagedScene scene;
    Model& model = scene.model;
    model = scenes::make_scene_model(setting, {"base", column.density, 1e10, column.poisson}, bond(), 1);
    const double half = 0.5 * column.width;
    scenes::hold(model, scenes::add_box(model, "base", {-half, -0.5, -1}, {half, 0.5, 0}));
    double z = 0;
    for (const Layer& layer : column.layers) {
        model.materials.push_back({"layer", column.density, young_of(column, layer), column.poisson});
        const double depth = layer.thickness / layer.blocks;
        for (int i = 0; i < layer.blocks; ++i, z += depth) {
            const int block = scenes::add_box(model, "layer", {-half, -0.5, z}, {half, 0.5, z + depth});
            model.blocks[block].material = static_cast<int>(model.materials.size()) - 1;
        }
    }
    if (setting.stiffness_factor) {  // one stiffness for all joints, of the first layer's
        const Layer& first = column.layers.front();
        const double depth = first.thickness / first.blocks;
        model.joints[0].stiffness =
            scenes::stiffness_by_rule(setting, 2 * depth / young_of(column, first), bond());
    }
    Stage shaking = scenes::dynamic_stage(setting, duration, Eigen::Vector3d::Zero());
    shaking.motions = {{0, 0, std::make_shared<const GroundMotion>(base)}};
    scene.stages = {shaking};
    return scene;
}

std::vector<references::SiteLayer> site_of(const scenes::SceneSetting& setting, const Column& column)
{
    std::vector<references::SiteLayer> site;
    const Layer& first = column.layers.front();
    const double first_compliance = 2 * first.thickness / first.blocks / young_of(column, first);
    double below = 0;  // L / E of the block below; the base is held
    for (const Layer& layer : column.layers) {
        const double young = young_of(column, layer), depth = layer.thickness / layer.blocks;
        const double compliance = depth / young;
        for (int i = 0; i < layer.blocks; ++i) {
            const double normal =
                setting.stiffness_factor
                    ? *setting.stiffness_factor * scenes::default_stiffness(setting, first_compliance, bond())
                    : scenes::default_stiffness(setting, below + compliance, bond());
            site.push_back(
                {depth, column.density, column.density * layer.speed * layer.speed, shear_to_normal * normal});
            below = compliance;
        }
    }
    return site;
}

namespace
{

// Printed: a stack 50 m high, one cycle of a sine of displacement, a point 18.5 m from the base, an axis of 0.04
// s.
constexpr double stack_height = 50, point_height = 18.5;  // m

/// What is not printed. With these the reflection from the surface returns to the point after 0.04 s.
struct WaveChoice {
    double speed = 2000;      // m/s, intact
    double amplitude = 0.01;  // m
    double frequency = 50;    // Hz
    int layers = 50;          // with a centroid at the height of the point: 50 or 150
    double width = 5000;      // m
};

double one_cycle(const WaveChoice& wave, double time)
{
    if (time <= 0 || time >= 1 / wave.frequency) return 0;
    return wave.amplitude * std::sin(2 * std::numbers::pi * wave.frequency * time);
}

GroundMotion one_cycle_motion(const WaveChoice& wave)
{
    const double interval = 5e-4 / wave.frequency;  // s, of the samples
    std::vector<double> samples;
    for (int i = 0; i <= 4000; ++i) samples.push_back(one_cycle(wave, i * interval));
    return GroundMotion::from_displacement(samples, interval, "one cycle of a sine");
}

struct WaveRecord {
    std::vector<double> trace;  // m, at the point, at the end of every step from 0 on
    std::function<double(double)> exact;
    double jointed_speed = 0;  // m/s
};

WaveRecord climb(const scenes::SceneSetting& setting, const WaveChoice& wave, VerifyResult& result)
{
    Column column{{{stack_height, wave.speed, wave.layers}}, 2500, 0.2, wave.width};
    const double depth = stack_height / wave.layers;
    const references::SiteLayer block = site_of(setting, column).back();
    WaveRecord record;
    record.jointed_speed = std::sqrt(
        references::jointed_shear_modulus(block.shear_modulus, block.joint_stiffness, depth) / block.density);
    const double c = record.jointed_speed;
    record.exact = [c, wave](double t) {
        const auto base = [&](double time) { return one_cycle(wave, time); };
        return references::shear_wave(base, c, stack_height, point_height, t);
    };
    const double reflection = (2 * stack_height - point_height) / c;
    const double duration = std::floor(reflection / setting.time_step) * setting.time_step;
    const scenes::StagedScene scene = column_scene(setting, column, one_cycle_motion(wave), duration);
    State state = initial_state(scene.model);
    const int watched = 1 + static_cast<int>(point_height / depth);  // the block whose centroid is the point
    record.trace = {0};
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (std::abs(now.stage_time - static_cast<double>(record.trace.size()) * setting.time_step) < 1e-9)
            record.trace.push_back(pose_of(scene.model.kinematics, now, watched).centroid.x());
    };
    run_scene(scene, state, observer, result);
    result.answer.insert(result.answer.end(), record.trace.begin(), record.trace.end());
    return record;
}

/// Crest and trough over the amplitude, less one.
struct Extremes {
    double crest = 0, trough = 0;
    double worst() const { return std::max(std::abs(crest), std::abs(trough)); }
};

Extremes extremes_of(const WaveRecord& record, double amplitude)
{
    const auto [least, most] = std::minmax_element(record.trace.begin(), record.trace.end());
    return {*most / amplitude - 1, -*least / amplitude - 1};
}

VerifyResult run_amplitude(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const WaveChoice wave;
    const WaveRecord record = climb(setting, wave, result);
    const Extremes extremes = extremes_of(record, wave.amplitude);
    result.error = extremes.worst();
    double shape = 0;
    std::vector<double> times, exact;
    for (std::size_t i = 0; i < record.trace.size(); ++i) {
        times.push_back(static_cast<double>(i) * setting.time_step);
        exact.push_back(record.exact(times.back()));
        shape = std::max(shape, std::abs(record.trace[i] - exact.back()));
    }
    result.picture =
        linear_diagram("time [s]", "displacement [m]",
                       {curve_of("d'Alembert", times, exact, true), curve_of("engine", times, record.trace)});
    const double omega = 2 * std::numbers::pi * wave.frequency, travel = point_height / record.jointed_speed;
    result.note = fmt::format(
        "crest {:+.2f} %, trough {:+.2f} %; damping of the integrator alone -{:.2f} %; largest difference "
        "anywhere "
        "{:.1f} % of the amplitude, at the corners of the pulse",
        100 * extremes.crest, 100 * extremes.trough,
        -100 * std::expm1(-own_damping(setting, omega) * omega * travel), 100 * shape / wave.amplitude);
    return result;
}

/// The same with other values of what is not printed; a slower wave with a longer step.
VerifyResult run_choices(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    struct Other {
        const char* what;
        WaveChoice wave;
    };
    for (const auto& [what, wave] : {Other{"amplitude 0.03 m", {.amplitude = 0.03}},
                                     Other{"150 layers", {.layers = 150}}, Other{"half as wide", {.width = 2500}},
                                     Other{"500 m/s and 12.5 Hz, 4 x the step", {.speed = 500, .frequency = 12.5}},
                                     Other{"40 Hz", {.frequency = 40}}}) {
        scenes::SceneSetting scaled = setting;
        scaled.time_step *= 2000 / wave.speed;
        const double error = extremes_of(climb(scaled, wave, result), wave.amplitude).worst();
        result.error = std::max(result.error, error);
        result.note += fmt::format("{}{}: {:.2f} %", result.note.empty() ? "" : ", ", what, 100 * error);
    }
    return result;
}

VerifyResult run_arrival(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const WaveChoice wave;
    const WaveRecord record = climb(setting, wave, result);
    const double lag = references::lag_of(record.trace, record.exact, setting.time_step);
    result.error = std::abs(lag) / setting.time_step;
    result.note = fmt::format("{:+.3e} s after {:.4e} s at {:.0f} m/s, joints included ({:.0f} m/s without)", lag,
                              point_height / record.jointed_speed, record.jointed_speed, wave.speed);
    return result;
}

}  // namespace

std::vector<Benchmark> wave_benchmarks()
{
    Benchmark row;
    row.source = "yagoda-biran-hatzor, section 3.5, figure 16";
    row.paper_error = "wave form preserved; figure not available";
    row.setting.kinematics = Kinematics::spatial_deformable;
    row.setting.time_step = 1e-4;
    row.sweep = sweep_of(row.setting, {4e-4, 2e-4, 1e-4, 5e-5});
    std::vector<Benchmark> rows;

    row.name = "shear-wave-amplitude";
    row.title = "Amplitude of a shear wave in stacked layers";
    row.quantity = "larger of |crest / amplitude - 1| and |trough / amplitude - 1|";
    row.tolerance = 0.01;
    row.run = run_amplitude;
    rows.push_back(row);

    row.name = "shear-wave-choices";
    row.title = "The same with other layers, waves and materials, which are not printed";
    row.run = run_choices;
    rows.push_back(row);
    rows.back().sweep.clear();

    row.name = "shear-wave-arrival";
    row.title = "Arrival of a shear wave in stacked layers";
    row.quantity = "|lag behind d'Alembert's solution| / time step";
    row.tolerance = 1;
    row.run = run_arrival;
    rows.push_back(row);
    for (Benchmark& site : site_rows()) rows.push_back(std::move(site));
    for (Benchmark& slip : slip_rows()) rows.push_back(std::move(slip));
    return rows;
}

}  // namespace voussoir::app::studies::verify
