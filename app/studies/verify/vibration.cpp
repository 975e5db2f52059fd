// Bonded stones that vibrate, as the program does it when it is told nothing: the frequency of a rod, the
// amplitude of a layer at resonance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/vibration.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/vibration.h"
#include "app/studies/verify/waves.h"

namespace voussoir::app::studies::verify
{

namespace
{

using std::numbers::pi;

// A rod of 20 m: what its joints and its steps take away does not depend on the length but on the frequency, 10
// Hz.
constexpr double rod_height = 20, rod_speed = 800, rod_width = 1;  // m, m/s, m
constexpr double rod_strain = 1e-5;                                // -, largest
constexpr int rod_cycles = 20;

/// Moves the stones upwards as in the lowest mode of their chain: each stretches at the same rate over its height.
void set_mode(const Model& model, double length, State& state)
{
    const int dimension = dimension_of(model.kinematics), count = static_cast<int>(model.blocks.size()) - 1;
    const double speed = rod_strain * rod_speed;
    const auto node = [&](int j) { return speed * std::sin(j * pi / (2 * count)); };
    for (int i = 1; i <= count; ++i) {
        double* velocity = state.velocities.data() + i * unknowns_per_block(model.kinematics);
        velocity[dimension - 1] = 0.5 * (node(i - 1) + node(i));
        velocity[dimension * dimension + dimension - 1] = (node(i) - node(i - 1)) / length;  // the last of dA/dt
    }
}

/// Frequency of the top's motion [Hz], by its first and last passage through zero upwards.
double rod_frequency_of(const scenes::SceneSetting& setting, int stones, VerifyResult& result)
{
    const double frequency = references::rod_frequency(stones, rod_speed, rod_height);
    // Poisson's ratio 0: a rod that neither thins nor bulges has one wave.
    const Column column{{{rod_height, rod_speed / std::sqrt(2.0), stones}}, 2000, 0, rod_width};
    const GroundMotion rest = GroundMotion::from_displacement({0, 0}, 1, "rest");
    const scenes::StagedScene scene = column_scene(setting, column, rest, (rod_cycles + 0.5) / frequency);
    std::vector<double> times{0}, heights{0};
    const double start = rod_height * (1 - 0.5 / stones);
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        times.push_back(now.stage_time);
        heights.push_back(pose_of(scene.model.kinematics, now, stones).centroid.z() - start);
    };
    run_moving(
        scene, [&](State& state) { set_mode(scene.model, rod_height / stones, state); }, observer, result);
    result.picture = linear_diagram("time [s]", "top [m]", {curve_of("engine", times, heights)});
    return frequency_of(times, heights);
}

VerifyResult run_rod(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "frequency / that of rigid joints:";
    for (int stones = 1; stones <= 8; ++stones) {
        const double exact = references::rod_frequency(stones, rod_speed, rod_height);
        const double ratio = rod_frequency_of(setting, stones, result) / exact;
        result.answer.push_back(ratio);
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.note +=
            fmt::format(" {:.5f} ({} x {:.1f} m, {:.2f} Hz),", ratio, stones, rod_height / stones, exact);
    }
    result.note.pop_back();
    return result;
}

// A layer of 20 m in 20 stones, each of constant strain.
constexpr double layer_height = 20;  // m
constexpr int layer_stones = 20;
constexpr double base_amplitude = 1e-5;  // m
constexpr double died = 1e-3;            // share of the free vibration that is left when it is measured

struct Layered {
    double frequency, damping;  // Hz, of the layer itself; ratio there
};

/// Amplitude of the surface relative to the base over that of the base.
double layer_amplitude_of(const scenes::SceneSetting& setting, const Layered& layer, VerifyResult& result)
{
    const double omega = 2 * pi * layer.frequency, period = 1 / layer.frequency;
    const double speed = 4 * layer_height * layer.frequency;
    const Column column{{{layer_height, speed, layer_stones}}, 2000, 0, 100 * layer_height};
    const GroundMotion shaking =
        GroundMotion::sine_acceleration(base_amplitude * omega * omega, layer.frequency, pi / 2, 1e6);
    const double settled = std::ceil(-std::log(died) / (layer.damping * omega) / period) * period;
    scenes::StagedScene scene = column_scene(setting, column, shaking, settled + 4 * period);
    scene.stages[0].damping.rate = 2 * layer.damping * omega;
    const Eigen::Vector3d top(0, 0, 0.5 * layer_height / layer_stones);
    std::vector<double> times, apart;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (now.stage_time < settled) return;
        const Pose pose = pose_of(scene.model.kinematics, now, layer_stones);
        const double base = pose_of(scene.model.kinematics, now, 0).centroid.x();
        times.push_back(now.stage_time);
        apart.push_back((pose.centroid + pose.map * top).x() - base);
    };
    State state = initial_state(scene.model);
    run_scene(scene, state, observer, result);
    result.picture = linear_diagram("time [s]", "surface - base [m]", {curve_of("engine", times, apart)});
    return amplitude_of(times, apart, layer.frequency) / base_amplitude;
}

VerifyResult run_layer(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "amplitude / that of the closed form:";
    for (const Layered& layer : {Layered{2.5, 0.02}, Layered{2.5, 0.05}, Layered{5, 0.02}, Layered{5, 0.05}}) {
        const double rate = 4 * pi * layer.frequency * layer.damping;
        const double exact =
            references::layer_amplitude(4 * layer_height * layer.frequency, layer_height, rate, layer.frequency);
        const double ratio = layer_amplitude_of(setting, layer, result) / exact;
        result.answer.push_back(ratio);
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.note += fmt::format(" {:.4f} ({:g} Hz, damping {:g} %, {:.2f} times the base),", ratio,
                                   layer.frequency, 100 * layer.damping, exact);
    }
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> vibration_benchmarks()
{
    Benchmark row;
    row.setting.kinematics = Kinematics::spatial_deformable;
    row.setting.time_step = 2e-3;
    std::vector<Benchmark> rows;

    row.name = "bonded-rod";
    row.title = "Free vibration of a bonded rod of 1 to 8 stones, at defaults";
    row.source = "docs/method.md (Integrators): closed form of the chain of elements; not from a paper";
    row.quantity = "largest |frequency / that of as many elements without joints - 1|";
    row.choices =
        "20 m high on a held base, 10 Hz as a rod of many stones. One stone of constant strain is 10 % too stiff, "
        "eight "
        "are 0.2 %: that error is the reference's too.";
    row.tolerance = 0.01;
    row.run = run_rod;
    rows.push_back(row);

    row.name = "layer-resonance";
    row.title = "A layer at resonance with damping of 2 and 5 %, at defaults";
    row.source = "docs/method.md (Integrators): closed form of the layer on a rigid base; not from a paper";
    row.quantity = "largest |amplitude of the surface / that of the closed form - 1|";
    row.choices =
        "20 m in 20 bonded stones, 2.5 and 5 Hz, shaken by its base at the frequency of the layer without joints "
        "until "
        "0.1 % of the free vibration is left. The damping is the program's, by the velocity relative to the "
        "ground: "
        "rate = 2 x ratio x omega.";
    row.tolerance = 0.03;
    row.run = run_layer;
    rows.push_back(row);
    for (Benchmark& tower : tower_vibration_rows()) rows.push_back(std::move(tower));
    return with_planar(std::move(rows));
}

}  // namespace voussoir::app::studies::verify
