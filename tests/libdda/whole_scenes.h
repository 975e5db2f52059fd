// Scenes of a few blocks that rock, slide and knock, and a wall large enough for threads to matter.
#pragma once

#include <memory>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

/// Where and in what measure a scene is told: x -> scale R x + offset, blocks in the order given.
struct Telling {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    double scale = 1;                       // units of length per metre
    std::vector<int> order{0, 1, 2, 3, 4};  // place in the model -> block of the plain telling
};

/// A held floor, two stacked boxes, a box that slides towards them and one that falls on top.
struct FewBlocks {
    Model model;
    State state;
    std::vector<int> place;  // of each block of the plain telling

    FewBlocks(Kinematics kinematics, const Telling& telling)
    {
        const double s = telling.scale;
        // Mass is told in the same unit, so Pa = kg/(m s2) scales with 1/s and kg/m3 with 1/s^3.
        JointMaterial joint = dry(25);
        joint.stiffness = {ContactStiffness::Kind::per_area, 2e9 / (s * s)};
        model = make_model(kinematics, {"stone", 2500 / (s * s * s), 2e9 / s, 0.2}, joint);
        const Eigen::Vector3d lower[] = {{-4, -4, -1}, {0, 0, 0}, {0.1, 0.05, 0.5}, {-0.9, 0.1, 0}, {0.2, 0, 1.0}};
        const Eigen::Vector3d upper[] = {
            {4, 4, 0}, {1, 0.8, 0.5}, {0.8, 0.7, 0.9}, {-0.1, 0.6, 0.4}, {0.7, 0.5, 1.3}};
        const Eigen::Vector3d speed[] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {3, 0.5, 0}, {0.2, 0.1, -2}};
        const Eigen::Vector3d spin[] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0.5}, {0.3, -0.2, 1}};
        place.resize(5);
        for (int i = 0; i < 5; ++i) {
            const int b = telling.order[i];
            place[b] = add_box(model, "block", s * lower[b], s * upper[b]);
            if (b == 0) hold(model, place[b]);
        }
        state = initial_state(model);
        for (int b = 0; b < 5; ++b) {
            const Eigen::Vector3d centre = s * (lower[b] + upper[b]) / 2;
            set_pose(model, state, place[b], telling.rotation * centre + telling.offset, telling.rotation);
            set_velocity(model, state, place[b], s * telling.rotation * speed[b], telling.rotation * spin[b]);
        }
        begin_stage(model, 0, state);
    }
};

/// A running-bond wall one stone thick on a held base that shakes sideways.
inline Model running_bond(Kinematics kinematics, int courses, int stones)
{
    Model model = make_model(kinematics, {"stone", 2000, 2e9, 0.2}, dry(31));
    const double length = 0.6, height = 0.3, depth = 0.3;
    hold(model, add_box(model, "base", {-1, 0, -0.3}, {stones * length + 1, depth, 0}));
    for (int course = 0; course < courses; ++course) {
        const bool shifted = course % 2 == 1;
        for (int i = 0; i < stones + shifted; ++i) {
            const double from = std::max(0.0, (i - 0.5 * shifted) * length);
            const double to = std::min(stones * length, (i + 1 - 0.5 * shifted) * length);
            add_box(model, "stone", {from, 0, course * height}, {to, depth, (course + 1) * height});
        }
    }
    return model;
}

/// Horizontal and vertical shaking of foundation 0.
inline Stage shaking(double duration, double time_step)
{
    Stage stage = dynamic_stage(duration, time_step);
    const auto wave = [](double amplitude, double frequency) {
        return std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(amplitude, frequency, 0.3, 10));
    };
    stage.motions = {{0, 0, wave(6, 3)}, {0, 1, wave(3, 4)}, {0, 2, wave(4, 7)}};
    return stage;
}

}  // namespace voussoir::testing
