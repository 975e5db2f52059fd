#include "app/results/surface_mesh.h"

#include <numeric>

namespace voussoir::app::results
{

using Eigen::Vector3d;

namespace
{

/// Of which part of which block a face is.
struct PartOf {
    int block = 0, part = 0;
};

template <int D>
void add_vertices(const std::vector<VectorIn<D>>& levers, int block, SurfaceMesh& mesh)
{
    for (const VectorIn<D>& lever : levers) {
        mesh.levers.insert(mesh.levers.end(), lever.data(), lever.data() + D);
        mesh.vertex_block.push_back(block);
    }
}

void add_face(const std::vector<int>& loop, std::int32_t first_vertex, const PartOf& of, SurfaceMesh& mesh)
{
    for (const int vertex : loop) mesh.face_vertices.push_back(first_vertex + vertex);
    mesh.face_first.push_back(static_cast<std::int32_t>(mesh.face_vertices.size()));
    mesh.face_block.push_back(of.block);
    mesh.face_part.push_back(of.part);
}

void add_part(const ConvexPolyhedron& part, const PartOf& of, SurfaceMesh& mesh)
{
    const auto first = static_cast<std::int32_t>(mesh.vertex_block.size());
    add_vertices<3>(part.vertices, of.block, mesh);
    for (const std::vector<int>& loop : part.faces) add_face(loop, first, of, mesh);
}

void add_part(const ConvexPolygon& outline, const PartOf& of, SurfaceMesh& mesh)
{
    const auto first = static_cast<std::int32_t>(mesh.vertex_block.size());
    add_vertices<2>(outline.vertices, of.block, mesh);
    std::vector<int> loop(outline.vertices.size());
    std::iota(loop.begin(), loop.end(), 0);
    add_face(loop, first, of, mesh);
}

template <class Part>
void add_block(const std::vector<Part>& parts, int block, SurfaceMesh& mesh)
{
    for (std::size_t p = 0; p < parts.size(); ++p) add_part(parts[p], {block, static_cast<int>(p)}, mesh);
}

template <int D>
void place_vertices(const SurfaceMesh& mesh, int block, const PoseIn<D>& pose, std::vector<double>& positions)
{
    using Vector = VectorIn<D>;
    for (int v = mesh.block_first_vertex[block]; v < mesh.block_first_vertex[block + 1]; ++v) {
        const Vector lever(mesh.levers.data() + D * v);
        Eigen::Map<Vector>(positions.data() + D * v) = pose.centroid + pose.map * lever;
    }
}

}  // namespace

SurfaceMesh surface_mesh_of(const Model& model)
{
    SurfaceMesh mesh;
    mesh.dimension = dimension_of(model.kinematics);
    mesh.face_first = {0};
    mesh.block_first_vertex = {0};
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        add_block(model.blocks[b].parts, static_cast<int>(b), mesh);
        add_block(model.blocks[b].outlines, static_cast<int>(b), mesh);
        mesh.block_first_vertex.push_back(static_cast<std::int32_t>(mesh.vertex_block.size()));
    }
    return mesh;
}

std::vector<double> positions_of(const SurfaceMesh& mesh, Kinematics kinematics, const State& state)
{
    std::vector<double> positions(mesh.levers.size());
    for (int b = 0; b + 1 < static_cast<int>(mesh.block_first_vertex.size()); ++b) {
        if (mesh.dimension == 2)
            place_vertices<2>(mesh, b, pose_in<2>(kinematics, state, b), positions);
        else
            place_vertices<3>(mesh, b, pose_of(kinematics, state, b), positions);
    }
    return positions;
}

}  // namespace voussoir::app::results
