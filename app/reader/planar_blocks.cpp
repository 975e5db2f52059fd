#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/reader/block_reading.h"
#include "libdda/geometry/plane.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector2d;

constexpr double same_depth = 1e-6;  // of the depth

/// Extent along y, in the user's coordinates.
DrawnDepth depth_of(const std::string& stone, const ConvexPolyhedron& part, const BlockReading& reading)
{
    DrawnDepth depth{INFINITY, -INFINITY, stone};
    for (const Eigen::Vector3d& vertex : part.vertices) {
        depth.low = std::min(depth.low, vertex.y() + reading.mesh_origin.y());
        depth.high = std::max(depth.high, vertex.y() + reading.mesh_origin.y());
    }
    return depth;
}

std::string in_words(const DrawnDepth& depth)
{
    return fmt::format("from y = {:.10g} m to {:.10g} m", depth.low, depth.high);
}

/// All drawn stones reach as far along y as the first one; another extent is a fault.
void check_depth(const DrawnDepth& depth, const std::string& place, BlockReading& reading)
{
    if (!reading.depth) reading.depth = depth;
    const DrawnDepth& first = *reading.depth;
    const double apart = std::max(std::abs(depth.low - first.low), std::abs(depth.high - first.high));
    if (apart <= same_depth * (first.high - first.low)) return;
    reading.findings.faults.push_back(
        {place, fmt::format("{}, but {} {}", in_words(depth), first.stone, in_words(first)),
         "all stones of a planar scene must have the same extent along y; change them, or use polygons [x, z]"});
}

/// Makes an outline; what is wrong with it becomes a fault at `place`.
std::optional<ConvexPolygon> outline_from(std::vector<Vector2d> corners, const std::string& place,
                                          Findings& findings)
{
    try {
        return make_convex_polygon(std::move(corners), place);
    } catch (const InputError& error) {
        findings.faults.insert(findings.faults.end(), error.faults.begin(), error.faults.end());
        return std::nullopt;
    }
}

/// `rotate: {angle: 45 deg, about: [0, 0]}`, from x to z; about the box's centre if `about` is not given.
void rotate_corners(YamlCursor& rotate, const Vector2d& centre, std::vector<Vector2d>& corners)
{
    if (!rotate.expect_map("a rotation {angle: 45 deg, about: [x, z]}")) return;
    rotate.forbid("axis", "a box with corners [x, z] is rotated in the plane, from x to z");
    Vector2d about = centre;
    const double angle = rotate.quantity("angle", words::dimension::angle, words::Range::any());
    if (const auto value = rotate.find("about"))
        about = value->as_plane_vector(words::dimension::length);
    else
        rotate.took_default("about", "the centre of the box");
    rotate.reject_unknown_keys();
    const Eigen::Rotation2Dd rotation(angle);
    for (Vector2d& corner : corners) corner = about + rotation * (corner - about);
}

Vector2d read_flat_corner(YamlCursor& box, const std::string& key)
{
    const auto value = box.require(key, "the " + key + " corner [x, z]");
    return value ? value->as_plane_vector(words::dimension::length) : Vector2d::Constant(std::nan(""));
}

}  // namespace

std::vector<ConvexPolygon> outlines_of(const std::string& name, const std::string& place,
                                       const std::vector<ConvexPolyhedron>& parts, BlockReading& reading)
{
    std::vector<ConvexPolygon> outlines;
    for (const ConvexPolyhedron& part : parts) {
        try {
            double depth = 0;
            outlines.push_back(outline_of(part, depth, place));
        } catch (const InputError& error) {
            reading.findings.faults.insert(reading.findings.faults.end(), error.faults.begin(),
                                           error.faults.end());
            return {};
        }
        check_depth(depth_of(name, part, reading), place, reading);
    }
    return outlines;
}

void read_flat_box(YamlCursor& entry, YamlCursor& box, BlockReading& reading)
{
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = box.text("name", "the block's name");
    const Vector2d lower = read_flat_corner(box, "lower"), upper = read_flat_corner(box, "upper");
    if ((upper.array() <= lower.array()).any()) box.fault("no area", "upper must exceed lower in x and z");
    std::vector<Vector2d> corners = {lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}};
    if (std::optional<YamlCursor> rotate = box.find("rotate"))
        rotate_corners(*rotate, (lower + upper) / 2, corners);
    box.reject_unknown_keys();
    Belonging belonging = read_belonging(entry, reading.model, true);
    entry.reject_unknown_keys();
    if (reading.findings.faults.size() > faults_before) return;
    if (auto outline = outline_from(std::move(corners), box.place(), reading.findings))
        add_stones({{name, {}, {std::move(*outline)}}}, box, std::move(belonging), "the block is named " + name,
                   reading);
}

void read_polygon(YamlCursor& entry, YamlCursor& polygon, BlockReading& reading)
{
    if (!is_planar(reading.model.kinematics))
        return polygon.fault("a polygon in a spatial scene",
                             "use a box or a mesh, or set kinematics: planar_rigid or planar_deformable");
    if (!polygon.expect_map("a polygon {name, corners: [[x, z], ...]}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = polygon.text("name", "the block's name");
    std::vector<Vector2d> corners;
    if (const auto list = polygon.require("corners", "the outline [[x, z], ...]"))
        for (const YamlCursor& corner : list->items("an outline [[x, z], ...]"))
            corners.push_back(corner.as_plane_vector(words::dimension::length));
    polygon.reject_unknown_keys();
    Belonging belonging = read_belonging(entry, reading.model, true);
    entry.reject_unknown_keys();
    if (reading.findings.faults.size() > faults_before) return;
    if (auto outline = outline_from(std::move(corners), polygon.place(), reading.findings))
        add_stones({{name, {}, {std::move(*outline)}}}, polygon, std::move(belonging),
                   "the block is named " + name, reading);
}

std::optional<double> read_thickness(YamlCursor& top, Kinematics kinematics)
{
    if (is_planar(kinematics))
        return top.find_quantity("thickness", words::dimension::length, words::Range::positive());
    top.forbid("thickness", "it belongs to planar scenes");
    return std::nullopt;
}

void settle_thickness(const YamlCursor& top, std::optional<double> thickness, BlockReading& reading)
{
    if (!is_planar(reading.model.kinematics)) return;
    const double drawn = reading.depth ? reading.depth->high - reading.depth->low : 1;
    if (!thickness)
        top.took_default("thickness", fmt::format("{:g} m{}", drawn,
                                                  reading.depth ? ", the extent of the stones along y" : ""));
    set_thickness(reading.model, thickness.value_or(drawn));
}

}  // namespace voussoir::app::reader
