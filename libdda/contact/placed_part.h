// Convex parts where they are now.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::contact
{

/// The shape of a part in a scene of D dimensions.
template <int D>
struct ShapeIn;
template <>
struct ShapeIn<3> {
    using Type = ConvexPolyhedron;
    static const std::vector<Type>& of(const Block& block) { return block.parts; }
};
template <>
struct ShapeIn<2> {
    using Type = ConvexPolygon;
    static const std::vector<Type>& of(const Block& block) { return block.outlines; }
};

/// A convex part in world coordinates, with what contact search asks of it. The faces of an outline are its edges:
/// face i runs from vertex i to vertex i + 1.
template <int D>
struct PlacedPartIn {
    int block = 0, part = 0;
    const typename ShapeIn<D>::Type* shape = nullptr;          // topology
    std::vector<VectorIn<D>> vertices;                         // m
    std::vector<VectorIn<D>> normals;                          // unit, outward, per face
    VectorIn<D> lower, upper;                                  // m, bounding box
    PoseIn<D> pose{VectorIn<D>::Zero(), MatrixIn<D>::Zero()};  // of the block, where all this is
    double size = 0;                                           // m, D-th root of the reference volume or area

    /// Largest direction . x over the vertices [m].
    double support(const VectorIn<D>& direction) const
    {
        double most = direction.dot(vertices.front());
        for (const VectorIn<D>& x : vertices) most = std::max(most, direction.dot(x));
        return most;
    }
};

using PlacedPart = PlacedPartIn<3>;
using PlacedOutline = PlacedPartIn<2>;

/// Area of a face [m2], length of an edge [m].
double face_measure(const PlacedPart& part, int face);
double face_measure(const PlacedOutline& part, int edge);

/// All parts of all blocks, in order of block and part. Reuses the memory of `parts`; those of blocks that have
/// not moved since stay as they are. The shapes of a model do not change while it runs.
template <int D>
void place_parts(const Model& model, const State& state, int threads, std::vector<PlacedPartIn<D>>& parts);

}  // namespace voussoir::contact
