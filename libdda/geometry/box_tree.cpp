#include "libdda/geometry/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace voussoir
{

namespace
{

/// What Eigen asks: whether to look into a volume, and what to do with a box of it.
struct Query {
    const std::vector<Eigen::AlignedBox3d>& boxes;
    int box;
    std::vector<int> found;

    bool intersectVolume(const Eigen::AlignedBox3d& volume) const { return volume.intersects(boxes[box]); }
    bool intersectObject(int other)
    {
        if (other > box && boxes[other].intersects(boxes[box])) found.push_back(other);
        return false;  // look on
    }
};

}  // namespace

BoxTree::BoxTree(std::vector<Eigen::AlignedBox3d> boxes) : boxes_(std::move(boxes))
{
    std::vector<int> all(boxes_.size());
    std::iota(all.begin(), all.end(), 0);
    tree_.init(all.begin(), all.end(), boxes_.begin(), boxes_.end());
}

std::vector<int> BoxTree::neighbours_behind(int box) const
{
    Query query{boxes_, box, {}};
    Eigen::BVIntersect(tree_, query);
    std::sort(query.found.begin(), query.found.end());
    return std::move(query.found);
}

}  // namespace voussoir
