// Which unknowns a block has: a property of the scene, chosen once.
#pragma once

#include <string_view>

namespace voussoir
{

/// Spatial or planar, deformable or rigid. Planar scenes are part of the layout; their traits arrive later.
enum class Kinematics { spatial_deformable, spatial_rigid };

/// Unknowns per block: 12 (translation, rotation, strain) or 6 (translation, rotation). Source: Shi 1988.
constexpr int unknowns_per_block(Kinematics kinematics)
{
    return kinematics == Kinematics::spatial_deformable ? 12 : 6;
}

/// Numbers that hold a block's place and shape: centroid and 3x3 deformation map (12), or centroid and unit
/// quaternion w, x, y, z (7).
constexpr int coordinates_per_block(Kinematics kinematics)
{
    return kinematics == Kinematics::spatial_deformable ? 12 : 7;
}

constexpr bool is_deformable(Kinematics kinematics)
{
    return kinematics == Kinematics::spatial_deformable;
}

constexpr std::string_view name_of(Kinematics kinematics)
{
    return kinematics == Kinematics::spatial_deformable ? "spatial deformable" : "spatial rigid";
}

}  // namespace voussoir
