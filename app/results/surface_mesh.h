// The faces of all blocks as one mesh: what results.h5 stores once and every picture draws.
#pragma once

#include <cstdint>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::app::results
{

/// Vertices of all convex parts of all blocks, block after block; faces as loops into them. The faces of a planar
/// scene are its outlines, counter-clockwise with x to the right and z up.
struct SurfaceMesh {
    int dimension = 3;                             // 2: vertices have x and z
    std::vector<double> levers;                    // (vertices x dimension) m, relative to the centroid
    std::vector<std::int32_t> vertex_block;        // (vertices)
    std::vector<std::int32_t> block_first_vertex;  // (blocks + 1): vertices of block b are [b], ..., [b + 1] - 1
    std::vector<std::int32_t> face_first;          // (faces + 1): loop of face f in face_vertices
    std::vector<std::int32_t> face_vertices;       // counter-clockwise from outside
    std::vector<std::int32_t> face_block;          // (faces)
    std::vector<std::int32_t> face_part;           // (faces) which convex part of the block
};

SurfaceMesh surface_mesh_of(const Model& model);

/// Places of all vertices in a state, x = c + A X. @returns (vertices x dimension of the mesh) m, relative to the
/// model's origin
std::vector<double> positions_of(const SurfaceMesh& mesh, Kinematics kinematics, const State& state);

}  // namespace voussoir::app::results
