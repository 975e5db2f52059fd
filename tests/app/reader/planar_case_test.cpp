// Planar cases: the same stones drawn in space or in the plane, and what a planar scene does not take.
#include <gtest/gtest.h>

#include "app/reader/overlaps.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

const std::vector<std::string> rigid = {"kinematics=planar_rigid"}, deformable = {"kinematics=planar_deformable"};

/// `two_boxes` in the plane's own words: a floor, and a stone as a polygon.
const std::string two_outlines =
    with(with(with(two_boxes, "lower: [-1, -1, -1], upper: [1, 1, 0]", "lower: [-1, -1], upper: [1, 0]"),
              "{box: {name: stone, lower: [-0.5, -0.5, 0], upper: [50 cm, 0.5, 1]}}",
              "{polygon: {name: stone, corners: [[-0.5, 0], [50 cm, 0], [0.5, 1], [-0.5, 1]]}}"),
         "title: Two boxes", "kinematics: planar_rigid");

/// `two_boxes` with the floor as deep as the stone.
const std::string equally_deep =
    with(two_boxes, "[-1, -1, -1], upper: [1, 1, 0]", "[-1, -0.5, -1], upper: [1, 0.5, 0]");

/// `overrides` and one more.
std::vector<std::string> also(std::vector<std::string> overrides, const std::string& more)
{
    overrides.push_back(more);
    return overrides;
}

TEST(PlanarCase, StonesDrawnInSpaceGiveTheirOutlinesAndTheThickness)
{
    const std::string text = with(with(equally_deep, "-0.5, -1]", "0, -1]"), "0.5, 0]", "3, 0]");
    const Case the_case = read(with(with(text, "[-0.5, -0.5, 0]", "[-0.5, 0, 0]"), "0.5, 1]", "3, 1]"), rigid);
    const Model& model = the_case.model;
    EXPECT_DOUBLE_EQ(model.thickness, 3);
    EXPECT_TRUE(has_default(the_case, "thickness = 3 m, the extent of the stones along y"));
    ASSERT_EQ(model.blocks.size(), 2);
    EXPECT_TRUE(model.blocks[1].parts.empty());
    EXPECT_EQ(model.blocks[1].outlines.at(0).vertices.size(), 4);
    EXPECT_NEAR(model.mass(1), 3 * 2400, 1e-9);
    EXPECT_TRUE(model.blocks[1].moments.centroid.isApprox(Eigen::Vector3d(0, 0, 0.5), 1e-15));
    EXPECT_TRUE(has_default(the_case, "foundation: x = fixed, z = fixed, rotation = fixed"));
}

TEST(PlanarCase, OutlinesAreOneMetreThickUnlessTheCaseSaysSo)
{
    const Case the_case = read(two_outlines);
    EXPECT_TRUE(has_default(the_case, "thickness = 1 m"));
    EXPECT_NEAR(the_case.model.mass(1), 2400, 1e-9);
    for (const std::string& text :
         {two_outlines, with(equally_deep, "title: Two boxes", "kinematics: planar_rigid")}) {
        const Model thick = read(text, {"thickness=40 cm"}).model;
        EXPECT_DOUBLE_EQ(thick.thickness, 0.4);
        EXPECT_NEAR(thick.mass(1), 0.4 * 2400, 1e-9);
        EXPECT_NEAR(thick.blocks[1].moments.second(0, 0), 0.4 / 12, 1e-15);
    }
}

TEST(PlanarCase, APolygonAndADrawnBoxMakeTheSameBlock)
{
    const Model drawn = read(equally_deep, rigid).model, outlined = read(two_outlines).model;
    for (int b = 0; b < 2; ++b) {
        EXPECT_EQ(drawn.blocks[b].moments.centroid, outlined.blocks[b].moments.centroid);
        EXPECT_NEAR(drawn.mass(b), outlined.mass(b), 1e-9);
        EXPECT_LT((drawn.blocks[b].moments.second - outlined.blocks[b].moments.second).norm(), 1e-15);
    }
}

TEST(PlanarCase, AFlatBoxTurnsFromXToZ)
{
    const Model model =
        read(with(two_outlines, "upper: [1, 0]", "upper: [1, 0], rotate: {angle: 90 deg, about: [1, 0]}"),
             {"blocks[1]={polygon: {name: stone, corners: [[5, 0], [6, 0], [6, 1]]}}"})
            .model;
    EXPECT_TRUE(model.blocks[0].moments.centroid.isApprox(Eigen::Vector3d(1.5, 0, -1), 1e-14));
    EXPECT_NE(faults_of(two_outlines, {"blocks[0].box.rotate={axis: [0, 1, 0], angle: 1 deg}"})
                  .find("is rotated in the plane"),
              std::string::npos);
}

TEST(PlanarCase, ABoxTurnedAboutYIsTheTurnedOutline)
{
    const std::string turned =
        "upper: [50 cm, 0.5, 1], rotate: {axis: [0, 1, 0], angle: 90 deg, about: [0, 0, 0]}";
    const Model model = read(with(equally_deep, "upper: [50 cm, 0.5, 1]", turned),
                             also(rigid, "blocks[0].box.upper=[-0.1, 0.5, 0]"))
                            .model;
    EXPECT_TRUE(model.blocks[1].moments.centroid.isApprox(Eigen::Vector3d(0.5, 0, 0), 1e-14));
}

TEST(PlanarCase, StonesOfAnotherDepthAreRefused)
{
    EXPECT_EQ(faults_of(two_boxes, rigid),
              "case.yaml:8: blocks[1].box: from y = -0.5 m to 0.5 m, but floor from y = -1 m to 1 m; all stones "
              "of a planar scene must have the same extent along y; change them, or use polygons [x, z]");
}

TEST(PlanarCase, StonesTurnedOutOfThePlaneAreRefused)
{
    const std::string turned = "upper: [50 cm, 0.5, 1], rotate: {axis: [1, 0, 0], angle: 30 deg}";
    EXPECT_EQ(
        faults_of(with(equally_deep, "upper: [50 cm, 0.5, 1]", turned), also(rigid, "output=null")),
        "case.yaml:8: blocks[1].box: a shape that is not a prism along y; a planar scene takes stones that are "
        "the same in every section along y");
}

TEST(PlanarCase, OutlinesThatAreNoneAreRefused)
{
    const auto fault = [](const std::string& corners) {
        return faults_of(two_outlines, {"blocks[1].polygon.corners=" + corners});
    };
    EXPECT_NE(fault("[[0, 0], [1, 0]]").find("2 corners; an outline has at least three"), std::string::npos);
    EXPECT_NE(fault("[[0, 0], [4, 0], [1, 1], [0, 4]]").find("points inwards"), std::string::npos);
    EXPECT_NE(fault("[[0, 0, 0], [1, 0], [1, 1]]").find("a list of 3; expected two components [x, z]"),
              std::string::npos);
    EXPECT_NE(faults_of(two_outlines, {"blocks[0].box.upper=[-1, 0]"}).find("no area"), std::string::npos);
}

TEST(PlanarCase, OverlappingOutlinesAreRefused)
{
    EXPECT_EQ(
        faults_of(with(two_outlines, "[-0.5, 0], [50 cm, 0]", "[-0.5, -0.25], [50 cm, -0.25]")),
        "case.yaml:8: blocks[1].polygon: floor and stone: overlap by 0.25 m; stones may touch but not overlap");
    const ConvexPolygon square = make_rectangle({0, 0}, {1, 1}),
                        corner = make_convex_polygon({{0, 0}, {1, 0}, {0, 1}});
    EXPECT_NEAR(overlap_depth(square, square, {0.75, 0.5}), 0.25, 1e-15);
    EXPECT_LE(overlap_depth(square, corner, {1, 0}), 0);
    EXPECT_LT(overlap_depth(corner, square, {0.6, 0.6}), 0) << "only the slanted side parts them";
}

TEST(PlanarCase, YMeansNothing)
{
    const std::string sine = "{sine: {acceleration: 1 m/s2, frequency: 1 Hz}}";
    const auto fault = [](const std::string& setting) { return faults_of(two_outlines, {setting}); };
    EXPECT_EQ(fault("foundation.y=fixed"),
              "--set foundation.y: has no meaning here; a planar scene lies in x and z");
    EXPECT_EQ(fault("stages[1].motion={x: " + sine + ", y: " + sine + "}"),
              "--set stages[1].motion: stages[1].motion.y: has no meaning here; a planar scene lies in x and z");
    EXPECT_NE(
        fault("stages[1].body_acceleration=[{blocks: masonry, y: " + sine + "}]").find("has no meaning here"),
        std::string::npos);
    EXPECT_EQ(fault("gravity.direction=[0, 0.1, -1]"),
              "--set gravity.direction: 0.1 along y; a planar scene lies in x and z: give [x, z]");
}

TEST(PlanarCase, VectorsHaveTwoComponentsOrAYThatSaysNothing)
{
    for (const char* direction : {"[0.3, -0.4]", "[0.3, 0, -0.4]"}) {
        const Case the_case = read(two_outlines, {std::string("gravity.direction=") + direction});
        EXPECT_TRUE(the_case.stages[0].gravity.isApprox(9.80665 * Eigen::Vector3d(0.6, 0, -0.8), 1e-14));
    }
    const auto with_point = [](const std::string& point) {
        return read(two_outlines, {"output.histories.top.point=" + point});
    };
    const Case flat = with_point("[0.5, 1]"), spatial = with_point("[0.5, 0.2, 1]");
    EXPECT_EQ(*flat.output.histories[0].point, Eigen::Vector3d(0.5, 0, 1));
    EXPECT_EQ(*spatial.output.histories[0].point, Eigen::Vector3d(0.5, 0, 1));
    EXPECT_TRUE(flat.warnings.empty());
    ASSERT_EQ(spatial.warnings.size(), 1);
    EXPECT_NE(spatial.warnings[0].find("y = 0.2 m is ignored"), std::string::npos);
}

TEST(PlanarCase, PlaneStrainUnlessTheCaseSaysStress)
{
    EXPECT_EQ(read(equally_deep, deformable).model.plane, PlaneCondition::strain);
    EXPECT_TRUE(has_default(read(equally_deep, deformable), "plane = strain"));
    EXPECT_EQ(read(equally_deep, also(deformable, "plane=stress")).model.plane, PlaneCondition::stress);
    EXPECT_EQ(faults_of(two_outlines, {"plane=strain"}),
              "--set plane: has no meaning here; rigid blocks have neither strain nor stress");
}

TEST(PlanarCase, ASpatialSceneTakesNothingPlanar)
{
    EXPECT_EQ(faults_of(two_boxes, {"thickness=1 m"}),
              "--set thickness: has no meaning here; it belongs to planar scenes");
    EXPECT_EQ(faults_of(two_boxes, {"plane=stress"}),
              "--set plane: has no meaning here; it belongs to kinematics: planar_deformable");
    EXPECT_EQ(faults_of(two_boxes, {"blocks[1]={polygon: {name: stone, corners: [[0, 0], [1, 0], [1, 1]]}}",
                                    "output.histories=null"}),
              "--set blocks[1]: blocks[1].polygon: a polygon in a spatial scene; use a box or a mesh, or set "
              "kinematics: planar_rigid or planar_deformable");
    EXPECT_NE(faults_of(two_boxes, {"blocks[1].box.lower=[0, 0]"}).find("expected three components [x, y, z]"),
              std::string::npos);
}

}  // namespace
}  // namespace voussoir::app::reader
