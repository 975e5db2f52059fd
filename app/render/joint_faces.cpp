#include "app/render/joint_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace voussoir::app::render
{

using Eigen::Vector3d;

namespace
{

struct FacePlane {
    Vector3d area_normal = Vector3d::Zero();  // m2, outward
    Vector3d middle = Vector3d::Zero();       // m
};

FacePlane plane_of(const results::SurfaceMesh& mesh, int face, const std::vector<Vector3d>& places)
{
    FacePlane plane;
    const int first = mesh.face_first[face], end = mesh.face_first[face + 1];
    const Vector3d& origin = places[mesh.face_vertices[first]];
    for (int i = first; i < end; ++i) {
        const Vector3d here = places[mesh.face_vertices[i]] - origin;
        const Vector3d next = places[mesh.face_vertices[i + 1 < end ? i + 1 : first]] - origin;
        plane.area_normal += 0.5 * here.cross(next);
        plane.middle += (origin + here) / (end - first);
    }
    return plane;
}

struct BestFace {
    int face = -1;
    double area = 0;  // m2
};

/// Smallest sum of distance from the centre to the plane and of the tilt against the direction, as a length.
BestFace best_face(const results::SurfaceMesh& mesh, const std::vector<Vector3d>& places, int block,
                   const Vector3d& outward, const Vector3d& centre)
{
    BestFace best;
    double best_miss = std::numeric_limits<double>::infinity();
    const auto range = std::equal_range(mesh.face_block.begin(), mesh.face_block.end(), block);
    for (auto it = range.first; it != range.second; ++it) {
        const int face = static_cast<int>(it - mesh.face_block.begin());
        const FacePlane plane = plane_of(mesh, face, places);
        const double area = plane.area_normal.norm();
        const Vector3d normal = plane.area_normal / area;
        const double tilt = 1 - normal.dot(outward);
        const double miss = std::abs(normal.dot(centre - plane.middle)) + tilt * std::sqrt(area);
        if (tilt > 0.5 || miss >= best_miss) continue;
        best_miss = miss;
        best = {face, area};
    }
    return best;
}

}  // namespace

std::vector<int> faces_of_joint(const results::SurfaceMesh& mesh, const std::vector<Vector3d>& places,
                                const WatchedJoint& joint)
{
    const BestFace a = best_face(mesh, places, joint.block_a, -joint.normal, joint.centre);
    const BestFace b = best_face(mesh, places, joint.block_b, joint.normal, joint.centre);
    std::vector<int> faces;
    if (a.face >= 0 && (b.face < 0 || a.area < 3 * b.area)) faces.push_back(a.face);
    if (b.face >= 0 && (a.face < 0 || b.area < 3 * a.area)) faces.push_back(b.face);
    return faces;
}

}  // namespace voussoir::app::render
