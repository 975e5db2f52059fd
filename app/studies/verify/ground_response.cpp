// What soil makes of a wave from the rock below.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "app/studies/verify/ground.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/layered_site.h"
#include "app/studies/verify/references/viscous_face.h"
#include "app/studies/verify/settings.h"

namespace voussoir::app::studies::verify
{

using Eigen::Vector3d;
using std::numbers::pi;

namespace
{

constexpr double layer_height = 20, layer_frequency = 2.5;  // m, Hz: a speed of 200 m/s
constexpr int layer_blocks = 20;
constexpr double peak = 0.01;  // m/s
constexpr double band = 1.15;  // frequencies at which the damping is as asked: the layer's over this and times it
constexpr double left = 1e-3;  // share of the motion when the run ends

struct Site {
    double impedance = 0, damping = 0;  // rho c of the layer / that of the rock; ratio
};

references::Peak largest_of(const std::vector<double>& values, double first, double interval)
{
    const std::vector<references::Peak> peaks = references::peaks_of(values, first, interval);
    references::Peak largest;
    for (const references::Peak& one : peaks)
        if (one.value > largest.value) largest = one;
    return largest;
}

/// First peak of the surface's motion over the outcrop's: by the engine, in closed form with Rayleigh's damping,
/// and with the same damping at all frequencies.
struct Amplified {
    references::Peak ours, exact, constant;
};

Amplified amplified(const scenes::SceneSetting& setting, const Site& site, VerifyResult& result)
{
    const double speed = 4 * layer_height * layer_frequency, rock_speed = speed / site.impedance;
    const RayleighDamping damping = rayleigh(site.damping, layer_frequency / band, layer_frequency * band);
    // One block of rock, as thick in time as one of the layer.
    const GroundColumn column{{{layer_height / layer_blocks / site.impedance, rock_speed, 1},
                               {layer_height, speed, layer_blocks, damping}}};
    const GroundMotion wave = ricker_velocity(peak, layer_frequency);
    const double decay = 2 * pi * layer_frequency * (site.damping + 2 / pi * site.impedance);
    const double duration = 3 / layer_frequency - std::log(left) / decay;
    const SurfaceMotion surface =
        surface_motion(setting, ground_model(setting, column), 0, wave, duration, result);
    std::vector<double> incoming(surface.times.size());
    for (std::size_t i = 0; i < incoming.size(); ++i) incoming[i] = 2 * wave.velocity(surface.times[i]);

    const double first = 0.6 * layer_frequency, interval = 0.005 * layer_frequency;
    std::vector<double> ours, exact, constant;
    for (int i = 0; i <= 160; ++i) {
        const double f = first + i * interval;
        ours.push_back(std::abs(references::fourier(surface.velocities, setting.time_step, f) /
                                references::fourier(incoming, setting.time_step, f)));
        const double omega = 2 * pi * f, layer = f * layer_height / speed;
        const std::complex<double> modulus(1, omega * damping.of_stiffness), density(1, -damping.of_mass / omega);
        exact.push_back(std::abs(references::surface_over_outcrop(layer, site.impedance, modulus, density)));
        constant.push_back(
            std::abs(references::surface_over_outcrop(layer, site.impedance, {1, 2 * site.damping}, 1)));
    }
    return {largest_of(ours, first, interval), largest_of(exact, first, interval),
            largest_of(constant, first, interval)};
}

VerifyResult run_layer_on_rock(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "amplification, frequency / closed form:";
    for (const double impedance : {0.1, 0.2, 0.5})
        for (const double damping : {0.02, 0.05, 0.1}) {
            const auto [ours, exact, constant] = amplified(setting, {impedance, damping}, result);
            const double height = ours.value / exact.value, place = ours.frequency / exact.frequency;
            // 3 % of a peak count as much as 1 % of its frequency.
            result.error = std::max({result.error, std::abs(height - 1), 3 * std::abs(place - 1)});
            result.answer.push_back(height);
            result.note += fmt::format(
                " {:.4f}, {:.4f} (impedance {:g}, damping {:g} %: {:.3f} at {:.3f} Hz; damped alike at all "
                "frequencies {:.3f} at {:.3f} Hz),",
                height, place, impedance, 100 * damping, exact.value, exact.frequency, constant.value,
                constant.frequency);
        }
    result.note.pop_back();
    return result;
}

// The 15 layers of 1 m of the row site-inhomogeneous, on rock, with damping in the blocks and not in the
// integrator.
constexpr double stack_density = 2000, rock_speed = 2500, highest = 50;  // kg/m3, m/s, Hz
constexpr double stack_damping = 0.02 / (std::numbers::pi * 14);         // s: 2 % at 14 Hz, near the first peak

GroundColumn stack_on_rock()
{
    GroundColumn column{{{3, rock_speed, 1}}, stack_density};
    for (const double speed : {1200, 1150, 1100, 700, 1050, 1000, 950, 900, 600, 850, 800, 750, 700, 450, 500})
        column.layers.push_back({1, speed, 2, {0, stack_damping}});
    return column;
}

/// Peaks of |surface / top of the rock| below 50 Hz, and of the exact ratio.
struct StackPeaks {
    std::vector<references::Peak> ours, exact;
};

StackPeaks stack_peaks(const scenes::SceneSetting& setting, VerifyResult& result)
{
    const GroundColumn column = stack_on_rock();
    scenes::StagedScene scene{ground_model(setting, column),
                              {scenes::dynamic_stage(setting, 1.5, Vector3d::Zero())}};
    const auto wave = std::make_shared<const GroundMotion>(ricker_velocity(peak, 0.5 * highest));
    scene.stages[0].incoming_waves = {{0, 0, wave}};
    const int top = static_cast<int>(scene.model.blocks.size()) - 1;
    std::vector<double> up, down;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const auto velocity_at = [&](int block, double above) {
            return (velocity_of(scene.model.kinematics, now, block) +
                    map_rate_of(scene.model.kinematics, now, block) * Vector3d(0, 0, above))
                .x();
        };
        up.push_back(velocity_at(top, 0.25));
        down.push_back(velocity_at(1, -0.25));
    };
    State state = initial_state(scene.model);
    run_scene(scene, state, observer, result);
    std::vector<references::SiteLayer> site;
    for (std::size_t i = 1; i < column.layers.size(); ++i)
        site.push_back(
            {1, stack_density, stack_density * column.layers[i].speed * column.layers[i].speed, INFINITY});
    const double interval = 0.05;
    std::vector<double> ours, exact;
    const int count = static_cast<int>(std::round(highest / interval));
    for (int i = 1; i <= count; ++i) {
        const double f = i * interval;
        ours.push_back(std::abs(references::fourier(up, setting.time_step, f) /
                                references::fourier(down, setting.time_step, f)));
        exact.push_back(std::abs(references::amplification(site, f, stack_damping)));
    }
    return {references::peaks_of(ours, interval, interval), references::peaks_of(exact, interval, interval)};
}

VerifyResult run_stack(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    const auto [ours, exact] = stack_peaks(setting, result);
    if (ours.size() != exact.size()) {
        result.failure = fmt::format("{} peaks below 50 Hz, the reference has {}", ours.size(), exact.size());
        return result;
    }
    result.note = "peaks, exact in brackets:";
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double height = ours[i].value / exact[i].value, place = ours[i].frequency / exact[i].frequency;
        result.error = std::max({result.error, std::abs(height - 1), 3 * std::abs(place - 1)});
        result.answer.push_back(height);
        result.note += fmt::format(" {:.3f} at {:.3f} Hz ({:.3f} at {:.3f}),", ours[i].value, ours[i].frequency,
                                   exact[i].value, exact[i].frequency);
    }
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> ground_response_rows()
{
    Benchmark row;
    row.setting.kinematics = Kinematics::spatial_deformable;
    row.setting.time_step = 1e-3;
    std::vector<Benchmark> rows;

    row.name = "layer-on-rock";
    row.title = "A layer on elastic rock with damping of 2, 5 and 10 %, at default joints";
    row.source = "[Kramer1996], 7.2.1.4: damped layer on elastic rock";
    row.quantity = "largest |peak of surface / outcrop over the closed form - 1| and 3 x that of its frequency";
    row.choices =
        "20 m in 20 bonded blocks on one of rock with a viscous base; Ricker's pulse of 2.5 Hz, run until 0.1 % "
        "of "
        "the motion is left. Rayleigh's damping, as named 15 % below and above the layer's frequency, in the "
        "closed "
        "form too; the note has the peak for a damping that is the same at all frequencies: where much is "
        "radiated "
        "it lies up to 4 % lower.";
    row.tolerance = 0.03;
    row.run = run_layer_on_rock;
    rows.push_back(row);

    row.name = "layers-on-rock";
    row.title = "15 layers on rock with damping in their blocks, at default joints";
    row.source = "yagoda-biran-hatzor, section 3.5: the layers; exact ratio by [Kramer1996], 7.2.1";
    row.quantity =
        "largest |peak of surface / top of the rock over the exact one - 1| and 3 x that of its frequency";
    row.choices =
        "The layers of site-inhomogeneous in two blocks each on a block of rock with a viscous base, damped by "
        "stiffness, 2 % at 14 Hz; Ricker's pulse of 25 Hz, peaks below 50 Hz.";
    row.setting.time_step = 5e-4;
    row.tolerance = 0.03;
    row.run = run_stack;
    rows.push_back(row);
    return with_planar(std::move(rows));
}

}  // namespace voussoir::app::studies::verify
