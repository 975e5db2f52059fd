// Where an entry of `blocks` stands, and how often: scaled, mirrored, turned, moved, copied.
#pragma once

#include <string_view>
#include <vector>

#include "app/reader/yaml_cursor.h"
#include "importers/helper/placed_copy.h"
#include "libdda/model/kinematics.h"

namespace voussoir::app::reader
{

using importers::helper::PlacedCopy;

/// A turn about an axis through a point.
struct Rotation {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit
    double angle = 0;                                 // rad
    Eigen::Vector3d about = Eigen::Vector3d::Zero();  // m
    /// Of so many of these turns.
    Eigen::Matrix3d matrix(int times = 1) const;
};

/// `{axis: z, angle: 45 deg, about: [x, y, z]}`. The axis is a letter or a direction; a planar scene needs none
/// and then turns from x to z. @param about where the axis stands if the case does not say; @param whose that, in
/// words
Rotation read_rotation(YamlCursor& rotate, Kinematics kinematics, const Eigen::Vector3d& about,
                       std::string_view whose);

/// `scale`, `mirror`, `rotate`, `move` and `copy` of an entry, which act in this order wherever they are written.
/// @returns at least one place; the one of an entry without these keys is as drawn
std::vector<PlacedCopy> read_placing(YamlCursor& entry, Kinematics kinematics);

}  // namespace voussoir::app::reader
