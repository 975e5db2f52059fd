// Boxes for scenes, spatial or planar as the setting says.
#pragma once

#include <string>

#include "app/studies/scenes/scene_setting.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::app::studies::scenes
{

/// make_model for a scene that may be planar: a slice of `thickness` [m] that nothing pushes sideways (plane
/// stress), which is what a single row of blocks is. The joint becomes the setting's: joint_in.
Model make_scene_model(const SceneSetting& setting, const BlockMaterial& material, const JointMaterial& joint,
                       double thickness);

/// Adds a box of group 0 and material 0; a planar scene takes its outline. @returns its index
/// @param lower, upper opposite corners [m], x horizontal, z up, y the thickness
int add_box(Model& model, const std::string& name, const Eigen::Vector3d& lower, const Eigen::Vector3d& upper);

/// Holds a block wholly, or lets it follow a motion given for it.
void hold(Model& model, int block);

/// Velocity of a block's centroid at the start of a stage [m/s]; it must not turn or deform.
void set_velocity(const Model& model, State& state, int block, const Eigen::Vector3d& velocity);

/// Stiffness of the first contact of the scene as it stands at the start [Pa/m], and the area of its contact
/// points [m2].
struct StartContact {
    double stiffness = 0, area_per_point = 0;
};
StartContact start_contact(const Model& model);

}  // namespace voussoir::app::studies::scenes
