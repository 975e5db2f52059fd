// Foundations moved by the records of the L'Aquila main shock stand, at the end of every step, where the exact
// integral of the piecewise-linear record is: at any time step, and when steps are cut.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "records/record.h"
#include "tests/libdda/scenes.h"
#include "tests/records/test_files.h"
#include "tests/verification/exact_integral.h"

namespace voussoir::verification
{

namespace
{

using Eigen::Vector3d;

constexpr double allowed = 1e-10;  // of the peak displacement

/// Three components of one station, along x, y and z, each with its reference.
struct GroundOfStation {
    std::array<std::shared_ptr<const GroundMotion>, 3> motions;
    std::vector<ExactIntegral> exact;
    std::array<double, 3> peaks{};  // m
    double duration = 0;            // s
};

void add_component(const records::Channel& channel, int axis, const std::string& name, GroundOfStation& ground)
{
    ground.motions[axis] = std::make_shared<GroundMotion>(records::to_ground_motion(channel, name));
    ground.exact.emplace_back(channel.quantity, channel.samples, channel.time_step);
    ground.peaks[axis] = ground.exact.back().peak_displacement();
    ground.duration = ground.motions[axis]->duration();
}

/// A foundation, and a stone on it if the test wants one.
struct Scene {
    Model model;
    Stage stage;
    State state;

    Scene(const GroundOfStation& ground, bool with_stone, double duration, double time_step)
        : model(make_model(Kinematics::spatial_rigid, testing::stone(), testing::dry(30)))
    {
        testing::hold(model, testing::add_box(model, "foundation", {-3, -3, -1}, {3, 3, 0}));
        if (with_stone) testing::add_box(model, "stone", {-0.4, -0.3, 0}, {0.4, 0.3, 0.5});
        stage = testing::dynamic_stage(duration, time_step);
        for (int axis = 0; axis < 3; ++axis) stage.motions.push_back({0, axis, ground.motions[axis]});
        state = initial_state(model);
    }
};

/// What came of a run: how far the foundation ever was from its reference, as a share of the peak displacement.
struct Followed {
    double farthest = 0;
    RunReport report;
};

Followed follow(Scene& scene, const GroundOfStation& ground)
{
    Followed result;
    const Vector3d anchor = scene.model.blocks[0].moments.centroid;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const Vector3d moved = testing::centroid(scene.model, now, 0) - anchor;
        for (int axis = 0; axis < 3; ++axis) {
            const auto& exact = ground.exact[axis];  // the ground is where it starts, whatever a file calls that
            const double off =
                std::abs(moved[axis] - (exact.displacement(now.stage_time) - exact.displacement(0)));
            result.farthest = std::max(result.farthest, off / ground.peaks[axis]);
        }
    };
    result.report = run(scene.model, {scene.stage}, scene.state, observer);
    EXPECT_EQ(result.report.outcome, Outcome::completed) << ::testing::PrintToString(result.report.diagnosis);
    EXPECT_EQ(scene.state.stage_time, scene.stage.duration);
    return result;
}

/// Each station by its name of file; H1, H2 and V along x, y and z.
class LAquila : public ::testing::TestWithParam<const char*>
{
 protected:
    void SetUp() override
    {
        const char* components[] = {"H1", "H2", "V"};
        for (const std::string component : components) {
            const auto folder = records::data_folder() / "motions/laquila2009";
            auto file = folder / (std::string(GetParam()) + "_" + component + ".cor.acc");
            if (!exists(file)) file += ".gz";
            if (!exists(file)) GTEST_SKIP() << "no " << file;
            channels_.push_back(records::read_record(file, {}).channels.at(0));
        }
    }

    GroundOfStation whole() const
    {
        GroundOfStation ground;
        for (int axis = 0; axis < 3; ++axis) add_component(channels_[axis], axis, GetParam(), ground);
        return ground;
    }

    /// The 5 s round the peak of the strongest component, taken as records of their own, of any quantity.
    GroundOfStation strong_part(records::Quantity quantity = records::Quantity::acceleration) const
    {
        std::size_t peak_at = 0;
        double largest = 0;
        for (const records::Channel& channel : channels_)
            for (std::size_t i = 0; i < channel.samples.size(); ++i)
                if (std::abs(channel.samples[i]) > largest) largest = std::abs(channel.samples[i]), peak_at = i;
        GroundOfStation ground;
        for (int axis = 0; axis < 3; ++axis) {
            records::Channel part = channels_[axis];
            const auto before = static_cast<std::size_t>(1.5 / part.time_step),
                       count = static_cast<std::size_t>(5 / part.time_step);
            const auto from = part.samples.begin() + static_cast<std::ptrdiff_t>(peak_at - before);
            part.samples.assign(from, from + static_cast<std::ptrdiff_t>(count + 1));
            part.quantity = quantity;
            add_component(part, axis, GetParam(), ground);
        }
        return ground;
    }

    std::vector<records::Channel> channels_;
};
INSTANTIATE_TEST_SUITE_P(Stations, LAquila, ::testing::Values("AQV_16837", "AQK_16889", "AQG_16833"),
                         [](const auto& info) { return std::string(info.param).substr(0, 3); });

}  // namespace

// All three components of the whole record, 300 to 860 s, at steps that do not divide its 5 ms.
TEST_P(LAquila, FoundationFollowsTheWholeRecord)
{
    const GroundOfStation ground = whole();
    for (const double time_step : {3.7e-3, 11e-3}) {
        Scene scene(ground, false, ground.duration, time_step);
        const Followed followed = follow(scene, ground);
        std::printf("%s, %.0f s in steps of %.1f ms: off by %.1e of the peak displacement\n", GetParam(),
                    ground.duration, 1e3 * time_step, followed.farthest);
        EXPECT_LT(followed.farthest, allowed);
    }
    for (int axis = 0; axis < 3; ++axis) {
        const GroundMotion& motion = *ground.motions[axis];
        std::printf("  %s (%s): PGA %.3f m/s2, peak displacement %.4f m, residual velocity %+.3e m/s\n",
                    channels_[axis].component.c_str(), axis == 0 ? "x" : (axis == 1 ? "y" : "z"),
                    motion.peak_acceleration(), ground.peaks[axis], motion.residual_velocity());
        EXPECT_NEAR(motion.residual_velocity(), ground.exact[axis].residual_velocity(),
                    1e-10 * std::abs(motion.residual_velocity()) + 1e-14);
    }
}

// A stone rests on the foundation, rocks and slides; steps of the record's own length and of others.
TEST_P(LAquila, FoundationUnderAStoneFollowsTheRecord)
{
    const GroundOfStation ground = strong_part();
    for (const double time_step : {3.7e-3, 5e-3, 11e-3}) {
        Scene scene(ground, true, ground.duration, time_step);
        const Followed followed = follow(scene, ground);
        const Vector3d slid = testing::centroid(scene.model, scene.state, 1) -
                              testing::centroid(scene.model, scene.state, 0) - Vector3d(0, 0, 0.75);
        std::printf("%s, 5 s under a stone, steps of %.1f ms: off by %.1e, the stone slid %.1f mm\n", GetParam(),
                    1e3 * time_step, followed.farthest, 1e3 * slid.head<2>().norm());
        EXPECT_LT(followed.farthest, allowed);
    }
}

// A stone that falls on the moving ground, and no more than two passes of the open-close iteration to take a step
// in: the impacts cut steps. The ground is the same.
TEST_P(LAquila, FoundationFollowsTheRecordWhenStepsAreCut)
{
    const GroundOfStation ground = strong_part();
    Scene scene(ground, true, ground.duration, 5e-3);
    scene.stage.control.max_open_close = 2;
    testing::set_velocity(scene.model, scene.state, 1, {0.3, 0, 1}, {0, 2, 0});
    const Followed followed = follow(scene, ground);
    std::printf("%s, 5 s under a knocking stone: %d steps, %d cuts, off by %.1e\n", GetParam(),
                static_cast<int>(followed.report.steps), static_cast<int>(followed.report.step_cuts),
                followed.farthest);
    EXPECT_GT(followed.report.step_cuts, 10);
    EXPECT_LT(followed.farthest, allowed);
}

// The same samples, called velocities and displacements: a record of either is followed as exactly.
TEST_P(LAquila, FoundationFollowsARecordOfVelocityOrDisplacement)
{
    for (const records::Quantity quantity : {records::Quantity::velocity, records::Quantity::displacement}) {
        GroundOfStation ground = strong_part(quantity);
        for (const double time_step : {3.7e-3, 11e-3}) {
            Scene scene(ground, false, ground.duration, time_step);
            EXPECT_LT(follow(scene, ground).farthest, allowed);
        }
    }
}

}  // namespace voussoir::verification
