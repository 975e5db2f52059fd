// Structures of few stones whose limit is known to limit analysis: what verdicts at rest are judged by.
#pragma once

#include <cstdint>
#include <string>

#include "app/studies/verify/limit_masonry.h"

namespace voussoir::app::studies::verify
{

/// The n-th of a row of random arches, walls, portals, leaning frames and domes, in turn, with default joints as a
/// case has them at rest: planar but for the domes and every second arch. The same seed draws the same on every
/// machine, whatever the stones are.
/// @param rigid or deformable stones
LimitMasonry limit_scene(std::uint64_t seed, int n, bool rigid);

}  // namespace voussoir::app::studies::verify
