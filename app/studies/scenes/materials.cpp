#include "app/studies/scenes/materials.h"

#include <cmath>

#include "libdda/contact/normal_stiffness.h"

namespace voussoir::app::studies::scenes
{

JointMaterial dry_joint(double friction)
{
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = std::atan(friction);
    return joint;
}

JointMaterial dry_joint(double friction, double stiffness)
{
    JointMaterial joint = dry_joint(friction);
    joint.stiffness = {ContactStiffness::Kind::per_point, stiffness};
    return joint;
}

BlockMaterial stone(double density, double young)
{
    return {"stone", density, young, 0.2};
}

JointMaterial dry_joint_at_angle(double friction_angle, const ContactStiffness& stiffness)
{
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = friction_angle;
    joint.stiffness = stiffness;
    return joint;
}

namespace
{

/// Times E/L.
double rule_of_papers(Kinematics kinematics)
{
    return is_deformable(kinematics) ? 10 : 1;
}

}  // namespace

double default_stiffness(const SceneSetting& setting, double compliance, const JointMaterial& joint)
{
    const double factor = contact::times_modulus(setting.kinematics, joint_in(setting, joint));
    return 2 * factor / compliance;
}

JointMaterial joint_in(const SceneSetting& setting, JointMaterial joint)
{
    if (setting.papers_joints || setting.open_close == OpenClose::published) joint.face = FaceLaw::corners;
    if (!setting.papers_joints) return joint;
    joint.restitution.reset();
    if (joint.stiffness.kind == ContactStiffness::Kind::from_modulus && joint.stiffness.value == 0)
        joint.stiffness.value = rule_of_papers(setting.kinematics);
    return joint;
}

ContactStiffness stiffness_by_rule(const SceneSetting& setting, double compliance, const JointMaterial& joint)
{
    if (!setting.stiffness_factor) return {};
    return {ContactStiffness::Kind::per_area,
            *setting.stiffness_factor * default_stiffness(setting, compliance, joint)};
}

}  // namespace voussoir::app::studies::scenes
