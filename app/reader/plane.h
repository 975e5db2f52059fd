// What a case says differently when its scene is planar: no y, a thickness, plane strain or plane stress.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// The key `y` means nothing in a planar scene.
void forbid_y(YamlCursor& map);

/// `plane: strain` or `stress`, a fault where there is no strain across a plane.
void read_plane_condition(YamlCursor& top, Model& model);

/// [x, y, z], in a planar scene [x, z] too. @returns (3) in space, y as it is written
Eigen::Vector3d read_vector(const YamlCursor& value, const words::Dimension& dimension, Kinematics kinematics);

/// A direction [x, y, z]; in a planar scene [x, z], or [x, 0, z] as spatial scenes write it. Its
/// length, if not zero, has a square that is a number.
Eigen::Vector3d read_direction(const YamlCursor& value, Kinematics kinematics);

/// A place [x, y, z] [m]; in a planar scene [x, z], or a place in space whose y is left away with a warning: all
/// points across the plane move alike.
Eigen::Vector3d read_place(const YamlCursor& value, Kinematics kinematics);

}  // namespace voussoir::app::reader
