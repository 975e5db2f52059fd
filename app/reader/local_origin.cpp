#include "app/reader/local_origin.h"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "libdda/geometry/plane.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr double plain_distance = 1e4;  // m: nearer than that doubles keep 2e-12 m
constexpr double rounded_share = 1e-6;  // of a stone's size
constexpr double half_unit = std::numeric_limits<double>::epsilon() / 2;

/// Of the corners, about the centroid [m].
AlignedBox3d shape_of(const Block& block)
{
    AlignedBox3d box;
    for (const ConvexPolyhedron& part : block.parts)
        for (const Vector3d& vertex : part.vertices) box.extend(vertex);
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices) box.extend(to_space(vertex));
    return box;
}

/// Of all corners [m], model coordinates.
AlignedBox3d extent_of(const Model& model)
{
    AlignedBox3d extent;
    for (const Block& block : model.blocks) {
        const AlignedBox3d shape = shape_of(block);
        extent.extend(Vector3d(block.moments.centroid + shape.min()));
        extent.extend(Vector3d(block.moments.centroid + shape.max()));
    }
    return extent;
}

void refuse_rounded_stones(BlockReading& reading)
{
    const Model& model = reading.model;
    for (const Block& block : model.blocks) {
        const AlignedBox3d shape = shape_of(block);
        const Vector3d place = block.moments.centroid + model.origin;
        const double farthest =
            std::max((place + shape.min()).cwiseAbs().maxCoeff(), (place + shape.max()).cwiseAbs().maxCoeff());
        if (!(half_unit * farthest > rounded_share * shape.sizes().maxCoeff())) continue;
        reading.findings.faults.push_back(
            {reading.places.at(block.name) + ": " + block.name,
             fmt::format("{:.3g} m from the origin of coordinates, where they are rounded by up to {:.2g} m, more "
                         "than a millionth of its size",
                         farthest, half_unit * farthest),
             "count the coordinates from a place nearer to the structure"});
        return;  // the others are there, too
    }
}

/// A stone so long that its corners, counted from its middle, are rounded by more than a millionth of another
/// stone.
void refuse_stone_beyond_all(BlockReading& reading)
{
    const auto size = [](const Block& block) { return shape_of(block).sizes().maxCoeff(); };
    const bool all_finite = std::all_of(reading.model.blocks.begin(), reading.model.blocks.end(),
                                        [](const Block& block) { return std::isfinite(block.moments.volume); });
    if (!all_finite) return;  // others tell of that
    const auto [small, large] =
        std::minmax_element(reading.model.blocks.begin(), reading.model.blocks.end(),
                            [&](const Block& a, const Block& b) { return size(a) < size(b); });
    const double rounding = half_unit * size(*large) / 2;
    if (!(rounding > rounded_share * size(*small)) || !reading.findings.faults.empty()) return;
    reading.findings.faults.push_back(
        {reading.places.at(large->name) + ": " + large->name,
         fmt::format(
             "{:.3g} m long, so that its corners are rounded by up to {:.2g} m, more than a millionth of the "
             "size of {}",
             size(*large), rounding, small->name),
         "check the unit of its coordinates; ground need not reach farther than the structure"});
}

}  // namespace

double coordinate_rounding(const Model& model)
{
    const AlignedBox3d extent = extent_of(model);
    if (extent.isEmpty()) return 0;
    return half_unit * std::max((extent.min() + model.origin).cwiseAbs().maxCoeff(),
                                (extent.max() + model.origin).cwiseAbs().maxCoeff());
}

double rounded_misfit(const Model& model)
{
    constexpr double roundings = 8;  // of a corner that is placed and turned, on both sides
    return model.origin.isZero(0) ? 0 : roundings * coordinate_rounding(model);
}

void settle_origin(BlockReading& reading)
{
    Model& model = reading.model;
    const AlignedBox3d extent = extent_of(model);
    if (extent.isEmpty() || !extent.sizes().allFinite()) return;
    refuse_rounded_stones(reading);
    refuse_stone_beyond_all(reading);
    if (!model.origin.isZero(0)) return;  // meshes far away have set it
    const Vector3d middle = (0.5 * extent.min() + 0.5 * extent.max()).array().round();
    if (middle.cwiseAbs().maxCoeff() <= std::max(plain_distance, extent.sizes().maxCoeff())) return;
    model.origin = is_planar(model.kinematics) ? to_space(from_space<2>(middle)) : middle;
    for (Block& block : model.blocks) block.moments.centroid -= model.origin;
}

}  // namespace voussoir::app::reader
