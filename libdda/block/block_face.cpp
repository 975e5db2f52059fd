#include "libdda/block/block_face.h"

#include <Eigen/Geometry>
#include <cmath>

namespace voussoir::step
{

/// Triangles from a corner, each by the middles of its edges.
FaceIn<3> face_of(const Model& model, const BlockFace& face, const Eigen::Matrix3d& map)
{
    const ConvexPolyhedron& part = model.blocks[face.block].parts[face.part];
    const std::vector<int>& loop = part.faces[face.face];
    const auto corner = [&](std::size_t i) { return Eigen::Vector3d(map * part.vertices[loop[i]]); };
    FaceIn<3> result;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const Eigen::Vector3d a = corner(0), b = corner(i), c = corner(i + 1), twice = (b - a).cross(c - a);
        for (const Eigen::Vector3d& sum : {Eigen::Vector3d(a + b), Eigen::Vector3d(b + c), Eigen::Vector3d(c + a)})
            result.points.push_back({0.5 * sum, twice.norm() / 6});
        result.normal += twice;
    }
    result.normal.normalize();
    return result;
}

/// Two points of Gauss.
FaceIn<2> face_of(const Model& model, const BlockFace& face, const Eigen::Matrix2d& map)
{
    const std::vector<Eigen::Vector2d>& corners = model.blocks[face.block].outlines[face.part].vertices;
    const Eigen::Vector2d a = map * corners[face.face], b = map * corners[(face.face + 1) % corners.size()];
    const Eigen::Vector2d along = b - a, off = along / (2 * std::sqrt(3.0));
    const double weight = 0.5 * along.norm() * model.thickness;
    FaceIn<2> result;
    for (const double side : {-1.0, 1.0}) result.points.push_back({0.5 * (a + b) + side * off, weight});
    result.normal = Eigen::Vector2d(along.y(), -along.x()).normalized();
    return result;
}

template <int D>
Eigen::Vector3d middle_of(const Model& model, const BlockFace& face)
{
    const FaceIn<D> drawn = face_of(model, face, MatrixIn<D>(MatrixIn<D>::Identity()));
    VectorIn<D> sum = VectorIn<D>::Zero();
    double area = 0;
    for (const auto& point : drawn.points) {
        sum += point.weight * point.lever;
        area += point.weight;
    }
    return model.blocks[face.block].moments.centroid + to_space(VectorIn<D>(sum / area));
}

template Eigen::Vector3d middle_of<2>(const Model&, const BlockFace&);
template Eigen::Vector3d middle_of<3>(const Model&, const BlockFace&);

}  // namespace voussoir::step
