// Tie rods in pictures: from end to end, where the stones are.
#include <gtest/gtest.h>

#include "app/render/scene.h"
#include "tests/app/command_test.h"
#include "tests/app/test_files.h"

namespace voussoir::app::render
{
namespace
{

using Eigen::Vector3d;

class Rods : public CommandTest
{
};

const std::string pushed =
    "--set stages[1].body_acceleration='[{blocks: blocks, x: {sine: {acceleration: 8 m/s2, frequency: 2, "
    "duration: 0.2 "
    "s}}}]' "
    "--set bars='[{name: dowel, between: [foundation, blocks], diameter: 1 mm, length: 1 cm, yield_strength: 1 "
    "MPa}, "
    "{name: tie, from: {block: floor, at: [-1, 0, -0.1]}, to: {block: stone, at: [-0.5, 0, 0.5]}, diameter: 1 mm, "
    "yield_strength: 1 MPa}]'";

TEST_F(Rods, GoFromEndToEndAndDowelsAreNotSeen)
{
    folder_.write("case.yaml", two_boxes);
    ASSERT_EQ(voussoir("run case.yaml -o results -q --set blocks[1].group=blocks " + pushed), 0) << output_;
    const results::ResultsReader results(folder_.path() / "results/results.h5");
    ASSERT_EQ(results.model.rods.size(), 1U);
    const std::size_t last = results.times.size() - 1;
    const results::RecordedFrame frame = results.frame(last);
    const double moved = pose_of(results.model.kinematics, frame.state, 1).centroid.x();
    ASSERT_GT(moved, 1e-3) << "the stone slides";
    SceneOptions options;
    options.deformation_scale = 3;
    const Scene scene = make_scene(results.model, frame, options);
    ASSERT_EQ(scene.rods.size(), 1U);
    EXPECT_LT((scene.rods[0].from - Vector3d(-1, 0, -0.1)).norm(), 1e-9);
    EXPECT_LT((scene.rods[0].to - Vector3d(-0.5 + 3 * moved, 0, 0.5)).norm(), 0.2 * moved);
    options.look.hidden = {false, true};
    EXPECT_TRUE(make_scene(results.model, frame, options).rods.empty()) << "an end is not drawn";
}

}  // namespace
}  // namespace voussoir::app::render
