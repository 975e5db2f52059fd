// Rods and dowels in a case file; and what is said about faults.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double endless = std::numeric_limits<double>::infinity();

/// A base and two blocks on one another. @param bars the entry; @param output what stands at the end
std::string stack(const std::string& bars, const std::string& output = "", const std::string& stage = "")
{
    return "materials: {stone: {density: 2000 kg/m3, young: 2 GPa, poisson: 0.25}}\n"
           "joints: {dry: {friction: 30 deg}}\n"
           "blocks:\n"
           "  - {box: {name: base, lower: [0, 0, -1], upper: [1, 1, 0]}, group: foundation}\n"
           "  - {box: {name: low, lower: [0, 0, 0], upper: [1, 1, 1]}, group: drums}\n"
           "  - {box: {name: high, lower: [0, 0, 1], upper: [1, 1, 2]}, group: drums}\n"
           "foundation: {blocks: foundation}\n" +
           bars + "stages:\n  - {name: rest, type: static" + stage + "}\n" + output;
}

const std::string rod =
    "bars: [{name: tie, from: {block: base, at: [1, 0.5, -0.5]}, to: {block: high, at: [1, 0.5, 1.5]}, diameter: "
    "20 "
    "mm, yield_strength: 235 MPa, prestress: 10 MPa}]\n";

void expect_fault(const std::string& text, const std::string& found, const std::string& remedy)
{
    const std::string faults = faults_of(text);
    EXPECT_NE(faults.find(found), std::string::npos) << faults;
    EXPECT_NE(faults.find(remedy), std::string::npos) << faults;
}

}  // namespace

TEST(BarCase, ReadsARod)
{
    for (const char* kinematics : {"spatial_rigid", "planar_deformable"}) {
        const Model model = read(stack(rod), {std::string("kinematics=") + kinematics}).model;
        ASSERT_EQ(model.bars.size(), 1u);
        const Bar& bar = model.bars[0];
        const double area = std::numbers::pi * 1e-4;
        EXPECT_EQ(bar.name, "tie");
        EXPECT_TRUE(bar.is_rod);
        EXPECT_EQ(bar.block_a, 0);
        EXPECT_EQ(bar.block_b, 2);
        EXPECT_DOUBLE_EQ(bar.length, 2);
        EXPECT_NEAR(bar.axial, 2e11 * area / 2, 1);
        EXPECT_NEAR(bar.tension, 235e6 * area, 1e-6);
        EXPECT_NEAR(bar.prestress, 10e6 * area, 1e-6);
        EXPECT_EQ(bar.compression, 0);
        EXPECT_EQ(bar.lateral, 0);
        EXPECT_NEAR(bar.anchor_a.x(), 0.5, 1e-12);
        EXPECT_NEAR(bar.anchor_a.z(), 0, 1e-12);
    }
}

TEST(BarCase, PutsADowelIntoEachJointOfTwoGroups)
{
    const std::string bars =
        "bars:\n"
        "  - {name: dowel, between: [drums, drums], area: 4 cm2, length: 10 cm, yield_strength: 200 MPa}\n"
        "  - {between: [foundation, drums], area: 4 cm2, length: 10 cm, carries: [tension, shear], "
        "shear_stiffness: 3e7 N/m}\n";
    const Model model = read(stack(bars)).model;
    ASSERT_EQ(model.bars.size(), 2u);
    const Bar &dowel = model.bars[0], &elastic = model.bars[1];
    EXPECT_EQ(dowel.name, "dowel low high");
    EXPECT_FALSE(dowel.is_rod);
    EXPECT_EQ(dowel.axial, 0);
    EXPECT_NEAR(dowel.lateral, 2e11 / 2.6 * 4e-4 / 0.1, 1);
    EXPECT_NEAR(dowel.shear, 200e6 * 4e-4 / std::sqrt(3.0), 1e-6);
    EXPECT_LT((dowel.anchor_a - Eigen::Vector3d(0, 0, 0.5)).norm(), 1e-12);
    EXPECT_LT((dowel.anchor_b - Eigen::Vector3d(0, 0, -0.5)).norm(), 1e-12);
    EXPECT_EQ(elastic.name, "dowels 2 base low");
    EXPECT_NEAR(elastic.axial, 2e11 * 4e-4 / 0.1, 1);
    EXPECT_EQ(elastic.lateral, 3e7);
    EXPECT_EQ(elastic.tension, endless);
    EXPECT_EQ(elastic.compression, 0);
    // From a to b: where b rises it is pulled.
    EXPECT_LT((elastic.axis - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

// What fit_tolerance closes is a joint, with a dowel from the start; what it does not is none.
TEST(BarCase, PutsADowelIntoAJointThatIsDrawnOpen)
{
    std::string apart = stack("bars: [{name: dowel, between: [drums, drums], area: 4 cm2, length: 10 cm}]\n");
    const std::string touching = "lower: [0, 0, 1], upper: [1, 1, 2]";
    apart.replace(apart.find(touching), touching.size(), "lower: [0, 0, 1.004], upper: [1, 1, 2]");
    expect_fault(apart, "no joint between", "whose blocks touch");
    const Model model = read("fit_tolerance: 5 mm\n" + apart).model;
    ASSERT_EQ(model.bars.size(), 1u);
    EXPECT_EQ(model.bars[0].name, "dowel low high");
    const auto end_of = [&](int block, const Eigen::Vector3d& lever) {
        return (model.blocks[block].moments.centroid + lever).eval();
    };
    const Eigen::Vector3d a = end_of(model.bars[0].block_a, model.bars[0].anchor_a);
    EXPECT_LT((a - end_of(model.bars[0].block_b, model.bars[0].anchor_b)).norm(), 1e-12);
    EXPECT_LE(std::abs(a.z() - 1.002), 0.002 + 1e-12);
}

TEST(BarCase, ARodMayCarryCompressionToo)
{
    const std::string both =
        "bars: [{from: {block: base, at: [1, 0.5, -0.5]}, to: {block: high, at: [1, 0.5, 1.5]}, "
        "area: 1 cm2, yield_strength: 100 MPa, carries: ";
    const Bar strut = read(stack(both + "compression}]\n")).model.bars[0];
    EXPECT_EQ(strut.tension, 0);
    EXPECT_NEAR(strut.compression, 1e4, 1e-9);
    const Bar bar = read(stack(both + "[tension, compression]}]\n")).model.bars[0];
    EXPECT_NEAR(bar.tension, 1e4, 1e-9);
    EXPECT_NEAR(bar.compression, 1e4, 1e-9);
}

TEST(BarCase, ReadsTheHistoryOfABar)
{
    const Case the_case = read(stack(rod, "output: {histories: {force: {bar: tie}, top: {block: high}}}\n"));
    ASSERT_EQ(the_case.output.bar_histories.size(), 1u);
    EXPECT_EQ(the_case.output.bar_histories[0].name, "force");
    EXPECT_EQ(the_case.output.bar_histories[0].bar, 0);
    EXPECT_EQ(the_case.output.histories.size(), 1u);
}

TEST(BarCase, FaultsAreToldWithTheirRemedy)
{
    const auto bars = [](const std::string& entry) { return stack("bars: [{" + entry + "}]\n"); };
    const std::string ends = "from: {block: low, at: [0, 0, 0]}, to: {block: high, at: [0, 0, 2]}, ";
    expect_fault(bars(ends + "length: 1 m"), "neither diameter nor area", "give one of them");
    expect_fault(bars(ends + "diameter: 1 cm, area: 1 cm2"), "both diameter and area", "give one of them");
    expect_fault(bars(ends + "area: 1 cm2, carries: shear"), "\"shear\"", "tension, compression or both");
    expect_fault(bars(ends + "area: 1 cm2, yield_strength: 5 MPa, prestress: 6 MPa"), "prestress above",
                 "smaller");
    expect_fault(bars("from: {block: low, at: [0, 0, 0]}, to: {block: low, at: [0, 0, 1]}, area: 1 cm2"),
                 "same block", "two blocks");
    expect_fault(bars("from: {block: low, at: [0, 0, 1]}, to: {block: high, at: [0, 0, 1]}, area: 1 cm2"),
                 "same place", "between");
    expect_fault(bars("from: {block: low, at: [0, 0, 5]}, to: {block: high, at: [0, 0, 2]}, area: 1 cm2"),
                 "outside of block low", "within it");
    expect_fault(bars("from: {block: lou, at: [0, 0, 0]}, to: {block: high, at: [0, 0, 2]}, area: 1 cm2"),
                 "no block \"lou\"", "low");
    expect_fault(bars("between: [drums, drum], area: 1 cm2, length: 1 m"), "no block is in group \"drum\"",
                 "drums");
    expect_fault(bars("between: [foundation, foundation], area: 1 cm2, length: 1 m"), "no joint between",
                 "whose blocks touch");
    expect_fault(bars("between: [drums, drums], diameter: 1e200 m, length: 1 m"),
                 "no number a computation can use", "diameter");
    // Joints are not sought in a model that has faults already.
    std::string no_joints = bars("between: [drums, drums], area: 1 cm2, length: 1 m");
    no_joints.erase(no_joints.find("joints: {"), std::string("joints: {dry: {friction: 30 deg}}\n").size());
    EXPECT_NE(faults_of(no_joints).find("joints"), std::string::npos);
    expect_fault(stack(rod, "output: {histories: {force: {bar: tye}}}\n"), "no bar \"tye\"", "tie");
    expect_fault(stack(rod, "", ", open_close: published"), "bars with open_close: published", "newton");
}

}  // namespace voussoir::app::reader
