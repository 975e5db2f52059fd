#include "libdda/model/model.h"

namespace voussoir
{

Block make_block(std::string name, int group, int material, std::vector<ConvexPolyhedron> parts)
{
    Block block;
    block.name = std::move(name);
    block.group = group;
    block.material = material;
    block.moments = moments_of(parts);
    for (ConvexPolyhedron& part : parts)
        block.parts.push_back(translated(std::move(part), -block.moments.centroid));
    return block;
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
