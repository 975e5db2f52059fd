// The papers' time stepping of a dropped cube, written a second time: what the scheme itself loses.
#pragma once

#include "app/studies/verify/references/rebound.h"

namespace voussoir::app::studies::verify::references
{

/// Share of the drop lost in the first bounce when the linear cube (centroid height, vertical and lateral strain)
/// on its springs is stepped by Newmark (beta 1/2, gamma 1), contact open or closed as it ends the step.
/// Source: [Li2017], equations 7 to 9
double newmark_loss(const DroppedCube& cube, double time_step);

}  // namespace voussoir::app::studies::verify::references
