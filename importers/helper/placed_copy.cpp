#include "importers/helper/placed_copy.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "libdda/errors.h"
#include "libdda/geometry/plane.h"

namespace voussoir::importers::helper
{
namespace
{

void turn_round(std::vector<std::vector<int>>& faces)
{
    for (std::vector<int>& face : faces) std::reverse(face.begin(), face.end());
}

/// What a rotation about y leaves of the other axes' y components.
constexpr double in_plane = 1e-12;

bool leaves_plane(const Eigen::Matrix3d& linear)
{
    const double most = linear.cwiseAbs().maxCoeff();
    const Eigen::Vector4d across(linear(0, 1), linear(2, 1), linear(1, 0), linear(1, 2));
    return across.cwiseAbs().maxCoeff() > in_plane * most;
}

/// @throws InputError for a copy so large, small or far away that its lengths, or products of them, are no numbers
template <class Vector>
void check_size(const std::vector<Vector>& vertices, const std::string& name)
{
    constexpr double huge = 1e100;    // m
    constexpr double rounded = 1e-6;  // of the size, as where vertices are joined
    double largest = 0, size = 0;
    bool finite = true;
    for (const Vector& x : vertices) {
        largest = std::max(largest, x.cwiseAbs().maxCoeff());
        size = std::max(size, (x - vertices.front()).cwiseAbs().maxCoeff());
        finite = finite && x.allFinite();
    }
    const char* found = nullptr;
    if (!finite || largest > huge)
        found = "it is too large or too far away";
    else if (size < 1 / huge)
        found = "nothing is left of its size";
    else if (largest * std::numeric_limits<double>::epsilon() > rounded * size)
        found = "it is so far away that its shape is rounded";
    if (found != nullptr) throw InputError(name, found, "check scale, rotate, move and copy");
}

}  // namespace

PlacedCopy after(const PlacedCopy& second, const PlacedCopy& first)
{
    return {second.linear * first.linear, second.linear * first.offset + second.offset, first.suffix};
}

ConvexPolyhedron placed(ConvexPolyhedron part, const PlacedCopy& copy, const std::string& name)
{
    if (copy.is_as_drawn()) return part;
    for (Eigen::Vector3d& x : part.vertices) x = copy.linear * x + copy.offset;
    check_size(part.vertices, name);
    if (copy.is_mirrored()) turn_round(part.faces);
    ConvexPolyhedron shape = make_convex_polyhedron(std::move(part.vertices), std::move(part.faces), name);
    shape.glued = std::move(part.glued);
    return shape;
}

ConvexPolygon placed(ConvexPolygon outline, const PlacedCopy& copy, const std::string& name)
{
    if (copy.is_as_drawn()) return outline;
    if (leaves_plane(copy.linear))
        throw InputError(name, "turned out of the plane of the scene",
                         "outlines [x, z] can be turned about y only: leave away the axis, or give [0, 1, 0]");
    const Eigen::Matrix2d linear = from_space<2>(copy.linear);
    const Eigen::Vector2d offset = from_space<2>(copy.offset);
    for (Eigen::Vector2d& x : outline.vertices) x = linear * x + offset;
    check_size(outline.vertices, name);
    return make_convex_polygon(std::move(outline.vertices), name);
}

std::vector<mesh::PolygonSurface> placed(std::vector<mesh::PolygonSurface> surfaces,
                                         const std::vector<PlacedCopy>& copies)
{
    if (copies.empty()) return surfaces;
    std::vector<mesh::PolygonSurface> all;
    all.reserve(surfaces.size() * copies.size());
    for (const PlacedCopy& copy : copies)
        for (const mesh::PolygonSurface& surface : surfaces) {
            mesh::PolygonSurface& stone = all.emplace_back(surface);
            stone.name += copy.suffix;
            for (Eigen::Vector3d& x : stone.vertices) x = copy.linear * x + copy.offset;
            if (!copy.is_as_drawn() && !stone.vertices.empty()) check_size(stone.vertices, stone.name);
            if (copy.is_mirrored()) turn_round(stone.faces);
        }
    return all;
}

}  // namespace voussoir::importers::helper
