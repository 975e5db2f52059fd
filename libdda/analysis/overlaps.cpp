#include "libdda/analysis/overlaps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "libdda/contact/contact_history.h"
#include "libdda/geometry/extent.h"

namespace voussoir
{

namespace
{

using Eigen::Vector3d;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double opposite = -0.99;  // cosine: two sides of a strip, within 8 degrees

double least_width_of(const ConvexPolyhedron& part)
{
    double least = infinite;
    for (int face = 0; face < static_cast<int>(part.faces.size()); ++face)
        least = std::min(least, extent_along(face_normal(part, face), part.vertices));
    return least;
}

double least_width_of(const ConvexPolygon& outline)
{
    double least = infinite;
    for (std::size_t i = 0; i < outline.vertices.size(); ++i) {
        const Eigen::Vector2d side = outline.vertices[(i + 1) % outline.vertices.size()] - outline.vertices[i];
        if (side.norm() > 0)
            least = std::min(
                least, extent_along(Eigen::Vector2d(-side.y(), side.x()).normalized().eval(), outline.vertices));
    }
    return least;
}

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

/// Width of the strip that a contact is, between an edge of either stone [m]; infinite when it is none.
double strip_width(const Model& model, const ContactPatch& patch, std::span<const ContactPoint> points)
{
    if (patch.edge_edge) return infinite;
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
void look_for_overlap(const Model& model, const ContactSetIn<D>& contacts, const std::vector<double>& widths,
                      double time, RunReport& report)
{
    DeepestOverlap& deepest = report.deepest;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const double width = std::min(widths[patch.block_a], widths[patch.block_b]);
        const auto points = std::span(contacts.points).subspan(patch.first_point, patch.point_count);
        for (const ContactPointIn<D>& point : points) {
            double depth = contact::depth_beyond_fit(model, point);
            if (depth <= report.max_penetration && depth <= deepest.share * width) continue;
            depth = std::min(depth, strip_width(model, patch, points));
            report.max_penetration = std::max(report.max_penetration, depth);
            if (depth <= deepest.share * width) continue;
            const double free_of_stress = std::max(0.0, -point.rest_gap - model.fit_tolerance);
            const double forgiven = std::min(free_of_stress, depth);
            deepest = {depth / width, depth, forgiven, time, patch.block_a, patch.block_b};
        }
    }
}

}  // namespace

std::vector<double> least_widths(const Model& model)
{
    std::vector<double> widths;
    for (const Block& block : model.blocks) {
        double least = infinite;
        for (const ConvexPolyhedron& part : block.parts) least = std::min(least, least_width_of(part));
        for (const ConvexPolygon& outline : block.outlines) least = std::min(least, least_width_of(outline));
        widths.push_back(least);
    }
    return widths;
}

void note_overlap(const Model& model, const std::vector<double>& widths, const State& state, RunReport& report)
{
    look_for_overlap(model, state.contacts, widths, state.time, report);
    look_for_overlap(model, state.planar_contacts, widths, state.time, report);
}

}  // namespace voussoir
