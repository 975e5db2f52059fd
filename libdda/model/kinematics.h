// Which unknowns a block has: a property of the scene, chosen once.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace voussoir
{

/// Spatial or planar, deformable or rigid. Planar scenes live in the x-z plane (libdda/geometry/plane.h).
enum class Kinematics { spatial_deformable, spatial_rigid, planar_deformable, planar_rigid };

/// A slice in the x-z plane.
constexpr bool is_planar(Kinematics kinematics)
{
    return kinematics == Kinematics::planar_deformable || kinematics == Kinematics::planar_rigid;
}

/// With strain among the unknowns.
constexpr bool is_deformable(Kinematics kinematics)
{
    return kinematics == Kinematics::spatial_deformable || kinematics == Kinematics::planar_deformable;
}

/// 2 or 3.
constexpr int dimension_of(Kinematics kinematics)
{
    return is_planar(kinematics) ? 2 : 3;
}

inline constexpr std::array<int, 3> spatial_axes{0, 1, 2};  ///< x, y, z.
inline constexpr std::array<int, 2> planar_axes{0, 2};      ///< x, z.

/// The axes of space that a scene has, 0, 1, 2 being x, y, z.
constexpr std::span<const int> axes_of(Kinematics kinematics)
{
    if (is_planar(kinematics)) return planar_axes;
    return spatial_axes;
}

/// Unknowns per block: 12 or, planar, 6 (translation, rotation, strain); rigid 6 or 3 (translation, rotation).
/// Source: [Shi1988].
constexpr int unknowns_per_block(Kinematics kinematics)
{
    if (is_deformable(kinematics)) return is_planar(kinematics) ? 6 : 12;
    return is_planar(kinematics) ? 3 : 6;
}

/// Numbers that hold a block's place and shape: centroid and deformation map (12 or 6); centroid and unit
/// quaternion w, x, y, z (7), or centroid and angle (3).
constexpr int coordinates_per_block(Kinematics kinematics)
{
    if (is_deformable(kinematics)) return is_planar(kinematics) ? 6 : 12;
    return is_planar(kinematics) ? 3 : 7;
}

/// "spatial deformable" and so on.
constexpr std::string_view name_of(Kinematics kinematics)
{
    switch (kinematics) {
        case Kinematics::spatial_deformable:
            return "spatial deformable";
        case Kinematics::spatial_rigid:
            return "spatial rigid";
        case Kinematics::planar_deformable:
            return "planar deformable";
        case Kinematics::planar_rigid:
            break;
    }
    return "planar rigid";
}

}  // namespace voussoir
