#include "app/render/extrusion.h"

#include <algorithm>
#include <utility>

namespace voussoir::app::render
{

namespace
{

void close_face(int block, int part, results::SurfaceMesh& mesh)
{
    mesh.face_first.push_back(static_cast<std::int32_t>(mesh.face_vertices.size()));
    mesh.face_block.push_back(block);
    mesh.face_part.push_back(part);
}

/// The loop at y = -half (the front), then the same at y = half.
void add_vertices(const results::SurfaceMesh& outlines, int face, double half, results::SurfaceMesh& mesh)
{
    for (const double y : {-half, half})
        for (int i = outlines.face_first[face]; i < outlines.face_first[face + 1]; ++i) {
            const double* lever = outlines.levers.data() + 2 * outlines.face_vertices[i];
            mesh.levers.insert(mesh.levers.end(), {lever[0], y, lever[1]});
            mesh.vertex_block.push_back(outlines.face_block[face]);
        }
}

void add_prism(const results::SurfaceMesh& outlines, int face, double half, results::SurfaceMesh& mesh)
{
    const int block = outlines.face_block[face], part = outlines.face_part[face];
    const int corners = outlines.face_first[face + 1] - outlines.face_first[face];
    const auto front = static_cast<std::int32_t>(mesh.vertex_block.size()), back = front + corners;
    add_vertices(outlines, face, half, mesh);
    for (int i = 0; i < corners; ++i) mesh.face_vertices.push_back(front + i);
    close_face(block, part, mesh);
    for (int i = corners - 1; i >= 0; --i) mesh.face_vertices.push_back(back + i);
    close_face(block, part, mesh);
    for (int i = 0; i < corners; ++i) {
        const int next = (i + 1) % corners;
        mesh.face_vertices.insert(mesh.face_vertices.end(), {front + next, front + i, back + i, back + next});
        close_face(block, part, mesh);
    }
}

}  // namespace

results::SurfaceMesh extruded(const results::SurfaceMesh& outlines, double thickness)
{
    results::SurfaceMesh mesh;
    mesh.face_first = {0};
    for (int face = 0; face < static_cast<int>(outlines.face_block.size()); ++face)
        add_prism(outlines, face, thickness / 2, mesh);
    const std::size_t blocks = outlines.block_first_vertex.size() - 1;
    for (std::size_t b = 0; b <= blocks; ++b) {
        const auto first =
            std::lower_bound(mesh.vertex_block.begin(), mesh.vertex_block.end(), static_cast<std::int32_t>(b));
        mesh.block_first_vertex.push_back(static_cast<std::int32_t>(first - mesh.vertex_block.begin()));
    }
    return mesh;
}

results::RecordedModel in_space(results::RecordedModel model)
{
    if (model.mesh.dimension == 2) model.mesh = extruded(model.mesh, model.thickness);
    return model;
}

}  // namespace voussoir::app::render
