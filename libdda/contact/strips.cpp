#include "libdda/contact/strips.h"

#include <algorithm>
#include <limits>

#include "libdda/geometry/extent.h"

namespace voussoir::contact
{

namespace
{

using Eigen::Vector3d;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double opposite = -0.99;  // cosine: two sides of a strip, within 8 degrees
// A strip is as high as its stone is pressed in at the edge ahead; joints further back may be pressed in less.
constexpr double hardly_wider = 2;

/// A side of a contact polygon: its direction, as the polygon is walked round, and whose edge it is.
struct Side {
    Vector3d along;  // unit
    bool of_incident = false;
};

/// Sides without length are left out.
std::vector<Side> sides_of(const Model& model, const ContactPatch& patch, std::span<const ContactPoint> points)
{
    const std::size_t own_edges = model.blocks[patch.block_a].parts[patch.part_a].faces[patch.feature_a].size();
    std::vector<Side> sides;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d along = points[(i + 1) % points.size()].position - points[i].position;
        // The lower half of a label is the edge that leaves the corner: the incident face's own ones come first.
        if (along.squaredNorm() > 0)
            sides.push_back({along.normalized(), (points[i].feature & 0xffff) < own_edges});
    }
    return sides;
}

}  // namespace

double strip_width(const Model& model, const ContactPatch& patch, std::span<const ContactPoint> all_points)
{
    if (patch.edge_edge) return infinite;
    const std::span<const ContactPoint> points = corners_of(all_points);
    double width = infinite;
    const std::vector<Side> sides = sides_of(model, patch, points);
    for (const Side& own : sides)
        for (const Side& other : sides) {
            if (!own.of_incident || other.of_incident || own.along.dot(other.along) > opposite) continue;
            const Vector3d across = patch.normal.cross(own.along).normalized();
            width = std::min(width, extent_along(across, points, &ContactPoint::position));
        }
    return width;
}

/// Of a segment: its ends are the incident edge's own, 0 and 1, or where the reference edge ends, 2 and 3.
double strip_width(const Model&, const ContactPatchIn<2>&, std::span<const ContactPointIn<2>> points)
{
    const bool first_is_own = points[0].feature < 2, second_is_own = points[1].feature < 2;
    return first_is_own == second_is_own ? infinite : (points[1].position - points[0].position).norm();
}

template <int D>
void Strips<D>::find_depths()
{
    depths_.assign(model_.blocks.size(), 0);
    for (const ContactPatchIn<D>& patch : contacts_.patches) {
        const auto points = std::span(contacts_.points).subspan(patch.first_point, patch.point_count);
        double depth = 0;
        for (const ContactPointIn<D>& point : points) depth = std::max(depth, -(point.gap + point.rest_gap));
        if (depth <= std::min(depths_[patch.block_a], depths_[patch.block_b])) continue;
        depth = std::min(depth, strip_width(model_, patch, points));
        for (const int block : {patch.block_a, patch.block_b}) depths_[block] = std::max(depths_[block], depth);
    }
    for (const Foundation& foundation : model_.foundations)
        if (foundation.fully_held()) depths_[foundation.block] = 0;
}

template <int D>
bool Strips<D>::is_of_yielding(const ContactPatchIn<D>& patch)
{
    const auto points = std::span(contacts_.points).subspan(patch.first_point, patch.point_count);
    const double width = strip_width(model_, patch, points);
    if (width == infinite) return false;
    if (depths_.empty()) find_depths();
    return width <= hardly_wider * std::max(depths_[patch.block_a], depths_[patch.block_b]);
}

template class Strips<3>;
template class Strips<2>;

}  // namespace voussoir::contact
