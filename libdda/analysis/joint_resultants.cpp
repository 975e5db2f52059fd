#include "libdda/analysis/joint_resultants.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "libdda/analysis/edge_stress.h"
#include "libdda/contact/placed_part.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

struct JointPoint {
    Vector3d normal, force;  // on the block with the lower index
    Vector3d position;
    double area, slip, normal_force, gap;
    bool open;
};

/// All patches of a pair of blocks.
struct Joint {
    std::vector<JointPoint> points;
    std::vector<BedPatch> patches;
};
using Joints = std::map<std::pair<int, int>, Joint>;

JointResultant resultant(int block_a, int block_b, const std::vector<JointPoint>& points)
{
    JointResultant joint;
    joint.block_a = block_a;
    joint.block_b = block_b;
    for (const JointPoint& p : points) {
        joint.area += p.area;
        joint.centre += p.area * p.position;
        joint.normal += p.area * p.normal;
        joint.slip += p.area * p.slip;
    }
    joint.centre /= joint.area;
    joint.slip /= joint.area;
    joint.normal.normalize();
    joint.pressure_centre.setZero();
    for (const JointPoint& p : points) {
        joint.force += p.force;
        joint.moment += (p.position - joint.centre).cross(p.force);
        joint.normal_force += p.normal_force;
        joint.pressure_centre += p.normal_force * p.position;
        if (!p.open) joint.closed_area += p.area;
        joint.widest_gap = std::max(joint.widest_gap, p.gap);
    }
    joint.pressure_centre =
        joint.normal_force > 0 ? Vector3d(joint.pressure_centre / joint.normal_force) : joint.centre;
    return joint;
}

FacePlane plane_of(const ConvexPolyhedron& part, std::uint32_t face)
{
    FacePlane plane{face_normal(part, static_cast<int>(face)), Vector3d::Zero()};
    const std::vector<int>& loop = part.faces[face];
    for (const int corner : loop) plane.middle += part.vertices[corner] / static_cast<double>(loop.size());
    return plane;
}

FacePlane plane_of(const ConvexPolygon& outline, std::uint32_t edge)
{
    const Eigen::Vector2d &p = outline.vertices[edge], &q = outline.vertices[(edge + 1) % outline.vertices.size()];
    const Eigen::Vector2d along = (q - p).normalized();
    return {to_space(Eigen::Vector2d(along.y(), -along.x())), to_space(Eigen::Vector2d(0.5 * (p + q)))};
}

/// A patch as a bed that bears. @param sign of its forces on the block with the lower index
template <int D>
BedPatch bed_of(const Model& model, const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch, double sign)
{
    BedPatch bed;
    bed.normal = to_space(VectorIn<D>(sign * patch.normal));
    bed.edge_edge = patch.edge_edge;
    if (!patch.edge_edge) {
        const FacePlane of_a =
            plane_of(contact::ShapeIn<D>::of(model.blocks[patch.block_a])[patch.part_a], patch.feature_a);
        const FacePlane of_b =
            plane_of(contact::ShapeIn<D>::of(model.blocks[patch.block_b])[patch.part_b], patch.feature_b);
        bed.faces = sign > 0 ? std::array{of_a, of_b} : std::array{of_b, of_a};
    }
    for (const ContactPointIn<D>& point : points_of(contacts, patch))
        bed.points.push_back({to_space(point.position), point.area, point.normal_force});
    bed.inner = bed.points.size() - corners_of(contacts, patch).size();
    return bed;
}

template <int D>
void collect(const Model& model, const ContactSetIn<D>& contacts, EdgeStress edge_stress, Joints& joints)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        // The patch's forces act on its block a; ours on the block with the lower index.
        const double sign = patch.block_a < patch.block_b ? 1 : -1;
        const Vector3d normal = to_space(VectorIn<D>(sign * patch.normal));
        Joint& joint = joints[std::minmax(patch.block_a, patch.block_b)];
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts.points[i];
            const VectorIn<D> force = sign * (point.normal_force * patch.normal - point.shear_force);
            joint.points.push_back({normal, to_space(force), to_space(point.position), point.area,
                                    point.plastic_slip.norm(), point.normal_force, point.gap,
                                    point.status == ContactStatus::open});
        }
        if (edge_stress == EdgeStress::judged) joint.patches.push_back(bed_of(model, contacts, patch, sign));
    }
}

}  // namespace

std::vector<JointResultant> joint_resultants(const Model& model, const State& state, EdgeStress edge_stress)
{
    Joints joints;
    if (is_planar(model.kinematics))
        collect(model, state.planar_contacts, edge_stress, joints);
    else
        collect(model, state.contacts, edge_stress, joints);
    std::vector<JointResultant> result;
    for (const auto& [pair, joint] : joints) {
        result.push_back(resultant(pair.first, pair.second, joint.points));
        if (edge_stress == EdgeStress::left_out) continue;
        const double size = std::min(size_of(model, pair.first), size_of(model, pair.second));
        const Bearing hardest = hardest_bearing(joint.patches, size);
        result.back().edge_stress = hardest.stress;
        result.back().bearing_area = hardest.area;
    }
    return result;
}

}  // namespace voussoir
