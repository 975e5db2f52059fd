// The lantern over the oculus of a dome.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/pattern.h"
#include "importers/patterns/vaults.h"
#include "libdda/errors.h"

namespace voussoir::importers::patterns
{

/// A point of a dome. @param radius from the centre of the sphere [m] @param angle from the axis [rad]
/// @param azimuth from x [rad] @returns [m]
Eigen::Vector3d point_of(const Dome& dome, double radius, double angle, double azimuth);

/// Adds what makes no lantern.
void check_lantern(const Dome& dome, std::vector<Fault>& faults);

/// Adds "lantern_curb_b01" ..., a ring between the last course and a level bed, "lantern_post_b01" ... over every
/// second of its stones, "lantern_ring_b01" ... from the middle of a post to that of the next, "lantern_cap" (all
/// in group lantern). Inside and outside it goes up from the edges of the oculus.
/// @pre the dome has been checked; its lantern has a height
void add_lantern(const Dome& dome, const std::string& prefix, Pattern& pattern);

}  // namespace voussoir::importers::patterns
