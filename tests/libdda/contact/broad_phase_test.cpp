// Which parts may touch: the sweep against every pair looked at one by one.
#include "libdda/contact/broad_phase.h"

#include <gtest/gtest.h>

#include "libdda/contact/narrow_phase.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

struct Cloud {
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    State state;
    std::vector<double> reach;
    std::vector<bool> held;
};

/// Boxes of random size, place and attitude; some are held, some reach far.
Cloud random_boxes(unsigned seed, int count, double spread)
{
    Random random(seed);
    Cloud cloud;
    for (int b = 0; b < count; ++b) {
        const Eigen::Vector3d half(random.between(0.1, 1), random.between(0.1, 1), random.between(0.1, 1));
        add_box(cloud.model, "box", -half, half);
        cloud.held.push_back(random.between(0, 1) < 0.2);
        cloud.reach.push_back(random.between(0, 1) < 0.1 ? random.between(0, 1) : 0.01);
    }
    cloud.state = initial_state(cloud.model);
    for (int b = 0; b < count; ++b)
        set_pose(cloud.model, cloud.state, b, random.vector(spread), random.rotation());
    return cloud;
}

std::vector<std::pair<int, int>> candidate_pairs(const std::vector<contact::PlacedPart>& parts,
                                                 const std::vector<double>& reach, const std::vector<bool>& held)
{
    contact::Candidates candidates;
    candidates.pairs = {{7, 8}};  // of the search before
    contact::find_candidates(parts, reach, held, 1, candidates);
    return candidates.pairs;
}

}  // namespace

TEST(BroadPhase, FindsThePairsThatBruteForceFinds)
{
    std::size_t found = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Cloud cloud = random_boxes(seed, 60, 4);
        const std::vector<contact::PlacedPart> parts = placed(cloud.model, cloud.state);
        std::vector<std::pair<int, int>> expected;
        for (int i = 0; i < static_cast<int>(parts.size()); ++i)
            for (int j = i + 1; j < static_cast<int>(parts.size()); ++j) {
                if (cloud.held[i] && cloud.held[j]) continue;
                const double grow = cloud.reach[i] + cloud.reach[j];
                bool overlap = true;
                for (int k = 0; k < 3; ++k)
                    overlap = overlap && parts[i].lower[k] - grow <= parts[j].upper[k] &&
                              parts[j].lower[k] - grow <= parts[i].upper[k];
                if (overlap) expected.emplace_back(i, j);
            }
        EXPECT_EQ(candidate_pairs(parts, cloud.reach, cloud.held), expected) << "seed " << seed;
        found += expected.size();
    }
    EXPECT_GT(found, 1000U);
}

TEST(BroadPhase, MissesNothingThatTouches)
{
    std::size_t touching = 0;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const Cloud cloud = random_boxes(seed, 50, 3);
        const std::vector<contact::PlacedPart> parts = placed(cloud.model, cloud.state);
        const std::vector<bool> all_free(parts.size(), false);
        const auto pairs = candidate_pairs(parts, cloud.reach, all_free);
        for (int i = 0; i < static_cast<int>(parts.size()); ++i)
            for (int j = i + 1; j < static_cast<int>(parts.size()); ++j) {
                const double margin = cloud.reach[i] + cloud.reach[j];
                if (!contact::contact_polygon(parts[i], parts[j], margin, {})) continue;
                ++touching;
                EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::pair(i, j)));
            }
    }
    EXPECT_GT(touching, 100U);
}

TEST(BroadPhase, PartsOfOneBlockAreNoPair)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    model.blocks.push_back(
        make_block("L", 0, 0, {make_box({0, 0, 0}, {1, 1, 1}), make_box({1, 0, 0}, {2, 1, 1})}));
    add_box(model, "box", {0, 0, 1}, {1.5, 1, 2});
    const State state = initial_state(model);
    const auto pairs = candidate_pairs(placed(model, state), {0.01, 0.01}, {false, false});
    EXPECT_EQ(pairs, (std::vector<std::pair<int, int>>{{0, 2}, {1, 2}}));
}

// The box of a turned, stretched block is that of its vertices where they are.
TEST(BroadPhase, PlacedPartsFollowTheMap)
{
    Model model = make_model(Kinematics::spatial_deformable, stone(), dry(30));
    add_box(model, "box", {-1, -0.5, -0.5}, {1, 0.5, 0.5});
    State state = initial_state(model);
    set_pose(model, state, 0, {10, 0, 0}, 1.1 * turned(90 * degrees, {0, 0, 1}));
    const contact::PlacedPart part = placed(model, state).front();
    EXPECT_LT((part.lower - Eigen::Vector3d(10 - 0.55, -1.1, -0.55)).norm(), 1e-14);
    EXPECT_LT((part.upper - Eigen::Vector3d(10 + 0.55, 1.1, 0.55)).norm(), 1e-14);
    EXPECT_NEAR(part.support(Eigen::Vector3d(1, 1, 0)), 10 + 0.55 + 1.1, 1e-14);
    for (const Eigen::Vector3d& n : part.normals) EXPECT_NEAR(n.norm(), 1, 1e-15);
}

// Memory that is used again gives what new memory gives: for blocks that stay, turn in place, are shifted, and
// change their shape without moving.
TEST(BroadPhase, PartsPlacedAgainAreThoseThatArePlacedAnew)
{
    Model model = make_model(Kinematics::spatial_deformable, stone(), dry(30));
    for (int b = 0; b < 4; ++b) add_box(model, "box", {-1, -0.5, -0.5}, {1, 0.5, 0.5});
    State state = initial_state(model);
    std::vector<contact::PlacedPart> again;
    contact::place_parts(model, state, 1, again);
    const auto centroid = [&](int block) { return pose_of(model.kinematics, state, block).centroid; };
    set_pose(model, state, 1, centroid(1), turned(90 * degrees, {0, 0, 1}));
    set_pose(model, state, 2, {0, 0, 3}, Eigen::Matrix3d::Identity());
    set_pose(model, state, 3, centroid(3), 1.1 * Eigen::Matrix3d::Identity());
    contact::place_parts(model, state, 1, again);
    const std::vector<contact::PlacedPart> anew = placed(model, state);
    for (int b = 0; b < 4; ++b) {
        EXPECT_EQ(again[b].vertices, anew[b].vertices) << b;
        EXPECT_EQ(again[b].normals, anew[b].normals) << b;
        EXPECT_EQ(again[b].lower, anew[b].lower) << b;
        EXPECT_EQ(again[b].upper, anew[b].upper) << b;
    }
}

}  // namespace voussoir::testing
