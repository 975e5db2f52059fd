// Which of many boxes meet.
#pragma once

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>
#include <vector>

namespace voussoir
{

/// Boxes in a bounding volume hierarchy, so that looking for the neighbours of one takes no longer in a tower than
/// in a pavement. Not for what moves: it is built once.
class BoxTree
{
 public:
    /// @param boxes (n) [m], at least one
    explicit BoxTree(std::vector<Eigen::AlignedBox3d> boxes);

    /// Boxes behind `box` in the list that meet it, if only in a point; ascending.
    std::vector<int> neighbours_behind(int box) const;
    /// A box of the list.
    const Eigen::AlignedBox3d& operator[](int box) const { return boxes_[box]; }

 private:
    std::vector<Eigen::AlignedBox3d> boxes_;
    Eigen::KdBVH<double, 3, int> tree_;
};

}  // namespace voussoir
