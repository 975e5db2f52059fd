// Where stones stand that a file or a pattern drew elsewhere: scaled, mirrored, turned and moved, more than once.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"
#include "libdda/geometry/convex_polygon.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::helper
{

/// One of the places of what is drawn once: x -> linear x + offset.
struct PlacedCopy {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();  // -, invertible: scale, mirror and rotation
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();      // m
    std::string suffix;                                    // of the names of its stones

    /// Nothing is moved, to the last bit.
    bool is_as_drawn() const { return linear.isIdentity(0) && offset.isZero(0); }
    /// Left becomes right: faces have to be turned round.
    bool is_mirrored() const { return linear.determinant() < 0; }
};

/// What `first` and then `second` do to a stone; the suffix is that of `first`.
PlacedCopy after(const PlacedCopy& second, const PlacedCopy& first);

/// A convex part in its place; the same bits when it is placed as drawn. Marks of glued faces stay with their
/// faces.
/// @param name of the stone @throws InputError when no shape with a volume remains, or its size is no number
ConvexPolyhedron placed(ConvexPolyhedron part, const PlacedCopy& copy, const std::string& name);

/// An outline of a planar scene in its place. @throws InputError likewise, and when the copy leaves the plane
ConvexPolygon placed(ConvexPolygon outline, const PlacedCopy& copy, const std::string& name);

/// All surfaces of a file [m, z up] in all their places, copy by copy; as they are if `copies` is empty.
/// @throws InputError when the size of one of them is no number
std::vector<mesh::PolygonSurface> placed(std::vector<mesh::PolygonSurface> surfaces,
                                         const std::vector<PlacedCopy>& copies);

}  // namespace voussoir::importers::helper
