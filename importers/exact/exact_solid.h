// A closed surface that stays exact however often it is cut, and the convex hull of points (CGAL).
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace voussoir
{

/// A closed triangle surface in plain doubles.
struct TriangleSurface {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<Eigen::Vector3i> triangles;  // counter-clockwise from outside
};

/// The plane through three points, exactly; its front is the side from which they run counter-clockwise.
using ExactPlane = std::array<Eigen::Vector3d, 3>;

/// One connected solid whose vertices are exact numbers.
class ExactSolid
{
 public:
    /// @pre closed, oriented outward, not crossing itself; cavities may be surfaces of their own that point inward
    explicit ExactSolid(const TriangleSurface& surface);
    ~ExactSolid();
    ExactSolid(ExactSolid&&) noexcept;
    ExactSolid& operator=(ExactSolid&&) noexcept;

    TriangleSurface rounded() const;

    struct Halves {
        std::vector<ExactSolid> behind, before;  // each connected piece for itself
    };
    /// Both sides of a plane. Nothing when the plane misses the solid, or when a side would be no manifold surface
    /// (pieces that touch in an edge or a vertex only).
    std::optional<Halves> cut(const ExactPlane& plane) const;

 private:
    struct Content;
    explicit ExactSolid(std::unique_ptr<Content> content);
    std::unique_ptr<Content> content_;
};

/// The convex hull of points, vertices that are no corners left out; no triangles when the points lie in a plane.
TriangleSurface convex_hull(const std::vector<Eigen::Vector3d>& points);

}  // namespace voussoir
