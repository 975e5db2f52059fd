#include "libdda/analysis/overlaps.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "libdda/contact/contact_history.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/contact/strips.h"

namespace voussoir
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;  // of the smaller block's size

/// Extent of all parts along a direction [m].
template <class Part, class Direction>
double extent_of(const std::vector<Part>& parts, const Direction& direction)
{
    double low = infinite, high = -infinite;
    for (const Part& part : parts)
        for (const Direction& vertex : part.vertices) {
            low = std::min(low, direction.dot(vertex));
            high = std::max(high, direction.dot(vertex));
        }
    return high - low;
}

double least_width_of(const std::vector<ConvexPolyhedron>& parts)
{
    double least = infinite;
    for (const ConvexPolyhedron& part : parts)
        for (int face = 0; face < static_cast<int>(part.faces.size()); ++face)
            if (!part.is_glued(face)) least = std::min(least, extent_of(parts, face_normal(part, face)));
    return least;
}

double least_width_of(const std::vector<ConvexPolygon>& outlines)
{
    double least = infinite;
    for (const ConvexPolygon& outline : outlines)
        for (std::size_t i = 0; i < outline.vertices.size(); ++i) {
            const Eigen::Vector2d side = outline.vertices[(i + 1) % outline.vertices.size()] - outline.vertices[i];
            if (side.norm() > 0)
                least =
                    std::min(least, extent_of(outlines, Eigen::Vector2d(-side.y(), side.x()).normalized().eval()));
        }
    return least;
}

/// How deep a corner of a patch is in the other block beyond the fit [m]; @param enough smaller depths may be
/// larger than they are
template <int D>
double depth_at(const Model& model, const ContactPatchIn<D>& patch, const ContactPointIn<D>& point,
                std::span<const ContactPointIn<D>> points, double enough)
{
    const double depth = contact::depth_beyond_fit(model, point);
    return depth <= enough ? depth : std::min(depth, contact::strip_width(model, patch, points));
}

template <int D>
void look_for_overlap(const Model& model, const ContactSetIn<D>& contacts, const OverlapWatch& watch, double time,
                      RunReport& report)
{
    DeepestOverlap& deepest = report.deepest;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const double width = std::min(watch.widths[patch.block_a], watch.widths[patch.block_b]);
        const auto points = std::span(contacts.points).subspan(patch.first_point, patch.point_count);
        for (const ContactPointIn<D>& point : points) {
            const double enough = std::min(report.max_penetration, deepest.share * width);
            const double depth = depth_at<D>(model, patch, point, points, enough);
            report.max_penetration = std::max(report.max_penetration, depth);
            if (depth <= deepest.share * width) continue;
            const double free_of_stress = std::max(0.0, -point.rest_gap - model.fit_tolerance);
            const auto drawn = watch.drawn.find(std::minmax(patch.block_a, patch.block_b));
            deepest = {depth / width, depth, std::min(free_of_stress, depth), time, patch.block_a,
                       patch.block_b, 0};
            if (drawn != watch.drawn.end()) deepest.drawn = std::min(depth, drawn->second);
        }
    }
}

using Pair = std::pair<int, int>;

template <int D>
void add_drawn(const Model& model, const ContactSetIn<D>& contacts, std::map<Pair, double>& depths)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const auto points = std::span(contacts.points).subspan(patch.first_point, patch.point_count);
        double deepest = 0;
        for (const ContactPointIn<D>& point : points)
            deepest = std::max(deepest, depth_at<D>(model, patch, point, points, deepest));
        if (deepest <= rounding * std::min(size_of(model, patch.block_a), size_of(model, patch.block_b))) continue;
        double& depth = depths[std::minmax(patch.block_a, patch.block_b)];
        depth = std::max(depth, deepest);
    }
}

/// Deepest overlap of each pair of blocks at the start [m].
std::map<Pair, double> depths_in(const Model& model, State start)
{
    find_initial_contacts(model, start);
    std::map<Pair, double> depths;
    add_drawn(model, start.contacts, depths);
    add_drawn(model, start.planar_contacts, depths);
    return depths;
}

}  // namespace

std::vector<double> least_widths(const Model& model)
{
    const bool planar = is_planar(model.kinematics);
    std::vector<double> widths;
    for (const Block& block : model.blocks)
        widths.push_back(planar ? least_width_of(block.outlines) : least_width_of(block.parts));
    return widths;
}

std::vector<DrawnOverlap> drawn_overlaps(const OverlapWatch& watch)
{
    std::vector<DrawnOverlap> overlaps;
    for (const auto& [pair, depth] : watch.drawn) {
        const double width = std::min(watch.widths[pair.first], watch.widths[pair.second]);
        overlaps.push_back({pair.first, pair.second, depth, depth / width});
    }
    return overlaps;
}

OverlapWatch::OverlapWatch(const Model& model) : OverlapWatch(model, initial_state(model)) {}

OverlapWatch::OverlapWatch(const Model& model, State start)
    : widths(least_widths(model)), drawn(depths_in(model, std::move(start)))
{
}

void note_overlap(const Model& model, const OverlapWatch& watch, const State& state, RunReport& report)
{
    look_for_overlap(model, state.contacts, watch, state.time, report);
    look_for_overlap(model, state.planar_contacts, watch, state.time, report);
}

}  // namespace voussoir
