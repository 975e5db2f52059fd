// Scenes far from the origin of coordinates: what of them a double keeps, and the local origin that a run computes
// about.
#pragma once

#include "app/reader/block_reading.h"

namespace voussoir::app::reader
{

/// What a coordinate of the scene is rounded to at most as it is read: half a unit in its last place [m].
double coordinate_rounding(const Model& model);

/// What joints of stones that touch may overlap or gape by because the coordinates of both were rounded, and
/// turned with these roundings [m]; zero for a scene that has no local origin.
double rounded_misfit(const Model& model);

/// Gives a scene whose middle is farther than 10 km, and than its own extent, from the origin of coordinates an
/// origin of its own, from which positions are counted inside; results are in the user's coordinates. Nothing
/// changes for other scenes. A stone that its coordinates round by more than a millionth of its size is a fault.
void settle_origin(BlockReading& reading);

}  // namespace voussoir::app::reader
