// Stones and joints of scenes.
#pragma once

#include "app/studies/scenes/scene_setting.h"
#include "libdda/model/model.h"

namespace voussoir::app::studies::scenes
{

/// A dry joint with Shi's stiffness per contact point. @param friction coefficient; @param stiffness [N/m]
JointMaterial dry_joint(double friction, double stiffness);

/// A dry joint with the stiffness by the documented rule. @param friction coefficient
JointMaterial dry_joint(double friction);

/// A dry joint by its angle of friction [rad].
JointMaterial dry_joint_at_angle(double friction_angle, const ContactStiffness& stiffness);

/// A block material of the default elasticity. @param density [kg/m3]; @param young [Pa]
BlockMaterial stone(double density = 2000, double young = 1e10);

/// The stiffness by the rule of the setting times `setting.stiffness_factor`; the rule itself when there is none.
/// Source: docs/method.md. @param compliance L_a/E_a + L_b/E_b of the blocks that are not held [m/Pa]
ContactStiffness stiffness_by_rule(const SceneSetting& setting, double compliance,
                                   const JointMaterial& joint = {});

/// 2 f / compliance, f the default factor of the engine for the joint, a dry one unless given; with joints as in
/// the papers 10 for deformable blocks and 1 for rigid ones [Pa/m].
double default_stiffness(const SceneSetting& setting, double compliance, const JointMaterial& joint = {});

/// Gives a joint whose stiffness is by the rule that of the setting, and its law of impacts to all.
JointMaterial joint_in(const SceneSetting& setting, JointMaterial joint);

}  // namespace voussoir::app::studies::scenes
