// What the colours of stones show.
#include "app/render/stone_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/render/framing.h"
#include "app/render/scene.h"
#include "tests/app/command_test.h"
#include "tests/app/test_files.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::render
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;
using results::friction_use;
using results::JointBound;

constexpr double degree = std::numbers::pi / 180;

JointNow carrying(double normal, double shear, double area = 1)
{
    JointNow now;
    now.normal_force = normal;
    now.shear_force = shear;
    now.area_in_use = area;
    return now;
}

TEST(StoneValues, LargestCompressionIsMinusTheLeastPrincipalStress)
{
    Matrix3d pressed = Vector3d(-1e6, -3e6, 2e6).asDiagonal(), sheared = Matrix3d::Zero();
    sheared(1, 2) = sheared(2, 1) = 4e5;
    EXPECT_NEAR(largest_compression(pressed), 3e6, 1e-6);
    EXPECT_NEAR(largest_compression(sheared), 4e5, 1e-6);
}

TEST(StoneValues, StrainIsThatOfTheStretchWhateverTheTurn)
{
    results::RecordedModel model;
    model.kinematics = Kinematics::spatial_deformable;
    results::RecordedFrame frame;
    const Matrix3d stretch = Vector3d(1 + 1e-4, 1 - 2e-4, 1 - 1e-3).asDiagonal();
    for (const double turn : {0.0, 0.3, 2.0}) {
        const Matrix3d map = Eigen::AngleAxisd(turn, Vector3d(1, 2, 3).normalized()) * stretch;
        frame.state.coordinates.assign({5, 6, 7});
        frame.state.coordinates.insert(frame.state.coordinates.end(), map.data(), map.data() + 9);
        EXPECT_NEAR(largest_compression(strain_of(model, frame, 0)), 1e-3 - 0.5e-6, 1e-12) << turn;
    }
    model.kinematics = Kinematics::spatial_rigid;
    EXPECT_EQ(strain_of(model, frame, 0).norm(), 0);
}

TEST(FrictionUse, IsShearOverWhatCoulombAllows)
{
    const JointBound dry{0.5, 0}, mortar{0.5, 3};
    EXPECT_DOUBLE_EQ(*friction_use(dry, false, carrying(10, 2)), 0.4);
    EXPECT_DOUBLE_EQ(*friction_use(dry, false, carrying(10, 5)), 1);
    EXPECT_DOUBLE_EQ(*friction_use(dry, false, carrying(10, 0)), 0);
    EXPECT_FALSE(friction_use(dry, false, carrying(0, 0, 0))) << "an open joint uses none";
    EXPECT_FALSE(friction_use({0, 0}, false, carrying(10, 0))) << "without friction there is nothing to use";
    EXPECT_DOUBLE_EQ(*friction_use(mortar, true, carrying(10, 5.5, 2)), 0.5)
        << "5 N of friction and 6 N of the bond";
    EXPECT_DOUBLE_EQ(*friction_use(mortar, true, carrying(-4, 2, 2)), 0.5) << "tension takes 2 N of the 6 N";
    JointNow broken = carrying(10, 2, 2);
    broken.broken = true;
    EXPECT_DOUBLE_EQ(*friction_use(mortar, true, broken), 0.4) << "friction alone is left";
}

class FrictionOfARun : public CommandTest
{
 protected:
    /// Of the stone at the end of the run.
    double use_after(const std::string& settings)
    {
        folder_.write("case.yaml", two_boxes);
        EXPECT_EQ(voussoir("run case.yaml -o results -q --set stages[1]=null " + settings), 0) << output_;
        const results::ResultsReader results(folder_.path() / "results/results.h5");
        return stone_values(results.model, results.frame(results.times.size() - 1), SnapshotColor::friction,
                            {})[1];
    }
};

TEST_F(FrictionOfARun, OnASlopeIsTheTangentOverThatOfTheFrictionAngle)
{
    const double tilted = std::tan(20 * degree) / std::tan(30 * degree);
    EXPECT_NEAR(use_after("--set 'gravity={direction: [0.36397023426620234, 0, -1]}'"), tilted, 1e-3);
    EXPECT_NEAR(
        use_after("--set 'gravity={direction: [0.36397023426620234, 0, -1]}' --set joints.dry.friction='40 deg'"),
        std::tan(20 * degree) / std::tan(40 * degree), 1e-3);
    EXPECT_NEAR(use_after(""), 0, 1e-3) << "on the level";
}

TEST_F(FrictionOfARun, KnowsTheFactorsOfSingleStones)
{
    const std::string stone = "{box: {name: stone, lower: [-0.5, -0.5, 0], upper: [50 cm, 0.5, 1]}}";
    const std::string corners =
        "[[-0.5, -0.5, 0], [0.5, -0.5, 0], [0.5, 0.5, 0], [-0.5, 0.5, 0], [-0.5, -0.5, 1], [0.5, -0.5, 1], "
        "[0.5, 0.5, 1], [-0.5, 0.5, 1]]";
    const std::string faces =
        "[[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]";
    folder_.write("case.yaml", with(two_boxes, stone,
                                    "{polyhedron: {name: stone, parts: [{vertices: " + corners +
                                        ", faces: " + faces + "}], friction_factor: 3}}"));
    ASSERT_EQ(voussoir("run case.yaml -o results -q --set stages[1]=null --set "
                       "'gravity={direction: [0.36397023426620234, 0, -1]}'"),
              0)
        << output_;
    const results::ResultsReader results(folder_.path() / "results/results.h5");
    const double mean = 2;  // of 3 and 1
    EXPECT_NEAR(results.model.bounds.at(0).friction, mean * std::tan(30 * degree), 1e-12);
    EXPECT_NEAR(
        stone_values(results.model, results.frame(results.times.size() - 1), SnapshotColor::friction, {})[1],
        std::tan(20 * degree) / (mean * std::tan(30 * degree)), 1e-3);
}

TEST_F(FrictionOfARun, IsGreyWithoutAPressingJointAndItsScaleIsWhole)
{
    use_after("");
    const results::ResultsReader results(folder_.path() / "results/results.h5");
    results::RecordedFrame frame = results.frame(results.times.size() - 1);
    const SceneOptions options{SnapshotColor::friction, 1, noteworthy_opening};
    const auto scale_of_it = [&] {
        const Scene scene = make_scene(results.model, frame, options);
        Framing framing(SnapshotColor::friction);
        framing.add(scene);
        return std::pair(framing.scale(), scene.has_blank);
    };
    EXPECT_FALSE(scale_of_it().second);
    EXPECT_EQ(scale_of_it().first.highest, 1) << "though the stone uses none of it";
    frame.joints[0] = JointNow();  // it has lifted off
    EXPECT_TRUE(scale_of_it().second);
    EXPECT_EQ(scale_of_it().first.lowest, 0);
    EXPECT_EQ(scale_of_it().first.highest, 1);
}

}  // namespace
}  // namespace voussoir::app::render
