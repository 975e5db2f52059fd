#include "app/results/surface_mesh.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

void add_part(const ConvexPolyhedron& part, int block, int part_index, SurfaceMesh& mesh)
{
    const auto first = static_cast<std::int32_t>(mesh.vertex_block.size());
    for (const Vector3d& lever : part.vertices) {
        mesh.levers.insert(mesh.levers.end(), lever.data(), lever.data() + 3);
        mesh.vertex_block.push_back(block);
    }
    for (const std::vector<int>& loop : part.faces) {
        for (const int vertex : loop) mesh.face_vertices.push_back(first + vertex);
        mesh.face_first.push_back(static_cast<std::int32_t>(mesh.face_vertices.size()));
        mesh.face_block.push_back(block);
        mesh.face_part.push_back(part_index);
    }
}

}  // namespace

SurfaceMesh surface_mesh_of(const Model& model)
{
    SurfaceMesh mesh;
    mesh.face_first = {0};
    mesh.block_first_vertex = {0};
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const std::vector<ConvexPolyhedron>& parts = model.blocks[b].parts;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            add_part(parts[p], static_cast<int>(b), static_cast<int>(p), mesh);
        }
        mesh.block_first_vertex.push_back(static_cast<std::int32_t>(mesh.vertex_block.size()));
    }
    return mesh;
}

std::vector<double> positions_of(const SurfaceMesh& mesh, Kinematics kinematics, const State& state)
{
    std::vector<double> positions(mesh.levers.size());
    for (std::size_t b = 0; b + 1 < mesh.block_first_vertex.size(); ++b) {
        const Pose pose = pose_of(kinematics, state, static_cast<int>(b));
        for (int v = mesh.block_first_vertex[b]; v < mesh.block_first_vertex[b + 1]; ++v) {
            const Vector3d lever(mesh.levers.data() + 3 * v);
            Eigen::Map<Vector3d>(positions.data() + 3 * v) = pose.centroid + pose.map * lever;
        }
    }
    return positions;
}

Vector3d ground_displacement(const Model& model, const State& state)
{
    Vector3d sum = Vector3d::Zero(), count = Vector3d::Zero();
    for (const Foundation& foundation : model.foundations) {
        const Vector3d moved = pose_of(model.kinematics, state, foundation.block).centroid -
                               model.blocks[foundation.block].moments.centroid;
        for (int axis = 0; axis < 3; ++axis) {
            if (!foundation.translation_held[axis]) continue;
            sum[axis] += moved[axis];
            count[axis] += 1;
        }
    }
    return sum.cwiseQuotient(count.cwiseMax(1));
}

}  // namespace voussoir
