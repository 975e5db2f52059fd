// Landings in their order: what a blow has struck meets others in the same step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

class LandingsInOrder : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, LandingsInOrder, every_kinematics(), test_name);

/// Collisions of equal masses on a line, one after the other. @returns speeds after `duration` [m/s]
std::vector<double> collide_in_order(std::vector<double> places, double width, double restitution, double duration)
{
    const std::size_t count = places.size();
    std::vector<double> speeds(count, 0.0);
    speeds[0] = 1;
    double time = 0;
    while (true) {
        double next = duration - time;
        std::size_t pair = count;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const double approach = speeds[i] - speeds[i + 1];
            const double wait = std::max(0.0, places[i + 1] - places[i] - width) / approach;
            if (approach > 1e-9 && wait < next) next = wait, pair = i;
        }
        for (std::size_t i = 0; i < count; ++i) places[i] += next * speeds[i];
        time += next;
        if (pair == count) return speeds;
        const double mean = (speeds[pair] + speeds[pair + 1]) / 2, half = (speeds[pair] - speeds[pair + 1]) / 2;
        speeds[pair] = mean - restitution * half;
        speeds[pair + 1] = mean + restitution * half;
    }
}

}  // namespace

// A row of bricks in free flight, gaps between them that close in, between and at the ends of steps: each hands
// its speed on to the next.
TEST_P(LandingsInOrder, BricksInARowStrikeOneAfterTheOther)
{
    constexpr double width = 0.1;
    for (const double restitution : {1.0, 0.5, 0.0})
        for (const double gap : {0.005, 0.0051, 0.001})
            for (const double h : {2e-3, 1e-3, 5e-4}) {
                JointMaterial joint = dry(30);
                joint.restitution = restitution;
                Model model = make_model(GetParam(), stone(), joint);
                std::vector<double> places;
                for (int i = 0; i < 5; ++i) {
                    places.push_back(i * (width + gap));
                    add_box(model, "brick", {places[i], 0, 0}, {places[i] + width, 0.06, 0.06});
                }
                model.initial_motions.push_back({.block = 0, .velocity = {1, 0, 0}});
                State state = initial_state(model);
                constexpr double duration = 0.08;
                const RunReport report = run(model, {dynamic_stage(duration, h, {0, 0, 0})}, state, {});
                ASSERT_EQ(report.outcome, Outcome::completed);
                const std::vector<double> speeds = collide_in_order(places, width, restitution, duration);
                for (int i = 0; i < 5; ++i)
                    EXPECT_NEAR(velocity_of(model.kinematics, state, i).x(), speeds[i], 1e-3)
                        << i << ": e = " << restitution << ", gap " << gap << " m, step " << h << " s";
            }
}

// A stone meets the one below, which has just come back from the floor in the same step.
TEST_P(LandingsInOrder, StonesThatFallOneAboveTheOtherKeepTheirEnergy)
{
    for (const double gap : {0.002, 0.0005})
        for (const double h : {1e-3, 5e-4}) {
            JointMaterial joint = dry(30);
            joint.restitution = 1;
            Model model = make_model(GetParam(), stone(), joint);
            hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
            add_box(model, "large", {-0.2, -0.2, 0.1}, {0.2, 0.2, 0.4});
            add_box(model, "small", {-0.1, -0.1, 0.4 + gap}, {0.1, 0.1, 0.6 + gap});
            State state = initial_state(model);
            const RunReport report = run(model, {dynamic_stage(0.15, h)}, state, {});  // 0.143 s to the floor
            ASSERT_EQ(report.outcome, Outcome::completed);
            double energy = 0, drawn = 0;
            for (const int b : {1, 2}) {
                const double height = centroid(model, state, b).z(), before = model.blocks[b].moments.centroid.z();
                const double speed = velocity_of(model.kinematics, state, b).norm();
                energy += model.mass(b) * (0.5 * speed * speed + gravity * (height - before));
                drawn += model.mass(b) * gravity * 0.1;
            }
            EXPECT_NEAR(energy, 0, 1e-3 * drawn) << "gap " << gap << " m, step " << h << " s";
        }
}

// Ten equal stones, gaps of a millimetre between them, fall together and hand their speeds on, some fifty times in
// 0.25 s. A blow knows the speeds of the start of its step, less what gravity adds until then, and steps are
// divided eight times at most: that is what is left, and it goes with the step.
TEST_P(LandingsInOrder, AStackOfTenThatIsDroppedKeepsItsEnergy)
{
    constexpr double width = 0.2, drop = 0.05, gap = 1e-3;
    for (const auto& [h, share] : {std::pair{1e-3, 0.03}, {5e-4, 0.003}}) {
        JointMaterial joint = dry(30);
        joint.restitution = 1;
        Model model = make_model(GetParam(), stone(), joint);
        hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
        for (int i = 0; i < 10; ++i) {
            const double bottom = drop + i * (width + gap);
            add_box(model, "stone", {-0.1, -0.1, bottom}, {0.1, 0.1, bottom + width});
        }
        State state = initial_state(model);
        const RunReport report = run(model, {dynamic_stage(0.25, h)}, state, {});
        ASSERT_EQ(report.outcome, Outcome::completed);
        double energy = 0, drawn = 0;
        for (int b = 1; b <= 10; ++b) {
            const double rise = centroid(model, state, b).z() - model.blocks[b].moments.centroid.z();
            const double speed = velocity_of(model.kinematics, state, b).norm();
            energy += model.mass(b) * (0.5 * speed * speed + gravity * rise);
            drawn += model.mass(b) * gravity * drop;
        }
        EXPECT_NEAR(energy, 0, share * drawn) << "step " << h << " s";
        EXPECT_EQ(report.blows.unfinished, 0);
        EXPECT_GT(report.blows.solved, 20);
    }
}

// Without restitution they come to rest one after the other, all that they had taken by impulses.
TEST_P(LandingsInOrder, AStackOfTenThatIsDroppedStaysWhereItLands)
{
    constexpr double width = 0.2, drop = 0.05, gap = 1e-3;
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
    double drawn = 0;
    for (int i = 0; i < 10; ++i) {
        const double bottom = drop + i * (width + gap);
        const int stone = add_box(model, "stone", {-0.1, -0.1, bottom}, {0.1, 0.1, bottom + width});
        drawn += model.mass(stone) * gravity * (drop + i * gap);
    }
    State state = initial_state(model);
    const RunReport report = run(model, {dynamic_stage(0.2, 1e-3)}, state, {});
    ASSERT_EQ(report.outcome, Outcome::completed);
    EXPECT_NEAR(report.energy.impact, drawn, 0.02 * drawn);
    EXPECT_LT(report.energy.kinetic, 1e-3 * drawn);
}

}  // namespace voussoir::testing
