// The words of a mechanism stay a dozen sentences, whatever the size of the structure.
#include "app/report/mechanism_words.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

namespace voussoir::app::report
{
namespace
{

constexpr int courses = 20, per_course = 15;

/// A wall of 300 stones of which each has come apart from the next, but for the lowest course: 19 bodies.
struct Wall {
    Wall()
    {
        for (int course = 1; course <= courses; ++course)
            for (int stone = 1; stone <= per_course; ++stone)
                model.block_names.push_back(fmt::format("wall_c{:02}_b{:02}", course, stone));
        for (int block = 0; block + 1 < courses * per_course; ++block) {
            model.joints.emplace_back();
            model.joints.back().block_a = block;
            model.joints.back().block_b = block + 1;
            MovedJoint moved;
            moved.joint = block;
            moved.opening = 1e-3 * (300 - block);
            moved.opens = true;
            moved.parted = block % 2 == 0;
            mechanism.joints.push_back(moved);
        }
        mechanism.kind = MechanismKind::hinges;
        mechanism.hinges = static_cast<int>(mechanism.joints.size());
        for (int course = 0; course < courses; ++course) {
            Body body;
            body.blocks.resize(per_course);
            std::iota(body.blocks.begin(), body.blocks.end(), per_course * course);
            body.rests = course == 0;
            body.displacement = body.last_displacement = 0.01 * course;
            mechanism.bodies.push_back(body);
        }
    }

    results::RecordedModel model;
    Mechanism mechanism;
};

TEST(MechanismWords, OfThreeHundredStonesAreAsFewAsOfTen)
{
    const Wall wall;
    const MechanismWords words = words_of(wall.mechanism, wall.model, {});
    EXPECT_EQ(
        words.headline,
        "The structure fails as a mechanism of 299 hinges: 19 bodies of stones move (285 of 300 stones of wall "
        "in courses 2 to 20).");
    EXPECT_LE(words.joints.size() + words.bodies.size(), 9U);
    ASSERT_EQ(words.joints.size(), 2U);
    EXPECT_EQ(
        words.joints[0],
        "150 joints within wall have come apart; the one that moved most: wall_c01_b01 and wall_c01_b02 have come "
        "apart: 300 mm open.");
    EXPECT_EQ(words.joints[1].rfind(
                  "149 joints within wall turn; the one that moved most: Hinge between wall_c01_b02", 0),
              0U)
        << words.joints[1];
    ASSERT_EQ(words.bodies.size(), 4U);
    EXPECT_EQ(words.bodies[0],
              "Moves as one: 15 of 300 stones of wall in course 2: moved by 10 mm, turned by 0°.");
    EXPECT_EQ(words.bodies[3],
              "16 more bodies: 240 of 300 stones of wall in courses 5 to 20; moved by up to 190 mm, turned by up "
              "to 0°.");
}

TEST(MechanismWords, OfFewJointsNameEach)
{
    Wall wall;
    wall.mechanism.joints.resize(7);
    wall.mechanism.bodies.resize(3);
    const MechanismWords words = words_of(wall.mechanism, wall.model, {});
    EXPECT_EQ(words.joints.size(), 7U);
    EXPECT_EQ(words.bodies.size(), 2U);
    EXPECT_EQ(words.joints[2], "wall_c01_b03 and wall_c01_b04 have come apart: 298 mm open.");
}

}  // namespace
}  // namespace voussoir::app::report
