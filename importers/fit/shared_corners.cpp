#include "importers/fit/shared_corners.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "libdda/errors.h"

namespace voussoir::importers::fit
{

using Eigen::Vector3d;

namespace
{

constexpr int iterations = 8;           // the last moves corners by rounding where all can be flat
constexpr double same_corner = 0.04;    // share of the smaller side's size
constexpr double over_the_edge = 0.02;  // share of a side's size: a corner so far outside it still faces it
// Of the square of a corner's move in squares of distances from planes: decides only what these leave open.
constexpr double stiffness_of_corners = 1e-6;

using CornerOf = std::pair<int, int>;  // stone, vertex

/// Sets of corners that are one.
class Corners
{
 public:
    Corners(const std::vector<SidedStone>& stones, const std::vector<Facing>& joints) : stones_(stones)
    {
        for (const Facing& joint : joints) {
            const Side& a = side(joint.stone_a, joint.side_a);
            const Side& b = side(joint.stone_b, joint.side_b);
            for (const int v : a.corners) add({joint.stone_a, v});
            for (const int v : b.corners) add({joint.stone_b, v});
            for (const int v : a.corners) match(joint, v, a, b);
        }
        number_sets();
    }

    int of(const CornerOf& corner) const { return set_of_.at(index_.at(corner)); }
    bool has(const CornerOf& corner) const { return index_.contains(corner); }
    const std::map<CornerOf, int>& all() const { return index_; }
    int count() const { return count_; }
    int set(int index) const { return set_of_[index]; }

 private:
    const Side& side(int stone, int number) const { return stones_[stone].sides[number]; }
    const Vector3d& place(const CornerOf& c) const { return stones_[c.first].surface->vertices[c.second]; }

    void add(const CornerOf& corner)
    {
        if (!index_.try_emplace(corner, static_cast<int>(parent_.size())).second) return;
        parent_.push_back(static_cast<int>(parent_.size()));
        stones_in_.push_back({corner.first});
    }

    static int nearest(const std::vector<int>& corners, const std::vector<Vector3d>& vertices, const Vector3d& x)
    {
        return *std::min_element(corners.begin(), corners.end(), [&](int i, int j) {
            return (vertices[i] - x).squaredNorm() < (vertices[j] - x).squaredNorm();
        });
    }

    /// Corners that are each other's nearest.
    void match(const Facing& joint, int v, const Side& a, const Side& b)
    {
        const std::vector<Vector3d>& of_a = stones_[joint.stone_a].surface->vertices;
        const std::vector<Vector3d>& of_b = stones_[joint.stone_b].surface->vertices;
        const int w = nearest(b.corners, of_b, of_a[v]);
        if (nearest(a.corners, of_a, of_b[w]) != v) return;
        if ((of_a[v] - of_b[w]).norm() > same_corner * std::min(a.size, b.size)) return;
        join({joint.stone_a, v}, {joint.stone_b, w});
    }

    /// Two corners of one stone never become one.
    void join(const CornerOf& a, const CornerOf& b)
    {
        const int i = root(index_.at(a)), j = root(index_.at(b));
        if (i == j) return;
        for (const int stone : stones_in_[j])
            if (stones_in_[i].contains(stone)) return;
        stones_in_[i].insert(stones_in_[j].begin(), stones_in_[j].end());
        parent_[j] = i;
    }

    int root(int k) const
    {
        while (parent_[k] != k) k = parent_[k];
        return k;
    }

    void number_sets()
    {
        std::map<int, int> number;
        for (int k = 0; k < static_cast<int>(parent_.size()); ++k)
            set_of_.push_back(number.try_emplace(root(k), static_cast<int>(number.size())).first->second);
        count_ = static_cast<int>(number.size());
    }

    const std::vector<SidedStone>& stones_;
    std::map<CornerOf, int> index_;
    std::vector<int> parent_, set_of_;
    std::vector<std::set<int>> stones_in_;
    int count_ = 0;
};

/// A plane among the unknowns: it moves outward by (1, x, y) . p, x and y in its own directions over its size.
struct Plane {
    Frame frame;
    double size = 0;        // m
    std::set<int> corners;  // sets that are to lie in it

    Vector3d terms(const Vector3d& place) const
    {
        const Vector3d arm = (place - frame.centre) / size;
        return {1, frame.u.dot(arm), frame.v.dot(arm)};
    }
    void move(const Vector3d& p)
    {
        const Vector3d normal = (frame.normal - (p[1] * frame.u + p[2] * frame.v) / size).normalized();
        frame = frame_of(frame.centre + p[0] * frame.normal, normal);
    }
};

/// Whether a point lies over a side, seen along its normal.
bool lies_over(const SidedStone& stone, const Side& side, const Vector3d& x)
{
    const double margin = over_the_edge * side.size;
    for (const int face : side.faces)
        for (const Eigen::Matrix3d& t : triangles_of(*stone.surface, face)) {
            bool inside = true;
            for (int k = 0; k < 3 && inside; ++k) {
                const Vector3d along = t.col((k + 1) % 3) - t.col(k);
                const Vector3d inward = side.plane.normal.cross(along).normalized();
                inside = inward.dot(x - t.col(k)) >= -margin;
            }
            if (inside) return true;
        }
    return false;
}

std::map<SideOf, Plane> planes_of(const std::vector<SidedStone>& stones, const std::vector<Facing>& joints,
                                  const Corners& corners)
{
    std::map<SideOf, Plane> planes;
    const auto take = [&](const SideOf& own, const SideOf& other) {
        const SidedStone& stone = stones[own.stone];
        const Side& side = stone.sides[own.side];
        Plane& plane = planes.try_emplace(own, Plane{side.plane, side.size, {}}).first->second;
        for (const int v : side.corners) plane.corners.insert(corners.of({own.stone, v}));
        for (const int v : stones[other.stone].sides[other.side].corners)
            if (lies_over(stone, side, stones[other.stone].surface->vertices[v]))
                plane.corners.insert(corners.of({other.stone, v}));
    };
    for (const Facing& joint : joints) {
        const SideOf a{joint.stone_a, joint.side_a}, b{joint.stone_b, joint.side_b};
        take(a, b);
        take(b, a);
    }
    return planes;
}

std::vector<Vector3d> mean_places(const std::vector<SidedStone>& stones, const Corners& corners)
{
    std::vector<Vector3d> places(corners.count(), Vector3d::Zero());
    std::vector<double> count(corners.count(), 0);
    for (const auto& [corner, index] : corners.all()) {
        places[corners.set(index)] += stones[corner.first].surface->vertices[corner.second];
        ++count[corners.set(index)];
    }
    for (std::size_t k = 0; k < places.size(); ++k) places[k] /= count[k];
    return places;
}

/// One step of Gauss-Newton: rows 3 c of corners, then of planes.
void improve(const std::vector<Vector3d>& drawn, std::vector<Vector3d>& places, std::map<SideOf, Plane>& planes)
{
    const auto corners = static_cast<int>(places.size());
    const auto size = static_cast<Eigen::Index>(3 * (places.size() + planes.size()));
    if (size <= 0) return;
    std::vector<Eigen::Triplet<double>> triplets;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(size);
    int row = corners;
    for (const auto& [key, plane] : planes) {
        for (const int c : plane.corners) {
            Eigen::Matrix<double, 6, 1> slope;
            slope << plane.frame.normal, -plane.terms(places[c]);
            const std::array<int, 6> at{3 * c, 3 * c + 1, 3 * c + 2, 3 * row, 3 * row + 1, 3 * row + 2};
            const double off = plane.frame.height(places[c]);
            for (int i = 0; i < 6; ++i) {
                load[at[i]] -= slope[i] * off;
                for (int j = 0; j < 6; ++j) triplets.emplace_back(at[i], at[j], slope[i] * slope[j]);
            }
        }
        ++row;
    }
    for (int c = 0; c < corners; ++c)
        for (int k = 0; k < 3; ++k) {
            triplets.emplace_back(3 * c + k, 3 * c + k, stiffness_of_corners);
            load[3 * c + k] += stiffness_of_corners * (drawn[c][k] - places[c][k]);
        }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    DDA_ASSERT(factor.info() == Eigen::Success);  // positive definite: no side's corners lie on a line
    const Eigen::VectorXd moves = factor.solve(load);
    for (int c = 0; c < corners; ++c) places[c] += moves.segment<3>(3 * c);
    row = corners;
    for (auto& [key, plane] : planes) plane.move(moves.segment<3>(3 * row++));
}

}  // namespace

SharedShape share_corners(const std::vector<SidedStone>& stones, const std::vector<Facing>& joints)
{
    SharedShape shape;
    for (const SidedStone& stone : stones) shape.vertices.push_back(stone.surface->vertices);
    if (joints.empty()) return shape;
    const Corners corners(stones, joints);
    std::map<SideOf, Plane> planes = planes_of(stones, joints, corners);
    const std::vector<Vector3d> drawn = mean_places(stones, corners);
    std::vector<Vector3d> places = drawn;
    for (int i = 0; i < iterations; ++i) improve(drawn, places, planes);
    for (const auto& [corner, index] : corners.all())
        shape.vertices[corner.first][corner.second] = places[corners.set(index)];
    for (const auto& [key, plane] : planes) {
        shape.planes.emplace(key, plane.frame);
        double& misfit = shape.misfit[key];
        for (const int c : plane.corners) misfit = std::max(misfit, std::abs(plane.frame.height(places[c])));
    }
    return shape;
}

}  // namespace voussoir::importers::fit
