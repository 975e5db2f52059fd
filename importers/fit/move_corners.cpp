#include "importers/fit/move_corners.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

namespace voussoir::importers::fit
{

using Eigen::Vector3d;

namespace
{

constexpr double no_direction = 1e-6;
// Singular values of unit normals: planes that meet at less are nearly one. Corners lie in the shared planes
// already and are only set right; a free side is not worth a long way along another one.
constexpr double nearly_one_shared = 0.05, nearly_one_free = 0.3;  // some 4 and 25 degrees

/// Planes that a corner is to lie in: normal . move = step.
struct Planes {
    std::vector<Vector3d> normals;
    std::vector<double> steps;

    void add(const Frame& plane, const Vector3d& corner)
    {
        normals.push_back(plane.normal);
        steps.push_back(-plane.height(corner));
    }
};

/// The least move within the space of `free` that brings a corner which has moved already nearest to the planes.
/// Takes the directions that this needs from `free`.
Vector3d move_into(const Planes& planes, const Vector3d& moved, double nearly_one, Eigen::Matrix3d& free)
{
    const auto rows = static_cast<Eigen::Index>(planes.normals.size());
    if (rows == 0) return Vector3d::Zero();
    Eigen::MatrixXd normals(rows, 3);
    Eigen::VectorXd steps(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
        normals.row(k) = planes.normals[k].transpose() * free;
        steps[k] = planes.steps[k] - planes.normals[k].dot(moved);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(normals, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Vector3d move = Vector3d::Zero();
    for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k) {
        if (svd.singularValues()[k] < no_direction) continue;
        const Vector3d along = svd.matrixV().col(k);
        if (svd.singularValues()[k] >= nearly_one)
            move += svd.matrixU().col(k).dot(steps) / svd.singularValues()[k] * along;
        free -= along * along.transpose();
    }
    return move;
}

double off_plane(const Frame& plane, const std::set<int>& corners, const std::vector<Vector3d>& vertices)
{
    double most = 0;
    for (const int v : corners) most = std::max(most, std::abs(plane.height(vertices[v])));
    return most;
}

}  // namespace

std::vector<Vector3d> move_corners(const SidedStone& stone, const std::vector<Vector3d>& vertices,
                                   const std::map<int, Frame>& planes, double flat)
{
    const mesh::PolygonSurface& surface = *stone.surface;
    std::vector<Planes> shared(vertices.size()), own(vertices.size());
    for (int s = 0; s < static_cast<int>(stone.sides.size()); ++s) {
        const Side& side = stone.sides[s];
        std::set<int> corners;
        for (const int face : side.faces) corners.insert(surface.faces[face].begin(), surface.faces[face].end());
        const auto given = planes.find(s);
        const Frame plane = given != planes.end() ? given->second : plane_of(side, vertices);
        if (given == planes.end() && off_plane(plane, corners, vertices) > flat) continue;
        for (const int v : corners) (given != planes.end() ? shared : own)[v].add(plane, vertices[v]);
    }
    std::vector<Vector3d> moved = vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        Eigen::Matrix3d free = Eigen::Matrix3d::Identity();
        Vector3d move = move_into(shared[v], Vector3d::Zero(), nearly_one_shared, free);
        move += move_into(own[v], move, nearly_one_free, free);
        moved[v] += move;
    }
    return moved;
}

}  // namespace voussoir::importers::fit
