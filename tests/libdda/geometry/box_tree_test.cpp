#include "libdda/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <ctime>
#include <random>

namespace voussoir::testing
{

namespace
{

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

std::vector<AlignedBox3d> random_boxes(int count, double largest)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 10), size(0, largest);
    std::vector<AlignedBox3d> boxes;
    for (int i = 0; i < count; ++i) {
        const Vector3d lower(place(random), place(random), place(random));
        boxes.emplace_back(lower, lower + Vector3d(size(random), size(random), size(random)));
    }
    return boxes;
}

/// CPU time of finding all neighbours of cubes stacked in a tower [s].
double time_of_a_tower(int count)
{
    std::vector<AlignedBox3d> boxes;
    for (int i = 0; i < count; ++i) boxes.emplace_back(Vector3d(0, 0, i), Vector3d(1, 1, i + 1));
    const std::clock_t start = std::clock();
    const BoxTree tree(std::move(boxes));
    int pairs = 0;
    for (int i = 0; i < count; ++i) pairs += static_cast<int>(tree.neighbours_behind(i).size());
    EXPECT_EQ(pairs, count - 1) << "each touches the one above";
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

TEST(BoxTree, FindsWhatALookAtAllPairsFinds)
{
    for (const int count : {1, 2, 3, 500}) {
        const std::vector<AlignedBox3d> boxes = random_boxes(count, count < 10 ? 10 : 2);
        const BoxTree tree(boxes);
        int pairs = 0;
        for (int a = 0; a < count; ++a) {
            std::vector<int> expected;
            for (int b = a + 1; b < count; ++b)
                if (boxes[a].intersects(boxes[b])) expected.push_back(b);
            EXPECT_EQ(tree.neighbours_behind(a), expected);
            pairs += static_cast<int>(expected.size());
        }
        EXPECT_TRUE(count < 500 || pairs > count);
    }
}

// Sixteen times the blocks take about twenty times the time; all pairs would take 256 times as much.
TEST(BoxTree, OfATowerTakesTimeInProportion)
{
    const double few = time_of_a_tower(4000), many = time_of_a_tower(64000);
    EXPECT_LT(many, 64 * few) << few;
}

}  // namespace voussoir::testing
