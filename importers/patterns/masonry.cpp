#include "importers/patterns/masonry.h"

namespace voussoir::importers::patterns
{
namespace
{

/// Counter-clockwise from outside, with the corners numbered as MasonryBlock has them.
const std::vector<std::vector<int>> box_faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};

}  // namespace

mesh::PolygonSurface to_surface(const MasonryBlock& block)
{
    return {block.name, {block.corners.begin(), block.corners.end()}, box_faces};
}

ConvexPolyhedron to_polyhedron(const MasonryBlock& block)
{
    return make_convex_polyhedron({block.corners.begin(), block.corners.end()}, box_faces, block.name);
}

}  // namespace voussoir::importers::patterns
