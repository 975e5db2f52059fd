// Which blocks make a joint, and over which area.
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "libdda/analysis/joint_openings.h"
#include "libdda/contact/find_contacts.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/contact/narrow_phase.h"
#include "libdda/contact/normal_stiffness.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

using Corners = std::vector<contact::PolygonPoint>;

Vector3d outward(const ConvexPolyhedron& part, std::uint32_t face)
{
    return face_normal(part, static_cast<int>(face));
}

Vector3d outward(const ConvexPolygon& outline, std::uint32_t edge)
{
    const Eigen::Vector2d along = outline.vertices[(edge + 1) % outline.vertices.size()] - outline.vertices[edge];
    return to_space(Eigen::Vector2d(along.y(), -along.x())).normalized();
}

template <int D>
Corners drawn_corners(const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
{
    Corners corners;
    for (const ContactPointIn<D>& point : corners_of(contacts, patch))
        corners.push_back({to_space(point.position), point.gap + point.rest_gap, point.area, 0});
    return corners;
}

/// What of a polygon, or of a segment, is not further apart than `distance`: the gap is linear over it.
template <int D>
Corners nearer_than(double distance, const Corners& all)
{
    Corners kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const contact::PolygonPoint &here = all[i], &next = all[(i + 1) % all.size()];
        if (here.gap <= distance) kept.push_back(here);
        const bool is_end = D == 2 && i + 1 == all.size();
        if (is_end || (here.gap <= distance) == (next.gap <= distance)) continue;
        const double share = (distance - here.gap) / (next.gap - here.gap);
        kept.push_back({here.position + share * (next.position - here.position), distance, 0, 0});
    }
    return kept;
}

/// Gives the corners of what was cut their tributary areas; what has no extent is none. @param depth across a
/// planar scene [m]
template <int D>
void share_area(const Vector3d& normal, double depth, Corners& corners)
{
    if (corners.size() < D) return corners.clear();
    if constexpr (D == 3) {
        contact::assign_tributary_areas(corners, normal);
    } else {
        for (contact::PolygonPoint& end : corners)
            end.area = 0.5 * depth * (corners[1].position - corners[0].position).norm();
    }
}

double area_of(const Corners& corners)
{
    double area = 0;
    for (const contact::PolygonPoint& corner : corners) area += corner.area;
    return area;
}

/// One block's side of a patch, where the run begins.
struct Side {
    const PlacedBlock& block;
    Vector3d reference_normal, normal;  // unit, outward: in the reference shape, at the start

    Vector3d lever(const Vector3d& place) const
    {
        return block.pose.map.inverse() * (place - block.pose.centroid);
    }
};

template <int D>
Side side_of(const Model& model, const std::vector<PlacedBlock>& blocks, int block, int part, std::uint32_t face)
{
    const Vector3d normal = outward(contact::ShapeIn<D>::of(model.blocks[block])[part], face);
    return {blocks[block], normal, (blocks[block].turn * normal).normalized()};
}

/// @param incident the block that the corners lie on; @param reference the other one
/// @param swapped whether the incident block is the joint's second
FacingPatch facing_patch(const Side& incident, const Side& reference, bool swapped, const Corners& corners)
{
    const Vector3d normal = (reference.normal - incident.normal).normalized();
    const double slant = normal.dot(reference.normal);
    FacingPatch patch{incident.reference_normal, reference.reference_normal, {}};
    if (swapped) std::swap(patch.normal_a, patch.normal_b);
    for (const contact::PolygonPoint& corner : corners) {
        // Along the mean normal, so that nothing has slid at the start.
        const double start = corner.gap / slant;
        FacingPoint point{incident.lever(corner.position), reference.lever(corner.position - start * normal),
                          start, corner.area};
        if (swapped) std::swap(point.on_a, point.on_b);
        patch.points.push_back(point);
    }
    return patch;
}

void add_patch(FacingPatch patch, const Vector3d& normal, const Corners& corners, WatchedJoint& joint)
{
    for (const contact::PolygonPoint& corner : corners) {
        joint.facing_area += corner.area;
        joint.centre += corner.area * corner.position;
        joint.normal += corner.area * normal;
    }
    joint.patches.push_back(std::move(patch));
}

template <int D>
void collect(const Model& model, const std::vector<PlacedBlock>& blocks, const ContactSetIn<D>& contacts,
             std::map<std::pair<int, int>, WatchedJoint>& joints)
{
    for (const ContactPatchIn<D>& found : contacts.patches) {
        if (found.edge_edge) continue;
        const Side incident = side_of<D>(model, blocks, found.block_a, found.part_a, found.feature_a),
                   reference = side_of<D>(model, blocks, found.block_b, found.part_b, found.feature_b);
        if (incident.normal.dot(reference.normal) > -std::cos(facing_angle)) continue;
        const Corners all = drawn_corners(contacts, found);
        Corners corners = nearer_than<D>(touching_distance(model, found.block_a, found.block_b), all);
        share_area<D>(reference.normal, contact::depth_of<D>(model), corners);
        if (area_of(corners) <= 0) continue;
        const bool swapped = found.block_a > found.block_b;
        WatchedJoint& joint = joints[std::minmax(found.block_a, found.block_b)];
        for (const ContactPointIn<D>& point : points_of(contacts, found)) joint.area += point.area;
        joint.bonded = joint.bonded || found.intact;
        const Vector3d normal = (swapped ? -1 : 1) * (reference.normal - incident.normal).normalized();
        add_patch(facing_patch(incident, reference, swapped, corners), normal, corners, joint);
    }
}

}  // namespace

double touching_distance(const Model& model, int block_a, int block_b)
{
    return std::max(contact::contact_distance * (size_of(model, block_a) + size_of(model, block_b)),
                    model.fit_tolerance);
}

std::vector<WatchedJoint> joints_at_start(const Model& model, const State& start)
{
    State touching = start;
    find_initial_contacts(model, touching);
    const std::vector<PlacedBlock> blocks = placed_blocks(model, start);
    std::map<std::pair<int, int>, WatchedJoint> joints;
    if (is_planar(model.kinematics))
        collect(model, blocks, touching.planar_contacts, joints);
    else
        collect(model, blocks, touching.contacts, joints);
    std::vector<WatchedJoint> result;
    result.reserve(joints.size());
    for (auto& [pair, joint] : joints) {
        joint.block_a = pair.first;
        joint.block_b = pair.second;
        joint.centre /= joint.facing_area;
        joint.normal.normalize();
        result.push_back(std::move(joint));
    }
    return result;
}

}  // namespace voussoir
