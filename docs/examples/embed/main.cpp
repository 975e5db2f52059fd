// A block slides down an incline: the engine embedded in a program of one's own (docs/embedding.md).
#include <voussoir/voussoir.h>

#include <cmath>
#include <cstdio>
#include <numbers>

int main()
try {
    constexpr double degree = std::numbers::pi / 180, g = 9.80665;
    constexpr double incline = 45 * degree, friction = 20 * degree;  // rad

    // What stays: a plane that is held and a block on it, both 2400 kg/m3, 10 GPa.
    voussoir::JointMaterial joint;
    joint.friction_angle = friction;
    voussoir::Model model =
        voussoir::make_model(voussoir::Kinematics::spatial_deformable,
                             {.name = "stone", .density = 2400, .young = 1e10, .poisson = 0.2}, joint);
    model.blocks.push_back(voussoir::make_block("plane", 0, 0, {voussoir::make_box({-1, -1, -0.5}, {5, 1, 0})}));
    model.blocks.push_back(
        voussoir::make_block("block", 0, 0, {voussoir::make_box({-0.5, -0.5, 0}, {0.5, 0.5, 0.5})}));
    model.foundations.push_back({.block = 0});

    // One second from rest. The plane lies flat and gravity leans: x points down the slope.
    voussoir::Stage slide;
    slide.name = "slide";
    slide.duration = 1;              // s
    slide.control.time_step = 1e-3;  // s
    slide.gravity = {g * std::sin(incline), 0, -g * std::cos(incline)};

    voussoir::State state = voussoir::initial_state(model);
    const double start = voussoir::pose_of(model.kinematics, state, 1).centroid.x();
    const voussoir::RunReport report = voussoir::run(model, {slide}, state, {});
    const double slid = voussoir::pose_of(model.kinematics, state, 1).centroid.x() - start;

    // s = g (sin a - cos a tan phi) t^2 / 2
    const double exact = 0.5 * g * (std::sin(incline) - std::cos(incline) * std::tan(friction));
    const double error = std::abs(slid - exact) / exact;
    std::printf("engine for %s: slid %.6f m, exactly %.6f m, error %.1e\n",
                std::string(voussoir::instruction_set()).c_str(), slid, exact, error);
    return report.outcome == voussoir::Outcome::completed && error < 1e-4 ? 0 : 1;
} catch (const voussoir::InputError& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 1;
}
