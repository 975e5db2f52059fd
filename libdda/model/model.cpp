#include "libdda/model/model.h"

#include <algorithm>
#include <cmath>

#include "libdda/geometry/plane.h"

namespace voussoir
{

double friction_coefficient(const JointMaterial& joint, double speed)
{
    double from_speed = 0, from = std::tan(joint.friction_angle);
    for (const FrictionAtSpeed& point : joint.friction_at_speed) {
        const double to = std::tan(point.angle);
        if (speed < point.speed) return from + (to - from) * (speed - from_speed) / (point.speed - from_speed);
        from_speed = point.speed;
        from = to;
    }
    return from;
}

int most_branches(const Model& model)
{
    std::size_t most = 0;
    for (const BlockMaterial& material : model.materials) most = std::max(most, material.branches.size());
    return is_deformable(model.kinematics) ? static_cast<int>(most) : 0;
}

double size_of(const Model& model, int block)
{
    const double volume = model.blocks[block].moments.volume;
    return is_planar(model.kinematics) ? std::sqrt(volume / model.thickness) : std::cbrt(volume);
}

Block make_block(std::string name, int group, int material, std::vector<ConvexPolyhedron> parts)
{
    const Moments moments = moments_of(parts);
    return make_block(std::move(name), group, material, std::move(parts), moments);
}

Block make_block(std::string name, int group, int material, std::vector<ConvexPolyhedron> parts,
                 const Moments& moments)
{
    Block block;
    block.name = std::move(name);
    block.group = group;
    block.material = material;
    block.moments = moments;
    for (ConvexPolyhedron& part : parts)
        block.parts.push_back(translated(std::move(part), -block.moments.centroid));
    return block;
}

Block make_planar_block(std::string name, int group, int material, std::vector<ConvexPolygon> outlines,
                        double thickness)
{
    Block block;
    block.name = std::move(name);
    block.group = group;
    block.material = material;
    block.moments = moments_of(outlines, thickness);
    block.outlines = std::move(outlines);
    const Eigen::Vector2d centroid = from_space<2>(block.moments.centroid);
    for (ConvexPolygon& outline : block.outlines)
        for (Eigen::Vector2d& x : outline.vertices) x -= centroid;
    return block;
}

void attach_mass(Model& model, int block, double mass, const Eigen::Vector3d& point)
{
    Block& own = model.blocks[block];
    const double before = model.mass(block);
    Eigen::Vector3d arm = point - own.moments.centroid;
    if (is_planar(model.kinematics)) arm.y() = 0;
    const Eigen::Vector3d shift = mass / (before + mass) * arm;  // of the centre of mass
    own.attached_second += before * shift * shift.transpose() + mass * (arm - shift) * (arm - shift).transpose();
    own.attached_mass += mass;
    own.moments.centroid += shift;
    for (ConvexPolyhedron& part : own.parts) part = translated(std::move(part), -shift);
    for (ConvexPolygon& outline : own.outlines)
        for (Eigen::Vector2d& x : outline.vertices) x -= from_space<2>(shift);
}

void set_thickness(Model& model, double thickness)
{
    const double factor = thickness / model.thickness;
    model.thickness = thickness;
    for (Block& block : model.blocks) {
        block.moments.volume *= factor;
        block.moments.second *= factor;
    }
}

Model make_model(Kinematics kinematics, const BlockMaterial& material, const JointMaterial& joint)
{
    Model model;
    model.kinematics = kinematics;
    model.groups = {"masonry"};
    model.materials = {material};
    model.joints = {joint};
    model.joint_of_groups = {0};
    return model;
}

}  // namespace voussoir
