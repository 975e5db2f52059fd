// The arrow of the ground's acceleration.
#include "app/render/ground_shaking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/render/scene.h"
#include "libdda/errors.h"
#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::render
{
namespace
{

using Eigen::Vector3d;

class GroundArrow : public CommandTest
{
 protected:
    std::filesystem::path run_with(const std::string& motion)
    {
        folder_.write("case.yaml", two_boxes);
        EXPECT_EQ(voussoir("run case.yaml -o results -q " + motion), 0) << output_;
        return folder_.path() / "results/results.h5";
    }
};

const std::string shaken =
    "--set 'foundation={blocks: foundation, motion: {x: {sine: {acceleration: 3 m/s2, frequency: 10, duration: "
    "0.1 "
    "s}}, "
    "y: {sine: {acceleration: 4 m/s2, frequency: 10, duration: 0.1 s}}}}'";

TEST_F(GroundArrow, IsTheSumOfTheMotionsOfASupport)
{
    const std::filesystem::path file = run_with(shaken);
    const results::ResultsReader results(file);
    const std::vector<GroundShaking> shakings = shaking_of(file, results.model);
    ASSERT_EQ(shakings.size(), 1U);
    const GroundShaking& shaking = shakings[0];
    EXPECT_LT((shaking.place - Vector3d(0, 0, -0.5)).norm(), 1e-12) << "the middle of the floor";
    EXPECT_NEAR(shaking.largest, 5, 0.01) << "of 3 and 4 m/s2";
    for (const double time : {0.012, 0.0251, 0.07}) {
        const double sine = std::sin(2 * std::numbers::pi * 10 * time);
        EXPECT_LT((shaking.acceleration(time) - sine * Vector3d(3, 4, 0)).norm(), 0.02) << time;
    }
    EXPECT_EQ(shaking.acceleration(-1).norm(), 0);
    EXPECT_EQ(shaking.acceleration(10).norm(), 0) << "after the stage";
}

TEST_F(GroundArrow, PointsAndGrowsAsTheGroundDoes)
{
    const std::filesystem::path file = run_with(shaken);
    const results::ResultsReader results(file);
    Look look;
    look.ground = true;
    SceneOptions options;
    options.look = look_of(look, file, results);
    results::RecordedFrame frame = results.frame(0);
    const auto arrow_at = [&](double time) {
        frame.time = time;
        const Segment shaft = make_scene(results.model, frame, options).ground_arrows.at(0);
        return Vector3d(shaft.to - shaft.from);
    };
    const Vector3d most = arrow_at(0.025), back = arrow_at(0.075);
    EXPECT_NEAR(most.norm(), 1.0 / 6, 0.01) << "a sixth of the way between the two centroids";
    EXPECT_LT((most.normalized() - Vector3d(0.6, 0.8, 0)).norm(), 1e-3);
    EXPECT_LT((most + back).norm(), 0.02 * most.norm()) << "half a period later";
    EXPECT_TRUE(make_scene(results.model, frame, {}).ground_arrows.empty()) << "unless asked for";
}

TEST_F(GroundArrow, IsRefusedWhereNothingShakesAFoundation)
{
    const std::filesystem::path file = run_with("");
    EXPECT_NE(voussoir("render results/results.h5 --count 1 --size 320 240 --ground"), 0);
    EXPECT_NE(output_.find("no foundation follows a motion"), std::string::npos) << output_;
}

}  // namespace
}  // namespace voussoir::app::render
