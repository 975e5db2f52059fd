#include "libdda/analysis/material_point.h"

namespace voussoir
{

Eigen::Vector3d displacement_of(const Model& model, const State& state, const MaterialPoint& point)
{
    const Pose pose = pose_of(model.kinematics, state, point.block);
    return pose.centroid - model.blocks[point.block].moments.centroid + pose.map * point.lever - point.lever;
}

Eigen::Vector3d velocity_of(const Model& model, const State& state, const MaterialPoint& point)
{
    return velocity_of(model.kinematics, state, point.block) +
           map_rate_of(model.kinematics, state, point.block) * point.lever;
}

}  // namespace voussoir
