// Entries of `blocks` that are scaled, mirrored, turned, moved and copied: against what geometry says of the
// results.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "libdda/contact/initial_contacts.h"
#include "libdda/model/state.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::string scene = R"(materials: {m: {density: 2000 kg/m3, young: 1 GPa, poisson: 0.2}}
joints: {j: {friction: 30 deg}}
stages: [{type: static}]
)";

/// A brick of 2 x 1 x 0.5 m, turned in itself so that none of its moments vanish, with more keys beside it.
std::string brick(const std::string& keys)
{
    return scene +
           "blocks:\n"
           "  - {box: {name: brick, lower: [1, 2, 3], upper: [3, 3, 3.5], rotate: {axis: [1, 2, 3], angle: 40 "
           "deg}}, " +
           keys + "}\n";
}

std::vector<Block> blocks_of(const std::string& text, const std::vector<std::string>& overrides = {})
{
    return read(text, overrides).model.blocks;
}

/// A block is another one after x -> linear x + offset.
void expect_image(const Block& image, const Block& original, const Matrix3d& linear, const Vector3d& offset)
{
    const double grown = std::abs(linear.determinant());
    const Moments &is = image.moments, &was = original.moments;
    EXPECT_NEAR(is.volume, grown * was.volume, 1e-12 * is.volume) << image.name;
    EXPECT_TRUE(is.centroid.isApprox(linear * was.centroid + offset, 1e-13)) << image.name;
    EXPECT_TRUE(is.second.isApprox(grown * linear * was.second * linear.transpose(), 1e-11)) << image.name;
}

Matrix3d turn(double degrees, const Vector3d& axis)
{
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
}

std::vector<std::string> names_of(const std::vector<Block>& blocks)
{
    std::vector<std::string> names;
    for (const Block& block : blocks) names.push_back(block.name);
    return names;
}

TEST(Placing, ScaledStonesHaveTheMomentsOfTheirSize)
{
    const Block drawn = blocks_of(brick("group: g")).at(0);
    expect_image(blocks_of(brick("scale: 250 %")).at(0), drawn, 2.5 * Matrix3d::Identity(), Vector3d::Zero());
    expect_image(blocks_of(brick("scale: [2, 1, 0.5]")).at(0), drawn, Vector3d(2, 1, 0.5).asDiagonal(),
                 Vector3d::Zero());
}

TEST(Placing, TurnsAboutTheOriginOrAPoint)
{
    const Block drawn = blocks_of(brick("group: g")).at(0);
    const Matrix3d oblique = turn(33, {1, -1, 2}), upright = turn(-70, {0, 0, 1});
    expect_image(blocks_of(brick("rotate: {axis: [1, -1, 2], angle: 33 deg}")).at(0), drawn, oblique,
                 Vector3d::Zero());
    const Vector3d about(5, -1, 2);
    expect_image(blocks_of(brick("rotate: {axis: z, angle: -70 deg, about: [5, -1, 2]}")).at(0), drawn, upright,
                 about - upright * about);
    expect_image(blocks_of(brick("rotate: {axis: [1e-200, -1e-200, 2e-200], angle: 33 deg}")).at(0), drawn,
                 oblique, Vector3d::Zero());
}

TEST(Placing, MirroredStonesHaveMirroredMoments)
{
    const Block drawn = blocks_of(brick("group: g")).at(0);
    ASSERT_GT(std::abs(drawn.moments.second(0, 1)), 1e-3) << "or its image would be itself";
    const Block image = blocks_of(brick("mirror: {plane: y, at: 1 m}")).at(0);
    expect_image(image, drawn, Vector3d(1, -1, 1).asDiagonal(), {0, 2, 0});
    EXPECT_NEAR(image.moments.second(0, 1), -drawn.moments.second(0, 1), 1e-12);
    EXPECT_NEAR(image.moments.second(0, 2), drawn.moments.second(0, 2), 1e-12);
    for (int face = 0; face < 6; ++face) {  // still outward: or contact would look for stones inside
        const ConvexPolyhedron& part = image.parts.at(0);
        EXPECT_GT(face_normal(part, face).dot(part.vertices[part.faces[face][0]]), 0);
    }
}

TEST(Placing, ActsInOneOrderWhateverTheOrderOfWriting)
{
    const Block drawn = blocks_of(brick("group: g")).at(0);
    const Matrix3d linear =
        turn(90, {1, 0, 0}) * Matrix3d(Vector3d(-1, 1, 1).asDiagonal()) * Matrix3d(Vector3d(3, 2, 1).asDiagonal());
    for (const char* keys :
         {"scale: [3, 2, 1], mirror: {plane: x}, rotate: {axis: x, angle: 90 deg}, move: [1, 2, 4]",
          "move: [1, 2, 4], rotate: {axis: x, angle: 90 deg}, mirror: {plane: x}, scale: [3, 2, 1]"})
        expect_image(blocks_of(brick(keys)).at(0), drawn, linear, {1, 2, 4});
}

TEST(Placing, AStonePlacedWhereItIsHasTheSameBits)
{
    const Block drawn = blocks_of(brick("group: g")).at(0);
    const Block same = blocks_of(brick("scale: 1, rotate: {axis: y, angle: 0}, move: [0, 0, 0]")).at(0);
    EXPECT_EQ(same.parts.at(0).vertices, drawn.parts.at(0).vertices);
    EXPECT_EQ(same.moments.second, drawn.moments.second);
}

TEST(Placing, CopiesStandInRowsAndAreNumbered)
{
    const std::vector<Block> row = blocks_of(brick("copy: {copies: 3, step: [2.5 m, 0, 10 cm]}"));
    EXPECT_EQ(names_of(row), (std::vector<std::string>{"brick", "brick_2", "brick_3", "brick_4"}));
    for (int k = 0; k < 4; ++k) expect_image(row[k], row[0], Matrix3d::Identity(), k * Vector3d(2.5, 0, 0.1));
    EXPECT_TRUE(has_default(read(brick("copy: {step: [3, 0, 0]}")), "copies = 1"));
}

TEST(Placing, RowsOfRowsAreNumberedByRow)
{
    const std::vector<Block> field =
        blocks_of(brick("copy: [{copies: 1, step: [3, 0, 0]}, {copies: 2, step: [0, 4, 0]}]"));
    EXPECT_EQ(names_of(field), (std::vector<std::string>{"brick", "brick_2_1", "brick_1_2", "brick_2_2",
                                                         "brick_1_3", "brick_2_3"}));
    expect_image(field[5], field[0], Matrix3d::Identity(), {3, 8, 0});
    expect_image(field[2], field[0], Matrix3d::Identity(), {0, 4, 0});
}

TEST(Placing, AMirrorAmongTheCopiesKeepsTheOriginal)
{
    const std::vector<Block> four = blocks_of(
        brick("copy: [{mirror: {plane: x, at: -1}}, {copies: 1, step: [0, 0, 5]}, {mirror: {plane: y}}]"));
    EXPECT_EQ(names_of(four), (std::vector<std::string>{"brick", "brick_mirrored", "brick_2", "brick_2_mirrored",
                                                        "brick_mirrored2", "brick_mirrored_mirrored2",
                                                        "brick_2_mirrored2", "brick_2_mirrored_mirrored2"}));
    expect_image(four[1], four[0], Vector3d(-1, 1, 1).asDiagonal(), {-2, 0, 0});
    expect_image(four[7], four[0], Vector3d(-1, -1, 1).asDiagonal(), {-2, 0, 5});
}

TEST(Placing, CopiesTurnAndClimbAsAStair)
{
    const std::vector<Block> stair = blocks_of(
        brick("copy: {copies: 20, rotate: {axis: z, angle: 45 deg, about: [1, 0, 7]}, step: [0, 0, 0.8]}"));
    ASSERT_EQ(stair.size(), 21U);
    const Vector3d about(1, 0, 7);
    for (int k = 0; k <= 20; ++k) {
        const Matrix3d turned = turn(45 * k, {0, 0, 1});
        expect_image(stair[k], stair[0], turned, about - turned * about + k * Vector3d(0, 0, 0.8));
    }
}

TEST(Placing, ARingOfCopiesIsARingDrawnStoneByStone)
{
    // A planar arch: voussoir k between the angles k and k + 1 of 18 degrees.
    const auto corner = [](double radius, int k) {
        const double angle = k * 18 * std::numbers::pi / 180;
        return Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle));
    };
    const std::string planar = with(scene, "stages", "kinematics: planar_rigid\nthickness: 1\nstages");
    std::string drawn = planar + "blocks:\n", copied = drawn;
    for (int k = 0; k < 10; ++k) {
        drawn += "  - {polygon: {name: v" + std::to_string(k) + ", corners: [";
        for (const auto& [radius, side] : {std::pair{4., 0}, {5., 0}, {5., 1}, {4., 1}}) {
            const Eigen::Vector2d x = corner(radius, k + side);
            char text[80];
            std::snprintf(text, sizeof text, "[%.17g, %.17g],", x.x(), x.y());
            drawn += text;
        }
        drawn.back() = ']';
        drawn += "}}\n";
        if (k == 0) copied = with(drawn, "]}}\n", "]}, copy: {copies: 9, rotate: {angle: 18 deg}}}\n");
    }
    const Model ring = read(copied).model, stones = read(drawn).model;
    ASSERT_EQ(ring.blocks.size(), 10U);
    for (int k = 0; k < 10; ++k) {
        const Block &is = ring.blocks[k], &must = stones.blocks[k];
        EXPECT_TRUE(is.moments.centroid.isApprox(must.moments.centroid, 1e-14));
        EXPECT_TRUE(is.moments.second.isApprox(must.moments.second, 1e-12));
        for (int v = 0; v < 4; ++v)
            EXPECT_NEAR((is.outlines[0].vertices[v] - must.outlines[0].vertices[v]).norm(), 0, 1e-14);
    }
    State of_ring = initial_state(ring), of_stones = initial_state(stones);
    find_initial_contacts(ring, of_ring);
    find_initial_contacts(stones, of_stones);
    EXPECT_EQ(of_ring.planar_contacts.patches.size(), 9U);
    EXPECT_EQ(of_ring.planar_contacts.patches.size(), of_stones.planar_contacts.patches.size());
}

const std::string wall =
    scene +
    "blocks:\n"
    "  - wall: {length: 2, height: 1, thickness: 0.4, block: [0.5, 0.25], imperfection: {seed: 3, "
    "size: 1 %, friction: 10 %}}\n";

TEST(Placing, WallsAndHousesArePlacedAsAWhole)
{
    const std::vector<Block> drawn = blocks_of(wall);
    const std::vector<Block> placed =
        blocks_of(wall, {"blocks[0].rotate={axis: z, angle: 30 deg}", "blocks[0].move=[1, 0, 2]",
                         "blocks[0].copy={mirror: {plane: x, at: -5}}"});
    ASSERT_EQ(placed.size(), 2 * drawn.size());
    const Matrix3d turned = turn(30, {0, 0, 1}), mirror = Vector3d(-1, 1, 1).asDiagonal();
    for (std::size_t b = 0; b < drawn.size(); ++b) {
        expect_image(placed[b], drawn[b], turned, {1, 0, 2});
        const Block& image = placed[b + drawn.size()];
        expect_image(image, drawn[b], mirror * turned, {-11, 0, 2});
        EXPECT_EQ(image.name, drawn[b].name + "_mirrored");
        EXPECT_EQ(image.friction_factor, drawn[b].friction_factor);
    }
    const std::string house =
        scene +
        "blocks:\n"
        "  - house: {length: 3, width: 2, height: 1, wall_thickness: 0.4, block: [0.5, 0.25]}\n";
    const std::vector<Block> half = blocks_of(house, {"blocks[0].scale=0.5"}), whole = blocks_of(house);
    ASSERT_EQ(half.size(), whole.size());
    for (std::size_t b = 0; b < half.size(); ++b)
        expect_image(half[b], whole[b], 0.5 * Matrix3d::Identity(), Vector3d::Zero());
}

TEST(Placing, StonesOfAPlanarSceneStayInItsPlane)
{
    const std::vector<std::string> planar = {"kinematics=planar_rigid"};
    const std::string flat = scene + "blocks: [{box: {name: b, lower: [1, 0], upper: [3, 1]}}]\n";
    const auto placed = [&](const std::string& key) {
        return read(flat, {planar[0], "blocks[0]." + key}).model.blocks;
    };
    EXPECT_TRUE(placed("rotate={angle: 90 deg}")[0].moments.centroid.isApprox(Vector3d(-0.5, 0, 2), 1e-14));
    EXPECT_TRUE(
        placed("rotate={axis: y, angle: 90 deg}")[0].moments.centroid.isApprox(Vector3d(0.5, 0, -2), 1e-14));
    EXPECT_TRUE(placed("move=[1, 2]")[0].moments.centroid.isApprox(Vector3d(3, 0, 2.5), 1e-14));
    EXPECT_NEAR(placed("scale=[2, 3]")[0].moments.volume, 12, 1e-13);
    EXPECT_EQ(placed("copy={copies: 2, step: [0, 1]}").size(), 3U);
    EXPECT_NE(faults_of(flat, {planar[0], "blocks[0].rotate={axis: z, angle: 5 deg}"})
                  .find("b: turned out of the plane of the scene; outlines [x, z] can be turned about y only"),
              std::string::npos);
    // Drawn in space, along y: a turn brings it into the plane.
    const std::string along_y = scene + "blocks: [{box: {name: b, lower: [0, 1, 0], upper: [0.4, 3, 1]}}]\n";
    const Model model = read(along_y, {planar[0], "blocks[0].rotate={axis: z, angle: -90 deg}"}).model;
    EXPECT_NEAR(model.thickness, 0.4, 1e-15);
    EXPECT_TRUE(model.blocks[0].moments.centroid.isApprox(Vector3d(2, 0, 0.5), 1e-14));
}

TEST(Placing, BadPlacesAreRefusedInASentence)
{
    const auto fault = [](const std::string& setting) {
        return faults_of(brick("group: g"), {"blocks[0]." + setting});
    };
    EXPECT_EQ(fault("scale=0"), "--set blocks[0].scale: 0; must be > 0");
    EXPECT_EQ(
        fault("scale=[1, -1, 1]"),
        "--set blocks[0].scale: [1, -1, 1]; all factors must be > 0; mirror: {plane: x} makes left of right");
    EXPECT_EQ(
        fault("scale=2 m"),
        "--set blocks[0].scale: \"2 m\" has the wrong dimension; expected a number without unit such as 0.25");
    EXPECT_EQ(fault("rotate={axis: [0, 0, 0], angle: 1 deg}"),
              "--set blocks[0].rotate: blocks[0].rotate.axis: an axis of length 0; give a direction");
    EXPECT_EQ(fault("rotate={axis: up, angle: 1 deg}"),
              "--set blocks[0].rotate: blocks[0].rotate.axis: \"up\"; expected one of x, y, z");
    EXPECT_EQ(
        fault("rotate={angle: 1 deg}"),
        "--set blocks[0].rotate: blocks[0].rotate.axis: missing; give the axis of the rotation, z or [x, y, z]");
    EXPECT_EQ(
        fault("rotate={axis: z, angle: 5 m}"),
        "--set blocks[0].rotate: blocks[0].rotate.angle: \"5 m\" has the wrong dimension; expected an angle such "
        "as 30 deg");
    EXPECT_EQ(fault("move=[1, 2]"), "--set blocks[0].move: a list of 2; expected three components [x, y, z]");
    EXPECT_NE(fault("move=[.inf, 0, 0]").find("expected a length"), std::string::npos);
    EXPECT_EQ(
        fault("mirror={at: 1}"),
        "--set blocks[0].mirror: blocks[0].mirror.plane: missing; give the axis across the mirror, x, y or z");
    EXPECT_EQ(
        fault("scale=1e200"),
        "case.yaml:5: blocks[0].box: brick: it is too large or too far away; check scale, rotate, move and copy");
    EXPECT_EQ(
        fault("scale=1e-200"),
        "case.yaml:5: blocks[0].box: brick: nothing is left of its size; check scale, rotate, move and copy");
    EXPECT_NE(fault("move=[1e300, 0, 0]").find("brick: it is too large or too far away"), std::string::npos);
}

TEST(Placing, BadCopiesAreRefusedInASentence)
{
    const auto fault = [](const std::string& copy) {
        return faults_of(brick("group: g"), {"blocks[0].copy=" + copy});
    };
    EXPECT_EQ(fault("{copies: 0, step: [1, 0, 0]}"),
              "--set blocks[0].copy: blocks[0].copy.copies: \"0\"; expected a whole number from 1 to 199999");
    EXPECT_EQ(fault("[{copies: 1000, step: [9, 0, 0]}, {copies: 1000, step: [0, 9, 0]}]"),
              "--set blocks[0].copy: blocks[0].copy[1]: more than 200000 copies; give fewer copies");
    EXPECT_EQ(fault("{copies: 2}"),
              "--set blocks[0].copy: a copy in the place of the original; give step, rotate or mirror");
    EXPECT_EQ(fault("[]"),
              "--set blocks[0].copy: no copy; give a copy {copies: 3, step: [x, y, z]} or a list of them");
    EXPECT_EQ(fault("3"),
              "--set blocks[0].copy: \"3\"; expected a copy {copies: 3, step: [x, y, z]} or a list of them");
    EXPECT_EQ(
        fault("{copies: 2, mirror: {plane: x}}"),
        "--set blocks[0].copy: blocks[0].copy.mirror: a mirror beside copies, step or rotate; make it an item of "
        "its own: [{copies: 3, ...}, {mirror: ...}]");
    EXPECT_EQ(fault("{copeis: 2, step: [1, 0, 0]}"),
              "--set blocks[0].copy: blocks[0].copy.copeis: unknown key; did you mean copies?");
    EXPECT_NE(fault("{copies: 2, step: [1 mm, 0, 0]}").find("brick and brick_2: overlap by"), std::string::npos);
    EXPECT_NE(faults_of(wall, {"blocks[0].copy={copies: 100000, step: [0, 1, 0]}"})
                  .find("100001 copies of 18 blocks: more than 200000 blocks; give fewer copies or larger blocks"),
              std::string::npos);
    const std::string two = brick("copy: {step: [9, 0, 0]}") +
                            "  - {box: {name: brick_2, lower: [0, 0, 90], upper: [1, "
                            "1, 91]}}\n";
    EXPECT_NE(faults_of(two).find("a second block named brick_2"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::app::reader
